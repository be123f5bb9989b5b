"""The resources that the page asks for before its first drawing; `routes.py` has all, and is imported after that."""

from pinel_desktop.web.api import (
    classrooms,
    groups,
    programs,
    signs,
    status,
    stream,
    teacher,
    worlds,
)
from pinel_desktop.web.api.preparing import robots

FIRST = (status, teacher, classrooms, groups, programs, worlds, robots, signs, stream)
