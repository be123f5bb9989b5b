"""Activities: missions as data, and the checks that decide whether a program passes."""

from pinel_desktop.activities.batch import check_files
from pinel_desktop.activities.checking import RecordedRun, Report, check_program, judge_run, path_of
from pinel_desktop.activities.diagnosis import case_texts, input_text
from pinel_desktop.activities.examples import EXAMPLES, example, example_picture, program_of_example
from pinel_desktop.activities.faults import ActivityError, world_of
from pinel_desktop.activities.goals import Goal, goal_of, shipped_goal
from pinel_desktop.activities.live import CheckStatus, LiveEvaluation, initial_check_list
from pinel_desktop.activities.making import proposal_for, trials
from pinel_desktop.activities.model import Activity
from pinel_desktop.activities.reading import (
    PATHS,
    activity_names,
    activity_titles,
    choose_activity,
    read_activity,
    shipped_activity,
    shipped_texts,
    solution_of,
    start_of,
    world_title,
)
from pinel_desktop.activities.recorded import (
    case_of_real_run,
    case_of_run,
    judging_blockers,
    not_judgeable_notice,
    not_judged_text,
    tolerance_of,
)
from pinel_desktop.activities.run_log import RunLog, RunLogBuilder
from pinel_desktop.activities.wording import block_text

__all__ = [
    "EXAMPLES",
    "PATHS",
    "Activity",
    "ActivityError",
    "CheckStatus",
    "Goal",
    "LiveEvaluation",
    "RecordedRun",
    "Report",
    "RunLog",
    "RunLogBuilder",
    "activity_names",
    "activity_titles",
    "block_text",
    "case_of_real_run",
    "case_of_run",
    "case_texts",
    "check_files",
    "check_program",
    "choose_activity",
    "example",
    "example_picture",
    "goal_of",
    "initial_check_list",
    "input_text",
    "judge_run",
    "judging_blockers",
    "not_judgeable_notice",
    "not_judged_text",
    "path_of",
    "program_of_example",
    "proposal_for",
    "read_activity",
    "shipped_activity",
    "shipped_goal",
    "shipped_texts",
    "solution_of",
    "start_of",
    "tolerance_of",
    "trials",
    "world_of",
    "world_title",
]
