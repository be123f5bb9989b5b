"""Activities, the programs of groups for them, and examples."""

import contextlib
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from flask import Response

from pinel_desktop.errors import PinelError
from pinel_desktop.school.own_activities import goal_of_known, known_activity, own_activity
from pinel_desktop.web.api import WRITES, Resource, responses
from pinel_desktop.web.models import IdPath
from pinel_desktop.web.models.activities import (
    Activity,
    ActivityChoice,
    ActivityList,
    ActivityPath,
    ChosenActivity,
    Example,
    ExampleList,
    GoalPicture,
    NextActivity,
    TriedActivities,
    TriedActivity,
)
from pinel_desktop.web.models.work import Program, Setup
from pinel_desktop.web.responses import json_response
from pinel_desktop.web.services import Services, services
from storage import OwnActivityRow, ProgramRow

if TYPE_CHECKING:
    from pinel_desktop.activities import Activity as Mission
    from pinel_desktop.activities import Goal

api = Resource(
    "activities", "Activities, the programs that are to solve them, and examples.", __name__
)


@api.get("/activities", responses=responses(ActivityList))
def list_activities() -> Response:
    """The activities to choose from, in the order of the paths; then own activities that this release can use."""
    from pinel_desktop.activities import activity_names, shipped_activity  # noqa: PLC0415 - heavy

    chosen = [ActivityChoice(**_choice(shipped_activity(name))) for name in activity_names()]
    rows = services().store.own_activities.all()
    return json_response(ActivityList(activities=[*chosen, *_own_choices(rows)]))


@api.get("/examples", responses=responses(ExampleList))
def list_examples() -> Response:
    """The examples that a group may open as copies."""
    from pinel_desktop.activities import EXAMPLES  # noqa: PLC0415 - heavy

    return json_response(ExampleList(examples=[_example(name) for name in EXAMPLES]))


@api.get(
    "/activities/<name>",
    responses=responses(Activity, "unknown_activity", "activity_newer", "own_activity_unreadable"),
)
def get_activity(path: ActivityPath) -> Response:
    """An activity with the texts of its card."""
    from pinel_desktop.activities import (  # noqa: PLC0415 - heavy
        case_texts,
        initial_check_list,
        not_judgeable_notice,
    )

    mission, language = known_activity(services().store, path.name), services().settings.language
    return json_response(
        Activity(
            **_choice(mission),
            story=mission.story.of(language) if mission.story else "",
            criteria=mission.criteria.of(language) if mission.criteria else "",
            checks=[line.criterion for line in initial_check_list(mission, language)],
            n_cases=len(mission.cases),
            cases=case_texts(mission.cases, language),
            hints=[hint.of(language) for hint in mission.hints],
            question=mission.question.of(language) if mission.question else "",
            blocks=mission.blocks,
            world=world_name(mission),
            preset=mission.preset,
            feedback=mission.feedback,
            not_on_robot=not_judgeable_notice(mission, language),
            next=_after(mission),
        )
    )


@api.get("/groups/<id>/activities", responses=responses(TriedActivities, "group_not_found"))
def list_tried(path: IdPath) -> Response:
    """The activities that a group has run programs for, and whether it has passed them."""
    tried = services().store.grading_results.of_group(path.id)
    models = [TriedActivity(name=name, passed=passed) for name, passed in tried.items()]
    return json_response(TriedActivities(activities=models))


@api.post(
    "/groups/<id>/activities",
    responses=responses(Program, "group_not_found", "unknown_activity", *WRITES),
)
def begin_activity(path: IdPath, body: ChosenActivity) -> Response:
    """The group's program for an activity, the most recently changed one; created if there is none."""
    parts = services()
    mission = known_activity(parts.store, body.activity)
    row = parts.store.programs.of_activity(path.id, mission.name)
    return json_response(Program.of(row or _begin(path.id, mission, parts)))


def world_name(mission: "Mission") -> str:
    """Returns the name under which runs of an activity record their world."""
    return mission.world if isinstance(mission.world, str) else "own"


def _begin(group_id: str, mission: "Mission", parts: Services) -> ProgramRow:
    """Creates a program whose setup names the activity, with the blocks that the activity begins with."""
    from pinel_desktop.activities import start_of  # noqa: PLC0415 - heavy

    name = mission.title.of(parts.settings.language)
    program = parts.store.programs.create(group_id, name)
    setup = Setup(
        world=world_name(mission),
        preset=mission.preset,
        feedback=mission.feedback,
        activity=mission.name,
    )
    started = start_of(mission.name, parts.settings.language)
    document = {"pinel_ir": 1, "functions": [], "commands": [], **(started or {}), "name": name}
    workspace = {"document": document} if started else {}  # the page makes blocks of the document
    parts.store.versions.save(program.id, workspace, document, setup=setup.model_dump())
    return program


def _after(mission: "Mission") -> NextActivity | None:
    from pinel_desktop.activities import activity_names, shipped_activity  # noqa: PLC0415 - heavy

    names = activity_names()
    if mission.name not in names:  # an own activity is on no path
        return None
    following = names[names.index(mission.name) + 1 :]
    found = next(
        (one for one in map(shipped_activity, following) if one.path == mission.path), None
    )
    if found is None or mission.path is None:
        return None
    return NextActivity(name=found.name, title=found.title.of(services().settings.language))


def _choice(mission: "Mission") -> dict[str, Any]:
    return {
        "name": mission.name,
        "title": mission.title.of(services().settings.language),
        "path": mission.path,
        "number": mission.number,
        "minutes": mission.minutes,
        "level": mission.level,
        "goal_picture": _goal_picture(mission),
        "own": mission.path is None,
    }


def _example(name: str) -> Example:
    from pinel_desktop.activities import (  # noqa: PLC0415 - heavy
        example,
        example_picture,
        program_of_example,
    )

    shown, language = example(name), services().settings.language
    return Example(
        name=name,
        title=shown.title.of(language),
        about=shown.story.of(language) if shown.story else "",
        world=world_name(shown),
        picture=_picture(shown, example_picture(name)),
        document={
            **(program_of_example(name, language).document or {}),
            "name": shown.title.of(language),
        },
    )


def _own_choices(rows: list[OwnActivityRow]) -> Iterator[ActivityChoice]:
    for row in rows:
        with contextlib.suppress(PinelError):
            yield ActivityChoice(**_choice(own_activity(row)))


def _goal_picture(mission: "Mission") -> GoalPicture:
    return _picture(mission, goal_of_known(services().store, mission.name))


def _picture(mission: "Mission", goal: "Goal") -> GoalPicture:
    from pinel_desktop.activities import world_of  # noqa: PLC0415 - heavy

    world = world_of(mission, mission.cases[0])
    return GoalPicture.model_validate({"world": world, **goal.model_dump()})
