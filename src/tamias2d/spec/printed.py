"""Scalar expressions printed as Python functions, with the numbers in them apart.

Serves: laws of force, which are evaluated many times. Hides: how a text becomes a function whose
lines a traceback shows. Expressions that differ in their numbers alone have one text.
"""

import linecache
from collections.abc import Callable
from functools import cache
from typing import Any

from tamias2d.spec import library_functions
from tamias2d.spec.expression import Measure, Node, Number
from tamias2d.spec.python import PythonPrinter
from tamias2d.spec.symbols import SymbolTable

_ARGUMENTS = "numbers, time, position, velocity, orientation, angular_velocity, mass"


class LawPrinter(PythonPrinter):
    """Prints a law; its numbers become `numbers[0]`, `numbers[1]` and so on."""

    def __init__(self, table: SymbolTable) -> None:
        super().__init__(table)
        self.numbers: list[float] = []
        self._place: dict[int, int] = {}

    def scalar(self, node: Node) -> str:
        """Source of a scalar or a condition."""
        if not isinstance(node, Number | Measure):
            return super().scalar(node)
        if id(node) not in self._place:
            self._place[id(node)] = len(self.numbers)
            self.numbers.append(node.number)
        return f"numbers[{self._place[id(node)]}]"


def shape_of(node: Node, table: SymbolTable) -> tuple[str, tuple[float, ...]]:
    """Return the source of a scalar law, and the numbers in it."""
    printer = LawPrinter(table)
    text = printer.scalar(node)
    return text, tuple(printer.numbers)


@cache
def law_function(shape: str) -> Callable[..., Any]:
    """Return a law of some shape as a function of its numbers, of time, state and mass.

    Each is a float or an array of n. The bits of a value do not depend on which.
    """
    text = (
        f"def law({_ARGUMENTS}):\n"
        "    position_x, position_y = position\n"
        "    velocity_x, velocity_y = velocity\n"
        f"    return {shape}\n"
    )
    name = f"<tamias2d law {shape}>"
    linecache.cache[name] = (len(text), None, text.splitlines(keepends=True), name)
    names = dict(vars(library_functions))
    exec(compile(text, name, "exec"), names)
    function: Callable[..., Any] = names["law"]
    return function
