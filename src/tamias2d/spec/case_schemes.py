"""The schemes that a case names: each exists, has its steps, and is among what the case uses.

Serves: the check of a case. Hides: where in a case schemes stand.
"""

from collections.abc import Iterator, Mapping
from typing import Any

from tamias2d.spec.chapter import Item
from tamias2d.spec.equations import Report
from tamias2d.spec.links import rests_on
from tamias2d.spec.messages import Code

Path = tuple[str | int, ...]
_JUDGED = ("orders", "shows", "constants")


def check_schemes(item: Item, items: Mapping[str, Item], report: Report) -> None:
    """Report a scheme that is none, that no verdict would follow, or whose steps are missing."""
    used = rests_on(item, items)
    for path, name in _named(item):
        if name not in items or items[name].kind != "scheme":
            text = f"'{name}' is no scheme. Correct the name"
            report(item.diagnostic(Code.UNKNOWN_ID, text, *path))
        elif name not in used:
            text = f"'{name}' is not among what the case uses. Add it to 'uses'"
            report(item.diagnostic(Code.WRONG_LINK, text, *path))
    _check_steps(item, report)
    _check_pairs(item, report)


def _named(item: Item) -> Iterator[tuple[Path, str]]:
    data = item.data
    schemes = data.get("schemes", {})
    for number, name in enumerate(schemes.get("orders", ())):
        yield ("schemes", "orders", number), name
    for key in ("shows", "constants", "durations", "steps"):
        if isinstance(schemes.get(key), dict):
            yield from ((("schemes", key, name, "key"), name) for name in schemes[key])
    for name in data.get("conserves", {}).get("schemes", {}):
        yield ("conserves", "schemes", name, "key"), name
    for path, run in _runs(item):
        if "scheme" in run:
            yield (*path, "scheme"), run["scheme"]


def _check_steps(item: Item, report: Report) -> None:
    """Report a scheme to judge whose number of steps is missing, and a length without a scheme."""
    schemes = item.data.get("schemes", {})
    judged = {name for key in _JUDGED for name in schemes.get(key, ())}
    steps = schemes.get("steps", {})
    if isinstance(steps, dict) and schemes:
        for name in sorted(judged ^ set(steps)):
            text = f"'steps' and {', '.join(_JUDGED)} must name the same schemes: '{name}'"
            report(item.diagnostic(Code.BAD_KEY, f"{text} stands in one. Correct it", "schemes"))
    for name in schemes.get("durations", {}):
        if name not in judged:
            text = f"'{name}' has a duration, and no order or constant is asked of it. Leave it out"
            path = ("schemes", "durations", name, "key")
            report(item.diagnostic(Code.UNKNOWN_NAME, text, *path))


def _check_pairs(item: Item, report: Report) -> None:
    """Report a scheme without the length of its steps, and a length without a scheme."""
    for path, run in _runs(item):
        if ("scheme" in run) != ("time_step" in run):
            text = "'scheme' and 'time_step' go together. State both or none"
            report(item.diagnostic(Code.BAD_KEY, text, *path))


def _runs(item: Item) -> Iterator[tuple[Path, Mapping[str, Any]]]:
    """What states a run of its own, and where."""
    if "worlds" in item.data:
        yield ("worlds",), item.data["worlds"]
    for key in ("refuses", "notes"):
        for label, run in item.data.get(key, {}).get("scenes", {}).items():
            yield (key, "scenes", label), run
