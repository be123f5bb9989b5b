import type { plots as first } from "../pt-BR/plots";

export const plots: typeof first = {
  label: "Plots of the run",
  open: "Plots",
  empty: "Press Run: the plots appear here.",
  larger: "Make the plot larger",
  smaller: "Make the plot smaller",
  save: "Save plot or table",
  picture: "Picture of the plot (PNG)",
  table: "Table of the measurements (CSV)",
  keys: "The arrow keys pick the moment.",
  time: "time",
  figures: {
    path: "Path",
    position: "Position",
    heading: "Heading",
    speed: "Speed",
    turning: "Turning",
  },
  titles: {
    path: "The robot's path over the floor",
    position: "Where the robot is: x and y over time",
    heading: "Which way the robot faces over time",
    speed: "Forward speed: as told and as measured",
    turning: "Turning speed: as told and as measured",
  },
  quantities: { position: "x and y", heading: "heading", speed: "speed", turning: "turning" },
  roles: {
    obtained: "obtained",
    desired: "desired",
    true: "true",
    commanded: "commanded",
    measured: "measured",
  },
};
