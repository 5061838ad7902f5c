"""A constraint: an equation in the positions of bodies, and all that follows from it.

Serves: the joints of the specification, and those that a scene states by an equation of its own.
Hides: how the equation is differentiated. Given is C(q, t), which is to stay zero; found are its
slopes with respect to each coordinate of each body (the Jacobian), its rate along the motion, and
its convective part: the second derivative along the motion where no body is accelerated.
"""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

from tamias2d.spec.check import Type, infer
from tamias2d.spec.derivative import along
from tamias2d.spec.expression import Call, Name, Negative, Node, Number, names, rebuilt
from tamias2d.spec.messages import SpecFault
from tamias2d.spec.simplify import ONE, ZERO, component
from tamias2d.spec.symbols import Shape, Symbol, SymbolTable
from tamias2d.spec.whole_turns import without_turns

COORDINATES = {"position": "velocity", "orientation": "angular_velocity"}
"""What says where a body is, and the name of its rate."""
ENDS = ("a", "b", "c")
"""The indices of the bodies of a constraint."""
TIME = "time"
_AXES = (Call("vector", (ONE, ZERO)), Call("vector", (ZERO, ONE)))

Named = tuple[tuple[str, Node], ...]
"""Quantities with names, each written with those before it."""


@dataclass(frozen=True)
class Values:
    """Scalars, each an expression, and the named quantities that they are written with."""

    rows: tuple[Node, ...]
    where: Named


@dataclass(frozen=True)
class Constraint:
    """Equations with a zero on the right side, and named quantities in them.

    Every method raises `ValueError` where a part of an equation has no derivative.
    """

    equations: tuple[Node, ...]
    where: Named
    table: SymbolTable

    @cached_property
    def bodies(self) -> tuple[str, ...]:
        """The indices of the bodies whose coordinates stand in it."""
        trees = (*self.equations, *(tree for _, tree in self.where))
        used = {name for node in trees for name in names(node)}
        return tuple(
            end for end in ENDS if any(f"{coordinate}_{end}" in used for coordinate in COORDINATES)
        )

    @cached_property
    def types(self) -> tuple[Type, ...]:
        """Shape and unit of each equation."""
        return tuple(infer(node, self.table) for node in self.equations)

    def values(self) -> Values:
        """The equations as scalars: zero where the constraint holds."""
        table = table_with(self.table, self.where)
        rows = tuple(without_turns(row, table) for row in self._rows(self.equations))
        return Values(rows, _needed(rows, self.where))

    def slopes(self, end: str) -> Values:
        """How each row changes with x, y and orientation of one body, three rows for each."""
        seeds = [{f"position_{end}": axis} for axis in _AXES] + [{f"orientation_{end}": ONE}]
        columns = [self._rows(self._changed(self.equations, seed)) for seed in seeds]
        rows = tuple(entry for entries in zip(*columns, strict=True) for entry in entries)
        return Values(rows, _needed(rows, self.where))

    def bends(self, end: str) -> Values:
        """The second derivatives of the rows by the orientation of one body."""
        seed = {f"orientation_{end}": ONE}
        return self._values(self._changed(self._changed(self.equations, seed), seed), self.where)

    def time_slopes(self) -> Values:
        """How each row changes with time where no body moves."""
        return self._values(self._changed(self.equations, {TIME: ONE}), self.where)

    def rates(self) -> Values:
        """The rates of the rows along the motion."""
        return self._values(*_along_motion(self.equations, self.where, self._motion()))

    def convective(self) -> Values:
        """The rates of those rates, as far as no acceleration makes them."""
        motion = self._motion()
        return self._values(
            *_along_motion(*_along_motion(self.equations, self.where, motion), motion)
        )

    def _changed(self, nodes: Sequence[Node], seed: Mapping[str, Node]) -> list[Node]:
        """How trees change as some names do, in terms of the named quantities."""
        known: dict[Node, Node] = {tree: Name(name) for name, tree in self.where}
        rates = dict(seed)
        for name, tree in self.where:
            rates[name] = _renamed(along(tree, rates), known)
        return [_renamed(along(node, rates), known) for node in nodes]

    def _motion(self) -> dict[str, Node]:
        moving = {
            f"{coordinate}_{end}": Name(f"{rate}_{end}")
            for coordinate, rate in COORDINATES.items()
            for end in self.bodies
        }
        return {**moving, TIME: ONE}

    def _values(self, nodes: Sequence[Node], where: Named) -> Values:
        rows = self._rows(nodes)
        return Values(rows, _needed(rows, where))

    def _rows(self, nodes: Sequence[Node]) -> tuple[Node, ...]:
        """The trees as scalars, two for each that is a vector."""
        rows: list[Node] = []
        for node, kind in zip(nodes, self.types, strict=True):
            rows += [component(node, axis) for axis in "xy"] if kind.shape == "vector" else [node]
        return tuple(rows)


def table_with(table: SymbolTable, where: Named) -> SymbolTable:
    """The table with the named quantities that it does not know, such as rates of others."""
    for name, tree in where:
        try:
            table.resolve(name)
        except SpecFault:
            found = infer(tree, table)
            shape: Shape = "vector" if found.shape == "vector" else "scalar"
            table = table.with_locals([Symbol(name, _unit(found), f"rate in {name}", shape)])
    return table


def _unit(found: Type) -> str:
    """The unit of a type as text; a bare zero has none."""
    if found.dimension is None:
        return "1"
    powers = zip(("kg", "m", "s"), found.dimension.powers, strict=True)
    return "*".join(f"{base}^{power}" for base, power in powers if power) or "1"


def _along_motion(
    nodes: Sequence[Node], where: Named, motion: Mapping[str, Node]
) -> tuple[list[Node], Named]:
    """The rates of trees, and the named quantities with the rates that got names of their own."""
    known: dict[Node, Node] = {tree: Name(name) for name, tree in where}
    rates = dict(motion)
    more: list[tuple[str, Node]] = []
    for name, tree in where:
        rate = _renamed(along(tree, rates), known)
        if not _short(rate):
            more.append((f"{name}_rate", rate))
            known[rate] = rate = Name(f"{name}_rate")
        rates[name] = rate
    return [_renamed(along(node, rates), known) for node in nodes], (*where, *more)


def _renamed(node: Node, known: Mapping[Node, Node]) -> Node:
    """The tree with names for the parts that have one, also for those that stand around others."""
    while (named := rebuilt(node, known.get)) != node:
        node = named
    return node


def _short(node: Node) -> bool:
    """Whether a tree is as short as a name for it."""
    return isinstance(node, Name | Number) or (isinstance(node, Negative) and _short(node.operand))


def _needed(rows: Iterable[Node], where: Named) -> Named:
    """Those of some named quantities that stand in rows, or in others that do."""
    used = {name for row in rows for name in names(row)}
    kept: list[tuple[str, Node]] = []
    for name, tree in reversed(where):
        if name in used:
            used |= set(names(tree))
            kept.append((name, tree))
    return tuple(reversed(kept))
