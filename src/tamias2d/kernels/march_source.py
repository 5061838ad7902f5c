"""The source of many steps of a scheme: the generated step, taken apart into loops over numbers.

Serves: the makers of kernels. Hides: where the slopes of a step are kept, and when accelerations
are known already. Coordinates and rates of all bodies are rows of numbers; those of a step are one
row of `places` and of `speeds`, its accelerations one of `rates`.
"""

import ast
import re
import textwrap
from collections.abc import Callable
from copy import deepcopy
from dataclasses import dataclass
from functools import cache

from tamias2d.generated import schemes
from tamias2d.kernels.copied import copied, function_of
from tamias2d.kernels.force_demand import ForceDemand
from tamias2d.kernels.force_source import arguments as tables_of, source as forces
from tamias2d.motion import adaptive

HELPER = '@njit(error_model="numpy", no_cpython_wrapper=True, no_cfunc_wrapper=True)'
ENTRY = '@njit(cache=True, error_model="numpy", nogil=True, no_cfunc_wrapper=True)'
_NUMBERS = {"time", "time_step"}
_HEAD = '''"""Steps of Tamias2D by {scheme}: {demand}.

Made from the generated functions and from nothing else; its bits are those of the general way.
"""

'''
_SAME = '''def same(one, other):
    """Whether two rows are equal."""
    for j in range(len(one)):
        if one[j] != other[j]:
            return False
    return True'''
EVALUATIONS, REJECTED, KNOWN, DONE, SETTLED = range(5)
"""Places in `told`: accelerations and rejected steps so far; whether the last accelerations are
known (1); steps that are done; accelerations up to the last of them. Rejected ones follow."""
STEP, ERROR, RELATIVE, LENGTH, RATE, POWER, DAMPING = range(7)
"""Places in `control`: what the last step left to the next, and what the user allows."""
_START = '''time = times[k]
position, velocity, rate = places[k], speeds[k], rates[k]
position_end, velocity_end, rate_end = places[k + 1], speeds[k + 1], rates[k + 1]
told[{DONE}] = k
if told[{KNOWN}] == 0:
    told[{EVALUATIONS}] += 1
    if not accelerations(time, position, velocity, rate, {tables}):
        return k
    told[{KNOWN}] = 1
told[{SETTLED}] = told[{EVALUATIONS}]
told[{SETTLED} + 1] = told[{REJECTED}]'''
_FIXED = '''def advance(times, places, speeds, rates, work, told, felt, {tables}):
    """Step from each time to the next, as long as forces have values; return how many steps."""
    size = len(places[0])
{rows}
    for k in range(len(times) - 1):
{start}
        end = times[k + 1]
        time_step = end - time
{step}
        if {reused}:
            for j in range(size):
                rate_end[j] = {last_rate}[j]
        else:
            told[{EVALUATIONS}] += 1
            if not accelerations(end, position_end, velocity_end, rate_end, {tables}):
                return k
    return len(times) - 1
'''
_ADAPTIVE = '''def advance(limit, times, places, speeds, rates, dense, control, work, told, felt, {tables}):
    """Step towards a limit, each step as long as its error allows; return how many steps.

    It ends before, where a force has no value on the way or where steps get very short.
    """
    size = len(places[0])
{rows}
    for k in range(len(times) - 1):
        if times[k] >= limit:
            return k
{start}
        time_step = control[{STEP}]
        rejected = False
        while True:
            end = time + time_step if time_step < limit - time else limit
            time_step = end - time
            if time_step <= 1e-14 * abs(time) + 1e-300:
                return k
{step}
            error = 0.0
            for j in range(size):
                near = max(abs(position[j]), abs(position_end[j]))
                fast = max(abs(velocity[j]), abs(velocity_end[j]))
                allowed = control[{LENGTH}] + control[{RELATIVE}] * near
                allowed_rate = control[{RATE}] + control[{RELATIVE}] * fast
                place_error = combined(
                    {place_errors}
                )
                speed_error = combined(
                    {speed_errors}
                )
                if not (place_error <= 1e300 and speed_error <= 1e300):
                    error = 1e300
                error = max(error, place_error, speed_error)
            if error <= 1:
                break
            told[{REJECTED}] += 1
            rejected = True
            time_step *= shrinking(error, control[{POWER}])
        times[k + 1] = end
        longer = time_step * growth(
            error, control[{ERROR}], control[{POWER}], control[{DAMPING}], rejected
        )
        if end == limit and not rejected:
            longer = max(longer, control[{STEP}])
        control[{STEP}] = longer
        control[{ERROR}] = max(error, 1e-4)
        slopes = dense[k]
        for j in range(size):
{dense}
        if {reused}:
            for j in range(size):
                rate_end[j] = {last_rate}[j]
        else:
            told[{KNOWN}] = 0
    return len(times) - 1
'''
_PLACES = {
    name: place
    for name, place in globals().items()
    if name.isupper() and not name.startswith("_")
}


