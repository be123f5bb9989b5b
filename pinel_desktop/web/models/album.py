"""The album of stickers of a group."""

from typing import Annotated

from pydantic import Field

from pinel_desktop.school.album import StickerKind
from pinel_desktop.web.models import Id, ResponseModel, Time


class StickerWin(ResponseModel):
    """When a sticker was won, and by which run; `run_id` is null for a sign that a class taught."""

    won_at: Time
    run_id: Id | None


class Sticker(ResponseModel):
    """A sticker of an album, or its empty place."""

    name: Annotated[
        str,
        Field(
            description="of the activity; of a sticker for character: repair, shorter, careful, taught"
        ),
    ]
    kind: StickerKind
    path: Annotated[str | None, Field(description="of a shipped activity: its learning path")]
    title: Annotated[str, Field(description='of the activity; "" for character')]
    win: Annotated[StickerWin | None, Field(description="null for an empty place")]
    n_done: Annotated[int, Field(description="runs that count for it, if it needs several")]
    n_needed: int


class Album(ResponseModel):
    """The stickers of a group: activities along the paths, activities of teachers, then character."""

    enabled: Annotated[bool, Field(description="false, without stickers, if the teacher chose so")]
    stickers: list[Sticker]
