"""Own activities: activities that a teacher makes from a world, a sample solution and checks."""

import json
from dataclasses import asdict
from typing import TYPE_CHECKING, Any

from flask import Response

from pinel_desktop.errors import PinelError
from pinel_desktop.school.own_activities import (
    in_all_languages,
    own_activity,
    own_goal,
    save_activity,
)
from pinel_desktop.school.teacher_programs import create_program
from pinel_desktop.web.api import TEACHER, WRITES, Resource, responses
from pinel_desktop.web.errors import InvalidActivityError
from pinel_desktop.web.models import Empty, IdPath
from pinel_desktop.web.models.activities import GoalPicture
from pinel_desktop.web.models.own_activities import (
    OwnActivity,
    OwnActivityDraft,
    OwnActivityList,
    OwnActivityToEdit,
    Proposal,
    Sample,
    Stage,
    Trial,
    Trials,
)
from pinel_desktop.web.models.work import Program
from pinel_desktop.web.responses import describe_faults, json_response, notice
from pinel_desktop.web.services import read_document, services
from pinel_desktop.web.teaching import require_teacher
from storage import OwnActivityRow

if TYPE_CHECKING:
    from pinel_desktop.activities import Activity

api = Resource("own_activities", "Activities that a teacher makes.", __name__)

_FINISHED = {"check": "finished"}
_UNNAMED = "new"
_SAVE_ERRORS = ("own_activity_unsound", "invalid_activity", "name_empty", "name_too_long")


@api.get("/own-activities", responses=responses(OwnActivityList, *TEACHER))
def list_own_activities() -> Response:
    """The own activities that were made on this PC or merged from files. For the teacher."""
    require_teacher()
    rows = services().store.own_activities.all()
    return json_response(OwnActivityList(activities=[_listed(row) for row in rows]))


@api.get(
    "/own-activities/<id>",
    responses=responses(
        OwnActivityToEdit,
        *TEACHER,
        "own_activity_not_found",
        "activity_newer",
        "own_activity_unreadable",
    ),
)
def get_own_activity(path: IdPath) -> Response:
    """An own activity to be edited. For the teacher."""
    require_teacher()
    row = services().store.own_activities.get(path.id)
    return json_response(_to_edit(row, own_activity(row)))


@api.post(
    "/own-activities",
    responses=responses(OwnActivity, *TEACHER, *_SAVE_ERRORS, "own_activities_too_many", *WRITES),
)
def create_own_activity(body: OwnActivityDraft) -> Response:
    """Stores a new activity. Its solution must pass, and a program without commands must not. For the teacher."""
    require_teacher()
    return _save(services().store.own_activities.new_key(), body)


@api.put(
    "/own-activities/<id>",
    responses=responses(OwnActivity, *TEACHER, *_SAVE_ERRORS, "own_activity_not_found", *WRITES),
)
def change_own_activity(path: IdPath, body: OwnActivityDraft) -> Response:
    """Replaces an activity, also for the lessons and programs that name it. For the teacher."""
    require_teacher()
    return _save(services().store.own_activities.get(path.id).id, body)


@api.delete(
    "/own-activities/<id>", responses=responses(Empty, *TEACHER, "own_activity_not_found", *WRITES)
)
def delete_own_activity(path: IdPath) -> Response:
    """Removes an activity from the lists; programs that are to solve it still are. For the teacher."""
    require_teacher()
    services().store.own_activities.delete(path.id)
    return json_response(Empty())


@api.post(
    "/own-activities/<id>/take-back",
    responses=responses(Empty, *TEACHER, "own_activity_not_found", *WRITES),
)
def restore_own_activity(path: IdPath) -> Response:
    """Restores a deleted activity to the lists. For the teacher."""
    require_teacher()
    services().store.own_activities.undelete(path.id)
    return json_response(Empty())


@api.post("/own-activities/programs", responses=responses(Program, *TEACHER, *WRITES))
def create_solution_program() -> Response:
    """Creates an empty program of the teacher, for a sample solution. For the teacher."""
    require_teacher()
    parts = services()
    return json_response(Program.of(create_program(parts.store, parts.settings.language)))


