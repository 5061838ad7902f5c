"""The source of the accelerations of some bodies: the generated functions, for one demand.

Serves: the makers of kernels. Hides: how terms become loops. No equation is written here. The
state of n bodies is one row of numbers: all x, then all y, then all orientations.
"""

import re
from collections.abc import Callable, Iterator
from typing import Any

from tamias2d.generated import definitions, drag, gravitation, rotation, spring, translation
from tamias2d.kernels.copied import copied
from tamias2d.kernels.force_demand import TURNING, ForceDemand
from tamias2d.scene.springs import arm
from tamias2d.spec import functions as elementary

_NAMES = {"largest": "max", "least": "min"}
_IN_MATH = ("atan2", "cos", "exp", "log", "sin", "sqrt", "tan", "pi")
_STATE = {
    "position_x": "position[i]",
    "position_y": "position[count + i]",
    "orientation": "position[2 * count + i]",
    "velocity_x": "velocity[i]",
    "velocity_y": "velocity[count + i]",
    "angular_velocity": "velocity[2 * count + i]",
    "mass": "mass[i]",
}
_DRAGS = ("linear_drag", "quadratic_drag")


def arguments(demand: ForceDemand) -> list[str]:
    """Return the names of the tables that the accelerations take, in order."""
    found = ["gravity", "steady", "mass", *(["inertia"] if demand.rotation else [])]
    for k, _ in enumerate(demand.laws):
        found += [f"law_{k}_rows", f"law_{k}_numbers"]
    for kind in _DRAGS:
        found += [f"{kind}_rows", kind] if getattr(demand, kind) else []
    found += ["angular_drag"] if demand.angular_drag else []
    if demand.springs:
        found += ["first_ends", "second_ends", "still", "stiffness", "rest_length", "damping"]
        found += ["anchors"] if demand.anchors else []
    return found + (["gravitational_constant"] if demand.attraction else [])


def source(demand: ForceDemand) -> tuple[list[str], list[str]]:
    """Return the functions that the accelerations of a demand need, themselves the last.

    `accelerations` fills `rate` and returns whether all of it is finite. Returned beside it are the
    names that are to be imported from `math`.
    """
    body = "\n".join(f"    {line}" if line else "" for line in _body(demand))
    named = ", ".join(["time", "position", "velocity", "rate", *arguments(demand)])
    text = f"def accelerations({named}):\n{body}"
    copies = _functions(text)
    texts = [*copies, text]
    used = [name for name in _IN_MATH if re.search(rf"\b{name}\b", "\n".join(texts))]
    return texts, used


def _functions(body: str) -> list[str]:
    """The generated functions that are called, and what they call."""
    known: tuple[Callable[..., Any], ...] = (
        elementary.power,
        arm,
        definitions.point_velocity,
        definitions.torque,
        spring.spring_force,
        gravitation.attraction,
        drag.linear_drag_force,
        drag.quadratic_drag_force,
        drag.angular_drag_torque,
        translation.acceleration,
        rotation.angular_acceleration,
    )
    return [copied(f, _NAMES) for f in known if re.search(rf"(?<!def ){f.__name__}\(", body)]


def _body(demand: ForceDemand) -> Iterator[str]:
    yield '"""Set the accelerations of all bodies; return whether they are finite."""'
    yield "count = len(mass)"
    yield f"for j in range({demand.axes} * count):"
    yield "    rate[j] = steady[j]"
    for k, (component, shape) in enumerate(demand.laws):
        yield from _law(k, component, shape)
    for kind in _DRAGS:
        if getattr(demand, kind):
            yield from _drag(kind)
    if demand.angular_drag:
        yield "for i in range(count):"
        yield "    turn = angular_drag_torque(angular_drag[i], velocity[2 * count + i])"
        yield "    rate[2 * count + i] = rate[2 * count + i] + turn"
    if demand.springs:
        yield from _springs(demand)
    if demand.attraction:
        yield from _attraction()
    yield "check = 0.0"
    yield "for i in range(count):"
    yield "    force = (rate[i], rate[count + i])"
    yield "    rate[i], rate[count + i] = acceleration((gravity[0], gravity[1]), force, mass[i])"
    yield "    check += rate[i] * 0.0 + rate[count + i] * 0.0"
    if demand.rotation:
        yield "    turn = angular_acceleration(rate[2 * count + i], inertia[i])"
        yield "    rate[2 * count + i] = turn"
        yield "    check += turn * 0.0"
    yield "return check == 0.0"


