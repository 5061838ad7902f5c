"""Verification cases, and what the last run of them found.

Serves: the pages of cases and of the items that they check. Hides: how errors and verdicts
are worded.
"""

from collections.abc import Iterator

from tamias2d.spec.chapter import Item

from weave.links import rank
from weave.markdown import code, fence, table
from weave.woven import Woven

NO_RESULTS = "No results on this machine: `tamias2d verify` makes them."
_ORDER = ("fail", "stale", "uncovered", "pass")
_SIGNS = {"fail": "✗", "stale": "≠", "uncovered": "○", "pass": "✓"}


def parts(item: Item, woven: Woven) -> Iterator[str]:
    """The comparisons of a case, or the cases of any other item."""
    if item.kind == "case":
        yield from _comparisons(item, woven)
    elif about := cases_of(item.id, woven):
        rows = [[f"{{srs}}`{id}`", woven.spec.items[id].title, badge(id, woven)] for id in about]
        yield fence("dropdown", f"Cases ({len(rows)})", table(["", "case", "last result"], rows, style="cases"), depth=6, color="light")


def cases_of(id: str, woven: Woven) -> list[str]:
    """The cases that verify an item or use it."""
    found = [name for name in woven.used_by.get(id, []) if woven.spec.items[name].kind == "case"]
    return sorted(found, key=rank)


def _comparisons(item: Item, woven: Woven) -> Iterator[str]:
    yield fence("dropdown", "As written", code("yaml", woven.source(item)), depth=6, color="light")
    results = woven.results.get(item.id)
    if not results:
        yield f"*{NO_RESULTS}*\n"
        return
    rows = [[r.quantity, f"{r.error:.2g}", f"{r.tolerance:.2g}", mark(r.verdict)] for r in results]
    yield table(["compared", "error", "tolerance", ""], rows, style="results")


def verdict(id: str, woven: Woven) -> str:
    """The worst verdict of a case's comparisons."""
    found = {r.verdict for r in woven.results.get(id, [])}
    return next((word for word in _ORDER if word in found), "uncovered")


def badge(id: str, woven: Woven) -> str:
    """The verdict of a case as a coloured word."""
    return mark(verdict(id, woven))


def checked(ids: list[str], woven: Woven) -> str:
    """Links to cases, each with a sign of its last result."""
    signs = ((id, verdict(id, woven)) for id in ids)
    return " ".join(f"{{srs}}`{id}`[{_SIGNS[word]}]{{.sign .{word}}}" for id, word in signs)


def mark(word: str) -> str:
    """A verdict as a coloured word."""
    return f"[{word}]{{.verdict .{word}}}"
