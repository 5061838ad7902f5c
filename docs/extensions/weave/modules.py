"""The modules of the package, read from their source without importing it.

Serves: the module guide, the interface reference and the internals. Hides: the form of a
docstring that says what its module serves and hides.
"""

import ast
import re
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from weave.markdown import as_markdown, table

_GUIDE = re.compile(
    r"\b(?:Serves|Service):\s*(?P<service>.+?)\s*\b(?:Hides|Secret):\s*(?P<secret>.+?)(?=\n\s*\n|\Z)",
    re.S,
)


PARTS = (
    "",
    "scene",
    "motion",
    "contact",
    "kernels",
    "stepped",
    "engine",
    "simulator",
    "study",
    "record",
    "verify",
    "spec",
    "generated",
)


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
        says = [
            text[:1].upper() + text[1:] for text in (module.summary, *module.service_and_secret)
        ]
        link = f"{{module}}`{module.name}`"
        parts.setdefault(module.part, []).append([link, *map(as_markdown, says)])
    return "\n".join(
        f"**{name}**\n\n" + table(["module", "what it is", "serves", "hides"], rows, style="guide")
        for name, rows in parts.items()
    )
