"""The source of a kernel: the generated functions, copied, in a loop for exactly the demand.

Serves: what `explain --source` shows, and what is compiled. Hides: the layout of the loops. No
equation is written here: steps and forces are those of the generated modules.
"""

import re
import textwrap
from collections.abc import Callable, Iterator
from typing import Any

from tamias2d.generated import drag, rotation, schemes, translation
from tamias2d.generated.symbols import SYMBOLS
from tamias2d.kernels.copied import copied
from tamias2d.kernels.demand import Demand
from tamias2d.kernels.step import statements
from tamias2d.spec import functions as elementary
from tamias2d.spec.expression import parse
from tamias2d.spec.python import PythonPrinter
from tamias2d.spec.symbols import table_from

BLOCK = 256  # bodies that take all steps together: their arrays stay in the nearest cache

_TEMPLATE = '''"""Kernel of Tamias2D for {demand}.

Made from the generated functions and from nothing else; its bits are those of the general way.
"""

{imports}


{functions}{decorator}def advance({arguments}):
    """Take n bodies from times[0] to times[-1], with a step from each time to the next."""
    count = len(positions_x)
    for first in range(0, count, {block}):
        last = min(first + {block}, count)
{views}
        for k in range(len(times) - 1):
            time = times[k]
            time_step = times[k + 1] - time
            for i in range(last - first):
{body}
'''
_DECORATOR = '@njit(cache=True, error_model="numpy")\n'
_STATE = {
    "time": "at_time",
    "position_x": "at_position_x",
    "position_y": "at_position_y",
    "velocity_x": "at_velocity_x",
    "velocity_y": "at_velocity_y",
    "orientation": "at_position_turn",
    "angular_velocity": "at_velocity_turn",
    "mass": "masses[i]",
}
_DRAGS = {"linear_drag": drag.linear_drag_force, "quadratic_drag": drag.quadratic_drag_force}


def axes(demand: Demand) -> tuple[str, ...]:
    """Return the coordinates that a demand needs."""
    return ("x", "y", "turn") if demand.rotation else ("x", "y")


def arguments(demand: Demand) -> list[str]:
    """Return the names of a kernel's arguments in order.

    `times` (k,) and all plurals (n,) are arrays, the others numbers: where the accelerations are
    steady and no force acts, all bodies share them.
    """
    along = axes(demand)
    found = ["times", *(f"{state}_{a}" for state in ("positions", "velocities") for a in along)]
    if demand.steady:
        one = "accelerations" if demand.forces else "acceleration"
        return found + [f"{one}_{axis}" for axis in along]
    found += ["gravity_x", "gravity_y", *(f"loads_{axis}" for axis in along), "masses"]
    found += ["inertias"] if demand.rotation else []
    return found + [f"{kind}s" for kind in _DRAGS if getattr(demand, kind)]


def source(demand: Demand, *, compiled: bool = True) -> str:
    """Return the source of the kernel for a demand, for numba or as plain Python."""
    body = re.sub(r"(\w+)\[i\]", r"block_\1[i]", "\n".join(_body(demand)))
    decorator = _DECORATOR if compiled else ""
    copies = "".join(f"{decorator}{copied(f, {})}\n\n\n" for f in _functions(body))
    imports = ["from math import sqrt"] if "sqrt(" in body + copies else []
    imports += ["from numba import njit"] if compiled else []
    return _TEMPLATE.format(
        demand=demand,
        imports="\n".join(imports),
        functions=copies,
        decorator=decorator,
        arguments=", ".join(arguments(demand)),
        block=BLOCK,
        views=textwrap.indent("\n".join(_views(body)), " " * 8),
        body=textwrap.indent(body, " " * 16),
    )


def _views(body: str) -> Iterator[str]:
    """The block's part of each array: an index that starts at 0 is known not to be negative."""
    for name in dict.fromkeys(re.findall(r"block_(\w+)\[i\]", body)):
        yield f"block_{name} = {name}[first:last]"


def _functions(body: str) -> list[Callable[..., Any]]:
    """The generated functions that a kernel calls."""
    known: tuple[Callable[..., Any], ...] = (
        elementary.power,
        translation.acceleration,
        rotation.angular_acceleration,
        *_DRAGS.values(),
    )
    return [f for f in known if re.search(rf"(?<![\w.]){f.__name__}\(", body)]


def _body(demand: Demand) -> Iterator[str]:
    """One step of body i."""
    along = axes(demand)
    states = (("position", "positions"), ("velocity", "velocities"))
    for state, many in states:
        yield from (f"{state}_{axis} = {many}_{axis}[i]" for axis in along)
    lines = list(
        statements(getattr(schemes, demand.scheme), along, lambda name: _pull(demand, name))
    )
    yield from _used(lines)
    for state, many in states:
        yield from (f"{many}_{axis}[i] = {state}_{axis}" for axis in along)


def _used(lines: list[str]) -> list[str]:
    """The statements without those that say for which state a steady acceleration is asked."""
    kept = list(lines)
    for k in reversed(range(len(lines))):
        target = lines[k].partition(" = ")[0]
        later = "\n".join(kept[k + 1 :])
        if target.startswith("at_") and not re.search(rf"\b{target}\b(?! = )", later):
            del kept[k]
    return kept


def _pull(demand: Demand, name: str) -> Iterator[str]:
    """Statements for the acceleration of body i where a step asks for it."""
    along = axes(demand)
    if demand.steady:
        given = "accelerations_{}[i]" if demand.forces else "acceleration_{}"
        yield from (f"{name}_{axis} = {given.format(axis)}" for axis in along)
        return
    yield from (f"load_{axis} = loads_{axis}[i]" for axis in along)
    for component, text in demand.laws:
        axis = "xy"[component] if component < 2 else "turn"
        yield f"load_{axis} = load_{axis} + ({_law(text)})"
    for kind, force in _DRAGS.items():
        if getattr(demand, kind):
            yield f"drag_x, drag_y = {force.__name__}({kind}s[i], (at_velocity_x, at_velocity_y))"
            yield from (f"load_{axis} = load_{axis} + drag_{axis}" for axis in "xy")
    sides = "(gravity_x, gravity_y), (load_x, load_y), masses[i]"
    yield f"{name}_x, {name}_y = acceleration({sides})"
    if demand.rotation:
        yield f"{name}_turn = angular_acceleration(load_turn, inertias[i])"


def _law(text: str) -> str:
    """A law of time and state as source, with the names of the step's state."""
    printed = PythonPrinter(table_from(SYMBOLS)).scalar(parse(text))
    return re.sub(r"[a-z]\w*", lambda word: _STATE.get(word.group(), word.group()), printed)
