"""Kicks and drifts between which joints hold: orders, the way back in time, energy (GD24)."""

import math
from collections.abc import Callable, Sequence

import numpy as np
import pytest
from numpy.typing import NDArray

import tamias2d as t2
from tamias2d.motion.method import Method
from tamias2d.scene import Scene, catalogue

G = 9.81


State = tuple[tuple[float, float], float, tuple[float, float], float]


def chain(states: Sequence[State]) -> Scene:
    """Rods of 1 m and 1 kg in a chain from the origin: places, turns, velocities and spins."""
    scene = Scene(gravity=(0, -G))
    for k, (place, turn, velocity, spin) in enumerate(states):
        rod = scene.add_body(
            None, mass=1, inertia=1 / 12, position=place, orientation=turn, velocity=velocity,
            angular_velocity=spin,
        )  # fmt: skip
        if k:
            scene.add_joint(t2.Revolute(), rod - 1, rod, anchor=(0, -0.5), other_anchor=(0, 0.5))
        else:
            scene.add_joint(t2.Revolute(), (0, 0), rod, other_anchor=(0, 0.5))
    return scene


def rods(count: int, turn: float) -> Scene:
    """A chain at rest, each rod of which is turned by an angle from the one before, rad."""
    states: list[State] = []
    x = y = 0.0
    for k in range(1, count + 1):
        dx, dy = math.sin(turn * k), -math.cos(turn * k)
        states.append(((x + dx / 2, y + dy / 2), turn * k, (0.0, 0.0), 0.0))
        x, y = x + dx, y + dy
    return chain(states)


def driven() -> Scene:
    """A rod that a motor turns, with another on it, and a pendulum on a trolley to and fro."""
    scene = rods(2, 0.7)
    scene.add_joint(t2.Rotary(motor=t2.Motor(speed=2.0)), (0, 0), 0)
    trolley = scene.add_body(None, mass=1, inertia=0.1, position=(5, 0), velocity=(0.9, 0))
    to_and_fro = "x(point_a) - 5[m] - 0.3[m]*sin(3[rad/s]*time)"
    scene.add_joint(t2.Equation([to_and_fro, "y(point_a)", "orientation_a/2"]), trolley)
    bob = scene.add_body(None, mass=2, inertia=0.1, position=(5, -0.7), velocity=(0.9, 0))
    scene.add_joint(t2.Distance(), trolley, bob)
    return scene


def sprung() -> Scene:
    """A chain whose joints have a spring, and a limit that bounces."""
    scene = rods(2, 0.5)
    spring = t2.JointSpring(stiffness=30.0, damping=0.0)
    limits = t2.Limits(lower=-0.2, upper=0.6, restitution=0.7)
    scene.add_joint(t2.Rotary(spring=spring), 0, 1)
    scene.add_joint(t2.Rotary(limits=limits), (0, 0), 0)
    return scene


SCENES: dict[str, tuple[Callable[[], Scene], float, int]] = {
    "three rods": (lambda: rods(3, 0.9), 0.5, 80),
    "driven": (driven, 0.5, 32),
    "sprung": (sprung, 0.8, 80),
    "loops": (lambda: catalogue.load("four-bars"), 0.3, 32),
    "loops, slides and springs": (lambda: catalogue.load("andrews"), 0.005, 80),
}
ORDERS = [
    *((name, t2.VelocityVerlet(), 2) for name in SCENES),
    *((name, t2.Yoshida4(), 4) for name in SCENES),
    ("three rods", t2.SemiImplicitEuler(), 1),
]


@pytest.mark.parametrize(("name", "method", "order"), ORDERS)
def test_a_scheme_keeps_its_order(name: str, method: Method, order: int) -> None:
    make, duration, count = SCENES[name]
    true = t2.simulate(make(), duration=duration, times=[duration]).position
    off: list[float] = []
    for steps in (count, 2 * count, 4 * count):
        run = t2.simulate(
            make(), duration=duration, times=[duration], method=method, time_step=duration / steps
        )
        off.append(float(np.linalg.norm(run.position - true)))
    observed = math.log2(off[0] / off[-1]) / 2
    assert observed == pytest.approx(order, abs=0.15)  # the next power of the step still shows


@pytest.mark.parametrize("method", [t2.VelocityVerlet(), t2.Yoshida4()])
def test_steps_lead_back_to_where_they_came_from(method: Method) -> None:
    """With all velocities turned round, whatever the step: they read the same backwards."""
    scene = rods(3, 0.9)
    steps = {"duration": 0.5, "times": [0.5], "method": method, "time_step": 0.025}
    run = t2.simulate(scene, **steps)
    rows = zip(
        run.position[0].tolist(), run.orientation[0].tolist(),
        (-run.velocity[0]).tolist(), (-run.angular_velocity[0]).tolist(), strict=True,
    )  # fmt: skip
    ended = t2.simulate(
        chain([(tuple(q), turn, tuple(v), spin) for q, turn, v, spin in rows]), **steps
    )
    begun = np.array([body.position for body in scene.bodies])
    assert ended.position[0] == pytest.approx(begun, abs=1e-12)  # 20 steps' rounding
    assert ended.velocity[0] == pytest.approx(0.0, abs=1e-11)


def energies(scene: Scene, method: Method, steps: int, time_step: float) -> NDArray[np.float64]:
    duration = steps * time_step
    run = t2.simulate(
        scene, duration=duration, times=np.linspace(0, duration, 201), method=method,
        time_step=time_step,
    )  # fmt: skip
    return np.asarray(run.energy)


def test_energy_swings_and_does_not_creep() -> None:
    """In the second half of the time it has the mean of the first; Runge and Kutta's falls."""
    scene = rods(2, 0.5)
    kept = energies(scene, t2.VelocityVerlet(), 4000, 0.02)
    span = float(np.ptp(kept))
    assert span < 0.01 * 2 * G
    assert abs(kept[100:].mean() - kept[:100].mean()) < 0.02 * span
    lost = energies(scene, t2.RungeKutta4(), 4000, 0.02)
    assert lost[150:].max() < lost[:50].min()
    assert not kept[150:].max() < kept[:50].min()