@dataclass(frozen=True)
class March:
    """The source of the steps of a scheme, and what its caller must know of it."""

    text: str
    """For the compiler; `plain` is the same without its marks."""
    plain: str
    rows: int
    """Of `work`, each as long as a row of `places`."""
    slopes: int
    """Of the velocity in a step, for its path; 0 for steps whose length is given."""


@cache
def march(scheme: str, demand: ForceDemand) -> March:
    """Return the source of the steps of a scheme under the forces of a demand."""
    step = _Step(function_of(getattr(schemes, scheme)))
    tables = ", ".join(tables_of(demand))
    filled = {
        **_PLACES,
        "tables": tables,
        "rows": "\n".join(f"    {name} = work[{k}]" for k, name in enumerate(step.rows)),
        "reused": step.reused,
        "last_rate": step.last_rate,
    }
    deep = " " * (12 if step.adaptive else 8)
    template = _ADAPTIVE if step.adaptive else _FIXED
    text = template.format(
        **filled,
        start=textwrap.indent(_START.format(**filled), " " * 8),
        step=textwrap.indent("\n".join(step.lines).replace("TABLES", tables), deep),
        place_errors=", ".join(f"({error}) / allowed" for error in step.place_errors),
        speed_errors=", ".join(f"({error}) / allowed_rate" for error in step.speed_errors),
        dense="\n".join(
            f"            slopes[{k} * size + j] = {slope}" for k, slope in enumerate(step.dense)
        ),
    )
    helpers, imports = forces(demand)
    helpers = [*helpers, _SAME, *(_controls() if step.adaptive else ())]
    if step.adaptive and "sqrt" not in imports:
        imports.append("sqrt")
    head = _HEAD.format(scheme=scheme, demand=demand)
    head += f"from math import {', '.join(sorted(imports))}\n" if imports else ""
    plain = "\n\n\n".join([head.rstrip(), *helpers, text])
    marked = [f"{head}from numba import njit", *(f"{HELPER}\n{each}" for each in helpers)]
    return March(
        "\n\n\n".join([*marked, f"{ENTRY}\n{text}"]), plain, len(step.rows), len(step.dense)
    )


def _controls() -> list[str]:
    """The functions that choose the length of a step."""
    known = {name.lower(): getattr(adaptive, name) for name in ("SAFETY", "SHORTER", "LONGER")}
    names = {name.upper(): repr(value) for name, value in known.items()}
    names |= {"CORRECTION": repr(adaptive.CORRECTION), "NONE": repr(adaptive.NONE)}
    names["largest"] = "max"
    return [copied(f, names) for f in (adaptive.combined, adaptive.growth, adaptive.shrinking)]


