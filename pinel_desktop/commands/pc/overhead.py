"""`pinel overhead`: sets up a camera above the floor, which sees where a real robot truly is."""

from collections.abc import Callable
from pathlib import Path
from typing import TypeVar

import click

from pinel_desktop.camera.overhead.markers import OverheadSetup, setting_of, setup_of
from pinel_desktop.camera.overhead.sheets import sheets_page
from pinel_desktop.commands.options import chosen_database, database_option
from pinel_desktop.commands.printing import Failure
from pinel_desktop.errors import PinelError
from pinel_desktop.messages import describe, language_of_system
from pinel_desktop.settings import CAMERA, OVERHEAD, Settings

_DEFAULT = OverheadSetup()
F = TypeVar("F", bound=Callable[..., None])


@click.group()
def command() -> None:
    """Set up a camera above the floor (docs/robots.md).

    Print the sheets, lay them out, measure, and try whether the camera sees them. From then on each run on a real robot
    records where the camera has seen the robot.
    """


@command.command()
@click.argument("file", type=click.Path(path_type=Path, dir_okay=False))
def sheets(file: Path) -> None:
    """Write the five sheets to print, on A4 at 100 %, as a page (HTML)."""
    file.write_text(sheets_page(language_of_system()), "utf-8")
    _say("overhead_sheets_written", path=str(file))


def _measure(
    name: str, low_m: float, high_m: float, default_m: float, what: str
) -> Callable[[F], F]:
    """Returns the option of a measure."""
    bounds = click.FloatRange(low_m, high_m)
    return click.option(
        name, type=bounds, default=default_m, show_default=True, help=f"{what}, in m."
    )


@command.command("set")
@_measure("--width", 0.5, 10, _DEFAULT.width_m, "From marker 1 to 2, centre to centre")
@_measure("--depth", 0.5, 10, _DEFAULT.depth_m, "From marker 1 to 4, centre to centre")
@_measure("--camera-height", 1, 10, _DEFAULT.camera_m, "Of the lens above the floor")
@_measure("--robot-height", 0, 0.9, _DEFAULT.robot_m, "Of the robot's marker above the floor")
@database_option
@click.pass_context
def set_up(
    ctx: click.Context, width: float, depth: float, camera_height: float, robot_height: float
) -> None:
    """Say where the markers lie and how high the camera hangs. Holds after the next start of PINEL."""
    setup = OverheadSetup(
        width_m=width, depth_m=depth, camera_m=camera_height, robot_m=robot_height
    )
    Settings.beside(chosen_database(ctx)).choose(OVERHEAD, setting_of(setup))
    _say("overhead_set")


@command.command()
@database_option
@click.pass_context
def off(ctx: click.Context) -> None:
    """Record no more poses with a camera. Holds after the next start of PINEL."""
    Settings.beside(chosen_database(ctx)).choose(OVERHEAD, "")
    _say("overhead_off")


@command.command("try")
@click.option("--camera", metavar="SOURCE", help="Number of a webcam, a video or a folder.")
@click.option("--seconds", type=click.FloatRange(1, 3600), default=20, show_default=True)
@database_option
@click.pass_context
def try_out(ctx: click.Context, camera: str | None, seconds: float) -> None:
    """Print what the camera sees: the robot's place, a covered marker, a moved camera."""
    settings = Settings.beside(chosen_database(ctx))
    setup = setup_of(settings[OVERHEAD])
    if setup is None:
        raise Failure(PinelError("overhead_not_set"))
    from pinel_desktop.camera.overhead_trial import sightings  # noqa: PLC0415 - loads OpenCV

    try:
        for code, params in sightings(camera or settings[CAMERA], setup, seconds):
            _say(code, **params)
    except PinelError as error:
        raise Failure(error) from error


def _say(code: str, **params: object) -> None:
    click.echo(describe(code, params, language_of_system()).line)
