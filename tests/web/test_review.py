"""The review over HTTP: a lesson's review, its table, differences between versions, the history of runs."""

import csv
import io
import json
from datetime import datetime
from typing import Any

import pytest

from pinel_desktop.app import App
from pinel_desktop.messages import LANGUAGES, describe
from pinel_desktop.web.models.review import Figures
from tests.school.review.sketches import Sketch, move, start, workspace_of
from tests.storage.sample_runs import ended
from tests.web.browser import Browser
from tests.web.conftest import SQUARE
from tests.web.fake_engine import FakeEngine
from tests.web.test_worlds import OWN

PIN = "314159"


class Pupils:
    """A group of a class that works over HTTP; the test decides how its runs end."""

    def __init__(self, browser: Browser, app: App, classroom: str, name: str) -> None:
        assert isinstance(app._engine, FakeEngine)
        self.browser, self.store, self.engine = browser, app._store, app._engine
        new_group = {"name": name, "classroom_id": classroom}
        self.group = browser.post("/api/groups", new_group).data
        place = f"/api/groups/{self.group['id']}/programs"
        self.program = browser.post(place, {"name": f"=Programa de {name}"}).data

    def edit(self, *blocks: Sketch, **more: Any) -> str:
        body = {"workspace": workspace_of([start(), *blocks]), "document": SQUARE, **more}
        place = f"/api/programs/{self.program['id']}/versions"
        return str(self.browser.post(place, body).data["id"])

    def run(
        self,
        version: str,
        state: str = "finished",
        reason: Any = None,
        passed: Any = None,
        world: str = "empty_room",
    ) -> str:
        body = {"version_id": version, "world": world}
        run_id = str(self.browser.post("/api/runs", body).data["id"])
        self.engine.send(ended(run_id, 0, 75, state=state, reason=reason))
        activity = None if passed is None else "square"
        self.store._database.write(
            lambda db: (
                db.execute(
                    "UPDATE runs SET passed = ?, activity = ? WHERE id = ?",
                    [passed, activity, run_id],
                ).rowcount
            )
        )
        return run_id


@pytest.fixture
def teacher(app: App) -> Browser:
    tab = Browser.signed_in(app.address)
    assert tab.put("/api/teacher/pin", {"pin": PIN}).status == 200
    return tab


@pytest.fixture
def ninth(teacher: Browser) -> str:
    return str(teacher.post("/api/classrooms", {"name": "9º A"}).data["id"])


@pytest.fixture
def lesson(teacher: Browser, ninth: str) -> Any:
    place = f"/api/classrooms/{ninth}/lessons"
    return teacher.post(place, {"title": "Aula 7"}).data


@pytest.fixture
def pupils(browser: Browser, app: App, ninth: str, lesson: Any) -> Pupils:
    return Pupils(browser, app, ninth, "Os Robôs")


def test_the_review_of_a_lesson_tells_what_each_group_did(
    teacher: Browser, browser: Browser, app: App, pupils: Pupils, lesson: Any, ninth: str
) -> None:
    pupils.edit(move())
    first = pupils.edit(move(), move("n"))
    crashed = pupils.run(first, "failed", "interrupted", passed=0)
    second = pupils.edit(move(metres=0.5), move("n"))
    repaired = pupils.run(second, passed=1)
    Pupils(browser, app, ninth, "Abelhas").edit()

    found = teacher.get(f"/api/lessons/{lesson['id']}/review").data
    assert found["lesson"]["title"] == "Aula 7"
    assert [one["group"]["name"] for one in found["groups"]] == ["Abelhas", "Os Robôs"]
    robots = found["groups"][1]
    assert robots["group"] == {key: pupils.group[key] for key in ("id", "name", "color", "picture")}
    marks = robots["entries"]
    assert [(mark["kind"], mark["version_id"], mark["number"]) for mark in marks] == [
        ("edit", first, 2),
        ("run", first, 2),
        ("edit", second, 3),
        ("run", second, 3),
    ]
    counts = [mark["changes"] and tuple(mark["changes"].values()) for mark in marks]
    assert counts == [(2, 0, 0, 0), None, (0, 0, 1, 0), (0, 0, 1, 0)]
    assert [mark["n_edits"] for mark in marks] == [2, None, 1, None]
    failed = marks[1]
    assert (failed["state"], failed["reason"], failed["passed"]) == ("failed", "interrupted", False)
    assert failed["message"]
    assert (marks[3]["repairs"], marks[3]["since"]) == (crashed, first)
    assert marks[3]["run_id"] == repaired
    assert {mark["computer"] for mark in marks} == {app._store.computers.this()[1]}
    figures = robots["figures"]
    assert (figures["n_edits"], figures["n_runs"], figures["n_failed"]) == (3, 2, 1)
    assert figures["attempts_until_passed"] == 2
    assert 0 <= figures["time_to_first_run_s"] < 60
    assert robots["blocks"] == [{"type": "move_forward", "count": 2, "loose": 0}]


