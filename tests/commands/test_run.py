"""`pinel run` on the command line."""

import json
from pathlib import Path
from typing import Any

import pytest

from storage import open_store
from tests.commands.typed import PROGRAMS, SQUARE, pinel, run_json

KEYS = {
    "state",
    "reason",
    "message",
    "run_id",
    "n_executed",
    "pose",
    "duration_s",
    "path_length_m",
    "closing_error_m",
    "estimated_closing_error_m",
    "said",
    "marks",
    "n_beeps",
    "variables",
    "faults",
    "telemetry_sha256",
}


def test_square_prints_the_object_of_the_language_and_ends_with_0() -> None:
    status, printed = run_json(SQUARE)
    assert status == 0
    assert set(printed) == KEYS
    assert (printed["state"], printed["reason"], printed["n_executed"]) == ("finished", None, 8)
    assert printed["closing_error_m"] < 1e-4
    assert abs(printed["pose"]["yaw_rad"]) < 3.5e-4
    assert printed["duration_s"] <= 17
    assert len(printed["telemetry_sha256"]) == 64


def test_run_is_kept_with_its_events_and_telemetry(home: Path) -> None:
    _, printed = run_json(SQUARE)
    with open_store(home / "pinel.db") as store:
        row = store.runs.get(printed["run_id"])
        assert row.state == "finished"
        assert row.telemetry_sha256 == printed["telemetry_sha256"]
        assert row.document is not None
        assert row.document["name"] == "square"


def test_no_store_leaves_nothing_behind(home: Path) -> None:
    _, printed = run_json(SQUARE, "--no-store")
    assert printed["run_id"] is None
    assert list(home.iterdir()) == []


def test_database_can_be_chosen(tmp_path: Path) -> None:
    other = tmp_path / "other" / "class 9ª B.db"
    run_json(SQUARE, "--db", str(other))
    assert other.exists()
    assert not (tmp_path / "pinel.db").exists()


def test_run_that_cannot_be_kept_runs_all_the_same_and_says_so(tmp_path: Path) -> None:
    folder = tmp_path / "a folder.db"
    folder.mkdir()
    result = pinel("run", SQUARE, "--json", "--db", str(folder))
    assert result.exit_code == 2  # click: a directory is no file
    (tmp_path / "file").write_text("in the way")
    result = pinel("run", SQUARE, "--json", "--db", str(tmp_path / "file" / "x.db"))
    assert result.exit_code == 0
    assert json.loads(result.stdout)["run_id"] is None
    assert result.stderr.startswith("pinel: ")


def test_gestures_answer_captures_in_order() -> None:
    _, drawn = run_json(str(PROGRAMS / "b_or_a.json"), "--gestures", "B,A", "--no-store")
    _, nothing = run_json(str(PROGRAMS / "b_or_a.json"), "--no-store")
    assert drawn["n_executed"] == 16
    assert nothing["n_executed"] == 2


def test_failed_run_ends_with_1_and_says_why_in_words() -> None:
    status, printed = run_json(str(PROGRAMS / "into_the_wall.json"), "--no-store")
    assert status == 1
    assert (printed["state"], printed["reason"]) == ("failed", "blocked")
    assert "2.77 m of 6 m" in printed["message"]


def test_program_with_faults_ends_with_2_and_prints_them() -> None:
    text = '[{"action": "move_forward", "distance": -1, "block": "kL0p"}]'
    status, printed = run_json("-", text=text)
    assert status == 2
    assert set(printed) == KEYS
    assert (printed["state"], printed["reason"], printed["pose"], printed["run_id"]) == (
        "failed",
        "invalid_program",
        None,
        None,
    )
    (fault,) = printed["faults"]
    assert fault == {
        "code": "distance_out_of_range",
        "pointer": "/0/distance",
        "block": "kL0p",
        "message": "The distance -1 is out of range.",
        "remedy": "Choose a distance in metres from 0 to 100.",
        "params": {"value": -1, "min": 0, "max": 100.0},
    }


@pytest.mark.parametrize(
    "text", ["", "{", "[" * 100_000, "[" + " " * 1_100_000 + "]", "\ufffe\x00"]
)
def test_hostile_text_ends_with_2_and_an_object(text: str) -> None:
    status, printed = run_json("-", text=text)
    assert status == 2
    assert printed["faults"]