@api.post("/own-activities/measure", responses=responses(Sample, *TEACHER, "body_too_large"))
def measure_solution(body: Stage) -> Response:
    """Runs a sample solution and proposes checks that fit its run. For the teacher."""
    from pinel_desktop.activities import proposal_for  # noqa: PLC0415 - heavy

    require_teacher()
    parts = services()
    reading = read_document(body.solution)
    activity, faults = _read({**_stage(body), "checks": [_FINISHED]})
    if activity is None or faults or reading.faults:
        found = [*reading.faults, *faults]
        shown = describe_faults(found, parts.settings.language)
        return json_response(Sample(faults=shown, proposal=None))
    proposal = Proposal(**asdict(proposal_for(activity, reading)))
    return json_response(Sample(faults=[], proposal=proposal))


@api.post("/own-activities/try", responses=responses(Trials, *TEACHER, "body_too_large"))
def try_activity(body: OwnActivityDraft) -> Response:
    """Runs the solution and a program without commands under the ideal and the realistic robot. For the teacher."""
    from pinel_desktop.activities import trials  # noqa: PLC0415 - heavy

    require_teacher()
    language = services().settings.language
    activity, faults = _read(_document(_UNNAMED, body))
    if activity is None or faults:
        return json_response(Trials(faults=describe_faults(faults, language), trials=[]))
    shown = [
        Trial(
            program=one.program,
            preset=one.preset,
            passed=one.passed,
            is_right=one.is_right,
            words=one.texts.get(language, ""),
        )
        for one in trials(activity)
    ]
    return json_response(Trials(faults=[], trials=shown))


def _save(key: str, body: OwnActivityDraft) -> Response:
    document = _document(key, body)
    activity, faults = _read(document)
    if activity is None or faults:
        raise InvalidActivityError(describe_faults(faults, services().settings.language))
    return json_response(_listed(save_activity(services().store, activity, document)))


def _read(document: dict[str, Any]) -> tuple["Activity | None", Any]:
    from pinel_desktop.activities import read_activity  # noqa: PLC0415 - heavy

    return read_activity(json.dumps(document))


def _document(key: str, body: OwnActivityDraft) -> dict[str, Any]:
    """Returns the activity of a form as JSON data, without empty texts."""
    texts = {"story": body.story, "criteria": body.criteria, "question": body.question}
    written = {name: in_all_languages(text) for name, text in texts.items() if text.strip()}
    return {
        **_stage(body),
        **written,
        "name": key,
        "title": in_all_languages(body.title),
        "level": body.level,
        "minutes": body.minutes,
        "hints": [in_all_languages(hint) for hint in body.hints if hint.strip()],
        "checks": [_FINISHED, *body.checks],
        "shows_path": body.shows_path,
    }


def _stage(body: Stage) -> dict[str, Any]:
    return {
        "pinel_activity": 2,
        "name": _UNNAMED,
        "title": in_all_languages(_UNNAMED),
        "world": body.world,
        "solution": body.solution,
        "cases": [{"gestures": body.gestures, "answers": body.answers}],
    }


def _to_edit(row: OwnActivityRow, mission: "Activity") -> OwnActivityToEdit:
    language, case = services().settings.language, mission.cases[0]
    checks = [check.model_dump(mode="json", exclude_none=True) for check in mission.checks]
    return OwnActivityToEdit(
        id=row.id,
        title=mission.title.of(language),
        story=mission.story.of(language) if mission.story else "",
        criteria=mission.criteria.of(language) if mission.criteria else "",
        hints=[hint.of(language) for hint in mission.hints],
        question=mission.question.of(language) if mission.question else "",
        level=mission.level or 1,
        minutes=mission.minutes,
        shows_path=mission.shows_path,
        checks=[check for check in checks if check != _FINISHED],
        solution=mission.solution or {},
        world=mission.world,
        gestures=case.gestures,
        answers=case.answers,
    )


def _listed(row: OwnActivityRow) -> OwnActivity:
    from pinel_desktop.activities import world_of  # noqa: PLC0415 - heavy

    picture, problem = None, None
    try:
        mission = own_activity(row)
        shown = {"world": world_of(mission, mission.cases[0]), **own_goal(row).model_dump()}
        picture = GoalPicture.model_validate(shown)
    except PinelError as error:
        problem = notice(error.code, error.params, services().settings.language)
    return OwnActivity(
        id=row.id,
        title=row.title,
        created_at=row.created_at,
        goal_picture=picture,
        problem=problem,
    )
