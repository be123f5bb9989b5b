"""Signs that a class taught: their names, how many samples count, and where they go."""

import struct
from collections.abc import Callable
from contextlib import closing
from pathlib import Path

import pytest

from pinel_desktop.gestures import features
from pinel_desktop.gestures.moving import movements
from storage import Store
from storage.exchange.parquet import FILES
from storage.exchange.scope import Scope
from storage.limits import MAX_TAUGHT_SIGNS, N_FEATURES
from storage.sql import opened as opened_file
from storage.sql import row_count
from storage.tables.work import TAUGHT_SIGNS
from tests.storage.bundle_makers import exported, hash_of, merged, work
from tests.storage.file.refusals import code_of

Opened = Callable[[Path], Store]


def hands(value: float, n: int = 10) -> bytes:
    return struct.pack("<e", value) * (N_FEATURES * n)


@pytest.fixture
def fifth(store: Store) -> str:
    return store.classrooms.create("5º B").id


def taught(store: Store, classroom_id: str) -> dict[str, int]:
    return {one.sign: one.n_samples for one in store.taught_signs.of_classroom(classroom_id)}


def test_a_hand_has_as_many_numbers_in_the_file_as_it_has_to_the_recognition() -> None:
    assert N_FEATURES == features.N_FEATURES == movements.N_FRAMES * movements.N_NUMBERS


def test_signs_are_listed_by_name_with_their_newest_samples(store: Store, fifth: str) -> None:
    for sign, value in (("vai", 1.0), ("F", 2.0), ("VAI ", 3.0)):
        store.taught_signs.add(fifth, sign, hands(value))
    assert taught(store, fifth) == {"F": 10, "vai": 20}
    (_, go) = store.taught_signs.of_classroom(fifth)
    assert go.samples == hands(3.0) + hands(1.0)
    assert taught(store, store.classrooms.create("6º").id) == {}


def test_signs_with_numbers_are_listed_by_their_value(store: Store, fifth: str) -> None:
    for sign in ("sinal 10", "Sinal 2", "água", "zebra", "sinal 1"):
        store.taught_signs.add(fifth, sign, hands(1.0))
    assert [*taught(store, fifth)] == ["água", "sinal 1", "Sinal 2", "sinal 10", "zebra"]


def test_a_sign_has_hands_at_rest_and_movements_each_counted_for_itself(
    store: Store, fifth: str
) -> None:
    for value, is_moving in ((1.0, True), (2.0, False), (3.0, True)):
        store.taught_signs.add(fifth, "Y", hands(value), is_moving=is_moving)
    (sign,) = store.taught_signs.of_classroom(fifth)
    assert (sign.samples, sign.movements) == (hands(2.0), hands(3.0) + hands(1.0))
    teach = store.taught_signs.name_to_teach
    assert code_of(lambda: teach(fifth, "y", is_moving=True)) == "sign_taught_enough"
    assert teach(fifth, "y") == "Y"
    store.exchange.purge("taught_sign", *store.taught_signs.keys(fifth, "Y"))
    assert store.taught_signs.of_classroom(fifth) == []


def test_a_letter_is_a_capital_whichever_is_typed(store: Store, fifth: str) -> None:
    assert store.taught_signs.name_to_teach(fifth, " ç ") == "Ç"
    assert store.taught_signs.name_to_teach(fifth, "7") == "7"


@pytest.mark.parametrize("name", ["a/b", "..", "?", "x" * 31, "a\u202eb/", "_"])
def test_a_name_that_cannot_be_part_of_an_address_is_refused(
    store: Store, fifth: str, name: str
) -> None:
    assert code_of(lambda: store.taught_signs.add(fifth, name, hands(1))) == "sign_name_wrong"


def test_what_cannot_be_taught_is_told(store: Store, fifth: str) -> None:
    signs = store.taught_signs
    assert code_of(lambda: signs.add(fifth, " ", hands(1))) == "name_empty"
    assert code_of(lambda: signs.add("x", "7", hands(1))) == "classroom_not_found"
    assert code_of(lambda: signs.of_classroom("x")) == "classroom_not_found"
    assert code_of(lambda: signs.keys(fifth, "7")) == "taught_sign_not_found"
    signs.add(fifth, "7", hands(1, 20))
    assert code_of(lambda: signs.add(fifth, "7", hands(1))) == "sign_taught_enough"
    for n in range(MAX_TAUGHT_SIGNS - 1):
        signs.add(fifth, f"sinal {n}", hands(1, 1))
    assert code_of(lambda: signs.add(fifth, "8", hands(1))) == "signs_too_many"
    signs.add(fifth, "sinal 3", hands(1, 1))


