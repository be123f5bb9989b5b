"""Activities: missions as data, and the checks that tell whether a program passes."""

from pinel_desktop.activities.batch import check_files
from pinel_desktop.activities.checking import (
    CaseReport,
    CheckReport,
    RecordedRun,
    Report,
    check_program,
    judge_run,
)
from pinel_desktop.activities.diagnosis import Advice, input_words
from pinel_desktop.activities.evidence import LogWriter, RunLog
from pinel_desktop.activities.examples import (
    EXAMPLES,
    example,
    example_picture,
    program_of_example,
)
from pinel_desktop.activities.faults import ActivityError, world_of
from pinel_desktop.activities.goals import Goal, goal_of, shipped_goal
from pinel_desktop.activities.making import Sample, Trial, sample_of, trials
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
    world_title,
    world_titles,
)
from pinel_desktop.activities.recorded import (
    before_words,
    case_of_real_run,
    case_of_run,
    not_judged_words,
    obstacles,
    slack_of,
)
from pinel_desktop.activities.standing import RunStanding, Standing, standings_before

__all__ = [
    "EXAMPLES",
    "PATHS",
    "Activity",
    "ActivityError",
    "Advice",
    "CaseReport",
    "CheckReport",
    "Goal",
    "LogWriter",
    "RecordedRun",
    "Report",
    "RunLog",
    "RunStanding",
    "Sample",
    "Standing",
    "Trial",
    "activity_names",
    "activity_titles",
    "before_words",
    "case_of_real_run",
    "case_of_run",
    "check_files",
    "check_program",
    "choose_activity",
    "example",
    "example_picture",
    "goal_of",
    "input_words",
    "judge_run",
    "not_judged_words",
    "obstacles",
    "program_of_example",
    "read_activity",
    "sample_of",
    "shipped_activity",
    "shipped_goal",
    "shipped_texts",
    "slack_of",
    "solution_of",
    "standings_before",
    "trials",
    "world_of",
    "world_title",
    "world_titles",
]
