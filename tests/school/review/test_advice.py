"""Advice about a run, as the review reads it from the report."""

import json
from typing import Any

import pytest

from pinel_desktop.school.review import advice_of_cases


def stored(*cases: Any) -> str:
    return json.dumps(cases)


def advice_of(text: str, diagnosis: int | None = None) -> dict[str, Any]:
    return {"words": {"pt-BR": text, "en": f"{text} (en)"}, "block": "a", "diagnosis": diagnosis}


def test_the_first_diagnosis_is_taken_before_the_words_of_a_check() -> None:
    advice = advice_of_cases(
        stored(None, advice_of("1 m a mais"), advice_of("vejam o giro", 3), advice_of("G1", 1))
    )
    assert advice is not None
    assert (advice.of("pt-BR"), advice.of("en"), advice.of("fr")) == ("G1", "G1 (en)", "G1 (en)")


def test_equal_mistakes_have_one_key_whatever_was_measured() -> None:
    (near, far) = (advice_of_cases(stored(advice_of(f"parou a {cm} cm"))) for cm in (12, 30))
    (other, same) = (advice_of_cases(stored(advice_of(text, 2))) for text in ("a", "b"))
    assert near is not None
    assert far is not None
    assert other is not None
    assert same is not None
    assert near.mistake("square") == far.mistake("square") != near.mistake("maze")
    assert other.mistake("square") == same.mistake("square")


@pytest.mark.parametrize(
    "report", [None, "[]", "[null]", '{"a": 1}', '[{"words": {}}]', "[3]", "["]
)
def test_a_report_without_words_or_a_damaged_one_says_nothing(report: str | None) -> None:
    assert advice_of_cases(report) is None
