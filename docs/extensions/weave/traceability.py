"""Traceability as lists: what a demand rests on, what a change of an item touches.

Serves: `{demands}`, `{dependents}`, `{cases-table}` and `{plan-table}`. Hides: how a chain of links
is followed.
"""

from collections.abc import Iterable

from docutils import nodes

from tamias2d.spec.chapter import Item
from tamias2d.trace import plan_table
from weave.cases import badge, cases_of, checked
from weave.chapter import WovenDirective
from weave.links import ids, linked, rank
from weave.markdown import bullets, fence, table
from weave.woven import Woven

_PLURALS = {"theory": "theories", "property": "properties"}


class DemandsDirective(WovenDirective):
    """Each goal and requirement with what it rests on, the functions that run, and the cases."""

    def run(self) -> list[nodes.Node]:
        box = nodes.container(classes=["srs-wide"])
        found = self.woven.spec.of_kind("goal", "requirement")
        self.parse("\n".join(demand(item, self.woven) for item in found), box)
        return [box]


def demand(item: Item, woven: Woven) -> str:
    """A goal or a requirement, folded: its words, its cases, and a row for each item it names."""
    own = cases_of(item.id, woven)
    used = sorted(item.data.get("uses", []), key=rank)
    rows = [_used_row(id, own, woven) for id in used]
    parts = [f"{{srs}}`{item.id}` {linked(item.data['says'], woven)}\n"]
    parts += [f"*Cases:* {checked(own, woven)}\n"] if own else []
    parts += [table(["", "rests on", "runs as", "cases of both"], rows)] if rows else []
    title = f"{item.id} {item.title}: {woven.verdict(item.id)}"
    return fence("dropdown", title, "\n".join(parts), depth=6, color="light")


def _used_row(id: str, own: list[str], woven: Woven) -> list[str]:
    """The cells of an item that a demand names; last the demand's cases in which it takes part."""
    code = " ".join(f"`{function}`" for function, _ in woven.code(id))
    both = [case for case in own if case in woven.graph.backward[id]]
    judged = checked(both, woven) if both else badge(id, woven)
    return [f"{{srs}}`{id}`", woven.spec.items[id].title, code, judged]


class DependentsDirective(WovenDirective):
    """`{dependents} model`: what a change of each item of a kind touches."""

    def run(self) -> list[nodes.Node]:
        box = nodes.container()
        found = self.woven.spec.of_kind(self.arguments[0])
        texts = (dependents(i, self.woven) for i in sorted(found, key=lambda item: rank(item.id)))
        self.parse("\n".join(texts), box)
        return [box]


def dependents(item: Item, woven: Woven) -> str:
    """The items that name an item, folded, by kind; how many rest on it through others, too."""
    graph, kinds = woven.graph, woven.spec.items
    direct = [id for id in graph.backward[item.id] if kinds[id].kind != "erratum"]
    if not direct:
        return ""
    lines = [f"{{srs}}`{item.id}` itself, {item.kind}"]
    for kind in dict.fromkeys(kinds[id].kind for id in direct):
        lines.append(_kind_line(kind, [id for id in direct if kinds[id].kind == kind]))
    every = len(graph.dependents(item.id))
    title = f"{item.id} {item.title}: named by {len(direct)}, {every} rest on it"
    return fence("dropdown", title, bullets(lines), depth=6, color="light")


def _kind_line(kind: str, found: Iterable[str]) -> str:
    return f"{_PLURALS.get(kind, f'{kind}s')}: {ids(found)}"


class CasesDirective(WovenDirective):
    """Each case with the demands that it checks, and its verdict."""

    def run(self) -> list[nodes.Node]:
        box = nodes.container()
        found = sorted(self.woven.spec.of_kind("case"), key=lambda item: rank(item.id))
        rows = (_case_row(case, self.woven) for case in found)
        self.parse(table(["", "case", "checks", "verdict"], rows, style="cases"), box)
        return [box]


def _case_row(case: Item, woven: Woven) -> list[str]:
    return [f"{{srs}}`{case.id}`", case.title, ids(case.data["verifies"]), badge(case.id, woven)]


class PlanTableDirective(WovenDirective):
    """Table 1 of the verification plan, drawn from the cases as they now stand."""

    def run(self) -> list[nodes.Node]:
        box = nodes.container(classes=["srs-wide"])
        columns, cases = plan_table()
        head = ["case", *(f"{{srs}}`{id}`" for id in columns)]
        rows = (
            [f"{checked([id], self.woven)} {title}", *("●" if mark else "" for mark in marks)]
            for id, title, marks in cases
        )
        self.parse(table(head, rows, style="matrix"), box)
        return [box]
