"""Sizes of functions: `python -m tools.sizes`.

It prints the longest functions of src/, those with most positional parameters, and the median
length in each package. Generated code is left out. It exits with 1 where a limit is passed: 60
lines, 10 positional parameters, a median of 15 lines. Lines are those from `def` to the end,
without the docstring; `self` and what can only be given by keyword are no positional parameters.
"""

import ast
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from operator import attrgetter
from pathlib import Path
from statistics import median

from rich.console import Console
from rich.table import Table

SOURCE = Path(__file__).resolve().parent.parent / "src/tamias2d"
LINES, POSITIONAL, MEDIAN = 60, 10, 15
EXCEPTIONS: dict[str, str] = {}
"""Functions that may pass a limit, as `package/file.py:Class.function`, each with the reason."""
_SHOWN = 8


@dataclass(frozen=True)
class Size:
    """The size of one function."""

    name: str
    """`package/file.py:Class.function`"""
    line: int
    lines: int
    positional: int

    @property
    def package(self) -> str:
        """The folder of the first level, or nothing for a file beside the folders."""
        return self.name.partition("/")[0] if "/" in self.name else ""

    @property
    def allowed(self) -> bool:
        """Whether it is within the limits of one function."""
        return self.lines <= LINES and self.positional <= POSITIONAL


def sizes(source: Path) -> list[Size]:
    """The sizes of all functions below a folder, but for generated ones."""
    found: list[Size] = []
    for path in sorted(source.rglob("*.py")):
        relative = path.relative_to(source)
        if "generated" not in relative.parts:
            tree = ast.parse(path.read_text(encoding="utf-8"))
            found += _inside(tree, f"{relative.as_posix()}:")
    return found


def _inside(parent: ast.AST, prefix: str) -> Iterator[Size]:
    for node in ast.iter_child_nodes(parent):
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
            method = isinstance(parent, ast.ClassDef)
            yield Size(prefix + node.name, node.lineno, _lines(node), _positional(node, method))
            yield from _inside(node, f"{prefix}{node.name}.")
        elif isinstance(node, ast.ClassDef):
            yield from _inside(node, f"{prefix}{node.name}.")
        else:
            yield from _inside(node, prefix)


def _lines(node: ast.FunctionDef | ast.AsyncFunctionDef) -> int:
    lines = (node.end_lineno or 0) - node.lineno + 1
    if ast.get_docstring(node, clean=False) is not None:
        lines -= (node.body[0].end_lineno or 0) - node.body[0].lineno + 1
    return lines


def _positional(node: ast.FunctionDef | ast.AsyncFunctionDef, method: bool) -> int:
    free = any(isinstance(d, ast.Name) and d.id == "staticmethod" for d in node.decorator_list)
    return len(node.args.posonlyargs + node.args.args) - (method and not free)


def medians(found: list[Size]) -> dict[str, float]:
    """The median length of the functions of each package."""
    packages = sorted({size.package for size in found})
    return {p: median(size.lines for size in found if size.package == p) for p in packages}


def faults(found: list[Size]) -> list[str]:
    """One line for each limit that is passed, and for each exception that nothing needs."""
    known = {size.name: size for size in found}
    unneeded = [name for name in EXCEPTIONS if name not in known or known[name].allowed]
    passed = [size for size in found if not size.allowed and size.name not in EXCEPTIONS]
    return [
        *(
            f"{size.name}: found {size.lines} lines and {size.positional} positional parameters: "
            f"must have at most {LINES} and {POSITIONAL}. Divide it, or group its parameters."
            for size in passed
        ),
        *(
            f"{package or 'src'}: found a median of {middle:g} lines: must be at most {MEDIAN}. "
            "Divide its functions."
            for package, middle in medians(found).items()
            if middle > MEDIAN
        ),
        *(f"{name}: is within the limits. Remove it from EXCEPTIONS." for name in unneeded),
    ]


def main(source: Path = SOURCE) -> int:
    """Run the tool; returns the exit code."""
    found = sizes(source)
    console = Console()
    for title, key in (("Longest", "lines"), ("Most positional parameters", "positional")):
        console.print(_table(title, sorted(found, key=attrgetter(key), reverse=True)[:_SHOWN]))
    middles = ", ".join(f"{p or 'src'} {middle:g}" for p, middle in medians(found).items())
    console.print(f"{len(found)} functions; median lines: {middles}")
    wrong = faults(found)
    for fault in wrong:
        print(fault, file=sys.stderr)
    return 1 if wrong else 0


def _table(title: str, rows: list[Size]) -> Table:
    table = Table("function", "lines", "positional", title=title, title_justify="left")
    for size in rows:
        table.add_row(size.name, str(size.lines), str(size.positional))
    return table


if __name__ == "__main__":
    sys.exit(main())
