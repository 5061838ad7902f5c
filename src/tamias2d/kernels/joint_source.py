"""The source of the reactions of joints, and of the return to them: generated functions in loops.

Serves: the makers of kernels. Hides: how joints of some kinds become loops. No equation is written
here. The state of n bodies is one row of numbers: all x, then all y, then all orientations.
"""

import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import cache
from typing import Any

from tamias2d.generated import definitions
from tamias2d.generated.constraints import CONSTRAINTS
from tamias2d.kernels import elimination, row_products
from tamias2d.kernels.copied import copied
from tamias2d.kernels.joined import joined
from tamias2d.motion.mechanism import APART, MOST, ROUNDING
from tamias2d.spec.constraint import ENDS
from tamias2d.spec.constraint_functions import ConstraintFunctions, Formula
from tamias2d.spec.functions import power
from tamias2d.spec.printed_constraint import printed_by

ENTRIES = 9  # of a row: slopes by x, y and orientation of A, B and C
LAW = 6  # numbers of a push: stiffness, rest, damping, constant, most, where its other row is
_IN_MATH = ("atan2", "cos", "exp", "log", "sin", "sqrt", "tan", "pi")
_BOUNDED = (definitions.force_share, definitions.torque_share)
_NAMES = {"largest": "max"}  # in these
_PLACE = ("position", "orientation")
_SPEED = ("velocity", "angular_velocity")
_PATTERN = ("row_starts", "row_entries", "row_columns")
_FACTORS = ("below", "below_rows", "targets")
_FACTORED = (
    *("fading", "doubtful", "entries", *_PATTERN, "inverse", "reach", "order", "pairs"),
    *("diagonal", "lower", *_FACTORS, "own", "shared"),
)
_ANSWERED = (
    *("wanted", "multipliers", "entries", *_PATTERN, "inverse"),
    *("diagonal", "lower", "below", "below_rows", "order", "total", "change"),
)
TABLES = (
    *("still", "fixed", "sizes", "inverse", "reach", "weights", "speeds", "placed"),
    *(*_PATTERN, "pairs", "order", *_FACTORS),
    *("entries", "wanted", "total", "change", "diagonal", "lower", "own", "shared"),
)
"""What every kernel takes after its state, before the tables of its kinds."""
DOUBTED, KEPT, FADED = range(3)
"""What rows are: in doubt; independent; some fade, as combinations of them are short (GD19)."""
_FADES = 8
"""Rounds in which fading rows are answered; others take all of theirs in one, but for rounding."""
_UNANSWERED = 1e-3
"""Of the accelerations: more than that, left by fading rows, is no passage of a singular place."""

_SETTLED = 1e-6
"""Of what is near in a return: drifts approach their end by no more than their turn each round."""
_ROUNDS = 40  # of a drift


@dataclass(frozen=True)
class JointDemand:
    """The kinds of rows that a mechanism has; those with equal demands share compiled code."""

    kinds: tuple[str, ...]
    pushed: tuple[str, ...] = ()
    """Of what springs and motors push along."""

    def __str__(self) -> str:
        """What acts, in words."""
        pushes = f"; springs and motors on {', '.join(self.pushed)}" if self.pushed else ""
        return f"{', '.join(self.kinds)}{pushes}"


def functions_of(kind: str) -> ConstraintFunctions:
    """Return the functions of a generated constraint, or of one of a scene's own, by its name."""
    return CONSTRAINTS[kind] if kind in CONSTRAINTS else printed_by(kind)


def tables_of(demand: JointDemand) -> list[str]:
    """Return the names of all tables, in order."""
    found = [*TABLES]
    for kind in demand.kinds:
        found += [f"{kind}_given", f"{kind}_ends"]
    for kind in demand.pushed:
        found += [f"{kind}_push_given", f"{kind}_push_ends", f"{kind}_push_law"]
    return found


