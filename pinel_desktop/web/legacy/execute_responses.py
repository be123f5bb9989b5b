"""The response of `/execute` to the original's page: one object for each command."""

from collections.abc import Mapping
from typing import Any

from pinel_desktop.web.legacy.open_run import ExecuteOutcome

_CAPTURES = ("classify_gestures", "classificar_gestos")
_SETTER = "set_gesture_result"
_BODIES = ("commands", "else", "elif")


def for_each(
    sent: list[dict[str, Any]], outcome: ExecuteOutcome, error: Mapping[str, Any] | None
) -> list[dict[str, Any]]:
    """Returns one object for each command of the request, as the original's backend answers its page.

    Args:
        error: why the call was not executed to its end.
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
    """Returns the gesture result that a command set; None for other commands."""
    if command.get("action") == _SETTER:
        return command.get("resultado", command.get("result"))
    return captured if command.get("action") in _CAPTURES else None
