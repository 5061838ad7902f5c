"""Scenes of random bodies, loads, springs and joints, and what is asked of them at random."""

import math
import warnings
from collections.abc import Callable
from typing import Any

import numpy as np

import tamias2d as t2
from tools.fuzz.numbers import Numbers

JUNK: tuple[object, ...] = (None, "", "a", [], {}, (1,), True, 10**400, 1j, b"1", object(), print)
LAWS = (
    "1[N]",
    "-10[N/m]*x(position)",
    "1[N]*sin(30[rad/s]*time)",
    "1[N]*exp(time*100[1/s])",
    "1[N*s]/(time - 0.01[s])",
    "1[N]*sqrt(x(position)*1[1/m])",
    "-1[kg/s]*y(velocity)",
    "1[m]",
    "1[N]*",
)
METHODS: tuple[Callable[[], Any], ...] = (
    t2.ClosedForm,
    t2.VelocityVerlet,
    t2.RungeKutta4,
    t2.Dop853,
    t2.Reference,
    t2.Stepped,
    t2.Legacy2018,
    t2.ExplicitEuler,
)
_ADAPTIVE = (t2.ClosedForm, t2.Dop853, t2.Reference)
WORK = 300  # steps and impacts of a run


def case(seed: int) -> str:
    """Make a scene and ask something of it; return what came of it."""
    numbers = Numbers(seed)
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("error", RuntimeWarning)
            warnings.simplefilter("ignore", t2.StepWarning)
            _ask(numbers, _scene(numbers))
    except t2.TamiasError:
        return "refused"
    return "done"


def _ask(numbers: Numbers, scene: t2.Scene) -> None:
    chance = numbers.chance
    match chance.randrange(6):
        case 0 | 1:
            sim = t2.Simulator(scene, time_step=_time_step(numbers))
            sim.step(chance.choice((1, 2, 5)))
            _finite(sim.position, sim.velocity, sim.orientation, sim.contacts.impulse)
        case 2 | 3 | 4:
            run = t2.simulate(scene, duration=numbers.positive(-3.0, -0.5), **_arguments(numbers))
            _finite(run.position, run.velocity, run.orientation, run.angular_velocity)
        case _:
            t2.needs(scene)
            t2.certify(t2.simulate(scene, duration=0.02, work_limit=WORK))


def _finite(*values: Any) -> None:
    for each in values:
        assert np.isfinite(each).all(), "a state is not finite"


def _time_step(numbers: Numbers) -> float:
    return numbers.chance.choice((1 / 60, 1 / 60, numbers.positive(-4.0, 0.0)))


def _arguments(numbers: Numbers) -> dict[str, Any]:
    chance, found = numbers.chance, dict[str, Any](work_limit=WORK)
    if chance.random() < 0.4:
        found["method"] = chance.choice(METHODS)()
        if type(found["method"]) not in _ADAPTIVE or numbers.strange():
            found["time_step"] = numbers.positive(-3.0, -1.0)
    if numbers.strange():
        found["times"] = [numbers.number(0.0, 0.1) for _ in range(chance.randint(0, 4))]
    if numbers.strange():
        found[chance.choice(("time_step", "times", "tolerance", "work_limit", "progress"))] = (
            chance.choice(JUNK)
        )
    return found


def _scene(numbers: Numbers) -> t2.Scene:
    chance = numbers.chance
    gravity = chance.choice(((0.0, 0.0), (0.0, -9.81), numbers.pair(20.0)))
    scene = t2.Scene(gravity=gravity, duration=0.05)
    if chance.random() < 0.6:
        _add_wall(scene, numbers)
    for _ in range(chance.randint(0, 4)):
        scene.add_body(_shape(numbers), **_body(numbers))
    bodies = len(scene.bodies)
    if bodies > 1 and chance.random() < 0.2:
        _add_spring(scene, numbers, bodies)
    if bodies > 1 and chance.random() < 0.15:
        _add_joint(scene, numbers, bodies)
    if chance.random() < 0.05:
        scene.add_attraction(gravitational_constant=numbers.positive(-6.0, 2.0))
    if chance.random() < 0.05:
        scene.add_field(force=(chance.choice(LAWS), numbers.number()))
    return scene


