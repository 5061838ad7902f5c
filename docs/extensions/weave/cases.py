"""Verification cases, and what the last run of them found.

Serves: the pages of cases and of the items that they check. Hides: how errors and verdicts
are worded.
"""

from collections.abc import Iterator
from math import isfinite
from typing import Any

from tamias2d.spec.chapter import Item
from tamias2d.trace import STALE
from tamias2d.verify import Outcome
from weave import published
from weave.formulas import equation, stack
from weave.links import linked, rank
from weave.markdown import bullets, code, display, fence, table
from weave.woven import Woven

NO_RESULTS = "No results yet: run `tamias2d verify`, then build these pages again."
_STALE = "The case, or something that it uses, has changed since."
_NAMES = {
    "exact": "whole history",
    "final": "final state",
    "moments": "states on the way",
    "schemes": "orders of the schemes",
    "certified": "bounds of certificates",
    "published": "tables of 2018",
    "conserves": "laws of conservation",
    "reference": "scipy's solution",
    "worlds": "many worlds",
    "refuses": "refusals",
    "pace": "time taken",
}
_SIGNS = {"fail": "✗", "stale": "≠", "uncovered": "○", "not run": "○", "manual": "?", "pass": "✓"}


def parts(item: Item, woven: Woven) -> Iterator[str]:
    """The comparisons of a case, or the cases of any other item."""
    if item.kind == "case":
        yield from _case(item, woven)
    elif about := cases_of(item.id, woven):
        rows = [[f"{{srs}}`{id}`", woven.spec.items[id].title, badge(id, woven)] for id in about]
        listing = table(["", "case", "last result"], rows, style="cases")
        title = f"Cases ({len(rows)}): {woven.verdict(item.id)}"
        yield fence("dropdown", title, listing, depth=6, color="light")


def _case(item: Item, woven: Woven) -> Iterator[str]:
    data = item.data
    if scene := data.get("scene"):
        time = f", for {data['duration']}" if "duration" in data else ""
        where = (
            f"`{scene}` of the [catalogue](/gallery.md)" if isinstance(scene, str) else "its own"
        )
        yield f"*Scene:* {where}{time}.\n"
    for key, lead in (("exact", "at any time"), ("final", "at the end"), ("worlds", "mean")):
        if bodies := data.get(key, {}).get("bodies"):
            yield f"*Exact {lead}:*\n"
            yield display(stack(_exact_lines(bodies, woven)))
    if questions := data.get("survey", {}).get("questions"):
        yield bullets(questions)
    yield bullets(_judged(name, part, woven) for name, part in data.items() if _is_judged(part))
    yield _results(item, woven)
    if "published" in data:
        title = "Published, reproduced and exact"
        yield fence("dropdown", title, published.part(item.id), depth=6, color="light")
    yield fence("dropdown", "As written", code("yaml", woven.source(item)), depth=6, color="light")


def _exact_lines(bodies: dict[str, dict[str, str]], woven: Woven) -> Iterator[str]:
    for body, quantities in bodies.items():
        for name, text in quantities.items():
            label = rf"\text{{{body.replace('_', ' ')}: }}" if len(bodies) > 1 else ""
            yield label + equation(woven, name, text)


def _is_judged(part: Any) -> bool:
    return isinstance(part, dict) and "tolerance" in part


def _judged(name: str, part: dict[str, Any], woven: Woven) -> str:
    source = f" Source: {linked(part['source'], woven)}." if "source" in part else ""
    because = f", because {linked(part['because'], woven)}" if "because" in part else ""
    return f"**{_NAMES.get(name, name)}** within `{part['tolerance']}`{because}.{source}"


def _results(item: Item, woven: Woven) -> str:
    outcomes = woven.outcomes.get(item.id)
    if not outcomes:
        return f"*{NO_RESULTS}*\n"
    listing = table(["compared", "error", "tolerance", ""], map(row, outcomes), style="results")
    return (f"{mark(STALE)} {_STALE}\n\n" if woven.verdict(item.id) == STALE else "") + listing


def row(result: Outcome) -> list[str]:
    """The cells of one comparison."""
    error = f"{result.error:.2g}" if isfinite(result.error) else ""
    note = f" {result.note}" if result.note else ""
    return [result.quantity, error, f"{result.tolerance:.2g}", f"{mark(result.verdict)}{note}"]


def cases_of(id: str, woven: Woven) -> list[str]:
    """The cases that verify an item or use it."""
    found = [name for name in woven.used_by.get(id, []) if woven.spec.items[name].kind == "case"]
    return sorted(found, key=rank)


def badge(id: str, woven: Woven) -> str:
    """The verdict of an item as a coloured word."""
    return mark(woven.verdict(id))


def checked(ids: list[str], woven: Woven) -> str:
    """Links to cases, each with a sign of its last result."""
    signs = ((id, woven.verdict(id)) for id in ids)
    return " ".join(f"{{srs}}`{id}`[{_SIGNS[word]}]{{.sign .{_css(word)}}}" for id, word in signs)


def mark(word: str) -> str:
    """A verdict as a coloured word."""
    return f"[{word}]{{.verdict .{_css(word)}}}"


def _css(word: str) -> str:
    """A verdict as the name of a CSS class."""
    return word.replace(" ", "-")