@pytest.mark.parametrize(
    ("samples", "is_allowed"),
    [
        (hands(1.0, 1), True),
        (hands(-65504.0, 20), True),
        (b"", False),
        (hands(1.0, 21), False),
        (hands(1.0)[:-1], False),
        (hands(1.0)[:-2] + struct.pack("<e", float("nan")), False),
        (hands(1.0)[:-2] + struct.pack("<e", float("inf")), False),
        ("text", False),
    ],
)
def test_a_bundle_may_hold_hands_and_nothing_else(samples: object, is_allowed: bool) -> None:
    assert TAUGHT_SIGNS.rules["samples"](samples) is is_allowed


def test_two_pcs_that_taught_one_sign_have_the_samples_of_both(
    store: Store, fifth: str, tmp_path: Path, opened: Opened
) -> None:
    other = opened(tmp_path / "other.db")
    merged(other, exported(store, tmp_path / "class.pinel").path)
    store.taught_signs.add(fifth, "vai", hands(1, 12))
    store.taught_signs.add(fifth, "vai", hands(4, 5), is_moving=True)
    other.taught_signs.add(fifth, "Vai", hands(2, 12))
    other.taught_signs.add(fifth, "F", hands(2))
    bundles = [exported(one, tmp_path / f"{i}.pinel").path for i, one in enumerate((store, other))]
    merged(store, bundles[1])
    merged(other, bundles[0])
    assert taught(store, fifth) == taught(other, fifth) == {"F": 10, "vai": 20}
    assert {one.n_movements for one in other.taught_signs.of_classroom(fifth)} == {0, 5}
    assert hash_of(store) == hash_of(other)
    assert merged(store, bundles[1]).nothing_new


def test_they_go_with_their_class_and_with_all_but_not_with_a_group_or_a_program(
    store: Store, fifth: str, tmp_path: Path
) -> None:
    store.taught_signs.add(fifth, "7", hands(1))
    store.taught_signs.add(store.classrooms.create("6º").id, "7", hands(1))
    group = store.groups.create("Onças", classroom_id=fifth)
    program, _ = work(store, group, "P")
    scopes = {
        "all": (Scope(), 2),
        "class": (Scope(classroom_id=fifth), 1),
        "group": (Scope(group_id=group.id), 0),
        "program": (Scope(program_id=program.id), 0),
    }
    for name, (scope, n) in scopes.items():
        counts = exported(store, tmp_path / f"{name}.pinel", scope).counts
        assert counts["taught_signs"] == n, name


def test_neither_anonymous_bundles_nor_parquet_files_have_them(
    store: Store, fifth: str, tmp_path: Path
) -> None:
    store.taught_signs.add(fifth, "sinal da Ana", hands(1.5))
    info = store.exchange.export(
        tmp_path / "x.pinel", app_version="1", computer=("", ""), anonymous=[]
    )
    octets = info.path.read_bytes()
    assert hands(1.5, 1)[:64] not in octets
    assert b"sinal da Ana" not in octets
    with closing(opened_file(info.path, "ro")) as db:
        assert row_count(db, "taught_signs") == 0
    assert "taught_signs" not in FILES


def test_they_are_deleted_with_their_class_and_do_not_come_back(
    store: Store, fifth: str, tmp_path: Path, path: Path
) -> None:
    store.taught_signs.add(fifth, "7", hands(1.5))
    bundle = exported(store, tmp_path / "a.pinel").path
    assert store.exchange.purge("classroom", fifth).counts["taught_signs"] == 1
    merged(store, bundle)
    with closing(opened_file(path, "ro")) as db:
        assert row_count(db, "taught_signs") == 0
    assert hands(1.5, 1)[:64] not in path.read_bytes()


def test_a_sign_is_deleted_for_good_and_can_be_taught_anew(
    store: Store, fifth: str, tmp_path: Path, opened: Opened, path: Path
) -> None:
    for sign in ("7", "7", "8"):
        store.taught_signs.add(fifth, sign, hands(1.5 if sign == "7" else 2.5))
    other = opened(tmp_path / "other.db")
    before = exported(store, tmp_path / "a.pinel").path
    merged(other, before)
    removal = store.exchange.purge("taught_sign", *store.taught_signs.keys(fifth, "7"))
    assert removal.counts == {"taught_signs": 2}
    assert [export.path for export in removal.exports] == [str(before)]
    assert hands(1.5, 1)[:64] not in path.read_bytes()
    merged(store, before)
    assert taught(store, fifth) == {"8": 10}
    store.taught_signs.add(fifth, "7", hands(3.5))
    after = exported(store, tmp_path / "b.pinel").path
    report = merged(other, after, delete=False)
    assert report.would_delete is not None
    assert report.would_delete.names == ("7",)
    merged(other, after)
    assert taught(other, fifth) == {"7": 10, "8": 10}
