"""The Sphinx extension that weaves srs/ into pages.

Serves: docs/conf.py. Hides: which directives and roles there are.
"""

from pathlib import Path
from typing import Any

from sphinx.application import Sphinx
from sphinx.environment import BuildEnvironment
from sphinx.errors import SphinxError

from tamias2d.errors import SpecError
from weave import fronts, gallery
from weave.chapter import IndicesDirective, ItemDirective, SymbolsDirective, item_kinds
from weave.checks import on_build_finished
from weave.guide import (
    CodesDirective,
    GuideDirective,
    InterfaceDirective,
    InternalsDirective,
    RefusalsDirective,
)
from weave.links import ItemRole, ModuleRole, PackageRole, SymbolRole
from weave.mirror import on_builder_inited
from weave.traceability import (
    CasesDirective,
    DemandsDirective,
    DependentsDirective,
    PlanTableDirective,
)
from weave.verification import PublishedDirective, ResultsDirective, SurveyDirective
from weave.woven import weave

_TABLES = {
    "symbols": SymbolsDirective,
    "indices": IndicesDirective,
    "demands": DemandsDirective,
    "dependents": DependentsDirective,
    "cases-table": CasesDirective,
    "published-tables": PublishedDirective,
    "all-results": ResultsDirective,
    "survey": SurveyDirective,
    "plan-table": PlanTableDirective,
    "gallery": gallery.GalleryDirective,
    "front": fronts.FrontDirective,
    "fastest": fronts.FastestDirective,
    "module-guide": GuideDirective,
    "interface": InterfaceDirective,
    "internals": InternalsDirective,
    "refusals": RefusalsDirective,
    "error-codes": CodesDirective,
}


class SpecificationFaultError(SphinxError):
    """The chapters cannot be read."""

    category = "The specification has faults"


def _read(app: Sphinx) -> None:
    try:
        app.woven = weave(Path(app.srcdir).parent)  # type: ignore[attr-defined]
    except SpecError as error:
        raise SpecificationFaultError(f"nothing can be woven:\n{error}") from None


def _all_pages(_app: Sphinx, env: BuildEnvironment, *_changes: set[str]) -> set[str]:
    return env.found_docs  # any page may show code, results or links that have changed


def setup(app: Sphinx) -> dict[str, Any]:
    """Register the mirror, a directive for each kind of fence, the tables and the checks."""
    app.connect("builder-inited", _read)
    app.connect("builder-inited", on_builder_inited)
    app.connect("builder-inited", gallery.on_builder_inited)
    app.connect("builder-inited", fronts.on_builder_inited)
    app.connect("env-get-outdated", _all_pages)
    app.connect("build-finished", on_build_finished)
    for kind in item_kinds():
        app.add_directive(kind, ItemDirective)
    for name, directive in _TABLES.items():
        app.add_directive(name, directive)
    app.add_role("srs", ItemRole())
    app.add_role("module", ModuleRole())
    app.add_role("package", PackageRole())
    app.add_role("symbol", SymbolRole())
    return {"version": "1", "parallel_read_safe": False, "parallel_write_safe": True}
