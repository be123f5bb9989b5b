"""What the program wrote at commit a15e9a7d, the baseline, opens unchanged; files/README.md says what it is.

The records hold what the program of that commit said of its files. What is said now may be more, never less or other.
"""

import json
from contextlib import closing
from pathlib import Path
from typing import Any

import pytest

from storage import open_store
from storage.sql import opened
from tests.compatibility import archived_files as kept
from tests.compatibility.archived_files import DATABASE

SUMMARY = kept.recorded("summary")
RESULTS = kept.recorded("results")
THEN = SUMMARY["database"]
IS_THE_PLATFORM = kept.platform_of_figures() == SUMMARY["platform"]
ANOTHER_PLATFORM_WITHIN = (
    1e-4  # m, rad, s: far more than last digits, far less than anything a person sees
)
RUNS = [
    " ".join(filter(None, (r["program_name"], r["reason"] or r["state"]))) for r in THEN["runs"]
]
Past = tuple[Path, dict[str, Any]]
ONCE_EACH = [(name, file) for name in RESULTS for file in kept.sources(name)]


@pytest.fixture(autouse=True)
def home(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """No command touches the data of whoever runs the tests."""
    monkeypatch.setenv("PINEL_HOME", str(tmp_path / "home"))
    monkeypatch.setenv("PINEL_LANG", "en")
    return tmp_path


@pytest.fixture(scope="module")
def app_was_there(
    tmp_path_factory: pytest.TempPathFactory,
) -> Past:
    """The database after the app had it open, and what the app told of it."""
    home = kept.unpack("database", tmp_path_factory.mktemp("database"))
    with kept.opened(home) as browser:
        report = kept.reported(browser)
    return home / DATABASE, report


def differences(now: Any, then: Any, within: float = 0.0, place: str = "") -> list[str]:
    """Where something is not as it was; what is there besides is none."""
    pairs: list[tuple[str, Any, Any]]
    if isinstance(then, dict) and isinstance(now, dict):
        pairs = [(f"{place}/{name}", now.get(name, "missing"), then[name]) for name in then]
    elif isinstance(then, list) and isinstance(now, list) and len(then) == len(now):
        pairs = [(f"{place}/{i}", *pair) for i, pair in enumerate(zip(now, then, strict=True))]
    elif now == then or _is_close(now, then, within):
        return []
    else:
        return [f"{place}: {now!r} instead of {then!r}"]
    return [one for at, *pair in pairs for one in differences(pair[0], pair[1], within, at)]


def _is_close(now: Any, then: Any, within: float) -> bool:
    both = isinstance(now, float) and isinstance(then, float)
    return both and abs(now - then) <= within


def test_the_database_opens_as_it_was_left_and_holds_the_same(home: Path) -> None:
    database = kept.unpack("database", home / "database") / DATABASE
    # `pinel runs` reads files of this release only and asks for PINEL to be started once
    with closing(opened(database, "ro")) as db:
        (state,) = db.execute("SELECT state FROM runs ORDER BY id DESC LIMIT 1").fetchone()
    assert state == "running"  # the power was cut
    with open_store(database) as store:
        assert store.notice is None
        assert store.writable
        assert store.exchange.content_hash() == THEN["content_hash"]


@pytest.mark.parametrize("what", [name for name in THEN if name != "content_hash"])
def test_the_app_tells_the_same_of_it(what: str, app_was_there: Past) -> None:
    assert differences(app_was_there[1][what], THEN[what], place=what) == []


@pytest.mark.parametrize("run", SUMMARY["verdicts"], ids=RUNS)
def test_a_run_can_be_repeated_as_it_could(run: str, app_was_there: Past) -> None:
    then = dict(SUMMARY["verdicts"][run])
    now = kept.verdict(app_was_there[0], run)
    allowed = [then.pop("outcome")] if IS_THE_PLATFORM else ["identical", "equal"]
    then.pop("outcome", None)
    assert now["outcome"] in allowed
    assert differences(now, then) == []


def test_a_backup_takes_the_place_of_a_damaged_database(home: Path) -> None:
    assert differences(kept.backup_restored(home), SUMMARY["backup"]) == []


def test_what_is_exported_of_it_now_is_what_was_exported(home: Path) -> None:
    database = kept.unpack("database", home / "database") / DATABASE
    status, text = kept.pinel("--db", database, "export", home / "all.pinel", "--json")
    then = SUMMARY["merged"]["all"]["content_hash"]
    assert (status, json.loads(text)["content_hash"]) == (0, then)


def test_bundles_bring_what_they_brought(home: Path) -> None:
    now, then = kept.all_merged(home), dict(SUMMARY["merged"])
    assert differences(now.pop("went on elsewhere"), then.pop("went on elsewhere")) == []
    assert now == then  # no other counts either


def test_an_anonymous_bundle_stays_anonymous_and_so_is_one_of_now(home: Path) -> None:
    texts = {one["name"] for kind in ("classrooms", "groups", "programs") for one in THEN[kind]}
    texts |= {note["text"] for note in THEN["notes"]} | {"Ana Souza", "PC da janela", "degrau"}
    bundles = [kept.unpack(f"bundles/{name}.pinel", home / name) for name in ("all", "anonymous")]
    database = kept.unpack("database", home / "database") / DATABASE
    bundles.append(home / "now.pinel")
    assert kept.pinel("--db", database, "export", bundles[-1], "--anonymous")[0] == 0
    found = {}
    for bundle in bundles:
        kept.merged(home / f"{bundle.stem}.db", bundle)
        octets = bundle.read_bytes() + (home / f"{bundle.stem}.db").read_bytes()
        found[bundle.stem] = {
            text for text in texts if any(form in octets for form in _stored_forms(text))
        }
    assert found == {"all": texts, "anonymous": set(), "now": set()}


def _stored_forms(text: str) -> tuple[bytes, bytes]:
    return text.encode(), json.dumps(text)[1:-1].encode()


def test_a_program_that_was_taken_along_comes_in(home: Path) -> None:
    assert differences(kept.program_brought(home / "new"), SUMMARY["program"]) == []


# the distance of a realistic robot from the start was its estimate, which has a name of its own now
# (`execution.semantics`, 3 and 4)
CHANGED_RESULTS = {
    "stairs": {
        "closing_error_m": 0.6737980225537294,
        "estimated_closing_error_m": RESULTS["stairs"]["result"]["closing_error_m"],
    }
}


@pytest.mark.parametrize(("name", "file"), ONCE_EACH, ids=[file.name for _, file in ONCE_EACH])
def test_a_program_is_read_and_runs_as_it_did(name: str, file: Path) -> None:
    then = {**RESULTS[name]["result"], **CHANGED_RESULTS.get(name, {})}
    within = 0.0 if IS_THE_PLATFORM else ANOTHER_PLATFORM_WITHIN
    if not IS_THE_PLATFORM:
        del then["telemetry_sha256"]
    now = kept.result(file, RESULTS[name]["options"])
    assert now["faults"] == []
    assert now["variables"].keys() == then["variables"].keys()
    assert differences(now, then, within) == []
