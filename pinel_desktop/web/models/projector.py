"""The presentation of runs, or of a program, on a projector."""

from typing import Annotated

from pydantic import Field, model_validator

from pinel_desktop.web.models import RequestModel, ResponseModel

_Id = Annotated[str, Field(pattern=r"^[A-Za-z0-9-]{1,64}$", description="UUID text")]


class Presented(RequestModel):
    """What to present: one run, two runs side by side, or a program."""

    runs: Annotated[list[_Id], Field(default_factory=list, max_length=2)]
    program: _Id | None = None

    @model_validator(mode="after")
    def _is_one(self) -> "Presented":
        if bool(self.runs) == (self.program is not None):
            raise ValueError("present runs or a program")
        return self

    @property
    def place(self) -> str:
        """The part of the page's address that says what is presented."""
        return "/".join(self.runs) if self.runs else f"program/{self.program}"


class ProjectorState(ResponseModel):
    """Where it is presented."""

    has_window: Annotated[
        bool, Field(description="a window on a second screen shows it; else the page does")
    ]
