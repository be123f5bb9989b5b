"""A check as a line of a check list: what counts, and how far the run is, in a pupil's words."""

from collections.abc import Callable, Mapping
from typing import Any

from pinel_desktop.activities import check_kinds as kinds
from pinel_desktop.activities.checks import Finding
from pinel_desktop.activities.wording import shown
from pinel_desktop.messages import describe

_NEAR = 0.1  # limits that are that much of a length apart are said as one length
_NO_LIMIT = 5_000  # a limit that an activity leaves out is far above
_STILL_M = 0.1
_MEASURED = {
    "check_ends_at": "measured_off",
    "check_ends_at_start": "measured_off",
    "check_ends_heading": "measured_heading",
    "check_ends_in": "measured_off",
    "check_visits": "measured_visits",
    "check_touches_nothing": "measured_touch",
    "check_pushed": "measured_off",
    "check_path_length": "measured_way",
    "check_path_length_long": "measured_way",
    "check_path_length_still": "measured_way",
    "check_draws_extra": "measured_drawing",
    "check_draws_missing": "measured_drawing",
    "check_way_extra": "measured_drawing",
    "check_way_missing": "measured_drawing",
    "check_closed": "measured_gap",
    "check_symmetric": "measured_number",
    "check_turned_total": "measured_turned",
    "check_turned_total_much": "measured_turned",
    "check_turned_total_net": "measured_net",
    "check_block_count": "measured_number",
    "check_nesting": "measured_number",
    "check_executed": "measured_number",
    "check_mark_count": "measured_number",
    "check_time": "measured_time",
}
_ONLY_WHERE_IT_FAILS = {"measured_off", "measured_gap", "measured_drawing", "measured_net"}


def criterion_of(check: kinds.Check, language: str) -> str:
    """What counts, as an order: "Terminar em “padaria”"."""
    if check.label is not None:
        return check.label.of(language)
    return _CRITERIA[type(check)](check, language)


def measured_of(finding: Finding, language: str) -> str:
    """What was measured: "agora a 12 cm"; "" where a number says nothing more."""
    code = _MEASURED.get(finding.code, "")
    is_needless = finding.holds and code in _ONLY_WHERE_IT_FAILS
    if not code or is_needless or not finding.values:
        return ""
    return _say(code, finding.values, language)


def _say(code: str, values: Mapping[str, Any], language: str) -> str:
    return describe(code, shown(values, language), language).message


def _counted(code: str, n: int, language: str, **values: Any) -> str:
    """Words for none, one or several."""
    ending = {0: "_none", 1: "_one"}.get(n, "")
    return _say(f"{code}{ending}", {"n": n, **values}, language)


def _finished(_check: kinds.Finished, language: str) -> str:
    return _say("criterion_finished", {}, language)


def _ends_at(check: kinds.EndsAt, language: str) -> str:
    ahead = ("place_ahead" if check.x_m > 0 else "place_behind", check.x_m)
    aside = ("place_left" if check.y_m > 0 else "place_right", check.y_m)
    places = [
        _say(code, {"by_m": abs(by)}, language)
        for code, by in (ahead, aside)
        if abs(by) > check.within_m
    ]
    if not places:
        return _say("criterion_ends_at_start", {}, language)
    return _say(
        "criterion_ends_at", {"place": _say("criteria_and", {}, language).join(places)}, language
    )


def _ends_heading(check: kinds.EndsHeading, language: str) -> str:
    if abs(check.heading_deg) % 360 <= check.within_deg:
        return _say("criterion_ends_heading_start", {}, language)
    side = _say("block_left" if check.heading_deg > 0 else "block_right", {}, language)
    values = {"target_deg": abs(check.heading_deg), "side": side}
    return _say("criterion_ends_heading", values, language)


def _ends_in(check: kinds.EndsIn, language: str) -> str:
    return _say("criterion_ends_in", {"zone": check.zone}, language)


def _visits(check: kinds.Visits, language: str) -> str:
    in_order = check.ordered and len(check.zones) > 1
    code = "criterion_visits" if in_order else "criterion_visits_any"
    return _say(code, {"zones": list(check.zones)}, language)


def _touches_nothing(_check: kinds.TouchesNothing, language: str) -> str:
    return _say("criterion_touches_nothing", {}, language)


