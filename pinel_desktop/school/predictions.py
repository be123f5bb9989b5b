"""Predictions of the runs of real robots, and runs whose difference from them is out of the ordinary for a robot."""

import json
from collections import OrderedDict
from collections.abc import Callable, Iterator, Mapping
from contextlib import suppress
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from pinel_desktop.errors import PinelError
from pinel_desktop.execution.inputs import ScriptedInputs
from pinel_desktop.robot.robot_profile import ROOM, RobotProfile, profile_from
from pinel_desktop.runs.record import spec_of
from pinel_desktop.runs.spec import RunSpec
from pinel_desktop.school.calibrated_robots import PREDICTOR
from storage import SIMULATOR, RunFilter, RunRow, Store, StoreError

if TYPE_CHECKING:
    from pinel_desktop.judge.client import JudgeClient
    from pinel_desktop.judge.messages import PredictedRun
    from pinel_desktop.runs.difference import Difference
    from pinel_desktop.runs.outliers import Unusual

# runs of real robots that are looked at, the newest ones, and runs of one robot that a run is compared with
_MAX_RUNS, _MAX_OTHERS = 200, 30
_MAX_STORED = 300


class Predictions:
    """Asks the judge's process for predictions; thread-safe.

    Args:
        judge: returns the client of the judge.
    """

    def __init__(self, store: Store, judge: "Callable[[], JudgeClient]") -> None:
        self._store, self._judge = store, judge
        self._differences: OrderedDict[object, Difference | None] = OrderedDict()

    def of_run(self, run_id: str) -> "PredictedRun":
        """Predicts a run of a real robot, live or recorded, and compares it with its prediction.

        The calibrated robot that was recorded with the run predicts it, else the ideal one.

        Raises:
            PinelError: `prediction_simulated` for a run in the simulator, `prediction_no_robot` for a record of an
                earlier release without the robot's limits, `run_not_repeatable` for one without its program,
                `run_newer`, `run_damaged`, and `judge_lost`.
            StoreError: `run_not_found`, `run_damaged`.
        """
        row = self._store.runs.get(run_id)
        predictor = row.parameters.get(PREDICTOR)
        return self._predicted(row, predictor if isinstance(predictor, dict) else None)

    def _predicted(self, row: RunRow, predictor: Mapping[str, Any] | None) -> "PredictedRun":
        from pinel_desktop.judge.messages import PredictionRequest  # noqa: PLC0415 - heavy

        spec = self._spec(row)
        telemetry = self._store.runs.telemetry(row.id)
        return self._judge().predict(
            PredictionRequest(
                spec=spec.as_message(),
                predictor=predictor,
                events=self._store.runs.events(row.id),
                columns={name: telemetry.column(name) for name in ("x_m", "y_m", "yaw_rad")},
                truths=[(truth.source, truth.poses) for truth in self._store.truths.of_run(row.id)],
                is_whole=row.state == "finished",
            )
        )

    def unusual_runs(self) -> "Iterator[tuple[str, str, Unusual]]":
        """Yields the runs among the newest ones of real robots that are out of the ordinary for their robot.

        Each with the source of its poses.
        """
        from pinel_desktop.runs.outliers import unusual  # noqa: PLC0415 - heavy

        for runs in self._by_robot().values():
            found = {run: self._difference(run) for run in runs[: _MAX_OTHERS + 1]}
            compared = {run: one for run, one in found.items() if one is not None}
            for run, own in compared.items():
                others = [other for name, other in compared.items() if name != run]
                if (outlier := unusual(own, others)) is not None:
                    yield run, own.source, outlier

    def _spec(self, row: RunRow) -> RunSpec:
        if row.link == SIMULATOR:
            raise PinelError("prediction_simulated")
        version = self._store.versions.get(row.version_id) if row.version_id else None
        document = version.document if version else row.document
        if document is None:
            raise PinelError("run_not_repeatable")
        try:
            robot = profile_from(row.parameters["robot"])
        except (KeyError, TypeError, ValueError, PinelError) as error:
            raise PinelError("prediction_no_robot") from error
        return replace(spec_of(row, document, ScriptedInputs()), robot=robot)

    def _by_robot(self) -> dict[object, list[str]]:
        """The newest ended runs by robot, newest first."""
        robots: dict[object, list[str]] = {}
        for entry in self._store.history.page(RunFilter(world=ROOM), limit=_MAX_RUNS):
            run = entry.run
            profile = _profile(run.parameters_json)
            if run.state != "running" and profile is not None:
                robot = (run.computer_id, run.model, profile.link, profile.address)
                robots.setdefault(robot, []).append(run.id)
        return robots

    def _difference(self, run_id: str) -> "Difference | None":
        """The difference of an ended run from the ideal robot's; None without a prediction.

        From memory if it was asked for before. The runs of a robot are compared with each other, some of them from
        before its calibration: the ideal robot predicts all of them.
        """
        from pinel_desktop.runs.difference import Difference  # noqa: PLC0415 - heavy

        truths = self._store.truths.of_run(run_id)
        key = (run_id, *((truth.source, truth.measured_at) for truth in truths))
        if key not in self._differences:
            found = None
            try:
                row = self._store.runs.get(run_id)
                found = Difference.from_message(self._predicted(row, None).difference)
            except StoreError:
                return None
            except PinelError as error:
                if error.code == "judge_lost":  # the next one can predict it
                    return None
            self._differences[key] = found
            while len(self._differences) > _MAX_STORED:
                self._differences.popitem(last=False)
        return self._differences[key]


def _profile(parameters_json: str | None) -> RobotProfile | None:
    with suppress(KeyError, TypeError, ValueError, PinelError):
        parameters: Mapping[str, Any] = json.loads(parameters_json or "{}")
        return profile_from(parameters["robot"])
    return None
