"""The pages about the program: module guide, interface reference, internals, error codes.

Serves: `{module-guide}`, `{interface}`, `{internals}`, `{refusals}`, `{error-codes}`.
Hides: which files they list.
"""

import ast
from collections.abc import Iterator, Sequence

from docutils import nodes

from tamias2d.spec.messages import Code
from weave.chapter import WovenDirective
from weave.interface import described, exported, public, reference
from weave.links import module_anchor
from weave.markdown import bullets, table
from weave.modules import Module, folders, guide, listing, modules
from weave.public_names import public_name


class GuideDirective(WovenDirective):
    """What each package serves and what it hides."""

    def run(self) -> list[nodes.Node]:
        box = nodes.container(classes=["srs-wide"])
        self.parse(guide(self.woven.root / "src/tamias2d"), box)
        return [box]


class InterfaceDirective(WovenDirective):
    """The public names that the fence lists, as a user writes them: `t2.Scene`."""

    def run(self) -> list[nodes.Node]:
        every = modules(self.woven.root / "src/tamias2d")
        return [self._section(name, every) for name in " ".join(self.content).split()]

    def _section(self, name: str, every: Sequence[Module]) -> nodes.section:
        section = nodes.section(ids=[f"t2-{name}"], classes=["srs-module"])
        section += nodes.title("", "", nodes.literal("", f"t2.{name}"))
        self.parse(public_name(name, every), section)
        return section


class InternalsDirective(WovenDirective):
    """`{internals} tamias2d.scene`: the modules of a package with their public names.

    Generated ones name their functions, whose code stands with the items.
    """

    def run(self) -> list[nodes.Node]:
        inside = folders(self.woven.root / "src/tamias2d")[self.arguments[0]]
        box = nodes.container(classes=["srs-wide"])
        self.parse(listing(inside), box)
        return [box, *(self._section(module) for module in inside)]

    def _section(self, module: Module) -> nodes.section:
        section = nodes.section(ids=[module_anchor(module.name)], classes=["srs-module"])
        section += nodes.title("", "", nodes.literal("", module.name.removeprefix("tamias2d.")))
        self.parse(described(module.tree), section)
        self.parse("\n".join(_contents(module)), section)
        return section


def _contents(module: Module) -> Iterator[str]:
    if module.path.name == "__init__.py":
        found = exported(module.tree)
        yield bullets(f"{{module}}`{home}`: {_code_list(names)}" for home, names in found)
    if ".generated." in module.name:
        names = _code_list([node.name for node in public(module.tree)])
        yield f"Printed from the specification: {names}."
    else:
        yield from reference(module.tree)


def _code_list(names: list[str]) -> str:
    return ", ".join(f"`{name}`" for name in names)


class RefusalsDirective(WovenDirective):
    """The stable codes of what is refused while a scene runs."""

    def run(self) -> list[nodes.Node]:
        box = nodes.container()
        rows = [
            [f"`{code}`", f"`{node.name}`", described(node).splitlines()[0]]
            for module in modules(self.woven.root / "src/tamias2d")
            for node in public(module.tree)
            for code in _codes(node)
        ]
        self.parse(table(["code", "class", "means"], rows), box)
        return [box]


def _codes(node: ast.stmt) -> Iterator[str]:
    """The value that a class gives to `code`."""
    for line in node.body if isinstance(node, ast.ClassDef) else ():
        if isinstance(line, ast.Assign | ast.AnnAssign) and isinstance(line.value, ast.Constant):
            target = line.targets[0] if isinstance(line, ast.Assign) else line.target
            if ast.unparse(target) == "code":
                yield str(line.value.value)


class CodesDirective(WovenDirective):
    """The stable codes of faults in chapters."""

    def run(self) -> list[nodes.Node]:
        box = nodes.container()
        self.parse(table(["code", "means"], [[f"`{c.code}`", c.meaning] for c in Code]), box)
        return [box]