class _Step:
    """One step of a scheme as statements on rows of numbers; each name is set only once."""

    def __init__(self, scheme: ast.FunctionDef) -> None:
        self.lines: list[str] = []
        self.rows: list[str] = []
        self.reused, self.last_rate = "False", "rate"
        self.place_errors: list[str] = []
        self.speed_errors: list[str] = []
        self.dense: list[str] = []
        self._now = {"position": "position", "velocity": "velocity"}
        self._calls = 0
        for statement in scheme.body:
            if isinstance(statement, ast.Assign):
                self._assign(statement)
            elif isinstance(statement, ast.Return):
                self._return(statement.value)
        self.adaptive = bool(self.dense)

    def _assign(self, statement: ast.Assign) -> None:
        (target,) = statement.targets
        if not isinstance(target, ast.Name):
            raise TypeError(ast.unparse(target))
        asked = _Asked(self._accelerated)
        value = asked.visit(deepcopy(statement.value))
        if isinstance(value, ast.Name):  # accelerations, and nothing else
            self._now[target.id] = value.id
            return
        text = self._element(value)
        self._now[target.id] = self._new(target.id)
        self._loop(self._now[target.id], text)

    def _accelerated(self, call: ast.Call) -> str:
        """Ask for accelerations; return the name of their row."""
        time, position, velocity = call.args
        moment = ast.unparse(time)
        place = self._row(position, "at_position")
        speed = self._row(velocity, "at_velocity")
        if (moment, place, speed) == ("time", "position", "velocity"):
            return "rate"
        self._calls += 1
        rate = self._new("asked")
        self.lines += [
            f"told[{EVALUATIONS}] += 1",
            f"if not accelerations({moment}, {place}, {speed}, {rate}, TABLES):",
            "    return k",
        ]
        if eval(moment, {"time": 0.0, "time_step": 1.0}) == 1.0:
            same = f"same({place}, position_end)"
            still = f"(not felt or same({speed}, velocity_end))"
            self.reused, self.last_rate = f"{moment} == end and {same} and {still}", rate
        return rate

    def _row(self, value: ast.expr, name: str) -> str:
        if isinstance(value, ast.Name):
            return self._now[value.id]
        row = self._new(name)
        self._loop(row, self._element(value))
        return row

    def _new(self, name: str) -> str:
        taken = {"position", "velocity", *self.rows}
        if name in ("position_end", "velocity_end"):
            return name
        fresh = name if name not in taken else next(
            other for k in range(1, 100) if (other := f"{name}_{k}") not in taken
        )
        self.rows.append(fresh)
        return fresh

    def _loop(self, row: str, text: str) -> None:
        self.lines += ["for j in range(size):", f"    {row}[j] = {text}"]

    def _element(self, value: ast.expr) -> str:
        return ast.unparse(_OnElement(self._now).visit(deepcopy(value)))

    def _return(self, value: ast.expr | None) -> None:
        if isinstance(value, ast.Call):  # a pair
            position, velocity, *parts = value.args
            errors = [[self._element(one) for one in part.elts] for part in parts]  # type: ignore[attr-defined]
            self.place_errors, self.speed_errors, self.dense = errors
        elif isinstance(value, ast.Tuple):
            position, velocity = value.elts
        else:
            raise TypeError(value)
        for last, name in ((position, "position_end"), (velocity, "velocity_end")):
            self._rename(self._row(last, name), name)

    def _rename(self, row: str, name: str) -> None:
        """Let a row be the one in which a step ends."""
        if row == name:
            return
        self.rows.remove(row)
        self.lines = [re.sub(rf"\b{row}\b", name, line) for line in self.lines]
        self.reused = re.sub(rf"\b{row}\b", name, self.reused)


class _Asked(ast.NodeTransformer):
    """Puts the name of a row in the place of each call for accelerations."""

    def __init__(self, asked: Callable[[ast.Call], str]) -> None:
        self._asked = asked

    def visit_Call(self, node: ast.Call) -> ast.expr:
        """Replace a call."""
        return ast.Name(self._asked(node))


class _OnElement(ast.NodeTransformer):
    """Puts a number of it in the place of each row."""

    def __init__(self, rows: dict[str, str]) -> None:
        self._rows = rows

    def visit_Name(self, node: ast.Name) -> ast.expr:
        """Replace a row; numbers stay."""
        return node if node.id in _NUMBERS else ast.Name(f"{self._rows.get(node.id, node.id)}[j]")