def test_another_world_speed_or_hint_is_no_change_of_blocks(
    teacher: Browser, pupils: Pupils, lesson: Any
) -> None:
    setup = {"world": "maze", "speed": 2.0, "activity": "square"}
    pupils.edit(move())
    pupils.edit(move(), setup=setup)
    pupils.edit(move(), setup={**setup, "n_hints": 1})
    last = pupils.edit(move(metres=2), setup={**setup, "n_hints": 2})
    pupils.run(last)
    hint = pupils.edit(move(metres=2), setup={**setup, "n_hints": 3})
    assert pupils.edit(move(metres=2), setup={**setup, "n_hints": 3}, world=OWN) != hint
    found = teacher.get(f"/api/lessons/{lesson['id']}/review").data["groups"][0]
    assert [(mark["kind"], mark["n_edits"]) for mark in found["entries"]] == [
        ("edit", 2),
        ("run", None),
    ]
    assert (found["figures"]["n_edits"], found["figures"]["n_hints"]) == (2, 3)
    line = teacher.get(f"/api/programs/{pupils.program['id']}/versions").data["versions"]
    assert [mark["setup_only"] for mark in line] == [True, True, False, True, True, False]


def test_a_joined_lesson_is_part_of_the_review(
    teacher: Browser, pupils: Pupils, lesson: Any, ninth: str
) -> None:
    pupils.edit(move())
    place = f"/api/classrooms/{ninth}/lessons"
    other = teacher.post(place, {"title": "Aula 8"}).data
    pupils.edit(move(metres=2))
    review = f"/api/lessons/{lesson['id']}/review"
    assert teacher.get(review).data["groups"][0]["figures"]["n_edits"] == 1
    teacher.patch(f"/api/lessons/{other['id']}", {"part_of": lesson["id"]})
    assert teacher.get(review).data["groups"][0]["figures"]["n_edits"] == 2


def test_joined_lessons_of_two_activities_count_the_attempts_of_either(
    teacher: Browser, pupils: Pupils, lesson: Any, ninth: str
) -> None:
    teacher.patch(f"/api/lessons/{lesson['id']}", {"activity": "maze"})
    version = pupils.edit(move(metres=1))
    pupils.run(version, passed=False)
    pupils.run(version, passed=True)  # at the square

    def attempts() -> Any:
        review = teacher.get(f"/api/lessons/{lesson['id']}/review").data
        return review["groups"][0]["figures"]["attempts_until_passed"]

    assert attempts() is None
    more = {"title": "Aula 8", "activity": "square"}
    other = teacher.post(f"/api/classrooms/{ninth}/lessons", more).data
    teacher.patch(f"/api/lessons/{other['id']}", {"part_of": lesson["id"]})
    assert attempts() == 2


@pytest.mark.parametrize(("language", "comma", "point"), [("pt-BR", ";", ","), ("en", ",", ".")])
def test_the_table_has_a_row_for_each_mark(
    teacher: Browser, pupils: Pupils, lesson: Any, language: str, comma: str, point: str
) -> None:
    pupils.run(pupils.edit(move()), "failed", "interrupted")
    pupils.run(pupils.edit(move(metres=2)))
    teacher.put("/api/settings", {"language": language})
    answer = teacher.get(f"/api/lessons/{lesson['id']}/review.csv")
    assert answer.headers["Content-Type"] == "text/csv; charset=utf-8"
    assert answer.text.startswith("\ufeff")
    header, *rows = csv.reader(io.StringIO(answer.text[1:]), delimiter=comma)
    assert header[0] == {"pt-BR": "Grupo", "en": "Group"}[language]
    assert [len(row) for row in rows] == [len(header)] * 4
    assert "review_" not in answer.text  # the code of a missing text
    assert {row[0] for row in rows} == {"Os Robôs"}
    assert {row[4] for row in rows} == {"'=Programa de Os Robôs"}
    assert rows[1][15] == f"2{point}5"
    assert rows[3][16] == rows[1][2]
    assert rows[0][6:11] == ["1", "1", "0", "0", "0"]
    assert header[-2:] == {"pt-BR": ["Aula", "Mundo"], "en": ["Lesson", "World"]}[language]
    assert {row[-2] for row in rows} == {lesson["title"]}


