"""The screens of a run on a real robot, which a double drives: the check list, the tape measure, what was predicted."""

from scripts.screenshots.camera import Photographer
from scripts.screenshots.lesson import enter
from scripts.screenshots.pupils import Seed
from tests.links.aurora import Aurora, free_port

LINK = "bridge"
_FAST = {"max_v_mps": 1.2, "max_omega_dps": 250.0, "room": {"width_m": 8.0, "depth_m": 8.0}}
_TURNS = "0.96"  # of what the double's odometry reports


def choose(camera: Photographer, seeded: Seed) -> int:
    """Sets the robot up, and chooses it in a program; returns the port at which PINEL waits for it."""
    port = free_port()
    enter(camera)
    camera.call("PUT", f"/api/real-robots/{LINK}", {"record": {**_FAST, "port": port}})
    camera.call("POST", "/api/teacher/leave")
    camera.open_program(seeded.programs["Quadrado"])
    camera.page.reload()
    camera.of("robot-choice").select_option(LINK)
    return port


def drive(camera: Photographer, seeded: Seed) -> None:
    """Drives the program on the double, to its end; the group is then asked for the tape measure."""
    aurora = Aurora(choose(camera, seeded), "--turns", _TURNS)
    try:
        camera.press_run()
        camera.of("before-point").first.wait_for()
        for point in camera.of("before-point").all():
            point.check()
        camera.press("before-go")
        camera.wait_for_phase("finished")
        camera.of("tape-open").wait_for()
    finally:
        aurora.close()


def measure(camera: Photographer) -> None:
    """Types what the tape says."""
    camera.press("tape-open")
    camera.of("tape-forward").fill("8")
    camera.of("tape-sideways").fill("5")
    camera.of("heading").fill("-14")


def forget(camera: Photographer) -> None:
    """Later screens are those of a PC without a real robot."""
    enter(camera)
    camera.call("DELETE", f"/api/real-robots/{LINK}")
    camera.call("POST", "/api/teacher/leave")
