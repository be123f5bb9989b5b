"""Runs on a real robot in a store: a hidden robot drives, the store records what a real one would give."""

import math
import random
from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from pinel_desktop.events.event_sequencer import EventSequencer
from pinel_desktop.events.model import Telemetry
from pinel_desktop.program.sources import read_source
from pinel_desktop.robot import RobotParameters
from pinel_desktop.robot.robot_profile import ROOM, DdsProfile
from pinel_desktop.runs.record import record_of
from pinel_desktop.runs.spec import RunSpec
from storage import RunRecorder, Store, TruePoseRow
from tests.calibration.hidden_robot import PATTERN, TAPE_M, TAPE_RAD, rows_of
from tests.storage.sample_runs import ended

ROBOT = RobotParameters(
    track_m=0.345, wheel_bias_left=0.012, wheel_bias_right=-0.008, wheel_bias_sd=0.0
)


def real_run(
    store: Store,
    program: str,
    *,
    hidden: RobotParameters = ROBOT,
    seed: int = 1,
    domain: int = 0,
    version_id: str | None = None,
) -> tuple[str, list[Telemetry]]:
    """Records a run; returns its id and its telemetry with the true poses, which the record lacks."""
    read: Any = read_source(program.encode(), "program.py").document
    profile = DdsProfile(domain=domain)
    spec = RunSpec(read, profile.room.as_world(), link="dds", robot=profile, seed=seed)
    row = store.runs.begin(
        record_of(spec, world_name=ROOM, app_version="0.3", version_id=version_id)
    )
    rows, sequencer, recorder = (
        rows_of(program, hidden, seed),
        EventSequencer(row.id),
        RunRecorder(store),
    )
    for tick, one in enumerate(rows, 1):
        shown = replace(one, true_x_m=None, true_y_m=None, true_yaw_rad=None)
        recorder(sequencer.wire(tick, shown))
    recorder(ended(row.id, len(rows), len(rows)))
    return row.id, rows


def true_end(rows: list[Telemetry], dice: random.Random) -> TruePoseRow:
    """The pose at the end as a person with a tape measures it."""
    end = rows[-1]
    return (
        None,
        (end.true_x_m or 0.0) + dice.gauss(0.0, TAPE_M),
        (end.true_y_m or 0.0) + dice.gauss(0.0, TAPE_M),
        math.remainder((end.true_yaw_rad or 0.0) + dice.gauss(0.0, TAPE_RAD), math.tau),
        TAPE_M,
        TAPE_RAD,
    )


def measured_run(store: Store, program: str, seed: int, **more: Any) -> str:
    """Records a run whose end was measured with a tape; returns its id."""
    run, rows = real_run(store, program, seed=seed, **more)
    store.truths.record(run, "tape", [true_end(rows, random.Random(seed))])
    return run


def measured_pattern(store: Store, pattern: Sequence[str] = PATTERN, **more: Any) -> list[str]:
    """Records runs of a pattern, measured with a tape; returns the ids."""
    return [measured_run(store, program, seed, **more) for seed, program in enumerate(pattern, 1)]