def test_the_table_calls_an_activity_by_its_title(
    teacher: Browser, pupils: Pupils, lesson: Any
) -> None:
    pupils.run(pupils.edit(move()), passed=True)
    teacher.put("/api/settings", {"language": "pt-BR"})
    text = teacher.get(f"/api/lessons/{lesson['id']}/review.csv").text
    assert ";Um quadrado de 1 m;" in text
    assert ";square;" not in text


def test_the_table_names_the_world_of_each_run_and_the_lesson_that_was_joined(
    teacher: Browser, pupils: Pupils, lesson: Any, ninth: str
) -> None:
    pupils.run(pupils.edit(move()))
    more = teacher.post(f"/api/classrooms/{ninth}/lessons", {"title": "Segunda parte"}).data
    pupils.run(pupils.edit(move(metres=3)), world="maze")
    teacher.patch(f"/api/lessons/{more['id']}", {"part_of": lesson["id"]})
    teacher.put("/api/settings", {"language": "pt-BR"})
    text = teacher.get(f"/api/lessons/{lesson['id']}/review.csv").text
    ends = [row[-2:] for row in csv.reader(io.StringIO(text), delimiter=";")][1:]
    assert ends == [
        [lesson["title"], ""],
        [lesson["title"], "Sala vazia"],
        ["Segunda parte", ""],
        ["Segunda parte", "Labirinto"],
    ]


def test_the_review_says_who_needs_what_and_which_hints_were_read(
    teacher: Browser, pupils: Pupils, lesson: Any
) -> None:
    setup = {"world": "empty_room", "activity": "square", "n_hints": 2}
    version = pupils.edit(move(), setup=setup)
    runs = [pupils.run(version, "failed", "blocked") for _ in range(3)]
    advice = {"words": {"pt-BR": "Vejam o giro."}, "diagnosis": 1}
    pupils.store._database.write(
        lambda db: (
            db.execute(
                "UPDATE runs SET passed = 0, activity = 'square', check_report = ? WHERE id = ?",
                [json.dumps({"cases": [{"advice": None}, {"advice": advice}]}), runs[0]],
            ).rowcount
        )
    )
    other = teacher.post(
        "/api/groups", {"name": "Emas", "classroom_id": lesson["classroom_id"]}
    ).data
    teacher.put("/api/settings", {"language": "pt-BR"})
    review = teacher.get(f"/api/lessons/{lesson['id']}/review").data
    (mine,) = review["groups"]
    assert (mine["need"], review["summary"]["not_begun"]) == ("help", [other["name"]])
    assert mine["sentence"] == "2 batidas seguidas."
    (hints,) = mine["hints"]
    assert (hints["title"], hints["n"]) == ("Um quadrado de 1 m", 2)
    assert hints["texts"][0] == "Quantos cantos o quadrado tem?"
    messages = [mark["message"] for mark in mine["entries"] if mark["kind"] == "run"]
    assert messages[0] == "Vejam o giro."
    assert messages[1] != messages[0]


def test_a_pass_of_another_mission_is_named_as_one(
    teacher: Browser, pupils: Pupils, ninth: str
) -> None:
    place = f"/api/classrooms/{ninth}/lessons"
    other = teacher.post(place, {"title": "Labirinto", "activity": "maze"}).data
    pupils.run(pupils.edit(move()), passed=1)
    teacher.put("/api/settings", {"language": "pt-BR"})
    (mine,) = teacher.get(f"/api/lessons/{other['id']}/review").data["groups"]
    assert mine["need"] == "working"
    assert mine["entries"][-1]["other_mission"] == "Um quadrado de 1 m"
    assert mine["sentence"] == "Em outra missão, “Um quadrado de 1 m”: Cumpriu a atividade."


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_figure_says_in_words_what_it_counts(language: str) -> None:
    for name in (*Figures.model_fields, "blocks", "changes", "repairs"):
        text = describe(f"figure_{name}", {}, language)
        assert text.message != f"figure_{name}"
        assert len(text.remedy.split()) > 4


