"""Activities: missions as data, and whether a program fulfils them."""

from pinel_desktop.activities.batch import check_files
from pinel_desktop.activities.checking import Report, check_program
from pinel_desktop.activities.faults import ActivityError
from pinel_desktop.activities.model import Activity
from pinel_desktop.activities.reading import activity_names, choose_activity, shipped_names

__all__ = [
    "Activity",
    "ActivityError",
    "Report",
    "activity_names",
    "check_files",
    "check_program",
    "choose_activity",
    "shipped_names",
]