_REACT = '''def react(time, position, velocity, rate, multipliers, {tables}):
    """Add what joints give to the accelerations; return what the rows are."""
{pushes}
    slopes(time, position, entries, still, {kinds})
    rows = factors(sizes[2], sizes[3], {factoring})
    if rows == {doubted}:
        return {doubted}
    convective(time, position, velocity, wanted, still, {kinds})
    along(entries, {pattern}, rate, total)
    size = 0.0
    if rows == {faded}:
        by_loads, by_motion = largest(own, order, total), largest(own, order, wanted)
        if by_motion < by_loads:  # it may stay there
            return {doubted}
        size = by_loads + by_motion
    for i in range(len(wanted)):
        wanted[i] = -(total[i] + wanted[i])
    answer({fades} if rows == {faded} else 2, {answered})
    if rows == {faded} and missed({missing}) > {unanswered} * size:
        return {doubted}
    across(entries, {pattern}, multipliers, change)
    check = 0.0
    for j in range(len(rate)):
        rate[j] = rate[j] + inverse[j] * change[j]
        check += rate[j] * 0.0
    return rows if check == 0.0 else {doubted}'''

_FIT = '''def fit(time, position, velocity, multipliers, {tables}):
    """Move places and velocities to where joints hold; return what the rows are."""
    before = 1e300
    length = length_of(position, fixed, sizes[0], {rounding})
    near = sizes[1] * length
    rows = {doubted}
    for _ in range({most}):
        slopes(time, position, entries, still, {kinds})
        rows = factors(sizes[4], sizes[5], {factoring})
        if rows == {doubted}:
            return {doubted}
        values(time, position, wanted, still, {kinds})
        for i in range(len(wanted)):
            wanted[i] = placed[i] * wanted[i]
        answer({fades} if rows == {faded} else 1, {answered})
        far = missed({missing}) if rows == {faded} else 0.0
        across(entries, {pattern}, multipliers, change)
        way, check = 0.0, 0.0
        for j in range(len(position)):
            position[j] = position[j] - inverse[j] * change[j]
            way = max(way, abs(weights[j] * change[j]))
            check += position[j] * 0.0
        if not check == 0.0 or way > 2 * before or far > {apart} * length:
            return {doubted}
        before = way
        if way <= near:
            break
    if not before <= near:
        return {doubted}
    rates(time, position, velocity, wanted, still, {kinds})
    for i in range(len(wanted)):
        wanted[i] = wanted[i] - speeds[i]
    answer({fades} if rows == {faded} else 1, {answered})
    across(entries, {pattern}, multipliers, change)
    check = 0.0
    for j in range(len(velocity)):
        velocity[j] = velocity[j] - inverse[j] * change[j]
        check += velocity[j] * 0.0
    return rows if check == 0.0 else {doubted}'''

_FACTORS_OF = '''def factors({factored}):
    """Factorise; return {kept} where no combination of rows is much shorter than they are.

    Where some may be, return {faded} and the factors that let them fade (GD19), with the squares of
    the lengths of rows as `own`; {doubted} where these are too near to rounding.
    """
    squares(entries, {pattern}, inverse, order, diagonal)
    multiply(entries, row_entries, row_columns, inverse, pairs, lower)
    for k in range(len(diagonal)):
        own[k] = diagonal[k]
    if factorised(diagonal, lower, {factors}):
        if inverse_size(diagonal, lower, {factors}, own, shared) < doubtful:
            return {kept}
    squares(entries, {pattern}, inverse, order, diagonal)
    multiply(entries, row_entries, row_columns, inverse, pairs, lower)
    squares(entries, {pattern}, reach, order, own)
    for k in range(len(diagonal)):
        diagonal[k] = diagonal[k] + fading * own[k]
    if fading > 0 and factorised(diagonal, lower, {factors}):
        return {faded}
    return {doubted}'''

_ANSWER = '''def answer(rounds, {answered}):
    """Set the multipliers that give what is wanted; each round takes up what is left."""
    for i in range(len(wanted)):
        multipliers[i] = 0.0
        total[i] = wanted[i]
    for n in range(rounds):
        if n > 0:
            leave({answered})
        solve(diagonal, lower, below, below_rows, order, total)
        for i in range(len(wanted)):
            multipliers[i] = multipliers[i] + total[i]'''

