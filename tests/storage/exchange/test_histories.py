"""Random histories of three to six PCs: work, moves, deletions, what is kept, merges in any order."""

import random

import pytest

from tests.storage.exchange.histories import History, Pc

N_STEPS = 30
N_HISTORIES = 10_000
SLICE = 250


def lived(seed: int) -> History:
    """A history in which everything reached everybody, and every question was answered; it is held to all rules."""
    history = History(random.Random(seed))
    history.advance(N_STEPS)
    history.exchange()
    return history


def hold_to_the_rules(seed: int) -> None:
    """One hash on all PCs, merging again changes nothing, nothing is lost that no person deleted."""
    history = lived(seed)
    try:
        assert len({pc.hash() for pc in history.pcs}) == 1
        there = set(history.pcs[0].keys())
        assert history.made - history.deleted <= there, "lost"
        for pc in history.pcs:
            assert pc.problems() == []
        first, *others = history.pcs
        assert all(
            first.merge(other, delete=True, retain_newer=True).nothing_new for other in others
        )
    finally:
        history.close()


def new_pc_after(files: list[Pc], rounds: int) -> str:
    """The hash of a new PC that merges the files, deleting what they delete, so many times."""
    pc = Pc()
    for file in files * rounds:
        pc.merge(file, delete=True)
    found = pc.hash()
    pc.close()
    return found


def hold_to_any_order(seed: int) -> None:
    """A new PC that merges files of all PCs, of two moments each, has one hash in any order."""
    history = History(random.Random(seed))
    history.advance(N_STEPS // 2)
    files = [pc.copy() for pc in history.pcs]
    history.advance(N_STEPS // 2)
    files += [pc.copy() for pc in history.pcs]
    orders = [history.chance.sample(files, len(files)) for _ in range(4)]
    has_retained = any(file.all("SELECT 1 FROM deletions WHERE turn > 0") for file in files)
    hashes = {new_pc_after(order, rounds=2 if has_retained else 1) for order in orders}
    for pc in files:
        pc.close()
    history.close()
    assert len(hashes) == 1, f"{has_retained=}"


def test_everything_that_reached_everybody_is_one_store() -> None:
    for seed in range(10):
        hold_to_the_rules(seed)


def test_no_order_of_files_changes_the_result() -> None:
    for seed in range(6):
        hold_to_any_order(seed)


@pytest.mark.nightly
@pytest.mark.timeout(900)
@pytest.mark.parametrize("first", range(0, N_HISTORIES, SLICE))
def test_many_histories(first: int) -> None:
    for seed in range(first, first + SLICE):
        hold_to_the_rules(seed)
        if seed % 4 == 0:
            hold_to_any_order(seed)