def _law(k: int, component: int, shape: str) -> Iterator[str]:
    count = len(set(re.findall(r"numbers\[(\d+)\]", shape)))
    text = re.sub(r"[a-z]\w*", lambda word: _STATE.get(word.group(), word.group()), shape)
    text = re.sub(r"\bnumbers\[(\d+)\]", rf"law_{k}_numbers[at + \1]", text)
    for name, other in _NAMES.items():
        text = re.sub(rf"\b{name}\(", f"{other}(", text)
    target = f"rate[{component} * count + i]" if component else "rate[i]"
    yield f"for k in range(len(law_{k}_rows)):"
    yield f"    i = law_{k}_rows[k]"
    if count:
        yield f"    at = {count} * k"
    yield f"    {target} = {target} + ({text})"


def _drag(kind: str) -> Iterator[str]:
    yield f"for i in {kind}_rows:"
    yield f"    x, y = {kind}_force({kind}[i], (velocity[i], velocity[count + i]))"
    yield "    rate[i] = rate[i] + x"
    yield "    rate[count + i] = rate[count + i] + y"


def _springs(demand: ForceDemand) -> Iterator[str]:
    yield "for k in range(len(stiffness)):"
    for name, end, first in (("a", "first_ends", 0), ("b", "second_ends", 2)):
        yield f"    {name} = {end}[k]"
        yield f"    if {name} < count:"
        yield f"        place_{name} = (position[{name}], position[count + {name}])"
        yield f"        speed_{name} = (velocity[{name}], velocity[count + {name}])"
        if demand.anchors:
            yield f"        turned_{name} = position[2 * count + {name}]"
            yield f"        spin_{name} = velocity[2 * count + {name}]"
        yield "    else:"
        yield f"        at = 3 * ({name} - count)"
        yield f"        place_{name} = (still[at], still[at + 1])"
        yield f"        speed_{name} = (0.0, 0.0)"
        if demand.anchors:
            yield f"        turned_{name} = still[at + 2]"
            yield f"        spin_{name} = 0.0"
            anchor = f"(anchors[4 * k + {first}], anchors[4 * k + {first + 1}])"
            yield f"    arm_{name} = arm({anchor}, turned_{name})"
            x, y = (f"place_{name}[{k}] + arm_{name}[{k}]" for k in (0, 1))
            yield f"    place_{name} = ({x}, {y})"
            yield f"    speed_{name} = point_velocity(speed_{name}, spin_{name}, arm_{name})"
    ends = "place_a, speed_a, place_b, speed_b"
    yield f"    x, y = spring_force(stiffness[k], rest_length[k], damping[k], {ends})"
    for name, force in (("a", "x, y"), ("b", "-x, -y")):
        x, y = force.split(", ")
        yield f"    if {name} < count:"
        yield f"        rate[{name}] = rate[{name}] + {x}".replace("+ -", "- ")
        yield f"        rate[count + {name}] = rate[count + {name}] + {y}".replace("+ -", "- ")
        if demand.anchors:
            turn = f"rate[{TURNING} * count + {name}]"
            yield f"        {turn} = {turn} + torque(arm_{name}, ({force}))"


def _attraction() -> Iterator[str]:
    yield "for a in range(count):"
    yield "    for b in range(a + 1, count):"
    ends = "(position[a], position[count + a]), (position[b], position[count + b])"
    yield f"        x, y = attraction(gravitational_constant[0], mass[a], mass[b], {ends})"
    yield "        rate[a] = rate[a] + x"
    yield "        rate[count + a] = rate[count + a] + y"
    yield "        rate[b] = rate[b] - x"
    yield "        rate[count + b] = rate[count + b] - y"
