"""Scenes that nothing outside pushes: momentum and angular momentum are kept by either way.

Of mechanisms, energy is judged as well.
"""

import math
from typing import Any

import numpy as np

import tamias2d as t2
from tamias2d.state import Array
from tools.fuzz.numbers import Numbers
from tools.fuzz.pinched import pinched, simulator

ROUNDING = 1e-12  # of the sum of magnitudes
REDUNDANT = 1e-9  # likewise, of joints that depend on each other: large impulses cancel
GAIN = 1e-3  # of the energy at first: more has to be told
_STEPS, _TIME_STEP = 60, 1 / 30


def located(seed: int) -> str:
    """Simulate bodies that meet, their impacts located; return what came of it."""
    scene = meeting(seed)
    run: t2.Run | None
    try:
        run = t2.simulate(scene, duration=_STEPS * _TIME_STEP, method=t2.ClosedForm())
    except t2.SimulationError as error:  # simultaneous impacts: the run goes up to there
        run = getattr(error, "run", None)
    if run is None or len(run.position) == 0:
        return "refused"
    mass = np.array([body.mass for body in scene.bodies])
    inertia = np.array([body.inertia for body in scene.bodies])
    _judge(mass, inertia, run.position, run.velocity, run.angular_velocity)
    return "done"


def stepped(seed: int) -> str:
    """Step bodies that meet; return what came of it."""
    scene = meeting(seed)
    sim = t2.Simulator(scene, time_step=_TIME_STEP)
    mass = np.array([body.mass for body in scene.bodies])
    inertia = np.array([body.inertia for body in scene.bodies])
    states = [(sim.position.copy(), sim.velocity.copy(), sim.angular_velocity.copy())]
    for _ in range(_STEPS):
        sim.step()
        states.append((sim.position.copy(), sim.velocity.copy(), sim.angular_velocity.copy()))
    place, velocity, spin = (np.array(each) for each in zip(*states, strict=True))
    _judge(mass, inertia, place, velocity, spin)
    return "done"


def jointed(seed: int) -> str:
    """Step a mechanism at which bodies are thrown; return what came of it."""
    case = pinched(seed)
    sim = simulator(case)
    mass = np.array([body.mass for body in case.scene.bodies])
    inertia = np.array([body.inertia for body in case.scene.bodies])
    states = [(sim.position.copy(), sim.velocity.copy(), sim.angular_velocity.copy())]
    for _ in range(2 * _STEPS):
        sim.step()
        states.append((sim.position.copy(), sim.velocity.copy(), sim.angular_velocity.copy()))
    place, velocity, spin = (np.array(each) for each in zip(*states, strict=True))
    most = REDUNDANT if case.redundant else ROUNDING
    _judge(mass, inertia, place, velocity, spin, most)
    energy = 0.5 * ((velocity**2).sum(axis=2) @ mass + spin**2 @ inertia)
    gain = float(energy[2:].max() / energy[1] - 1.0)  # velocities fit joints after a step
    told = any("got energy" in text for text in sim.warnings)
    assert told or gain <= GAIN, f"energy rose by {gain:.1e} of what there was at first"
    return "done"


def meeting(seed: int) -> t2.Scene:
    """Return some bodies on a ring that are thrown at its middle."""
    numbers = Numbers(seed)
    chance = numbers.chance
    scene = t2.Scene(gravity=(0.0, 0.0))
    count, far = chance.randint(2, 6), chance.choice((0.0, 100.0))
    surface: dict[str, Any] = {
        "restitution": chance.choice((0.0, 1.0, chance.random())),
        "friction": chance.choice((0.0, chance.random())),
    }
    for k in range(count):
        angle, out = k * math.tau / count, chance.uniform(4.0, 6.0)
        speed, aim = 10.0 ** chance.uniform(0.0, 1.5), angle + chance.uniform(-0.1, 0.1)
        scene.add_body(
            _shape(chance),
            mass=10.0 ** chance.uniform(-3.0, 3.0),
            position=(out * math.cos(angle) + far, out * math.sin(angle)),
            velocity=(-speed * math.cos(aim), -speed * math.sin(aim)),
            orientation=chance.uniform(-4.0, 4.0),
            angular_velocity=chance.uniform(-9.0, 9.0),
            **surface,
        )
    return scene


def _shape(chance: Any) -> Any:
    length, thickness = 10.0 ** chance.uniform(-1.0, 0.3), 10.0 ** chance.uniform(-3.0, 0.0)
    kind = chance.randrange(5)
    if kind == 0:
        return t2.Disc(radius=length)
    if kind == 1:
        return t2.Box(width=length, height=thickness)
    if kind == 2:
        return t2.Segment(length=length)
    if kind == 3:
        return t2.Capsule(length=length, radius=thickness)
    corners = [(length * math.cos(a), length * math.sin(a)) for a in (0.3, 2.0, 4.5)]
    return t2.Polygon(vertices=corners)


def _judge(
    mass: Array,
    inertia: Array,
    place: Array,
    velocity: Array,
    spin: Array,
    most: float = ROUNDING,
) -> None:
    (x, y), (u, v) = place.transpose(2, 0, 1), velocity.transpose(2, 0, 1)
    size = float(np.abs(mass * np.hypot(u, v)).sum(axis=1).max())
    reach = float(np.hypot(x, y).max())
    turning = mass * (x * v - y * u)
    both = float((np.abs(turning).sum(axis=1) + np.abs(inertia * spin).sum(axis=1)).max())
    for name, parts, scale in (
        ("momentum along x", mass * u, size),
        ("momentum along y", mass * v, size),
        ("angular momentum", turning + inertia * spin, max(both, size * reach)),
    ):
        off = float(np.ptp(parts.sum(axis=1))) / scale
        assert off <= most, f"{name} is off by {off:.1e} of the sum of magnitudes"
