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
    "event_driven",
    "kernels",
    "engine",
    "simulator",
    "record",
    "solve",
    "study",
    "ensemble",
    "verify",
    "commands",
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
    """For each part of the package what it serves and hides, and a table of its modules."""
    heads: dict[str, str] = {}
    rows: dict[str, list[list[str]]] = {}
    for module in modules(package):
        service, secret = module.service_and_secret
        if service and module.name == module.part:
            heads[module.part] = as_markdown(f"Serves: {service} Hides: {secret}")
        link = f"{{module}}`{module.name}`"
        rows.setdefault(module.part, []).append([link, as_markdown(module.summary)])
    return "\n".join(
        f"**{name}**\n\n{heads.get(name, '')}\n\n"
        + table(["module", "what it is"], found, style="guide")
        for name, found in rows.items()
    )
