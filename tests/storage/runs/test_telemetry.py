"""The codec of telemetry."""

import json
import struct

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from storage.runs.simplify_path import MAX_POINTS, outline
from storage.runs.telemetry import COLUMNS, STEPS, Telemetry, joined, pack, rows_of, unpack
from tests.storage.sample_runs import sample, square

STEP = np.array(list(STEPS.values()))
OF_RELEASE_0_1 = "78da6360646448496100831d4824174c908141848181910109702391b4020d0d400200c5360438"
figures = st.floats(-1e4, 1e4) | st.just(float("nan"))


@given(st.lists(st.lists(figures, min_size=len(COLUMNS), max_size=len(COLUMNS)), max_size=40))
def test_what_was_packed_comes_back_to_half_a_step(rows: list[list[float]]) -> None:
    given_rows = np.array(rows, dtype=np.float64).reshape(-1, len(COLUMNS))
    back = unpack(pack(given_rows), len(given_rows))
    assert np.array_equal(np.isnan(back), np.isnan(given_rows))
    assert np.all(np.isnan(back) | (np.abs(back - given_rows) <= STEP * 0.5000001))


@pytest.mark.parametrize("value", [1e300, -1e300, float("inf"), float("-inf")])
def test_a_value_beyond_all_measure_is_kept_at_the_limit_and_disturbs_no_other(
    value: float,
) -> None:
    rows = rows_of([sample("r", 0), sample("r", 1, v_mps=value), sample("r", 2)])
    back = Telemetry(unpack(pack(rows), 3))
    assert back.column("v_mps")[[0, 2]] == pytest.approx([0.3, 0.3])
    assert np.isfinite(back.column("v_mps")).all()


def test_a_minute_takes_at_most_60_kilobytes_in_chunks_of_a_second() -> None:
    events = list(square("r", laps=5))[:1800]
    n_bytes = sum(len(pack(rows_of(events[first : first + 30]))) for first in range(0, 1800, 30))
    print(f"telemetry: {n_bytes / 1000:.1f} KB a minute")
    assert n_bytes <= 60_000


def test_a_noisy_minute_takes_at_most_60_kilobytes() -> None:
    rng = np.random.default_rng(1)
    rows = rows_of(list(square("r", laps=5))[:1800])
    rows[:, 1:11] += rng.normal(0, 0.002, (1800, 10))
    n_bytes = sum(len(pack(rows[first : first + 30])) for first in range(0, 1800, 30))
    print(f"noisy telemetry: {n_bytes / 1000:.1f} KB a minute")
    assert n_bytes <= 60_000


def test_what_was_packed_before_true_poses_were_kept_reads_as_before_without_them() -> None:
    # a chunk of three rows and 13 columns, packed by release 0.1.0
    blob = bytes.fromhex(OF_RELEASE_0_1)
    back = Telemetry(unpack(blob, 3))
    assert back.column("x_m") == pytest.approx([0.0, 0.01, 0.02])
    assert back.column("bumper").tolist() == [0, 0, 1]
    assert np.isnan(back.column("done")).tolist() == [False, True, False]
    assert np.isnan(back.column("true_x_m")).all()
    assert json.loads(back.to_wire()[4:].split(b"}")[0] + b"}")["columns"][-1] == "true_yaw_rad"


def test_chunks_are_joined_in_their_order() -> None:
    rows = rows_of(square("r"))
    chunks = [(pack(part), len(part)) for part in np.array_split(rows, 12)]
    assert joined(chunks).column("tick").tolist() == list(range(len(rows)))
    assert joined([]).rows.shape == (0, len(COLUMNS))


def test_the_wire_form_is_an_aligned_header_and_float32_columns() -> None:
    wire = Telemetry(rows_of([sample("r", 0), sample("r", 1, done=None, bumper=True)])).to_wire()
    (length,) = struct.unpack_from("<I", wire)
    header = json.loads(wire[4 : 4 + length])
    assert length % 4 == 0
    assert header == {"columns": list(COLUMNS), "rows": 2, "rate_hz": 30}
    columns = np.frombuffer(wire, "<f4", offset=4 + length).reshape(len(COLUMNS), 2)
    found = dict(zip(header["columns"], columns.tolist(), strict=True))
    assert found["tick"] == [0, 1]
    assert found["x_m"] == pytest.approx([0.0, 0.01])
    assert found["bumper"] == [0, 1]
    assert found["done"][0] == 0
    assert np.isnan(found["done"][1])


def test_the_outline_of_a_square_has_five_points() -> None:
    rows = Telemetry(rows_of(square("r")))
    points = outline(rows.rows[:, 1:3])
    assert len(points) == 5
    assert np.allclose(points, [[0, 0], [1, 0], [1, 1], [0, 1], [0, 0]], atol=0.02)


@pytest.mark.parametrize("laps", [2, 30])
def test_the_outline_of_many_rounds_looks_like_one(laps: int) -> None:
    rows = Telemetry(rows_of(square("r", laps=laps)))
    points = np.array(outline(rows.rows[:, 1:3]))
    assert len(points) <= MAX_POINTS
    for corner in ([0, 0], [1, 0], [1, 1], [0, 1]):
        assert np.hypot(*(points - corner).T).min() < 0.03
    assert np.hypot(*np.diff(points, axis=0).T).max() < 1.05  # along the sides, never across


def test_the_outline_of_a_scribble_has_at_most_64_points_and_begins_where_it_began() -> None:
    rng = np.random.default_rng(3)
    points = np.cumsum(rng.normal(0, 0.05, (5000, 2)), axis=0)
    simplified = outline(points)
    assert 16 < len(simplified) <= MAX_POINTS
    assert np.allclose(simplified[0], points[0], atol=1e-4)


def test_the_outline_of_nothing_is_nothing() -> None:
    assert outline(np.empty((0, 2))) == []
    assert outline(np.zeros((9, 2))) == [[0, 0], [0, 0]]
