"""The module guide and the interface reference, read from the source without importing it.

Serves: `{module-guide}` and `{interface}`. Hides: how Python's syntax tree is searched.
"""

import ast
import re
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from weave.markdown import code, table

_GUIDE = re.compile(
    r"\b(?:Serves|Service):\s*(?P<service>.+?)\s*\b(?:Hides|Secret):\s*(?P<secret>.+?)(?=\n\s*\n|\Z)",
    re.S,
)


PARTS = ("", "scene", "motion", "contact", "record", "verify", "spec", "generated")
WIDTH = 84  # letters of code beside each other


@dataclass(frozen=True)
class Module:
    """One file of the package, parsed."""

    name: str
    path: Path
    tree: ast.Module

    @property
    def part(self) -> str:
        """The package of the first level that it belongs to."""
        above = self.name.split(".")
        inner = len(above) > 2 or self.path.name == "__init__.py"
        return ".".join(above[:2]) if inner else above[0]

    @property
    def docstring(self) -> str:
        return ast.get_docstring(self.tree) or ""

    @property
    def summary(self) -> str:
        """The docstring's first sentence."""
        return sentence(self.docstring.split("\n\n")[0])

    @property
    def service_and_secret(self) -> tuple[str, str]:
        """What the module does for others, and what they need not know; empty if unsaid."""
        found = _GUIDE.search(self.docstring)
        return (sentence(found["service"]), sentence(found["secret"])) if found else ("", "")


def sentence(text: str) -> str:
    """The first sentence of a text on one line."""
    return re.split(r"(?<=[.])\s", " ".join(text.split()))[0]


def modules(package: Path) -> Iterator[Module]:
    """Every module of a package: first what a user calls, then the parts, in the order of PARTS."""
    for path in sorted(package.rglob("*.py"), key=lambda p: _place(p.relative_to(package))):
        parts = [package.name, *path.relative_to(package).with_suffix("").parts]
        name = ".".join(parts[:-1] if parts[-1] == "__init__" else parts)
        yield Module(name, path, ast.parse(path.read_text("utf-8")))


def _place(path: Path) -> tuple[int, str]:
    first = path.parts[0] if len(path.parts) > 1 else ""
    return (PARTS.index(first) if first in PARTS else len(PARTS)), str(path)


def guide(package: Path) -> str:
    """A table of services and secrets for each part of the package."""
    parts: dict[str, list[list[str]]] = {}
    for module in modules(package):
        says = [module.summary, *module.service_and_secret]
        link = f"{{module}}`{module.name}`"
        parts.setdefault(module.part, []).append([link, *map(_markdown, says)])
    return "\n".join(
        f"**{name}**\n\n" + table(["module", "what it is", "serves", "hides"], rows, style="guide")
        for name, rows in parts.items()
    )


def public(tree: ast.Module | ast.ClassDef) -> Iterator[ast.FunctionDef | ast.ClassDef]:
    """The functions and classes without a leading underscore."""
    for node in tree.body:
        if isinstance(node, ast.FunctionDef | ast.ClassDef) and not node.name.startswith("_"):
            yield node


def signature(node: ast.FunctionDef | ast.ClassDef) -> str:
    """How a function or class is declared, as it is written, on as many lines as it needs."""
    if isinstance(node, ast.ClassDef):
        bases = ", ".join(map(ast.unparse, node.bases))
        fields = [ast.unparse(line) for line in node.body if isinstance(line, ast.AnnAssign)]
        head = f"class {node.name}({bases})" if bases else f"class {node.name}"
        return "\n    ".join([f"{head}:", *fields]) if fields else head
    returns = f" -> {ast.unparse(node.returns)}" if node.returns else ""
    flat = f"{node.name}({ast.unparse(node.args)}){returns}"
    if len(flat) <= WIDTH:
        return flat
    arguments = ",\n    ".join(_arguments(node.args))
    return f"{node.name}(\n    {arguments},\n){returns}"


def _arguments(args: ast.arguments) -> Iterator[str]:
    """Each argument as it is written; ast.unparse knows commas that are not within brackets."""
    depth, start, text = 0, 0, ast.unparse(args)
    for k, letter in enumerate(text):
        depth += (letter in "[({") - (letter in "])}")
        if letter == "," and depth == 0:
            yield text[start:k].strip()
            start = k + 1
    yield text[start:].strip()


def described(node: ast.FunctionDef | ast.ClassDef | ast.Module) -> str:
    """A docstring as Markdown; indented sections such as `Raises:` become quotations."""
    lines = (ast.get_docstring(node) or "").splitlines()
    return "\n".join(_markdown(re.sub(r"^ {4,}", "> ", line)) for line in lines)


def _markdown(text: str) -> str:
    """Plain text in which nothing but `code` is markup."""
    halves = text.split("`")
    return "`".join(
        re.sub(r"([*_$<>{}\[\]|#])", r"\\\1", h) if n % 2 == 0 else h for n, h in enumerate(halves)
    )


def reference(module: Module) -> Iterator[str]:
    """Signature and docstring of each public name of a module."""
    for node in public(module.tree):
        yield code("python", signature(node))
        yield described(node) + "\n"
        if isinstance(node, ast.ClassDef):
            for inner in public(node):
                if ast.get_docstring(inner):
                    kind = "property " if _is_property(inner) else ""
                    yield (
                        f"* `{kind}{signature(inner)}` \\\n  {described(inner)}".replace(
                            "\n", "\n  "
                        )
                        + "\n"
                    )


def _is_property(node: ast.FunctionDef | ast.ClassDef) -> bool:
    return any("property" in ast.unparse(d) for d in node.decorator_list)
