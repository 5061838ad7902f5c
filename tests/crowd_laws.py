"""Random crowds, and the laws of the specification on each of their steps.

What is judged is the equation of a law as the specification has it; its values are those that a
simulator shows before and after a step.
"""

import math
from functools import cache
from typing import Any, NamedTuple

import numpy as np

import tamias2d as t2
from tamias2d.simulator import Simulator
from tamias2d.spec.evaluate import Value, evaluate
from tamias2d.spec.expression import Call, Node, Relation, parse

# In 18 and 1052 many bodies go on together; in 199 restitution alone pushes a body of an island.
SEEDS = (*range(19), 131, 199, 1052)
STEPS = 16
Values = dict[str, Value]


class Step(NamedTuple):
    """What a step of a crowd has to show."""

    values: Values
    steady: Any
    """(n,), which bodies kept their velocities"""
    whole: bool
    """whether it was not taken in parts"""
    contacts: int


def holds(
    equation: str,
    seed: int,
    *,
    within: float,
    steady: bool,
    at_most: bool,
) -> None:
    """Fail unless an equation holds in each step of a crowd, as a part of its larger side.

    It may be judged of steady bodies alone; its left side may have to be at most the right one, in
    place of equal.
    """
    law = parse(equation)
    assert isinstance(law, Relation)
    for number, step in enumerate(steps_of(seed)):
        known = _of(step.values, step.steady) if steady else step.values
        excess = np.asarray(evaluate(law.left, known)) - np.asarray(evaluate(law.right, known))
        off = excess if at_most else np.abs(excess)
        size = max(_size(law.left, known), _size(law.right, known))
        assert np.max(off, initial=0.0) <= within * size, f"seed {seed}, step {number}"


def _size(side: Node, values: Values) -> float:
    """Return how large a side is; of a sum, how large its terms are together."""
    if isinstance(side, Call) and side.function == "sum":
        return float(np.abs(np.asarray(evaluate(side.arguments[0], values))).sum())
    return float(np.abs(np.asarray(evaluate(side, values))).max(initial=0.0))


def _of(values: Values, some: Any) -> Values:
    """Return the values of some bodies alone."""
    return {
        name: value
        if isinstance(value, float)
        else tuple(part[some] for part in value)
        if isinstance(value, tuple)
        else value[some]
        for name, value in values.items()
    }


@cache
def steps_of(seed: int) -> list[Step]:
    """Return the steps of a crowd."""
    sim, inertia = crowd(seed)
    before, motion = _state(sim, inertia, "before"), _motion(sim)
    found = []
    for _ in range(STEPS):
        sim.step()
        after, moves = _state(sim, inertia, "after"), _motion(sim)
        known: Values = {"mass_i": sim.mass, "time_step": sim.time_step}
        known |= {**before, **after}
        steady = (moves == motion).all(axis=1)
        found.append(Step(known, steady, sim.parts == 1, len(sim.contacts)))
        before = {name.replace("after", "before"): value for name, value in after.items()}
        motion = moves
    return found


def _motion(sim: Simulator) -> Any:
    return np.column_stack((sim.velocity, sim.angular_velocity))


def _state(sim: Simulator, inertia: Any, when: str) -> Values:
    place, velocity, spin, mass = sim.position, sim.velocity, sim.angular_velocity, sim.mass
    turning = mass * (place[:, 0] * velocity[:, 1] - place[:, 1] * velocity[:, 0])
    energy = 0.5 * (mass * (velocity**2).sum(axis=1) + inertia * spin**2)
    values = {
        "position_i": _pair(place), "velocity_i": _pair(velocity),
        "angular_momentum_i": turning + inertia * spin, "kinetic_energy_i": energy,
    }  # fmt: skip
    return {f"{name}_{when}": value for name, value in values.items()}


def _pair(rows: Any) -> tuple[Any, Any]:
    return rows[:, 0].copy(), rows[:, 1].copy()


def crowd(seed: int) -> tuple[Simulator, Any]:
    """Bodies of all shapes that nothing outside pushes, thrown at their middle; and their inertias.

    Sizes are from 5 mm to 5 m, masses of equal sizes in ratios of up to 1000, speeds up to 30 sizes
    a step, restitution and friction from 0 to 1.
    """
    chance = np.random.default_rng(seed)
    size = 10 ** chance.uniform(math.log10(0.005), math.log10(5.0))
    speed = 10 ** chance.uniform(-2.0, math.log10(30.0)) * size * 60
    rubs = chance.uniform(0.0, 1.0)
    scene = t2.Scene(gravity=(0.0, 0.0))
    side = int(chance.integers(3, 6))
    for k in range(side * side):
        own = size * chance.uniform(0.3, 1.0)
        out = np.array([k % side - (side - 1) / 2, k // side - (side - 1) / 2])
        scene.add_body(
            _shape(int(chance.integers(6)), own),
            mass=float(10 ** chance.uniform(-1.5, 1.5) * own**2),
            position=tuple(2.02 * size * out),
            orientation=chance.uniform(0.0, 6.0),
            velocity=tuple(speed * (-out / side + 0.2 * chance.normal(size=2))),
            angular_velocity=chance.uniform(-20.0, 20.0),
            restitution=chance.uniform(0.0, 1.0),
            friction=rubs,
        )
    return Simulator(scene), np.array([body.inertia for body in scene.bodies])


def _shape(kind: int, size: float) -> Any:
    """Return a shape that a circle of a size, m, contains."""
    angles = 2 * math.pi / 5 * np.arange(5)
    dumbbell = [
        t2.Part(shape=t2.Disc(radius=0.4 * size), position=(x * size, 0.0)) for x in (-0.6, 0.6)
    ]
    shapes = (
        t2.Disc(radius=size),
        t2.Box(width=1.6 * size, height=0.8 * size),
        t2.Polygon(vertices=[(size * math.cos(a), size * math.sin(a)) for a in angles]),
        t2.Capsule(length=size, radius=0.3 * size),
        t2.Segment(length=1.9 * size),
        t2.Compound(parts=dumbbell),
    )
    return shapes[kind]
