"""Colours and pictures that a group can choose, and patterns of its robot."""

# distinguishable on a projector and by colour-blind pupils; each dark enough for white text
COLORS = (
    "#1f6f8b",
    "#b3541e",
    "#5b4b9a",
    "#2e7d4f",
    "#a03561",
    "#8a6a00",
    "#34568b",
    "#7a3e3e",
    "#00796b",
    "#6d5d4b",
    "#9c3d97",
    "#4a6b1c",
)
# known to pupils of any school and distinguishable at a glance; the page has a drawing of each
PICTURES = (
    "rocket",
    "cat",
    "tree",
    "fish",
    "star",
    "bird",
    "bike",
    "sun",
    "turtle",
    "guitar",
    "flower",
    "snail",
    "ship",
    "rabbit",
    "mountain",
    "dog",
    "umbrella",
    "cherry",
    "plane",
    "crown",
    "squirrel",
    "anchor",
    "apple",
    "moon",
)
# of the robot's body; the page has a drawing of each (ui/src/scene/livery/patterns.ts)
PATTERNS = ("waves", "stripes", "dots", "checks", "star", "plain")
# for a group whose colour is unknown
GREY = "#808080"
# where a robot truly was: a tape measure, a camera above the floor, what the robot's own localisation publishes
TRUTH_SOURCES = ("tape", "camera", "localisation")
