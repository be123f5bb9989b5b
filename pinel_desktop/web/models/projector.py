"""The presentation of runs on a projector."""

from typing import Annotated

from pydantic import Field

from pinel_desktop.web.models import RequestModel, ResponseModel

_RunId = Annotated[str, Field(pattern=r"^[A-Za-z0-9-]{1,64}$", description="UUID text")]


class ProjectorRuns(RequestModel):
    """The runs to present: one, or two side by side."""

    runs: Annotated[list[_RunId], Field(min_length=1, max_length=2)]


class ProjectorState(ResponseModel):
    """Where the runs are presented."""

    has_window: Annotated[
        bool, Field(description="a window on a second screen shows them; else the page does")
    ]
