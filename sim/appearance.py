"""What a world looks like: names of grounds, prints and things. They change nothing that the robot measures.

`ui/src/scene/mat` draws them.
"""

from typing import Literal

from pydantic import Field

# the normal form of a world without any of these has none of the keys, as before they existed
IF_GIVEN = Field(exclude_if=lambda value: not value)

# what covers the whole floor
Ground = Literal["town", "living_room", "classroom", "court", "sea", "farm"]
# what is printed on the ground
Print = Literal["street", "crossing", "roof", "garden", "pond", "rug", "crops"]
# what a box is
BoxKind = Literal[
    "crate", "table", "chair", "bed", "plant", "cone", "fence", "tree", "bin", "bookshelf", "house"
]
