"""A joint's own equation: read, checked for names, units and derivatives, made ready to compute.

Serves: joints that a scene states by an equation. Hides: what such an equation may use.
"""

from collections.abc import Sequence
from functools import cache, lru_cache

from tamias2d.generated.symbols import SYMBOLS
from tamias2d.scene.rules import RuleError
from tamias2d.spec.check import TRUTH, Type, infer, refuse_not_stated
from tamias2d.spec.constraint import COORDINATES, ENDS, TIME, Constraint
from tamias2d.spec.constraint_functions import ConstraintFunctions
from tamias2d.spec.expression import Binary, Node, Relation, names, parse
from tamias2d.spec.messages import Code, SpecFault
from tamias2d.spec.printed_constraint import printed
from tamias2d.spec.row_program import RowProgram, row_programs
from tamias2d.spec.symbols import Index, SymbolTable
from tamias2d.spec.tex import plain
from tamias2d.suggestions import nearest

_PLACES = tuple(f"{name}_{end}" for end in ENDS for name in (*COORDINATES, "point"))
_ALLOWED = frozenset((*_PLACES, TIME))


def read_equations(texts: Sequence[str], of: str) -> ConstraintFunctions:
    """Return what a solver asks of a joint with these equations.

    Raises:
        RuleError: one is not in the language, uses what is not there, or has no derivative.
    """
    constraint = _constraint(tuple(texts), of)
    try:
        return printed(constraint, [f"anchor_{name[-1]}" for name, _ in constraint.where])
    except ValueError as error:
        raise RuleError(
            f"equations of {of}: {error} (TM7). Write it without min, max and abs.", "equations"
        ) from None


@lru_cache(256)
def equation_rows(texts: tuple[str, ...]) -> tuple[RowProgram, ...]:
    """Return the rows of equations that were read, as programs."""
    return row_programs(_constraint(texts, "a joint"))


def _constraint(texts: tuple[str, ...], of: str) -> Constraint:
    trees = tuple(_read(text, of, k) for k, text in enumerate(texts))
    used = {name for tree in trees for name in names(tree)}
    where = tuple(
        (f"point_{end}", parse(f"position_{end} + rotate(anchor_{end}, orientation_{end})"))
        for end in ENDS
        if f"point_{end}" in used
    )
    return Constraint(trees, where, _table())


def _read(text: str, of: str, k: int) -> Node:
    at = ("equations", k)
    try:
        node = parse(text)
        used = set(names(node))
        _refuse_names(used - _ALLOWED, of, k)
        refuse_not_stated(node)
        _refuse_condition(node, infer(node, _table()))
    except SpecFault as fault:
        where = f"equations[{k}] of {of}"
        raise RuleError(
            f"{where}: {fault.message} (TM7, column {fault.offset + 1}). It may use "
            f"{', '.join(_PLACES[:3])}, likewise for b and c, and time.",
            *at,
        ) from None
    if not used & set(_PLACES):
        raise RuleError(
            f"equations[{k}] of {of}: '{text}' holds no body (TM7). Let it use a place of one.", *at
        )
    return node


def _refuse_names(wrong: set[str], of: str, k: int) -> None:
    for name in sorted(wrong):
        near = nearest(name, sorted(_ALLOWED))
        hint = f"; did you mean '{near}'?" if near else ""
        raise RuleError(
            f"equations[{k}] of {of}: '{name}' is no place of a body{hint} (TM7). It may use "
            f"{', '.join(_PLACES[:3])}, likewise for b and c, and time.",
            *("equations", k),
        )


def _refuse_condition(node: Node, found: Type) -> None:
    """Refuse what is true or false; raise `SpecFault`."""
    if found == TRUTH:
        remedy = "State what is to be zero"
        if isinstance(node, Relation) and node.operator == "==":
            remedy = f"Write left - right: '{plain(Binary('-', node.left, node.right))}'"
        raise SpecFault(Code.SHAPE_MISMATCH, f"'{plain(node)}' is a condition. {remedy}")


@cache
def _table() -> SymbolTable:
    wanted = (*COORDINATES, *COORDINATES.values(), "point", "anchor", TIME)
    indices = [Index(end, end.upper(), f"of body {end.upper()}") for end in ENDS]
    return SymbolTable([SYMBOLS[name] for name in wanted], indices)
