"""Signs that captures can return, and signs that a class teaches."""

from typing import Annotated

from pydantic import BaseModel, Field

from pinel_desktop.web.models import DEFERRED, Id, RequestModel, ResponseModel


class Sign(ResponseModel):
    """A sign that the camera recognises.

    `n_samples` and `n_movements` count the hands and movements that the class has recorded. `landmarks` (21 of x to the
    right, y down, z away) show a typical hand, as a right hand appears in a mirror; null for letters, whose drawings
    ship.
    """

    name: str
    is_letter: Annotated[
        bool, Field(description="one of the letters that the camera knows untaught")
    ]
    n_samples: int
    n_movements: int
    landmarks: list[list[float]] | None


class SignList(ResponseModel):
    """Letters first, then the other signs that the class taught."""

    signs: list[Sign]


class SignName(ResponseModel):
    """The sign in the recording, as the class spells it."""

    name: str


class ClassroomOfCamera(RequestModel):
    """The class whose taught signs the camera recognises; null for a group without a class."""

    classroom_id: Id | None


class SignPath(BaseModel):
    """A class and the name of a sign in a path."""

    model_config = DEFERRED

    id: Id
    sign: Annotated[Id, Field(description="name of a sign, at most 30 characters")]
