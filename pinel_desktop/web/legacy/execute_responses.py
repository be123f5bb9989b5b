"""The two forms in which `/execute` answers: one object for a call, or one for each of its commands."""

from collections.abc import Mapping
from typing import Any

from pinel_desktop.web.legacy.open_run import Outcome

_CAPTURES = ("classify_gestures", "classificar_gestos")
_SETTER = "set_gesture_result"
_BODIES = ("commands", "else", "elif")


def for_each(
    sent: list[dict[str, Any]], outcome: Outcome, error: Mapping[str, Any] | None
) -> list[dict[str, Any]]:
    """One object for each command that was sent, as the original's backend answers its page.

    Args:
        error: why the call did not go to its end.
    """
    is_ok = outcome.state == "ok"
    done = [is_ok or index in outcome.results for index in range(len(sent))]
    answers: list[dict[str, Any]] = []
    for index, command in enumerate(sent):
        answer = {name: value for name, value in command.items() if name not in _BODIES}
        answer["status"] = "ok" if done[index] else "not_executed"
        if not done[index] and all(done[:index]):
            answer |= {"status": outcome.state, "error": error}
        if done[index] and (result := _result(command, outcome.results.get(index))) is not None:
            answer["resultado"] = result
        answers.append(answer)
    return answers


def _result(command: Mapping[str, Any], captured: str | None) -> Any:
    """The gesture result that a command made; None for others."""
    if command.get("action") == _SETTER:
        return command.get("resultado", command.get("result"))
    return captured if command.get("action") in _CAPTURES else None
