"""The modules of the package, read from their source without importing it.

Serves: the module guide, the interface reference and the internals. Hides: the form of a
docstring that says what its module serves and hides, and on which page a module stands.
"""

import ast
import re
from dataclasses import dataclass
from functools import cache
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
    def folder(self) -> str:
        """The package in whose folder it lies; of a package, itself."""
        inner = self.path.name == "__init__.py"
        return self.name if inner else self.name.rpartition(".")[0]

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


@cache
def modules(package: Path) -> tuple[Module, ...]:
    """Every module of a package: first what a user calls, then the parts, in the order of PARTS."""
    files = sorted(package.rglob("*.py"), key=lambda p: _place(p.relative_to(package)))
    return tuple(_parsed(path, package) for path in files)


def _parsed(path: Path, package: Path) -> Module:
    parts = [package.name, *path.relative_to(package).with_suffix("").parts]
    name = ".".join(parts[:-1] if parts[-1] == "__init__" else parts)
    return Module(name, path, ast.parse(path.read_text("utf-8")))


def _place(path: Path) -> tuple[int, str, bool, str]:
    first = path.parts[0] if len(path.parts) > 1 else ""
    rank = PARTS.index(first) if first in PARTS else len(PARTS)
    return rank, str(path.parent), path.name != "__init__.py", path.name


@cache
def folders(package: Path) -> dict[str, tuple[Module, ...]]:
    """The modules of a package and of each package inside it, by its name."""
    found: dict[str, list[Module]] = {}
    for module in modules(package):
        found.setdefault(module.folder, []).append(module)
    return {name: tuple(inside) for name, inside in found.items()}


def page_name(folder: str) -> str:
    """The name of the page of a package among the internals."""
    return folder.removeprefix("tamias2d.").replace(".", "-")


def page_of(name: str, package: Path) -> str:
    """The page of a module, or of a package."""
    return f"internals/{page_name(name if name in folders(package) else name.rpartition('.')[0])}"


def guide(package: Path) -> str:
    """A table of all packages: what each serves and hides."""
    rows = []
    for name, (head, *_) in folders(package).items():
        service, secret = head.service_and_secret
        rows.append(
            [f"{{package}}`{name}`", as_markdown(service or head.summary), as_markdown(secret)]
        )
    return table(["package", "serves", "hides"], rows, style="guide")


def listing(inside: tuple[Module, ...]) -> str:
    """A table of the modules of one package, with a sentence on each."""
    rows = [[f"{{module}}`{one.name}`", as_markdown(one.summary)] for one in inside]
    return table(["module", "what it is"], rows, style="guide")