_LEAVE = '''def leave({answered}):
    """Set what the multipliers leave of what is wanted."""
    across(entries, {pattern}, multipliers, change)
    for j in range(len(change)):
        change[j] = inverse[j] * change[j]
    along(entries, {pattern}, change, total)
    for i in range(len(wanted)):
        total[i] = wanted[i] - total[i]'''

_MISSED = '''def missed({missing}):
    """Return the length of what multipliers leave, of rows of length one."""
    leave({answered})
    square = 0.0
    for k in range(len(order)):
        square = square + total[order[k]] * total[order[k]] / own[k]
    return sqrt(square)'''

_ENTRY = '''def joints(fitting, time, position, velocity, rate, multipliers, {tables}):
    """Move a state to where joints hold, or add what they give; return what the rows are."""
    if fitting:
        return fit(time, position, velocity, multipliers, {tables})
    return react(time, position, velocity, rate, multipliers, {tables})'''

_DRIFT = '''def drift(time, duration, position, velocity, multipliers, {tables}):
    """Move places along velocities to where joints hold, by impulses along the rows of the begin.

    Velocities are those of the way then. Return what the rows are (GD24).
    """
    slopes(time, position, entries, still, {kinds})
    if factors(0.0, sizes[3], {factoring}) == {doubted}:
        return {doubted}
    rates(time, position, velocity, wanted, still, {kinds})
    for i in range(len(wanted)):
        wanted[i] = wanted[i] - speeds[i]
    answer(1, {answered})
    across(entries, {pattern}, multipliers, change)
    for j in range(len(velocity)):
        velocity[j] = velocity[j] - inverse[j] * change[j]
    values(time, position, own, still, {kinds})
    for i in range(len(own)):
        own[i] = (1 - placed[i]) * (own[i] + duration * speeds[i])
    near = {settled} * sizes[1] * length_of(position, fixed, sizes[0], {rounding})
    for j in range(len(position)):
        position[j] = position[j] + duration * velocity[j]
    before = 1e300
    for _ in range({rounds}):
        values(time + duration, position, wanted, still, {kinds})
        for i in range(len(wanted)):
            wanted[i] = wanted[i] - own[i]
        answer(1, {answered})
        across(entries, {pattern}, multipliers, change)
        way, check = 0.0, 0.0
        for j in range(len(position)):
            position[j] = position[j] - inverse[j] * change[j]
            velocity[j] = velocity[j] - inverse[j] * change[j] / duration
            way = max(way, abs(weights[j] * change[j]))
            check += position[j] * 0.0
        if not check == 0.0 or way > before:
            return {doubted}
        before = way
        if way <= near:
            return {kept}
    return {doubted}'''


_HELPERS = (_FACTORS_OF, _LEAVE, _ANSWER, _MISSED)


@cache
def joints(demand: JointDemand) -> tuple[str, str]:
    """Return the source of reactions and of the return: for the compiler, and plain.

    They are one source, because most of what they need is the same.
    """
    return _source(demand, _loops_of(demand), (*_HELPERS, _REACT, _FIT), _ENTRY)


@cache
def drifts(demand: JointDemand) -> tuple[str, str]:
    """Return the source of drifts that end where joints hold, likewise."""
    loops = [_loops(demand, name) for name in ("slopes", "constraint", "rate")]
    return _source(demand, loops, _HELPERS[:-1], _DRIFT)


def functions(demand: JointDemand, *, drifting: bool = False) -> tuple[list[str], list[str]]:
    """Return `react`, `fit` and perhaps `drift` with what they call, and what that imports."""
    made = (*_HELPERS, _REACT, _FIT, *([_DRIFT] if drifting else []))
    return _functions(demand, _loops_of(demand), made)


def _loops_of(demand: JointDemand) -> list[str]:
    loops = [_loops(demand, name) for name in ("slopes", "constraint", "rate", "convective")]
    return loops + [_pull_of(kind) for kind in demand.pushed if kind == "travel"]


def _source(
    demand: JointDemand, loops: Sequence[str], helpers: Sequence[str], entry: str
) -> tuple[str, str]:
    texts, imports = _functions(demand, loops, (*helpers, entry))
    head = f'"""Joints of Tamias2D: {demand}.\n\nMade from the generated functions.\n"""\n'
    return joined(head, imports, texts[:-1], texts[-1])