def _add_wall(scene: t2.Scene, numbers: Numbers) -> None:
    chance = numbers.chance
    surface: dict[str, Any] = {
        "restitution": numbers.number(0.0, 1.0),
        "friction": abs(numbers.number(0.0, 1.0)),
    }
    match chance.randrange(3):
        case 0:
            plane = t2.HalfPlane(normal=(0.0, 1.0), offset=numbers.number(-5.0, -3.0))
            scene.add_static(plane, **surface)
        case 1:
            scene.add_static(_shape(numbers), position=numbers.pair(), **surface)
        case _:
            scene.add_kinematic(
                _shape(numbers), position=numbers.pair(), velocity=numbers.pair(), **surface
            )


def _body(numbers: Numbers) -> dict[str, Any]:
    chance = numbers.chance
    found: dict[str, Any] = {
        "mass": numbers.positive(-2.0, 2.0),
        "position": numbers.pair(6.0),
        "velocity": numbers.pair(),
        "orientation": numbers.number(),
        "angular_velocity": numbers.number(),
        "restitution": chance.choice((0.0, 0.5, 1.0, numbers.number(0.0, 1.0))),
        "friction": chance.choice((0.0, 0.5)),
    }
    for name in ("linear_drag", "quadratic_drag", "angular_drag"):
        if chance.random() < 0.1:
            found[name] = abs(numbers.number(0.0, 2.0))
    if chance.random() < 0.1:
        found["force"] = (chance.choice(LAWS), numbers.number())
    if chance.random() < 0.05:
        found["inertia"] = numbers.positive()
    if numbers.strange():
        found[chance.choice(tuple(found))] = chance.choice(JUNK)
    if numbers.strange():
        found[chance.choice(("resitution", "nane", "group", "mask", "category", "name"))] = (
            chance.choice((*JUNK, 1))
        )
    return found


def _shape(numbers: Numbers) -> Any:
    chance = numbers.chance
    if numbers.strange() and chance.random() < 0.2:
        return chance.choice(JUNK)
    match chance.randrange(7):
        case 0:
            return t2.Disc(radius=numbers.positive())
        case 1:
            return t2.Box(width=numbers.positive(), height=numbers.positive(-4.0))
        case 2:
            return t2.Segment(length=numbers.positive())
        case 3:
            return t2.Capsule(length=numbers.positive(), radius=numbers.positive(-4.0))
        case 4:
            return t2.Polygon(vertices=_corners(numbers))
        case 5:
            parts = [
                t2.Part(
                    shape=t2.Disc(radius=0.3) if chance.random() < 0.5 else _shape(numbers),
                    position=numbers.pair(1.0),
                    orientation=numbers.number(),
                )
                for _ in range(chance.randint(1, 3))
            ]
            return t2.Compound(parts=parts)
        case _:
            return None if numbers.strange() else t2.Disc(radius=0.3)


def _corners(numbers: Numbers) -> list[tuple[float, float]]:
    chance = numbers.chance
    if numbers.strange():
        return [numbers.pair(1.0) for _ in range(chance.randint(0, 6))]
    angles = sorted(chance.uniform(0.0, math.tau) for _ in range(chance.randint(3, 6)))
    return [(0.6 * math.cos(angle), 0.4 * math.sin(angle)) for angle in angles]


def _add_spring(scene: t2.Scene, numbers: Numbers, bodies: int) -> None:
    chance = numbers.chance
    scene.add_spring(
        chance.randrange(bodies),
        chance.choice((chance.randrange(bodies), numbers.pair())),
        stiffness=numbers.positive(0.0, 4.0),
        rest_length=abs(numbers.number()),
        damping=abs(numbers.number(0.0, 1.0)),
    )


def _add_joint(scene: t2.Scene, numbers: Numbers, bodies: int) -> None:
    chance = numbers.chance
    kind = chance.choice(
        (
            t2.Revolute,
            t2.Weld,
            lambda: t2.Distance(length=numbers.positive()),
            lambda: t2.Prismatic(axis=numbers.pair()),
            lambda: t2.Gear(ratio=numbers.number()),
        )
    )
    first, second = chance.randrange(bodies), chance.randrange(bodies)
    scene.add_joint(kind(), first, second, anchor=numbers.pair(1.0))