def test_two_versions_are_compared_block_by_block(browser: Browser, pupils: Pupils) -> None:
    first = pupils.edit(move("a"), move("b"))
    loop = Sketch("r", "repeat", bodies={"DO": [move("a", 2)]})
    second = pupils.edit(loop)
    assert browser.get(f"/api/versions/{first}/difference?to={second}").data == {
        "added": [{"block": "r", "type": "repeat"}],
        "removed": [{"block": "b", "type": "move_forward"}],
        "changed": [
            {
                "block": "a",
                "type": "move_forward",
                "what": [{"name": "DISTANCE", "before": 1, "after": 2}],
            }
        ],
        "moved": [{"block": "a", "type": "move_forward"}],
    }
    response = browser.get(f"/api/versions/{first}/difference?to=gone")
    assert (response.status, response.error["code"]) == (404, "version_not_found")


def test_a_version_knows_its_place_in_the_line(browser: Browser, pupils: Pupils) -> None:
    first, second = pupils.edit(), pupils.edit(move())
    browser.put(f"/api/versions/{second}/label", {"text": "anda"})
    found = browser.get(f"/api/versions/{second}").data
    place = ("program_id", "number", "label", "parent_id")
    assert [found[name] for name in place] == [pupils.program["id"], 2, "anda", first]
    assert found["workspace"] == workspace_of([start(), move()])
    assert found["document"]["commands"]


def test_the_history_is_chosen_by_what_the_teacher_asks(
    teacher: Browser, browser: Browser, app: App, pupils: Pupils, lesson: Any, ninth: str
) -> None:
    version = pupils.edit(move())
    failed = pupils.run(version, "failed", "interrupted", passed=0)
    passed = pupils.run(version, passed=1)
    alone = Pupils(browser, app, ninth, "Abelhas")
    other = alone.run(alone.edit())
    day = app._store.runs.get(other).started_at

    def history(query: str) -> list[str]:
        return [run["id"] for run in teacher.get(f"/api/runs?{query}").data["runs"]]

    assert history("") == history(f"classroom={ninth}") == [other, passed, failed]
    assert history("classroom=none") == history("lesson=gone") == history("day=1999-01-01") == []
    assert history(f"lesson={lesson['id']}&group={pupils.group['id']}") == [passed, failed]
    assert history("activity=square&outcome=passed") == [passed]
    world = app._store.runs.get(other).world
    assert history(f"world={world}") == [other, passed, failed]
    assert history(f"world={world}&outcome=passed") == [passed]
    assert history("world=nowhere") == []
    assert history("outcome=not_passed") == history("outcome=failed") == [failed]
    assert len(history(f"day={_local_day(day)}")) == 3
    page = teacher.get("/api/runs?limit=2").data
    assert page["next"] == passed
    assert history(f"limit=2&before={page['next']}") == [failed]
    shown = page["runs"][1]
    assert shown["group"] == {key: pupils.group[key] for key in ("id", "name", "color", "picture")}
    assert (shown["program_name"], shown["passed"]) == ("=Programa de Os Robôs", True)
    for day in ("0001-01-01", "9999-12-31"):
        assert history(f"day={day}") == []
    assert teacher.get("/api/runs?outcome=great").error["code"] == "invalid_request"
    assert teacher.get("/api/runs?day=yesterday").error["code"] == "invalid_request"


@pytest.mark.parametrize("finding", ["not_repeatable", "differs"])
def test_the_teacher_accepts_a_run_that_cannot_be_repeated_and_no_other(
    browser: Browser, teacher: Browser, pupils: Pupils, finding: str
) -> None:
    run = pupils.run(pupils.edit(move()), passed=1)
    marked = "INSERT INTO unconfirmed_runs VALUES (?, NULL, '', ?)"
    pupils.store._database.write(lambda db: db.execute(marked, [run, finding]).rowcount)
    assert browser.post(f"/api/runs/{run}/accept").error["code"] == "teacher_only"
    accepted = teacher.post(f"/api/runs/{run}/accept").data
    is_left = finding == "differs"
    assert accepted["unconfirmed"] == (finding if is_left else None)
    assert accepted["passed"] is (None if is_left else True)
    assert teacher.post("/api/runs/gone/accept").error["code"] == "run_not_found"


def test_review_and_history_are_for_the_teacher(
    browser: Browser, teacher: Browser, lesson: Any
) -> None:
    for place in ("review", "review.csv"):
        refused = browser.get(f"/api/lessons/{lesson['id']}/{place}")
        assert (refused.status, refused.error["code"]) == (403, "teacher_only")
        missing = teacher.get(f"/api/lessons/gone/{place}")
        assert (missing.status, missing.error["code"]) == (404, "lesson_not_found")
    assert browser.get("/api/runs").error["code"] == "teacher_only"


def _local_day(time: str) -> str:
    return f"{datetime.fromisoformat(time).astimezone():%Y-%m-%d}"