def _functions(
    demand: JointDemand, loops: Sequence[str], templates: Sequence[str]
) -> tuple[list[str], list[str]]:
    """Return functions after all that they call, and the names to be imported from `math`."""
    names = {
        "tables": ", ".join(tables_of(demand)),
        "kinds": ", ".join(f"{kind}_given, {kind}_ends" for kind in demand.kinds),
        "pattern": ", ".join(_PATTERN),
        "factors": ", ".join(_FACTORS),
        "pushes": "\n".join(f"    {line}" for line in _pushes(demand)),
        "rounding": ROUNDING,
        "most": MOST,
        "factored": ", ".join(_FACTORED),
        "factoring": ", ".join(_FACTORED[2:]),
        "answered": ", ".join(_ANSWERED),
        "missing": ", ".join((*_ANSWERED, "own")),
        "doubted": DOUBTED,
        "kept": KEPT,
        "faded": FADED,
        "fades": _FADES,
        "unanswered": _UNANSWERED,
        "apart": APART,
        "settled": _SETTLED,
        "rounds": _ROUNDS,
    }
    texts = [*loops, *(template.format(**names) for template in templates)]
    used = "\n".join(texts)
    copies = _copies(used, demand)
    used = "\n".join([*copies, used])
    return [*copies, *texts], [name for name in _IN_MATH if re.search(rf"\b{name}\b", used)]


def _copies(body: str, demand: JointDemand) -> list[str]:
    """The functions that are called."""
    known: list[Callable[..., Any]] = [
        definitions.joint_spring_force,
        definitions.joint_spring_torque,
        *(definitions.joint_pull, *_BOUNDED),
        *(elimination.factorised, elimination.inverse_size, elimination.solve),
        *(row_products.along, row_products.across, row_products.squares, row_products.multiply),
        *(row_products.largest, row_products.length_of),
        *(row_products.place_of, row_products.rates_of, row_products.push_along),
        *(formula.function for kind in demand.kinds for formula in _formulas(functions_of(kind))),
        *(formula.function for kind in demand.pushed for formula in _formulas(functions_of(kind))),
    ]
    called = [f for f in dict.fromkeys(known) if re.search(rf"(?<!def ){f.__name__}\(", body)]
    copies = [_copy(f) for f in called]
    return [_copy(power), *copies] if "power(" in "".join(copies) else copies


@cache
def _copy(function: Callable[..., Any]) -> str:
    """Return the text of a function: several sources need it, and it takes a millisecond."""
    return copied(function, _NAMES if function in _BOUNDED else {})


def _formulas(functions: ConstraintFunctions) -> Iterator[Formula]:
    yield from (functions.constraint, *functions.slopes.values())
    yield from (functions.rate, functions.convective)


_CALLED = {"slopes": "slopes", "constraint": "values", "rate": "rates", "convective": "convective"}


def _loops(demand: JointDemand, name: str) -> str:
    """Return the function that computes one thing of the rows of all kinds."""
    target = "entries" if name == "slopes" else "found"
    moving = "velocity, " if name in ("rate", "convective") else ""
    tables = ", ".join(f"{kind}_given, {kind}_ends" for kind in demand.kinds)
    lines = [
        f"def {_CALLED[name]}(time, position, {moving}{target}, still, {tables}):",
        "    first = 0",
    ]
    for kind in demand.kinds:
        lines += (f"    {line}" for line in _loop(kind, name, bool(moving)))
    return "\n".join(lines)


def _loop(kind: str, name: str, moving: bool) -> Iterator[str]:
    functions = functions_of(kind)
    rows = len(functions.units)
    yield f"joints = len({kind}_ends) // {len(functions.bodies)}"
    yield "for k in range(joints):"
    yield from (f"    {line}" for line in _state(kind, kind, moving=moving))
    if name != "slopes":
        formula: Formula = getattr(functions, name)
        found = ", ".join(f"found[first + k + {i} * joints]" for i in range(rows))
        yield f"    {found}{',' * (rows == 1)} = {_call(formula)}"
    else:
        for end, formula in functions.slopes.items():
            numbers = [f"slope_{i}_{axis}" for i in range(rows) for axis in ("x", "y", "turn")]
            yield f"    {', '.join(numbers)} = {_call(formula)}"
            for i in range(rows):
                yield f"    at = {ENTRIES} * (first + k + {i} * joints) + {3 * ENDS.index(end)}"
                entries = ", ".join(f"entries[at{f' + {a}' if a else ''}]" for a in range(3))
                yield f"    {entries} = {', '.join(numbers[3 * i : 3 * i + 3])}"
    yield f"first = first + {rows} * joints"


