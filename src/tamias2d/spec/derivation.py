"""Whether each step of a derivation follows from the one before, and a closed form solves.

Serves: the reader. Hides: how an equation is tried out. The proof is numerical: values are
drawn from the symbols' ranges, one unknown is chosen so that the earlier equation holds, and
the later one must then hold too. Each later equation must also be able to fail. Where the reason of
the first step begins with the id of an item that has equations, the step must follow from one of
them, with what `where` puts in for its names.
"""

import math
import random
import re
from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np

from tamias2d.spec import expression as ex
from tamias2d.spec.chapter import Item
from tamias2d.spec.check import infer
from tamias2d.spec.derivative import differentiate
from tamias2d.spec.equations import Report, parsed, placed, relation, typed
from tamias2d.spec.evaluate import Value, evaluate
from tamias2d.spec.expression import Node, names, rebuilt, substituted, walk
from tamias2d.spec.messages import Code, SpecFault
from tamias2d.spec.symbols import Range, SymbolTable
from tamias2d.spec.tex import plain

POINTS = 24
_TOLERANCE = 1e-9  # of the largest term: far above rounding, far below any wrong factor
_PARTICLES = 5
_DEEPEST = 8  # substitutions within substitutions
_CITED = re.compile(r"(TM|GD|DD|IM|P)[0-9]+")

Values = dict[str, Value]


def check_derivation(
    item: Item, items: Mapping[str, Item], table: SymbolTable, report: Report
) -> None:
    """Report each step that does not follow, and a last step that is not the item's equation.

    The items are all of the specification, by their ids.
    """
    before: ex.Relation | None = None
    for number, step in enumerate(item.data.get("derivation", [])):
        where = ("derivation", number)
        now = relation(item, step["equation"], table, report, *where, "equation")
        own = before is not None
        given = _substitutions(item, step.get("where", {}), own, table, report, where)
        if now is None or given is None:
            return
        if before is None:
            _check_start(item, now, given, items, table, report)
        elif not _implies(before, now, given, table):
            steps = f"'{plain(now)}' does not follow from '{plain(before)}'"
            text = f"{steps}. Correct it, or say in 'where' what is put in"
            report(item.diagnostic(Code.DERIVATION_GAP, text, *where, "equation"))
            return
        before = now
    if before is not None:
        _check_end(item, before, table, report)


def _check_start(
    item: Item,
    first: ex.Relation,
    given: dict[str, Node],
    items: Mapping[str, Item],
    table: SymbolTable,
    report: Report,
) -> None:
    cited = _CITED.match(item.data["derivation"][0]["by"])
    source = items.get(cited.group()) if cited else None
    equations = list(_statements(source, table)) if source else []
    starts = (
        ex.Relation("==", substituted(each.left, given), substituted(each.right, given))
        for each in equations
    )
    if equations and not any(_implies(start, first, {}, table) for start in starts):
        text = f"the first step '{plain(first)}' does not follow from {source.id if source else ''}"
        text += ". Correct it, or say in 'where' what stands for the names of that item"
        report(item.diagnostic(Code.DERIVATION_GAP, text, "derivation", 0, "equation"))


def _statements(item: Item, table: SymbolTable) -> Iterator[ex.Relation]:
    """All that an item says by equations, with its own intermediate quantities put in or not."""

    def faultless(_fault: object) -> None:
        """What is wrong with that item is said where it is read."""

    if text := item.data.get("equation"):
        stated = relation(item, text, table, faultless, "equation")
        yield from [stated] if stated else []
    own = dict(_own_equations(item, faultless))
    for name, tree in own.items():
        yield ex.Relation("==", ex.Name(name), tree)
        expanded = tree
        for _ in range(_DEEPEST):
            expanded = substituted(expanded, {key: own[key] for key in own if key != name})
        yield ex.Relation("==", ex.Name(name), expanded)
    yield from _rates(item, faultless)


def _substitutions(
    item: Item,
    where: dict[str, str],
    own: bool,
    table: SymbolTable,
    report: Report,
    path: tuple[str | int, ...],
) -> dict[str, Node] | None:
    found: dict[str, Node] = {}
    for name, text in where.items():
        key = parsed(item, name, report, *path, "where", name, "key")
        node = parsed(item, text, report, *path, "where", name)
        if key is None or node is None:
            return None
        if typed(item, ex.Relation("==", key, node), table, report, *path, "where", name) is None:
            return None
        if own and not _is_own(item, key, node, table, report):
            text = f"'{name}' is not put in as the item defines it. Make them agree"
            report(item.diagnostic(Code.DERIVATION_GAP, text, *path, "where", name))
            return None
        found[plain(key)] = node
    return found


def _is_own(item: Item, key: Node, node: Node, table: SymbolTable, report: Report) -> bool:
    """Whether a quantity that the item itself defines is put in as defined."""
    own = dict(_own_equations(item, report)).get(plain(key))
    return own is None or _implies(
        ex.Relation("==", key, own), ex.Relation("==", key, node), {}, table
    )


def _check_end(item: Item, last: ex.Relation, table: SymbolTable, report: Report) -> None:
    targets = [
        ex.Relation("==", ex.Name(name), tree) for name, tree in _own_equations(item, report)
    ]
    targets += _rates(item, report)
    if text := item.data.get("equation"):
        own = relation(item, text, table, report, "equation")
        targets += [own] if own else []
    if targets and not any(_implies(last, target, {}, table) for target in targets):
        text = f"the last step '{plain(last)}' is not the item's equation. Finish it"
        report(item.diagnostic(Code.DERIVATION_GAP, text, "derivation"))


def _rates(item: Item, report: Report) -> Iterator[ex.Relation]:
    for name, text in item.data.get("states", {}).items():
        rate = parsed(item, text, report, "states", name)
        if rate is not None:
            yield ex.Relation("==", ex.Call("d", (ex.Name(name), ex.Name("time"))), rate)


def _own_equations(item: Item, report: Report) -> Iterator[tuple[str, Node]]:
    for name, text in item.data.get("equations", {}).items():
        node = parsed(item, text, report, "equations", name)
        if node is not None and not isinstance(node, (ex.Relation, ex.Both)):
            yield name, node


def _implies(
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


def check_closed_form(item: Item, table: SymbolTable, report: Report) -> None:
    """Report a closed form whose time derivative or start is not the state's."""
    forms = {
        name: node
        for name, text in item.data.get("closed_form", {}).items()
        if name != "when" and (node := parsed(item, text, report, "closed_form", name)) is not None
    }
    for name, form in forms.items():
        if name not in item.data.get("arguments", {}):
            text = f"closed form of {name}: no function of it could be tested. Add its 'arguments'"
            report(item.diagnostic(Code.BAD_KEY, text, "closed_form", name))
        rate = parsed(item, item.data.get("states", {}).get(name, "0"), report, "states", name)
        if rate is None:
            continue
        try:
            infer(form, table)
            solves = _same(differentiate(form, "time"), substituted(rate, forms), table)
            starts = _same(form, ex.Name(f"{name}_start"), table, time=0.0)
        except SpecFault as fault:
            report(placed(item, fault, "closed_form", name))
            continue
        except ValueError:
            solves = starts = False
        if not (solves and starts):
            what = (
                "its time derivative is not the rate of the state"
                if starts
                else f"at time 0 it is not {name}_start"
            )
            report(
                item.diagnostic(
                    Code.CLOSED_FORM,
                    f"closed form of {name}: {what}. Correct it",
                    "closed_form",
                    name,
                )
            )


def _same(left: Node, right: Node, table: SymbolTable, time: float | None = None) -> bool:
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
