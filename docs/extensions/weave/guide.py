"""The pages about the program: module guide, interface reference, error codes.

Serves: `{module-guide}`, `{interface}`, `{error-codes}`. Hides: which files are listed.
"""

from docutils import nodes

from tamias2d.spec.messages import Code
from weave.chapter import WovenDirective
from weave.links import module_anchor
from weave.markdown import table
from weave.modules import Module, described, guide, modules, public, reference


class GuideDirective(WovenDirective):
    """What each module serves and what it hides."""

    def run(self) -> list[nodes.Node]:
        box = nodes.container(classes=["srs-wide"])
        self.parse(guide(self.woven.root / "src/tamias2d"), box)
        return [box]


class InterfaceDirective(WovenDirective):
    """Every module with its public names; generated ones show their code with their items."""

    def run(self) -> list[nodes.Node]:
        package = self.woven.root / "src/tamias2d"
        return [self._section(module) for module in modules(package)]

    def _section(self, module: Module) -> nodes.section:
        section = nodes.section(ids=[module_anchor(module.name)], classes=["srs-module"])
        section += nodes.title("", "", nodes.literal("", module.name.removeprefix("tamias2d.")))
        self.parse(described(module.tree), section)
        if ".generated." not in module.name:
            self.parse("\n".join(reference(module)), section)
        else:
            names = ", ".join(f"`{node.name}`" for node in public(module.tree))
            self.parse(f"Printed from the specification: {names}.", section)
        return section


class CodesDirective(WovenDirective):
    """The stable codes of faults in chapters."""

    def run(self) -> list[nodes.Node]:
        box = nodes.container()
        self.parse(table(["code", "means"], [[f"`{c.code}`", c.meaning] for c in Code]), box)
        return [box]
