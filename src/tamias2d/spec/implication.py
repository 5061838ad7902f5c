"""Whether one equation follows from another, tried out at random values.

Serves: checks of derivations, closed forms and statements. Hides: how an equation is solved for one
of its names. The proof is numerical: values are drawn from the symbols' ranges, one unknown is
chosen so that the earlier equation holds, and the later one must then hold too. Each later equation
must also be able to fail.
"""

import math
import random
from typing import Any

import numpy as np

from tamias2d.spec import expression as ex
from tamias2d.spec.check import infer
from tamias2d.spec.evaluate import Value, evaluate
from tamias2d.spec.expression import Node, names, rebuilt, walk
from tamias2d.spec.symbols import Range, SymbolTable
from tamias2d.spec.tex import plain

POINTS = 24
_TOLERANCE = 1e-9  # of the largest term: far above rounding, far below any wrong factor
_PARTICLES = 5
_DEEPEST = 8  # substitutions within substitutions

Values = dict[str, Value]


def implies(
    before: ex.Relation, now: ex.Relation, given: dict[str, Node], table: SymbolTable
) -> bool:
    """Whether every tried solution of one equation solves the other, which is no identity."""
    atoms: dict[str, Node] = {}
    first, second = (_prepared(equation, given, atoms) for equation in (before, now))
    generator = random.Random(plain(before) + plain(now))
    tried, can_fail = 0, False
    for _ in range(4 * POINTS):
        values = {name: _draw(node, table, generator) for name, node in atoms.items()}
        _link_next(values)
        can_fail = can_fail or not _holds(second, values)
        solved = _solve(first, values, names(second))
        if solved is None or not all(map(_finite, solved.values())):
            continue
        if not _holds(second, solved):
            return False
        tried += 1
        if tried == POINTS:
            return can_fail
    return False


def _prepared(equation: ex.Relation, given: dict[str, Node], atoms: dict[str, Node]) -> ex.Relation:
    """The equation after substitution, with derivatives and integrals as unknowns of their own."""
    sides = (_atomic(side, given, atoms) for side in (equation.left, equation.right))
    prepared = ex.Relation("==", *sides)
    for name in names(prepared):
        atoms.setdefault(name, ex.Name(name))
    return prepared


def _atomic(node: Node, given: dict[str, Node], atoms: dict[str, Node], depth: int = 0) -> Node:
    def change(part: Node) -> Node | None:
        text = plain(part)
        if text in given and depth < _DEEPEST:
            rest = {name: tree for name, tree in given.items() if name != text}
            return _atomic(given[text], rest, atoms, depth + 1)
        if isinstance(part, ex.Call) and part.function in ("d", "integral"):
            atoms[text] = part
            return ex.Name(text)
        return None

    return rebuilt(node, change)


def _draw(node: Node, table: SymbolTable, generator: random.Random) -> Value:
    found = infer(node, table)
    reference = table.resolve(node.name) if isinstance(node, ex.Name) else None
    limits = reference.symbol.range if reference else Range()
    many = reference is not None and any(index.name in "ij" for index in reference.indices)

    def component() -> Value:
        if many:
            return np.array([_number(limits, generator) for _ in range(_PARTICLES)])
        return _number(limits, generator)

    return (component(), component()) if found.shape == "vector" else component()


def _number(limits: Range, generator: random.Random) -> float:
    if math.isfinite(limits.low) and math.isfinite(limits.high):
        return generator.uniform(limits.low, limits.high)
    size = 10 ** generator.uniform(-0.5, 0.5)
    if math.isfinite(limits.low):
        return limits.low + size
    return generator.choice((-1, 1)) * size


def _link_next(values: Values) -> None:
    """Index j is the next particle after i."""
    for name in values:
        if name.endswith("_j") and f"{name[:-2]}_i" in values:
            own = values[f"{name[:-2]}_i"]
            values[name] = (
                tuple(np.roll(c, -1) for c in own) if isinstance(own, tuple) else np.roll(own, -1)
            )


def _components(equation: ex.Relation, values: Values) -> list[tuple[float, float]]:
    left, right = evaluate(equation.left, values), evaluate(equation.right, values)
    lefts = left if isinstance(left, tuple) else (left,)
    rights = right if isinstance(right, tuple) else (right,) * len(lefts)
    if len(lefts) < len(rights):
        lefts = lefts * len(rights)
    return list(zip(lefts, rights, strict=True))


def _holds(equation: ex.Relation, values: Values) -> bool:
    try:
        pairs = _components(equation, values)
        scale = _scale(equation, values)
    except (ValueError, ZeroDivisionError, OverflowError):
        return False
    return all(bool(np.all(np.abs(a - b) <= _TOLERANCE * scale)) for a, b in pairs)


def _scale(equation: ex.Relation, values: Values) -> float:
    """The largest size among the terms of both sides: cancellation is no fault."""
    sizes = [1e-300]
    for side in (equation.left, equation.right):
        for node in walk(side):
            if node is side or isinstance(node, ex.Binary):
                value = evaluate(node, values)
                sizes += [
                    float(np.max(np.abs(c)))
                    for c in (value if isinstance(value, tuple) else (value,))
                ]
    return max(sizes)


def _residual(equation: ex.Relation, values: Values) -> Any:
    return np.array([float(np.sum(a - b)) for a, b in _components(equation, values)])


def _solve(equation: ex.Relation, values: Values, wanted: tuple[str, ...]) -> Values | None:
    """Change one unknown so that the equation holds; it must enter linearly."""
    inside = names(equation)
    for name in (*(n for n in inside if n in wanted), *(n for n in inside if n not in wanted)):
        try:
            solved = _solve_for(equation, values, name)
        except (ValueError, ZeroDivisionError, OverflowError, np.linalg.LinAlgError):
            continue
        if solved is not None and _holds(equation, solved):
            return solved
    return None


def _solve_for(equation: ex.Relation, values: Values, name: str) -> Values | None:
    value = values[name]
    parts = value if isinstance(value, tuple) else (value,)
    if any(isinstance(part, np.ndarray) for part in parts):
        return None

    def with_parts(changed: list[float]) -> Values:
        new = tuple(changed) if isinstance(value, tuple) else changed[0]
        return {**values, name: new}

    zero = _residual(equation, with_parts([0.0] * len(parts)))
    unit = [[float(k == m) for m in range(len(parts))] for k in range(len(parts))]
    matrix = np.array([_residual(equation, with_parts(row)) - zero for row in unit]).T
    if not np.any(matrix):
        return None
    solution = np.linalg.lstsq(matrix, -zero, rcond=None)[0]
    return with_parts([float(s) for s in solution])


def _finite(value: Value) -> bool:
    return all(
        bool(np.all(np.isfinite(c))) for c in (value if isinstance(value, tuple) else (value,))
    )


def same(left: Node, right: Node, table: SymbolTable, time: float | None = None) -> bool:
    """Whether two expressions agree at random points."""
    generator = random.Random(plain(left) + plain(right))
    equation = ex.Relation("==", left, right)
    for _ in range(POINTS):
        values = {name: _draw(ex.Name(name), table, generator) for name in names(equation)}
        if time is not None:
            values["time"] = time
        if not _holds(equation, values):
            return False
    return True
