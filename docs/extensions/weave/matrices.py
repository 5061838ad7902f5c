"""Traceability as tables: which item stands on which.

Serves: `{matrix}`, `{requirements}` and `{plan-table}`. Hides: how a chain of links is followed.
"""

from docutils import nodes

from tamias2d.spec.chapter import Item
from tamias2d.trace import plan_table
from weave.cases import badge, cases_of, checked
from weave.chapter import WovenDirective
from weave.links import ids, rank
from weave.markdown import table
from weave.woven import Woven


class MatrixDirective(WovenDirective):
    """`{matrix} rows by columns`: kinds of item; a mark where the row's item names the column's."""

    def run(self) -> list[nodes.Node]:
        rows, _, columns = self.arguments[0].partition(" by ")
        box = nodes.container(classes=["srs-wide"])
        self.parse(matrix(rows.split(), columns.split(), self.woven), box)
        return [box]


def matrix(row_kinds: list[str], column_kinds: list[str], woven: Woven) -> str:
    """The links between kinds of item; empty rows and columns are left out."""
    kept = (i for i in woven.spec.of_kind(*row_kinds) if _names(i, column_kinds, woven))
    rows = sorted(kept, key=lambda item: rank(item.id))
    used = {id for row in rows for id in _names(row, column_kinds, woven)}
    columns = sorted(used, key=rank)
    head = ["", *(f"{{srs}}`{id}`" for id in columns)]
    cells = (
        [f"{{srs}}`{row.id}`", *("●" if id in woven.spec.linked(row) else "" for id in columns)]
        for row in rows
    )
    return table(head, cells, style="matrix")


def _names(item: Item, kinds: list[str], woven: Woven) -> list[str]:
    return [
        id for id in woven.spec.linked(item) if id != "none" and woven.spec.items[id].kind in kinds
    ]


class RequirementsDirective(WovenDirective):
    """Goal or requirement, what it stands on, the functions that run, the cases, the verdict."""

    def run(self) -> list[nodes.Node]:
        box = nodes.container(classes=["srs-wide"])
        demands = self.woven.spec.of_kind("goal", "requirement")
        rows = [_demand_row(item, self.woven) for item in demands]
        self.parse(table(["", "", "stands on", "runs as", "cases", "verdict"], rows), box)
        return [box]


def _demand_row(item: Item, woven: Woven) -> list[str]:
    uses = item.data.get("uses", [])
    code = " ".join(f"`{function}`" for id in uses for function, _ in woven.code(id))
    cases = checked(cases_of(item.id, woven), woven)
    return [f"{{srs}}`{item.id}`", item.title, ids(uses), code, cases, badge(item.id, woven)]


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