def test_file_that_cannot_be_read_ends_with_2_and_names_it(tmp_path: Path) -> None:
    for missing in (tmp_path / "nowhere.json", tmp_path):
        status, printed = run_json(str(missing))
        assert status == 2
        assert str(missing) in printed["faults"][0]["message"]


def test_unknown_world_is_named_with_those_there_are() -> None:
    status, printed = run_json(SQUARE, "--world", "../nowhere", "--no-store")
    assert status == 2
    assert printed["reason"] == "unknown_world"
    assert "../nowhere" in printed["message"]


@pytest.mark.parametrize("name", ["own.json", "own.JSON", "own", "own.txt"])
def test_a_world_is_read_from_a_file_whatever_its_ending(name: str, tmp_path: Path) -> None:
    (tmp_path / name).write_text(json.dumps(OWN_WORLD), "utf-8")
    status, printed = run_json("-", "--world", str(tmp_path / name), "--no-store", text="[]")
    assert (status, printed["state"]) == (0, "finished")
    (tmp_path / name).write_text("{", "utf-8")
    status, printed = run_json("-", "--world", str(tmp_path / name), "--no-store", text="[]")
    assert (status, printed["reason"]) == (2, "invalid_world")


def test_same_program_has_the_same_hash_again() -> None:
    hashes = {run_json(SQUARE, "--no-store")[1]["telemetry_sha256"] for _ in range(2)}
    assert len(hashes) == 1


def test_without_json_it_prints_lines_for_people() -> None:
    result = pinel("run", SQUARE, "--no-store")
    assert "state           finished" in result.stdout
    assert "closing error   0.000 mm\n" in result.stdout
    assert "estimate" not in result.stdout


ON_WHEELS = ("--preset", "realistic", "--feedback", "odometry", "--seed", "1", "--no-store")


def test_a_robot_that_believes_that_it_is_back_is_not_reported_to_be() -> None:
    _, printed = run_json(SQUARE, *ON_WHEELS)
    assert printed["closing_error_m"] == pytest.approx(0.050, abs=0.001)
    assert printed["estimated_closing_error_m"] < 1e-4
    lines = pinel("run", SQUARE, *ON_WHEELS).stdout.splitlines()
    (pose,) = [line for line in lines if line.startswith("pose ")]
    assert pose.endswith("(the robot's estimate)")
    assert "closing error   50.321 mm" in lines
    assert "  estimated     0.001 mm" in lines


def test_what_the_robot_is_said_to_know_of_where_it_is_has_its_errors() -> None:
    help_text = " ".join(pinel("run", "--help").stdout.split())
    assert "true pose" not in help_text
    assert "a camera sees it, to about 1 mm" in help_text


def test_what_is_passed_over_in_a_bare_list_is_said() -> None:
    result = pinel("run", "-", "--no-store", text='[{"action": "stop", "status": "pending"}]')
    assert result.exit_code == 0
    assert "/0/status" in result.stderr


def test_hostile_values_end_with_2_and_an_object_that_can_be_printed() -> None:
    for text in (
        '{"pinel_ir": 1, "name": "\\ud800", "commands": [{"action": "stop", "block": "\\ud800"}]}',
        '[{"action": "repeat", "commands": [], "times": 1' + "0" * 4000 + "}]",
        '[{"action": "move_forward", "distance": 1' + "0" * 4000 + "}]",
    ):
        status, printed = run_json("-", text=text)
        assert status == 2
        assert printed["faults"]
        assert pinel("run", "-", text=text).exit_code == 2


def test_seed_beyond_its_range_is_refused() -> None:
    assert pinel("run", SQUARE, "--seed", "99999999999999999999").exit_code == 2


def test_python_text_is_run_like_its_document_from_a_file_and_from_standard_input(
    tmp_path: Path,
) -> None:
    file = tmp_path / "square.py"
    file.write_text(
        "for _ in range(4):\n    robot.move_forward(1.0)\n    robot.turn(-90)\n", "utf-8"
    )
    runs = [run_json(SQUARE), run_json(str(file)), run_json("-", text=file.read_text("utf-8"))]
    assert [status for status, _ in runs] == [0, 0, 0]
    assert len({printed["telemetry_sha256"] for _, printed in runs}) == 1


