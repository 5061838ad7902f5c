"""Traceability as tables: which item stands on which.

Serves: `{matrix}`, `{requirements}` and `{plan-table}`. Hides: how a chain of links is followed.
"""

from docutils import nodes

from tamias2d.spec.chapter import Item
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
    """Requirement, the models that meet it, their functions, the cases and the last results."""

    def run(self) -> list[nodes.Node]:
        box = nodes.container()
        rows = [_requirement_row(i, self.woven) for i in self.woven.spec.of_kind("requirement")]
        self.parse(table(["", "requirement", "stands on", "runs as", "cases"], rows), box)
        return [box]


def _requirement_row(item: Item, woven: Woven) -> list[str]:
    uses = item.data.get("uses", [])
    code = [f"`{c.function}`" for id in uses for c in woven.code.get(id, [])]
    by_people = "judged by people" if item.data.get("judged") else "none"
    checks = checked(cases_of(item.id, woven), woven)
    return [f"{{srs}}`{item.id}`", item.title, ids(uses), " ".join(code), checks or by_people]


class PlanTableDirective(WovenDirective):
    """Table 1 of the verification plan, drawn from the cases as they now stand."""

    def run(self) -> list[nodes.Node]:
        box = nodes.container()
        cases = [i for i in self.woven.spec.of_kind("case") if i.id.startswith("TC")]
        rows = [
            _plan_row(case, self.woven) for case in sorted(cases, key=lambda case: rank(case.id))
        ]
        self.parse(table(["", "case", "models", "requirements", "last result"], rows), box)
        return [box]


def _plan_row(case: Item, woven: Woven) -> list[str]:
    models = [id for id in case.data.get("uses", []) if id.startswith(("IM", "GD"))]
    requirements = [id for id in case.data["verifies"] if id.startswith(("R", "NFR"))]
    return [
        f"{{srs}}`{case.id}`",
        case.title,
        ids(models),
        ids(requirements),
        badge(case.id, woven),
    ]
