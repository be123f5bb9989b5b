"""Plots a run as the figures of the dissertation do: path, position, heading and control signals, desired and obtained.

Only this file needs matplotlib, which is large: it is the extra `plot`, and the package does not include it.
"""

import importlib.util
import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any

from pinel_desktop.errors import PinelError
from pinel_desktop.events.model import Event, Telemetry
from pinel_desktop.execution.clock import TICK_HZ
from pinel_desktop.messages import describe

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_ENDINGS = (".png", ".svg", ".pdf")
# message codes, each with the prefix `plot_`
_LABELS = (
    "path",
    "position",
    "heading",
    "signals",
    "desired",
    "obtained",
    "true",
    "start",
    "time",
    "v",
    "omega",
    "metres",
    "degrees",
)
_COLUMNS = (
    "x_m",
    "y_m",
    "yaw_rad",
    "command_v_mps",
    "command_omega_radps",
    "goal_x_m",
    "goal_y_m",
    "goal_yaw_rad",
    "true_x_m",
    "true_y_m",
)
# from Okabe and Ito's palette, which colour-blind people can distinguish
_BLUE, _ORANGE, _GREEN, _GREY = "#0072B2", "#D55E00", "#009E73", "#555555"
_VISIBLE_M = 0.005
_INCHES, _DPI = (11.0, 8.5), 120


@dataclass(slots=True)
class Curves:
    """Telemetry of a run by column; `observe` must be called with all events of the run."""

    columns: dict[str, list[float]] = field(
        default_factory=lambda: {name: [0.0] for name in _COLUMNS}
    )

    def observe(self, _tick: int, event: Event) -> None:
        if type(event) is Telemetry:
            for name, column in self.columns.items():
                value = getattr(event, name)
                column.append(math.nan if value is None else value)

    def __getitem__(self, name: str) -> list[float]:
        return self.columns[name]

    @property
    def time_s(self) -> list[float]:
        """Robot time of each row since the start, in s."""
        return [tick / TICK_HZ for tick in range(len(self["x_m"]))]


def plot_format(file: str) -> str:
    """Returns the picture format by the extension of the file's name.

    Raises PinelError `plot_ending` for an unknown extension, `plot_missing` without matplotlib.
    """
    ending = Path(file).suffix.lower()
    if ending not in _ENDINGS:
        raise PinelError("plot_ending", path=file, allowed=list(_ENDINGS))
    if importlib.util.find_spec("matplotlib") is None:
        raise PinelError("plot_missing")
    return ending[1:]


def draw(curves: Curves, file: str, *, title: str, language: str) -> None:
    """Writes a picture in the format of the file's extension (PNG, SVG or PDF).

    Raises PinelError as `plot_format` does, or `plot_unwritable` with the reason.
    """
    kind = plot_format(file)
    from matplotlib.backends.backend_agg import FigureCanvasAgg  # noqa: PLC0415
    from matplotlib.figure import Figure  # noqa: PLC0415

    labels = {name: describe(f"plot_{name}", {}, language).message for name in _LABELS}
    figure = Figure(figsize=_INCHES, dpi=_DPI, layout="constrained")
    FigureCanvasAgg(figure)
    figure.suptitle(title, parse_math=False)
    axes = figure.subplots(2, 2)
    _path(axes[0, 0], curves, labels)
    _position(axes[0, 1], curves, labels)
    _heading(axes[1, 0], curves, labels)
    _signals(axes[1, 1], curves, labels)
    try:
        figure.savefig(Path(file), format=kind)
    except (OSError, ValueError) as error:
        raise PinelError("plot_unwritable", path=file, detail=str(error)) from error


def _path(axes: "Axes", curves: Curves, labels: dict[str, str]) -> None:
    axes.plot(
        curves["goal_x_m"],
        curves["goal_y_m"],
        "--",
        color=_GREY,
        lw=1.0,
        zorder=3,
        label=labels["desired"],
    )
    axes.plot(curves["x_m"], curves["y_m"], color=_BLUE, label=labels["obtained"])
    if any(_differ(curves, name) for name in "xy"):
        axes.plot(curves["true_x_m"], curves["true_y_m"], color=_ORANGE, label=labels["true"])
    axes.plot(0.0, 0.0, "o", color=_GREEN, label=labels["start"])
    axes.set_aspect("equal", adjustable="datalim")
    axes.margins(0.1)
    _finish(axes, labels["path"], f"x {labels['metres']}", f"y {labels['metres']}")


def _differ(curves: Curves, name: str) -> bool:
    """Returns whether the estimated position ever differs visibly from the true one."""
    pairs = zip(curves[f"{name}_m"], curves[f"true_{name}_m"], strict=True)
    return any(abs(believed - true) > _VISIBLE_M for believed, true in pairs)


def _position(axes: "Axes", curves: Curves, labels: dict[str, str]) -> None:
    time_s = curves.time_s
    for name, color in (("x", _BLUE), ("y", _ORANGE)):
        axes.plot(time_s, curves[f"goal_{name}_m"], "--", color=_GREY, lw=1.0, zorder=3)
        axes.plot(time_s, curves[f"{name}_m"], color=color, label=f"{name} {labels['obtained']}")
    axes.plot([], [], "--", color=_GREY, lw=1.0, zorder=3, label=labels["desired"])
    _finish(axes, labels["position"], labels["time"], labels["metres"])


def _heading(axes: "Axes", curves: Curves, labels: dict[str, str]) -> None:
    time_s = curves.time_s
    goal, yaw = _unwrapped(curves["goal_yaw_rad"]), _unwrapped(curves["yaw_rad"])
    axes.plot(time_s, goal, "--", color=_GREY, lw=1.0, zorder=3, label=labels["desired"])
    axes.plot(time_s, yaw, color=_BLUE, label=labels["obtained"])
    _finish(axes, labels["heading"], labels["time"], labels["degrees"])


def _signals(axes: "Axes", curves: Curves, labels: dict[str, str]) -> None:
    time_s = curves.time_s
    axes.plot(time_s, curves["command_v_mps"], color=_BLUE, label=labels["v"])
    axes.plot(time_s, curves["command_omega_radps"], color=_ORANGE, label=labels["omega"])
    _finish(axes, labels["signals"], labels["time"], "")


def _finish(axes: "Axes", title: str, x: str, y: str) -> None:
    axes.set(title=title, xlabel=x, ylabel=y)
    axes.grid(visible=True, alpha=0.3)
    axes.legend(loc="best", fontsize="small")


def _unwrapped(yaws_rad: Sequence[float]) -> list[float]:
    """Returns headings in degrees without jumps at 180 degrees."""
    degrees: list[Any] = []
    turned = 0.0
    for i, yaw in enumerate(yaws_rad):
        turned += math.remainder(yaw - yaws_rad[i - 1], math.tau) if i else yaw
        degrees.append(math.degrees(turned))
    return degrees
