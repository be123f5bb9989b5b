"""The review of a long lesson of a large class, beside reading and parsing what it looks into."""

import random
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

from pinel_desktop.app import App
from storage import RunStart, Store
from tests.school.review.sketches import Body, Sketch, move, start, workspace_of
from tests.web.browser import Browser
from tests.web.fake_engine import FakeEngine

N_GROUPS, N_VERSIONS, N_RUNS = 12, 150, 30
N_BLOCKS = 60
REPEATS = 5
MAX_RATIO = 8.0


def program() -> list[Body]:
    """As long as programs get in a lesson: loops with motions in them."""
    loops: Body = [
        Sketch(
            f"r{n}",
            "repeat",
            numbers={"TIMES": 4},
            bodies={"DO": [move(f"m{n}-{i}") for i in range(4)]},
        )
        for n in range(N_BLOCKS // 5)
    ]
    return [[start(), *loops]]


def work(store: Store, classroom: str, group_name: str) -> None:
    """Edits with a run after every fifth, half of which fail."""
    group = store.groups.create(group_name, classroom_id=classroom)
    key = store.programs.create(group.id, "Quadrado").id
    stacks, chance = program(), random.Random(group_name)
    motions = [one for block in stacks[0] for one in block.all() if one.type == "move_forward"]
    for number in range(N_VERSIONS):
        chance.choice(motions).numbers["DISTANCE"] = number + 2
        version = store.versions.save(key, workspace_of(*stacks), {"commands": []})
        if number % (N_VERSIONS // N_RUNS) == 0:
            world = {"name": "w", "walls": [[x, x] for x in range(300)]}
            run = store.runs.begin(RunStart("sim", "w", world, 0, "1", version_id=version.id))
            state = chance.choice(["failed", "finished"])
            store._database.write(_ending(run.id, state))


def _ending(run_id: str, state: str) -> Callable[[Any], int]:
    change = "UPDATE runs SET state = ?, duration_s = 6, ended_at = started_at WHERE id = ?"
    return lambda db: int(db.execute(change, [state, run_id]).rowcount)


def seconds(call: Callable[[], object]) -> float:
    """The shortest of a few."""
    durations_s = []
    for _ in range(REPEATS):
        begin = time.perf_counter()
        call()
        durations_s.append(time.perf_counter() - begin)
    return min(durations_s)


def test_the_review_of_a_long_lesson_takes_a_few_times_what_reading_its_parts_takes(
    tmp_path: Path,
) -> None:
    with App(tmp_path / "pinel.db", make_engine=FakeEngine) as app:
        teacher = Browser.signed_in(app.address)
        teacher.put("/api/teacher/pin", {"pin": "314159"})
        store = app._store
        classroom = store.classrooms.create("9º A").id
        lesson = store.lessons.open(classroom, "Aula 7").id
        for number in range(N_GROUPS):
            work(store, classroom, f"Grupo {number}")
        place = f"/api/lessons/{lesson}/review"
        groups = teacher.get(place).data["groups"]
        marks = [mark for group in groups for mark in group["entries"]]
        assert len(groups) == N_GROUPS
        assert sum(group["figures"]["n_edits"] for group in groups) == N_GROUPS * N_VERSIONS
        version_ids = {mark["version_id"] for mark in marks}
        review_s = seconds(lambda: teacher.get(place))
        table_s = seconds(lambda: teacher.get(f"{place}.csv"))
        parts_s = seconds(
            lambda: (
                store.lesson_histories.of([lesson]),
                store.lesson_histories.workspaces(version_ids),
            )
        )
    print(
        f"\n{N_GROUPS} groups, {N_VERSIONS} versions of {N_BLOCKS} blocks and {N_RUNS} runs each:"
        f" review {review_s * 1000:.0f} ms, table {table_s * 1000:.0f} ms,"
        f" its {len(version_ids)} versions alone {parts_s * 1000:.0f} ms"
    )
    assert review_s < MAX_RATIO * parts_s