def test_faults_of_python_text_have_line_and_column() -> None:
    status, printed = run_json("-", text="robot.turn(90)\nrobot.jump()\n")
    assert (status, printed["reason"]) == (2, "invalid_program")
    params = printed["faults"][0]["params"]
    assert (params["line"], params["column"]) == (2, 1)
    result = pinel("run", "-", text="robot.turn(90)\nrobot.jump()\n")
    assert "Line 2, column 1: " in result.stdout


TALKING = {
    "pinel_ir": 1,
    "commands": [
        {"action": "ask", "question": "Name?", "variable": "name"},
        {"action": "ask", "question": "How far?", "variable": "far"},
        {"action": "set_variable", "name": "l", "value": [1, 0.5, "a", True]},
        {"action": "say", "text": {"op": "join", "args": ["Hi ", {"var": "name"}]}},
        {"action": "move_forward", "distance": {"var": "far"}},
        {"action": "mark", "symbol": "X"},
    ],
}


def test_what_was_said_and_marked_and_the_variables_are_printed() -> None:
    status, printed = run_json("-", "--no-store", "--answers", "Ana,0.5", text=json.dumps(TALKING))
    assert status == 0
    assert printed["said"] == ["Hi Ana"]
    (mark,) = printed["marks"]
    assert (mark["symbol"], mark["x_m"], mark["y_m"]) == ("X", pytest.approx(0.5, abs=1e-4), 0)
    assert printed["variables"] == {"name": "Ana", "far": 0.5, "l": [1, 0.5, "a", True]}


@pytest.mark.parametrize(
    ("options", "name"),
    [
        (["--answers", '"Silva, Ana",0.5'], "Silva, Ana"),
        (["--answers", "Ana", "--answers", "0.5"], "Ana"),
        (["--answers", '"",0'], ""),
        (["--answers", 'Bia, "0,5"'], "Bia"),
        (["--answers", "João, 0.5"], "João"),
    ],
)
def test_answers_may_hold_commas_in_quotes(options: list[str], name: str) -> None:
    status, printed = run_json("-", "--no-store", *options, text=json.dumps(TALKING))
    assert (status, printed["variables"]["name"]) == (0, name)


def test_missing_answer_fails_the_run_and_says_what_to_do() -> None:
    status, printed = run_json("-", "--no-store", "--answers", "Ana", text=json.dumps(TALKING))
    assert (status, printed["reason"]) == (1, "answer_missing")
    assert "How far?" in printed["message"]
    assert printed["variables"] == {"name": "Ana"}


def test_for_people_it_prints_what_was_said_marked_and_kept() -> None:
    lines = pinel("run", "-", "--no-store", "--answers", "Ana,0.5", text=json.dumps(TALKING)).stdout
    assert "said            Hi Ana" in lines
    assert "marked          X at x 0.500 m, y 0.000 m" in lines
    assert "variable        far = 0.5" in lines


def test_seed_decides_what_is_drawn(home: Path) -> None:
    draw = {"action": "say", "text": {"op": "random_int", "args": [1, 1_000_000]}}
    text = json.dumps([draw, draw])
    texts = [
        run_json("-", "--no-store", "--seed", str(seed), text=text)[1]["said"] for seed in (1, 1, 2)
    ]
    assert texts[0] == texts[1] != texts[2]
    assert texts[0][0] != texts[0][1]
    assert (
        run_json("-", "--no-store", text=text)[1]["said"]
        == run_json("-", "--seed", "0", text=text)[1]["said"]
    )


def test_answers_and_events_of_a_program_are_kept(home: Path) -> None:
    _, printed = run_json("-", "--answers", "Ana,0.5", text=json.dumps(TALKING))
    with open_store(home / "pinel.db") as store:
        row = store.runs.get(printed["run_id"])
        types = {event["type"] for event in store.runs.events(printed["run_id"])}
    assert row.state == "finished"
    assert {"asked", "answered", "said", "marked", "watch"} <= types