def _call(formula: Formula) -> str:
    return f"{formula.function.__name__}({', '.join(formula.arguments)})"


def _state(kind: str, table: str, *, moving: bool) -> Iterator[str]:
    """Set what the functions of one joint take: its parameters, and where its bodies are."""
    functions = functions_of(kind)
    shapes = shapes_of(functions)
    yield f"at = {sum(shapes.values())} * k"
    at = 0
    for name, size in shapes.items():
        parts = ", ".join(f"{table}_given[at + {at + i}]" for i in range(size))
        yield f"{name} = ({parts})" if size == 2 else f"{name} = {parts}"
        at += size
    for i, end in enumerate(functions.bodies):
        body = f"{table}_ends[{len(functions.bodies)} * k + {i}]"
        yield f"x, y, orientation_{end} = place_of({body}, position, still)"
        yield f"position_{end} = (x, y)"
        if moving:
            yield f"x, y, angular_velocity_{end} = rates_of({body}, velocity)"
            yield f"velocity_{end} = (x, y)"


def shapes_of(functions: ConstraintFunctions) -> dict[str, int]:
    """Return of how many numbers each parameter consists."""
    return {
        name: 2 if name.startswith(("anchor", "guide", "post")) else 1
        for name in functions.parameters
    }


def _pulled(kind: str) -> str:
    """What the function takes, after a number, that returns the pull of a spring by itself."""
    table = f"{kind}_push"
    return f"time, position, velocity, still, {table}_given, {table}_ends, {table}_law"


def _pull_of(kind: str) -> str:
    """Return the function that returns what a spring would exert without a maximum."""
    lines = [f"def {kind}_pull(k, {_pulled(kind)}):", *(f"    {line}" for line in _pull(kind))]
    return "\n".join([*lines, "    return pull"])


def _pull(kind: str) -> Iterator[str]:
    """Set what the spring of a row would exert without a maximum, and where its law begins."""
    functions, table = functions_of(kind), f"{kind}_push"
    law = "joint_spring_torque" if kind == "angle" else "joint_spring_force"
    yield from _state(kind, table, moving=True)
    yield f"(value,) = {_call(functions.constraint)}"
    yield f"(speed,) = {_call(functions.rate)}"
    yield f"at = {LAW} * k"
    numbers = [f"{table}_law[at{f' + {i}' if i else ''}]" for i in range(3)]
    yield f"pull = {law}({numbers[0]}, value - {numbers[1]}, {numbers[2]}, speed)"


def _pushes(demand: JointDemand) -> Iterator[str]:
    """Add what springs and motors give to the accelerations."""
    for kind in demand.pushed:
        functions = functions_of(kind)
        table = f"{kind}_push"
        yield f"for k in range(len({table}_law) // {LAW}):"
        yield from (f"    {line}" for line in _pull(kind))
        share = "torque_share" if kind == "angle" else "force_share"
        yield f"    most, size = {table}_law[at + 4], abs(pull)"
        yield "    if most > 0.0:"
        if kind == "travel":  # of which a target has two
            yield f"        if {table}_law[at + 5] != 0.0:"
            yield f"            other = k + int({table}_law[at + 5])"
            yield f"            size = joint_pull(pull, {kind}_pull(other, {_pulled(kind)}))"
        yield f"        pull = {share}(most, size) * pull"
        yield f"    push = pull + {table}_law[at + 3]"
        for i, end in enumerate(functions.bodies):
            body = f"{table}_ends[{len(functions.bodies)} * k + {i}]"
            yield f"    push_along({body}, push, {_call(functions.slopes[end])}, inverse, rate)"
