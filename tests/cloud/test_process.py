"""The process of the clouds: one program in 50 robots, by the app's client."""

import json
import os
import queue
import signal
from collections.abc import Iterator
from pathlib import Path
from typing import Any
from uuid import uuid4

import psutil
import pytest

from pinel_desktop.activities import choose_activity, solution_of, world_of
from pinel_desktop.cloud.client import CloudClient
from pinel_desktop.cloud.messages import N_ROBOTS, CloudRequest
from pinel_desktop.runs.fixed_inputs import FixedInputs
from sim.world import world_document

pytestmark = pytest.mark.waits

PROGRAMS = Path(__file__).parents[1] / "programs"
SQUARE = json.loads((PROGRAMS / "square.json").read_text("utf-8"))
ENDLESS = {
    **SQUARE,
    "commands": [{"action": "forever", "commands": [{"action": "wait", "seconds": 1}]}],
}
WAIT_S = 60.0

Event = dict[str, Any]


class Clouds:
    """A client and what it has published."""

    def __init__(self) -> None:
        self.events: queue.Queue[Event] = queue.Queue()
        self.client = CloudClient(self.events.put, lambda: "pt-BR")

    def begin(
        self, document: Event, activity: str | None = None, errors: dict[str, float] | None = None
    ) -> str:
        """Starts a cloud; with an activity in its last case."""
        cloud = str(uuid4())
        judge = choose_activity(activity) if activity else None
        last = judge and judge.model_copy(update={"cases": judge.cases[-1:]})
        self.client.begin(
            CloudRequest(
                cloud=cloud,
                document=document,
                world=world_of(last) if last else world_document("empty_room"),
                model="pioneer_3dx",
                robot_parameters=errors or {},
                activity=last.model_dump_json(exclude_none=True) if last else None,
                case="a partida de lá" if judge and judge.cases[1:] else "",
                inputs=FixedInputs(),
                language="pt-BR",
            )
        )
        return cloud

    def next(self) -> Event:
        return self.events.get(timeout=WAIT_S)

    def to_the_end(self) -> tuple[list[Event], Event]:
        """Returns all rows of a cloud in the order of their seeds, and its last event."""
        rows: list[Event] = []
        while not (event := self.next())["is_over"]:
            rows += event["rows"]
        return sorted(rows, key=lambda row: int(row["seed"])), event


@pytest.fixture(scope="module")
def lasting() -> Iterator[Clouds]:
    clouds = Clouds()
    clouds.client.prepare()
    yield clouds
    clouds.client.close()


def test_all_robots_arrive_and_a_sentence_says_how_firm_the_program_is(lasting: Clouds) -> None:
    cloud = lasting.begin(SQUARE)
    rows, end = lasting.to_the_end()
    assert [row["seed"] for row in rows] == list(range(1, N_ROBOTS + 1))
    assert len({tuple(map(tuple, row["path"])) for row in rows}) == N_ROBOTS
    assert (end["cloud"], end["n"]) == (cloud, N_ROBOTS)
    assert end["text"].startswith(f"{len(end['good'])} de 50 robôs param a menos de 10 cm")


def test_the_robots_have_the_errors_of_a_calibrated_one(lasting: Clouds) -> None:
    lasting.begin(SQUARE, errors={"wheel_bias_sd": 0.0, "wheel_noise": 0.0})
    rows, _ = lasting.to_the_end()
    assert len({tuple(map(tuple, row["path"])) for row in rows}) == 1


def test_a_mission_judges_each_robot(lasting: Clouds) -> None:
    lasting.begin(SQUARE, "square")
    rows, end = lasting.to_the_end()
    assert sorted(end["good"]) == [row["seed"] for row in rows if row["well"]]
    assert f"{len(end['good'])} de 50 robôs" in end["text"]
    assert "missão" in end["text"]


def test_in_a_case_of_a_mission_they_start_there_and_the_sentence_names_the_case(
    lasting: Clouds,
) -> None:
    solution = solution_of("stop_before_wall")
    assert solution is not None
    lasting.begin(solution, "stop_before_wall")
    rows, end = lasting.to_the_end()
    start = choose_activity("stop_before_wall").cases[-1].start
    assert start is not None
    assert all(row["path"][0] == [start.x_m, start.y_m] for row in rows)
    assert end["text"].startswith(f"Com a partida de lá: {len(end['good'])} de 50 robôs fazem")


def test_stop_ends_a_cloud_and_says_how_many_came(lasting: Clouds) -> None:
    cloud = lasting.begin(ENDLESS)
    lasting.next()
    lasting.client.stop(cloud)
    rows, end = lasting.to_the_end()
    assert len(rows) < N_ROBOTS
    assert end["cloud"] == cloud


def test_a_new_cloud_ends_the_one_before(lasting: Clouds) -> None:
    earlier = lasting.begin(ENDLESS)
    cloud = lasting.begin(SQUARE)
    _, replaced = lasting.to_the_end()
    assert replaced["cloud"] == earlier
    assert replaced["text"].startswith("Outra janela começou os seus 50 robôs.")
    rows, end = lasting.to_the_end()
    assert (len([row for row in rows if row["well"]]), end["cloud"]) == (N_ROBOTS, cloud)


def test_a_killed_worker_costs_no_robot(lasting: Clouds) -> None:
    lasting.begin(SQUARE)
    first = lasting.next()
    assert lasting.client.pid is not None
    for worker in psutil.Process(lasting.client.pid).children():
        worker.kill()
    rows, _ = lasting.to_the_end()
    assert len(rows) + len(first["rows"]) == N_ROBOTS
    assert all(row["cause"] is None for row in rows)


def test_a_killed_process_is_said_and_the_next_cloud_comes() -> None:
    clouds = Clouds()
    try:
        clouds.begin(ENDLESS)
        clouds.next()
        assert clouds.client.pid is not None
        os.kill(clouds.client.pid, signal.SIGKILL)
        _, end = clouds.to_the_end()
        assert end["text"].startswith("Os 50 robôs pararam de repente.")
        clouds.begin(SQUARE)
        assert len(clouds.to_the_end()[0]) == N_ROBOTS
    finally:
        clouds.client.close()


def test_no_process_stays_when_the_app_ends() -> None:
    clouds = Clouds()
    clouds.begin(ENDLESS)
    clouds.next()
    assert clouds.client.pid is not None
    process = psutil.Process(clouds.client.pid)
    every = [process, *process.children(recursive=True)]
    assert len(every) > 1
    clouds.client.close()
    _, running = psutil.wait_procs(every, timeout=WAIT_S)
    assert running == []
