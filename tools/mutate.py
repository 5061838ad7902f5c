"""Breaks the specification on purpose: `python -m tools.mutate [--only NAME]`.

Each executable equation is changed in each small way that a slip could take: a sign, an
operator, a dropped term, body A for body B, a wrong factor. A mutant is killed by the reader
(units, shapes, derivations, closed forms) or by the cases; one that survives shows a test that
is missing. One that gives the same numbers is none, such as a square of the opposite. Exits with
1 if one survives. It takes hours and is no part of CI.
"""

import argparse
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from copy import deepcopy
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import partial
from pathlib import Path

from rich.console import Console
from rich.progress import track

from tamias2d.errors import SpecError
from tamias2d.spec.chapter import Item
from tamias2d.spec.equations import Function
from tamias2d.spec.expression import (
    Binary,
    Both,
    Call,
    Name,
    Negative,
    Node,
    Number,
    Power,
    Relation,
    parse,
    parts,
    rebuilt,
)
from tamias2d.spec.formulas import check_item
from tamias2d.spec.implication import same
from tamias2d.spec.reader import read
from tamias2d.spec.specification import Specification
from tamias2d.spec.tex import plain
from tools.emit_functions import functions_by_module
from tools.generate import CODE, ROOT, outputs

_SWAPS = {"+": "-", "-": "+", "*": "/", "/": "*"}
_NOTHING_RAN = 5  # is what pytest answers where no case uses the item
_COPIED = ("src", "srs", "tests", "tools", "pyproject.toml")
_JUDGES = ("tests/generated/test_closed_forms.py", "tests/verify/test_cases.py")


@dataclass(frozen=True)
class Mutant:
    """One changed equation."""

    function: Function
    text: str

    def __str__(self) -> str:
        item = self.function.item
        line = item.at(self.function.key, self.function.name, "key")[0]
        return f"{item.file}:{line}: {self.function.name} = {self.text}"


def mutants(specification: Specification) -> Iterator[Mutant]:
    """All single changes of all executable equations."""
    for made in functions_by_module(specification).values():
        for function in made:
            seen = {plain(function.expression)}
            for tree in changes(function.expression):
                text = plain(tree)
                if text not in seen:
                    seen.add(text)
                    yield Mutant(function, text)


def changes(node: Node) -> Iterator[Node]:
    """The node with one change in it or below it."""
    yield from _changes_here(node)
    for part in parts(node):
        for other in changes(part):
            yield rebuilt(node, partial(_swap, part, other))


def _swap(old: Node, new: Node, node: Node) -> Node | None:
    return new if node is old else None


def _changes_here(node: Node) -> Iterator[Node]:
    match node:
        case Binary(operator=operator, left=left, right=right):
            yield replace(node, operator=_SWAPS[operator])
            if operator in "+-":
                yield left
                yield right
        case Negative(operand=operand):
            yield operand
        case Number(value=value):
            yield Number(value + 1)
        case Power(base=base):
            yield base
        case Call(function="cross", arguments=(a, b)):
            yield Call("cross", (b, a))
            yield Call("dot", (a, b))
        case Call(function="min", arguments=arguments):
            yield Call("max", arguments)
        case Name(name=name) if name.endswith(("_a", "_b")):
            yield Name(name[:-1] + ("b" if name.endswith("a") else "a"))
    if isinstance(node, Call | Name):
        yield Binary("*", Number(Fraction(2)), node)


def killed_by_reader(mutant: Mutant, specification: Specification) -> bool:
    """Whether the reader's checks refuse the changed item."""
    changed = _mutated(mutant, specification)
    return bool(check_item(changed, specification.items, specification.table))


def is_equal(mutant: Mutant, specification: Specification) -> bool:
    """Whether a mutant that the reader accepts gives the same numbers as what it replaces."""
    old, new = mutant.function.expression, parse(mutant.text)
    conditions = isinstance(old, Relation | Both)
    return not conditions and same(old, new, specification.table)


def _mutated(mutant: Mutant, specification: Specification) -> Item:
    item = deepcopy(specification.items[mutant.function.item.id])
    item.data[mutant.function.key][mutant.function.name] = mutant.text
    return item


def killed_by_cases(mutant: Mutant, specification: Specification, copy: Path) -> bool:
    """Whether a closed form or a case that uses the item fails on the code that it becomes."""
    changed = replace(specification, items=dict(specification.items))
    changed.items[mutant.function.item.id] = _mutated(mutant, specification)
    for path, text in outputs(changed).items():
        if path.startswith(CODE):
            (copy / path).write_text(text, encoding="utf-8")
    own = mutant.function.item.id
    concerned = [
        f"[{case.id}-"
        for case in specification.of_kind("case")
        if own in specification.closure(case)
    ]
    chosen = " or ".join([f"test_{own.lower()}_", *concerned])
    call = [sys.executable, "-m", "pytest", "-x", "-q", "-p", "no:cacheprovider", "-k", chosen]
    call += _JUDGES
    environment = {"PYTHONPATH": f"{copy / 'src'}:{copy}", "TAMIAS2D_HOME": str(copy), "PATH": ""}
    done = subprocess.run(call, cwd=copy, env=environment, capture_output=True, check=False)
    return done.returncode not in (0, _NOTHING_RAN)


def main() -> int:
    """Run the tool; returns the exit code."""
    parser = argparse.ArgumentParser(prog="python -m tools.mutate", description=__doc__)
    parser.add_argument("--only", help="the name of one function")
    wanted = parser.parse_args().only
    try:
        specification = read(ROOT / "srs")
    except SpecError as error:
        print(error, file=sys.stderr)
        return 2
    tried = [m for m in mutants(specification) if wanted in (None, m.function.name)]
    accepted = [m for m in tried if not killed_by_reader(m, specification)]
    left = [m for m in accepted if not is_equal(m, specification)]
    console = Console()
    killed, equal = len(tried) - len(accepted), len(accepted) - len(left)
    console.print(f"{len(tried)} mutants, {killed} killed by the reader, {equal} equal")
    with tempfile.TemporaryDirectory() as folder:
        for name in _COPIED:
            source = ROOT / name
            (shutil.copytree if source.is_dir() else shutil.copy)(source, Path(folder) / name)
        survivors = [
            m
            for m in track(left, "cases", console=console)
            if not killed_by_cases(m, specification, Path(folder))
        ]
    console.print(f"{len(left) - len(survivors)} killed by the cases, {len(survivors)} survive")
    for mutant in survivors:
        console.print(f"  survives: {mutant}", highlight=False, soft_wrap=True)
    return 1 if survivors else 0


if __name__ == "__main__":
    sys.exit(main())
