"""A generated step on vectors, taken apart into statements on numbers.

Serves: the maker of sources. Hides: how the syntax tree of a generated scheme is rewritten, axis
by axis, with the accelerations that it asks for put in front of the statement that uses them.
"""

import ast
from collections.abc import Callable, Iterator, Sequence
from copy import deepcopy
from typing import Any

from tamias2d.kernels.copied import function_of

Pull = Callable[[str], Iterator[str]]
"""Statements that set an acceleration of some name from `at_time`, `at_position_x` and so on."""
_NUMBERS = {"time", "time_step"}


def statements(scheme: Callable[..., Any], axes: Sequence[str], pull: Pull) -> Iterator[str]:
    """Yield a step of one body, from and to `position_<axis>` and `velocity_<axis>`."""
    for statement in function_of(scheme).body:
        if isinstance(statement, ast.Assign):
            asked = _Asked()
            value = asked.visit(deepcopy(statement.value))
            for name, call in asked.calls.items():
                yield from _place(call, axes)
                yield from pull(name)
            yield from _along(axes, _name(statement.targets[0]), value)
        elif isinstance(statement, ast.Return) and isinstance(statement.value, ast.Tuple):
            for state, end in zip(("position", "velocity"), statement.value.elts, strict=True):
                if _name(end) != state:
                    yield from _along(axes, state, end)


def _name(node: ast.expr) -> str:
    if not isinstance(node, ast.Name):
        raise TypeError(ast.unparse(node))
    return node.id


def _place(call: ast.Call, axes: Sequence[str]) -> Iterator[str]:
    """Statements that say for which time and state an acceleration is asked."""
    time, position, velocity = call.args
    yield f"at_time = {ast.unparse(time)}"
    yield from _along(axes, "at_position", position)
    yield from _along(axes, "at_velocity", velocity)


def _along(axes: Sequence[str], target: str, value: ast.expr) -> Iterator[str]:
    for axis in axes:
        yield f"{target}_{axis} = {ast.unparse(_OnAxis(axis).visit(deepcopy(value)))}"


class _Asked(ast.NodeTransformer):
    """Puts a name in the place of each acceleration, and keeps the call."""

    def __init__(self) -> None:
        self.calls: dict[str, ast.Call] = {}

    def visit_Call(self, node: ast.Call) -> ast.expr:
        """Replace a call of `acceleration`."""
        name = f"pull{len(self.calls)}" if self.calls else "pull"
        self.calls[name] = node
        return ast.Name(name)


class _OnAxis(ast.NodeTransformer):
    """Puts the component along an axis in the place of each vector."""

    def __init__(self, axis: str) -> None:
        self.axis = axis

    def visit_Name(self, node: ast.Name) -> ast.expr:
        """Rename a vector; numbers stay."""
        return node if node.id in _NUMBERS else ast.Name(f"{node.id}_{self.axis}")
