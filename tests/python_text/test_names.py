import unicodedata

import pytest
from hypothesis import given
from hypothesis import strategies as st

from pinel_desktop.program.python_text.forms import RESERVED
from pinel_desktop.program.python_text.names import program_name, python_name
from tests.python_text.languages import NAMES

TRICKY = st.text(alphabet="_u5fa ª2²é9e\u0301", min_size=1, max_size=9)
RESERVED_WITH_UNDERSCORES = st.builds(
    str.__add__, st.sampled_from(sorted(RESERVED)), st.sampled_from(["", "_", "__"])
)


@given(st.one_of(NAMES, TRICKY, RESERVED_WITH_UNDERSCORES, st.text(min_size=1)))
def test_every_name_has_a_python_name_that_leads_back_to_it(name: str) -> None:
    python = python_name(name)
    assert python.isidentifier()
    assert python not in RESERVED
    assert unicodedata.normalize("NFKC", python) == python
    assert program_name(python) == name


@given(st.one_of(NAMES, TRICKY, RESERVED_WITH_UNDERSCORES))
def test_a_python_name_that_was_typed_settles_after_one_round(typed: str) -> None:
    if typed.isidentifier() and typed not in RESERVED:
        once = python_name(program_name(typed))
        assert python_name(program_name(once)) == once


@pytest.mark.parametrize("name", ["lado", "área", "my_uncle", "x1", "Ünïcode", "角", "note_um"])
def test_ordinary_names_stay_as_they_are(name: str) -> None:
    assert python_name(name) == name