OWN_WORLD: dict[str, Any] = {
    "pinel_world": 1,
    "name": "corridor",
    "title": "Corredor",
    "size_m": [6, 1],
    "start": {"x_m": -2, "y_m": 0, "heading_deg": 0},
    "walls": [{"from": [1, -0.5], "to": [1, 0.5]}],
}


def test_a_world_in_a_file_is_run_in_and_kept_with_the_run(home: Path) -> None:
    (home / "corridor.json").write_text(json.dumps(OWN_WORLD), "utf-8")
    go = '[{"action": "move_forward", "distance": 4}]'
    status, printed = run_json("-", "--world", str(home / "corridor.json"), text=go)
    assert (status, printed["reason"]) == (1, "blocked")
    assert printed["pose"]["x_m"] == pytest.approx(3 - 0.2225 - 0.01, abs=0.002)
    store = open_store(home / "pinel.db")
    run = store.runs.get(printed["run_id"])
    store.close()
    assert run.world == "corridor"
    assert run.world_document["walls"] == OWN_WORLD["walls"]


def test_faults_of_a_world_end_with_2_and_are_told_in_words(home: Path) -> None:
    file = home / "crossing.json"
    walls = [{"from": [1, -0.5], "to": [2, 0.5]}, {"from": [1, 0.5], "to": [2, -0.5]}]
    file.write_text(json.dumps({**OWN_WORLD, "walls": walls}), "utf-8")
    status, printed = run_json(SQUARE, "--world", str(file))
    assert (status, printed["reason"], set(printed)) == (2, "invalid_world", KEYS)
    (fault,) = printed["faults"]
    assert (fault["pointer"], fault["message"]) == ("/walls/1", "Walls 1 and 2 cross.")
    lines = pinel("run", SQUARE, "--world", str(file))
    assert lines.exit_code == 2
    assert "/walls/1: Walls 1 and 2 cross." in lines.stdout


def test_a_world_s_file_that_cannot_be_read_ends_with_2_and_names_it(home: Path) -> None:
    (home / "folder.json").mkdir()
    for missing in ("nowhere.json", "folder.json", "null\0.json"):
        status, printed = run_json(SQUARE, "--world", str(home / missing))
        assert (status, printed["reason"]) == (2, "invalid_world")
        assert missing[:4] in printed["faults"][0]["message"]


def test_the_start_must_have_room_for_the_robot_that_runs(home: Path) -> None:
    file = home / "narrow.json"
    start = {"x_m": 0.85, "y_m": 0, "heading_deg": 0}
    file.write_text(json.dumps({**OWN_WORLD, "start": start}), "utf-8")
    _, printed = run_json("-", "--world", str(file), text="[]")
    assert [fault["code"] for fault in printed["faults"]] == ["start_in_wall"]
    small, _ = run_json("-", "--world", str(file), "--model", "small_robot", text="[]")
    assert small == 0


def test_what_a_real_robot_cannot_sense_is_a_fault_before_it_moves(tmp_path: Path) -> None:
    file = tmp_path / "floor.py"
    file.write_text('robot.move_forward(0.5)\nif robot.floor == "black":\n    robot.stop()\n')
    status, printed = run_json(str(file), "--robot", "bridge", "--bridge", "127.0.0.1:0")
    assert status == 2
    assert [fault["code"] for fault in printed["faults"]] == ["sensor_missing"]
    assert printed["n_executed"] == 0


@pytest.mark.parametrize(
    ("options", "reason"),
    [
        (["--set", "track_m=0.35"], "robot_parameters_ideal"),
        (["--preset", "realistic", "--set", "track_m=9"], "robot_parameter_range"),
        (["--preset", "realistic", "--set", "track_m"], "robot_parameter_unclear"),
        (["--preset", "realistic", "--set", "track_m=wide"], "robot_parameter_unclear"),
        (["--preset", "realistic", *["--set", "lag_s=0.1"] * 2], "robot_parameter_unclear"),
        (["--preset", "realistic", "--set", "wings=2"], "unknown_robot_parameter"),
    ],
)
def test_wrong_parameter_of_the_robot_is_named_before_the_run(
    options: list[str], reason: str
) -> None:
    status, printed = run_json(SQUARE, *options)
    assert (status, printed["reason"], printed["run_id"]) == (2, reason, None)
    assert printed["message"]
