"""The teacher's screens, and how each is reached."""

from scripts.screenshots.screens import WORK, Reach, School, at, hand, then


def _camera(school: School) -> None:
    school.camera.go("#/teacher/camera")
    hand(school)


def _presented(address: str) -> Reach:
    def reach(school: School) -> None:
        at(address, "presentation")(school)
        for _ in range(3):
            school.camera.page.keyboard.press("PageDown")

    return reach


def _merged(school: School) -> None:
    at("teacher/files", "merge-files")(school)
    school.camera.press("merge-files")
    school.camera.of("merge-results").wait_for()
    school.camera.of("merge-results").scroll_into_view_if_needed()


def _merged_work(school: School) -> None:
    """Work of another PC came; here it is this PC's own file."""
    at("teacher/files", "merge-files")(school)
    camera = school.camera
    for file in camera.of("found-file").all():
        file.set_checked("estragado" not in (file.get_attribute("aria-label") or ""))
    camera.press("merge-files")
    camera.of("merge-results").wait_for()


def _first_set_up(school: School) -> None:
    """No PIN has been chosen on this PC."""
    answer = {"has_pin": False, "is_open": False}
    school.camera.page.route("**/api/teacher", lambda route: route.fulfill(json=answer))
    school.camera.page.reload()
    at("teacher/lessons", "prepare-done")(school)


def _refused_pin(school: School) -> None:
    at("teacher", "pin")(school)
    school.camera.of("pin").fill("27")
    school.camera.press("sign-in")
    school.camera.page.get_by_role("alert").wait_for()


def _class(name: str, reach: Reach) -> Reach:
    """A part of the teacher's page, with a class chosen."""

    def further(school: School) -> None:
        reach(school)
        school.camera.page.locator("[data-testid=class-chip]", has_text=name).click()
        school.camera.page.wait_for_timeout(600)

    return further


def _made(school: School) -> None:
    """The form of an own activity, after a solution was chosen."""
    then(_ACTIVITIES, "making-new")(school)
    camera = school.camera
    camera.of("making-group").select_option(label="Capivaras")
    camera.of("making-program").select_option(label="Quadrado da sala")
    camera.of("making-check").first.wait_for()
    camera.of("making-title").fill("Um quadrado para o pátio")


def _checked(school: School) -> None:
    """What has to happen was chosen too."""
    _made(school)
    school.camera.of("making-check").nth(4).get_by_role("checkbox").check()  # the path's length


def _tried(school: School) -> None:
    _made(school)
    camera = school.camera
    camera.press("making-try")
    camera.of("making-trials").wait_for(timeout=60_000)
    camera.page.wait_for_timeout(2_000)


def _saved_activity(school: School) -> None:
    _checked(school)
    camera = school.camera
    camera.of("making-story").fill("Façam o robô voltar à partida.")
    camera.press("making-save")
    camera.of("making-row").first.wait_for()


def _bridge(school: School) -> None:
    """A real robot is set up, its fields unfolded."""
    at("teacher/robot", "robots-find")(school)
    page = school.camera.page
    page.locator("[data-testid=robot-kind][data-value=bridge]").click()
    page.locator("[data-testid=robot-keep]").click()
    school.camera.of("robot-forget").wait_for()
    for part in ("robot-limits", "robot-tolerances"):
        school.camera.press(part)
    school.camera.press("robot-contact")
    page.wait_for_timeout(1_000)


def _calibrated(school: School) -> None:
    """What three measured runs tell about the robot. Forgets the robot of `_bridge`."""
    at("teacher/robot", "real-run")(school)
    camera = school.camera
    if camera.of("robot-forget").is_visible():
        camera.press("robot-forget")
    measured = camera.of("real-run").filter(has=camera.page.locator(".calibration__measured"))
    for run in measured.all()[-3:]:
        run.get_by_role("checkbox").check()
    camera.press("calibrate")
    camera.of("calibration-result").wait_for(timeout=60_000)


def _printed(reach: Reach) -> Reach:
    """As the page is printed."""

    def further(school: School) -> None:
        reach(school)
        school.camera.page.emulate_media(media="print")

    return further


_COMPARE = at("compare/{past.runs[0]}/{past.runs[1]}", "compare-side")
_ACTIVITIES = at("teacher/activities", "making-new")
_LESSONS = _class("9º A", at("teacher/lessons", "class-chip"))
_CLASSES = _class("9º A", at("teacher/classes", "class-chip"))
_REVIEW = at("lesson/{past.lesson}", "review-group")
_PLAN = at("teacher/plan", "plan")
_CARDS = at("cards", "card")
_TAPE = at("run/{past.real.measured[0]}", "replay-slider")

TEACHERS: dict[str, Reach] = {
    "teacher-pin": at("teacher", "pin"),
    "teacher-pin-refused": _refused_pin,
    "teacher-prepare": _first_set_up,
}
SIGNED_IN: dict[str, Reach] = {
    "teacher-lessons": _LESSONS,
    "teacher-lessons-another": then(_LESSONS, "open-another"),
    "teacher-lessons-none": _class("6º D", _LESSONS),
    "teacher-plan": _PLAN,
    "teacher-plan-printed": _printed(_PLAN),
    "teacher-activities": _ACTIVITIES,
    "teacher-making": then(_ACTIVITIES, "making-new"),
    "teacher-making-full": _checked,
    "teacher-making-tried": _tried,
    "teacher-activities-full": _saved_activity,
    "teacher-classes": _CLASSES,
    "teacher-classes-delete": then(_CLASSES, "deletion-open"),
    "teacher-camera": _camera,
    "teacher-group": WORK,
    "teacher-robot": at("teacher/robot", "robots-find"),
    "teacher-robot-bridge": _bridge,
    "teacher-robot-calibrated": _calibrated,
    "teacher-files": at("teacher/files", "merge-files"),
    "teacher-files-refused": _merged,
    "teacher-files-merged": _merged_work,
    "teacher-computer": at("teacher/computer", "computer-name"),
    "review": _REVIEW,
    "review-printed": _printed(_REVIEW),
    "review-group": then(_REVIEW, "review-open"),
    "review-new": then(_LESSONS, "lesson-now-review"),
    "review-note": then(at("run/{past.runs[0]}", "note-open"), "note-open"),
    "review-runs": at("runs", "compare-choose"),
    "review-compare": _COMPARE,
    "review-apart": then(_COMPARE, "[data-testid=compare-view] >> nth=0"),
    "review-real": then(at("lesson/{past.real.lesson}", "review-group"), "review-open"),
    "review-tape": _TAPE,
    "review-tape-form": then(_TAPE, "tape-open"),
    "review-unusual": at("run/{past.real.unusual}", "replay-slider"),
    "album-printed": _printed(at("album/{past.group}", "album-place")),
    "cards": _CARDS,
    "cards-printed": _printed(_CARDS),
    "presentation-program": _presented("present/same/program/{past.program}"),
    "presentation": _presented("present/same/{past.runs[1]}"),
    "presentation-keys": at("present/same/{past.runs[1]}", "presentation-keys"),
    "presentation-pair": _presented("present/same/{past.runs[0]}/{past.runs[1]}"),
    "presentation-real": _presented("present/same/{past.real.unusual}"),
}
