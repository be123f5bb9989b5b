"""Requests of the app to the judge, and verdicts, as plain data for JSON lines."""

import base64
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pinel_desktop.activities.run_log import COLUMNS
from pinel_desktop.events.app_events import JudgedCase


@dataclass(frozen=True, slots=True)
class ObservedRun:
    """A run that a group observed.

    Attributes:
        world: the world's document.
        parameters: parameters of the run's record: the robot's setting.
        columns: telemetry by column, each of shape (n,), NaN for null.
        events: all events except telemetry, in their wire form.
    """

    world: Mapping[str, Any]
    parameters: Mapping[str, Any]
    columns: Mapping[str, NDArray[np.float64]]
    events: tuple[Mapping[str, Any], ...]

    def as_message(self) -> dict[str, Any]:
        """Returns the run as plain data."""
        columns = {name: _packed(self.columns[name]) for name in COLUMNS}
        plain = {"world": dict(self.world), "parameters": dict(self.parameters)}
        return {**plain, "columns": columns, "events": [dict(event) for event in self.events]}

    @classmethod
    def from_message(cls, message: Mapping[str, Any]) -> "ObservedRun":
        """Reads the run from plain data."""
        columns = {name: _unpacked(text) for name, text in message["columns"].items()}
        return cls(message["world"], message["parameters"], columns, tuple(message["events"]))


@dataclass(frozen=True, slots=True)
class JudgeRequest:
    """A program to be judged.

    Attributes:
        activity: the activity as JSON.
        document: the program's document.
        world: name of the world in which the group ran the program.
        observed: the group's run; None if it is no evidence, such as a run that was stopped.
        language: language of the texts for the group.
    """

    activity: str
    document: Mapping[str, Any]
    world: str
    observed: ObservedRun | None
    language: str

    def as_message(self) -> dict[str, Any]:
        """Returns the request as plain data."""
        return {
            "activity": self.activity,
            "document": dict(self.document),
            "world": self.world,
            "observed": self.observed.as_message() if self.observed else None,
            "language": self.language,
        }

    @classmethod
    def from_message(cls, message: Mapping[str, Any]) -> "JudgeRequest":
        """Reads the request from plain data."""
        observed = ObservedRun.from_message(message["observed"]) if message["observed"] else None
        activity, document = message["activity"], message["document"]
        return cls(activity, document, message["world"], observed, message["language"])


@dataclass(frozen=True, slots=True)
class Verdict:
    """The judge's verdict on a program.

    Attributes:
        passed: whether every case passes; None if a run on a real robot cannot be judged.
        missing: text for the group about why the program does not pass yet; None if it passes.
        cases: the report of each case, in the form of the store.
        block: id of the block that `missing` is about.
        tried: every case of an activity with several cases, in the form of the event `judged`.
        not_judged: the reason why a run on a real robot was not judged, from `activities.recorded`.
    """

    passed: bool | None
    missing: str | None
    cases: list[dict[str, Any]]
    block: str | None = None
    tried: list[JudgedCase] = field(default_factory=list)
    not_judged: str | None = None


@dataclass(frozen=True, slots=True)
class RunStartInfo:
    """The start of a run for live evaluation, and for a verdict at its end.

    Attributes:
        activity: the activity as JSON.
        document: the program's document.
        world: the world's document.
        parameters: parameters of the run's record: the robot's setting.
    """

    activity: str
    document: Mapping[str, Any]
    world: Mapping[str, Any]
    parameters: Mapping[str, Any]


@dataclass(frozen=True, slots=True)
class RunUpdate:
    """The events of a live run since the last update.

    Attributes:
        run: id of the run.
        start_info: the start of the run, in its first update only.
        events: the new events, in their wire form.
        language: language of the texts for the group.
    """

    run: str
    start_info: RunStartInfo | None
    events: Sequence[Mapping[str, Any]]
    language: str

    def as_message(self) -> dict[str, Any]:
        """Returns the update as plain data."""
        start_info = None
        if self.start_info is not None:
            start_info = {
                "activity": self.start_info.activity,
                "document": dict(self.start_info.document),
                "world": dict(self.start_info.world),
                "parameters": dict(self.start_info.parameters),
            }
        events = [dict(event) for event in self.events]
        return {
            "follow": self.run,
            "start_info": start_info,
            "events": events,
            "language": self.language,
        }

    @classmethod
    def from_message(cls, message: Mapping[str, Any]) -> "RunUpdate":
        """Reads the update from plain data."""
        start_info = RunStartInfo(**message["start_info"]) if message["start_info"] else None
        return cls(message["follow"], start_info, message["events"], message["language"])


@dataclass(frozen=True, slots=True)
class PredictionRequest:
    """A run of a real robot, live or recorded, to be predicted.

    Attributes:
        spec: the run's spec as `RunSpec.as_message`, with the profile of its robot.
        predictor: record of the calibrated robot that predicts (`school.calibrated_robots`); None for the ideal one.
        events: all events but telemetry so far, in wire format.
        columns: the robot's own poses by column, each of shape (n,): `x_m`, `y_m`, `yaw_rad`.
        truths: sources of truth, each with its poses as the store has them.
        is_whole: whether the run came to its end.
    """

    spec: Mapping[str, Any]
    predictor: Mapping[str, Any] | None
    events: Sequence[Mapping[str, Any]]
    columns: Mapping[str, NDArray[np.float64]]
    truths: Sequence[tuple[Any, Any]]
    is_whole: bool

    def as_message(self) -> dict[str, Any]:
        """Returns the request as plain data."""
        return {
            "predict": dict(self.spec),
            "predictor": self.predictor and dict(self.predictor),
            "events": [dict(event) for event in self.events],
            "columns": {name: _packed(column) for name, column in self.columns.items()},
            "truths": [list(truth) for truth in self.truths],
            "is_whole": self.is_whole,
        }

    @classmethod
    def from_message(cls, message: Mapping[str, Any]) -> "PredictionRequest":
        """Reads the request from plain data."""
        columns = {name: _unpacked(text) for name, text in message["columns"].items()}
        truths, is_whole = message["truths"], message["is_whole"]
        spec, predictor = message["predict"], message["predictor"]
        return cls(spec, predictor, message["events"], columns, truths, is_whole)


@dataclass(frozen=True, slots=True)
class PredictedRun:
    """The prediction of a run, and the run beside it; as plain data.

    Attributes:
        robot: name of the calibrated robot that predicts; None for the ideal one.
        within_m: distance from the predicted end within which 95 of 100 runs end; None if the robot does not state it.
        path: every third true pose of the prediction and the last one, as `[tick, x_m, y_m, yaw_rad]`, in the start
            frame; the heading has no jumps.
        steps: the steps of the prediction (`runs.prediction.Step`).
        awaits_input, is_cut, reads_sensors, knows_room: as in `runs.prediction.Prediction`.
        difference: `runs.difference.Difference`.
    """

    robot: str | None
    within_m: float | None
    path: list[tuple[float, ...]]
    steps: list[dict[str, Any]]
    awaits_input: bool
    is_cut: bool
    reads_sensors: bool
    knows_room: bool
    difference: dict[str, Any]


def _packed(column: NDArray[np.float64]) -> str:
    return base64.b64encode(np.ascontiguousarray(column, dtype="<f8").tobytes()).decode("ascii")


def _unpacked(text: str) -> NDArray[np.float64]:
    return np.frombuffer(base64.b64decode(text), dtype="<f8").astype(np.float64)