def _pushed(check: kinds.Pushed, language: str) -> str:
    return _say("criterion_pushed", {"zone": check.zone}, language)


def _uses(check: kinds.Uses, language: str) -> str:
    if check.at_most >= _NO_LIMIT:
        return _counted("criterion_uses", check.at_least, language, name=check.action)
    if check.at_least in (0, 1) or check.at_most == 0:
        return _counted("criterion_uses_most", check.at_most, language, name=check.action)
    values = {"name": check.action, "least": check.at_least, "most": check.at_most}
    return _say("criterion_uses_range", values, language)


def _marks(check: kinds.Marks, language: str) -> str:
    return _say("criterion_marks", {"symbol": check.symbol, "zone": check.zone}, language)


def _says(check: kinds.Says, language: str) -> str:
    return _say("criterion_says", {"text": check.text}, language)


def _path_length(check: kinds.PathLength, language: str) -> str:
    least, most = check.at_least_m, check.at_most_m
    if most <= _STILL_M:
        return _say("criterion_path_still", {}, language)
    if most >= _NO_LIMIT:
        return _say("criterion_path_least", {"least_m": least}, language)
    if least <= 0:
        return _say("criterion_path_most", {"most_m": most}, language)
    if most - least <= _NEAR * most:
        return _say("criterion_path", {"about_m": (least + most) / 2}, language)
    return _say("criterion_path_range", {"least_m": least, "most_m": most}, language)


def _draws(check: kinds.Draws, language: str) -> str:
    return _say(f"criterion_draws_{check.of}", {}, language)


def _closed(_check: kinds.Closed, language: str) -> str:
    return _say("criterion_closed", {}, language)


def _symmetric(check: kinds.Symmetric, language: str) -> str:
    return _counted("criterion_symmetric", check.axes, language)


def _turned_total(check: kinds.TurnedTotal, language: str) -> str:
    least, most = check.at_least_deg, check.at_most_deg
    values = {"least_deg": least, "most_deg": most}
    code = "criterion_turned_range"
    if most >= _NO_LIMIT or least <= 0:
        code = "criterion_turned_least" if most >= _NO_LIMIT else "criterion_turned_most"
    turned = _say(code, values, language)
    if check.net_deg is None:
        return turned
    if check.net_deg == 0:
        return _say("criterion_turned_balanced", {"turned": turned}, language)
    side = _say("block_left" if check.net_deg > 0 else "block_right", {}, language)
    more = {"turned": turned, "net_deg": abs(check.net_deg), "side": side}
    return _say("criterion_turned_net", more, language)


def _block_count(check: kinds.BlockCount, language: str) -> str:
    return _counted("criterion_block_count", check.at_most, language)


def _nesting(check: kinds.Nesting, language: str) -> str:
    return _counted("criterion_nesting", check.at_least, language)


def _executed(check: kinds.Executed, language: str) -> str:
    return _counted("criterion_executed", check.n, language, name=check.action)


def _mark_count(check: kinds.MarkCount, language: str) -> str:
    return _counted("criterion_mark_count", check.n, language)


def _time(check: kinds.Time, language: str) -> str:
    return _say("criterion_time", {"most_s": check.at_most_s}, language)


def _any_of(check: kinds.AnyOf, language: str) -> str:
    words = dict.fromkeys(criterion_of(one, language) for one in check.checks)
    return _say("criteria_or", {}, language).join(words)


_CRITERIA: dict[type, Callable[[Any, str], str]] = {
    kinds.Finished: _finished,
    kinds.EndsAt: _ends_at,
    kinds.EndsHeading: _ends_heading,
    kinds.EndsIn: _ends_in,
    kinds.Visits: _visits,
    kinds.TouchesNothing: _touches_nothing,
    kinds.Pushed: _pushed,
    kinds.Uses: _uses,
    kinds.Marks: _marks,
    kinds.Says: _says,
    kinds.PathLength: _path_length,
    kinds.Draws: _draws,
    kinds.Closed: _closed,
    kinds.Symmetric: _symmetric,
    kinds.TurnedTotal: _turned_total,
    kinds.BlockCount: _block_count,
    kinds.Nesting: _nesting,
    kinds.Executed: _executed,
    kinds.MarkCount: _mark_count,
    kinds.Time: _time,
    kinds.AnyOf: _any_of,
}
