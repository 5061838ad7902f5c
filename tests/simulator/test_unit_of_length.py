"""What is stated in another unit of length moves the same way: laws know no metre.

Lengths are scaled by a factor, torques and inertias by its square, forces and gravity as lengths;
times and masses stay.
"""

from collections.abc import Callable

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.scene import Distance, Gear, Groove, Prismatic, Revolute, Rotary, Weld, Wheel
from tamias2d.simulator import Simulator
from tamias2d.state import Array
from tests.engine.scenes import ground

SHIFT = 2.0**10
"""Near a thousand: what scales a float64 by it, or by its inverse, rounds nothing."""
ROUNDING = 1e-6
"""Of lengths in units and of radians, over half a second: 1e-16 times 1e8, by which limits are
firmer than what they hold (DD57), in some hundred solutions."""


class Model:
    """A scene whose lengths are given in a unit, m."""

    def __init__(self, unit: float) -> None:
        self.unit = unit
        self.scene = t2.Scene(gravity=(0.0, -10.0 * unit))

    def __call__(self, x: float, y: float) -> tuple[float, float]:
        return x * self.unit, y * self.unit

    def box(self, x: float, y: float, width: float, height: float, mass: float = 1.0) -> int:
        shape = t2.Box(width=width * self.unit, height=height * self.unit)
        surface = {"friction": 0.5, "restitution": 0.0}
        return self.scene.add_body(shape, mass=mass, position=self(x, y), **surface)

    def disc(self, x: float, y: float, radius: float, spin: float = 0.0) -> int:
        shape, moving = t2.Disc(radius=radius * self.unit), {"angular_velocity": spin}
        surface = {"friction": 0.5, "restitution": 0.0}
        return self.scene.add_body(shape, mass=1.0, position=self(x, y), **surface, **moving)

    def point(self, x: float, y: float, inertia: float) -> int:
        inertia = inertia * self.unit**2
        return self.scene.add_body(None, mass=1.0, inertia=inertia, position=self(x, y))

    def turning(self, speed: float, maximum: float) -> t2.Motor:
        return t2.Motor(speed=speed, maximum=maximum * self.unit**2)

    def moving(self, speed: float, maximum: float) -> t2.Motor:
        return t2.Motor(speed=speed * self.unit, maximum=maximum * self.unit)

    def twisting(self, stiffness: float, damping: float) -> t2.JointSpring:
        square = self.unit**2
        return t2.JointSpring(stiffness=stiffness * square, damping=damping * square)

    def between(self, lower: float, upper: float, restitution: float = 0.0) -> t2.Limits:
        lower, upper = lower * self.unit, upper * self.unit
        return t2.Limits(lower=lower, upper=upper, restitution=restitution)


def within(lower: float, upper: float, restitution: float = 0.0) -> t2.Limits:
    return t2.Limits(lower=lower, upper=upper, restitution=restitution)


def driven_arm(m: Model) -> None:
    hinge = Revolute(motor=m.turning(2.0, 2.0), limits=within(-0.5, 0.5, 0.5))
    m.scene.add_joint(hinge, (0.0, 0.0), m.box(0.5, 0.0, 1.0, 0.1), at=(0.0, 0.0))


def rotor_of_no_size(m: Model) -> None:
    hinge = Revolute(motor=m.turning(5.0, 0.3), limits=within(-0.5, 0.5))
    m.scene.add_joint(hinge, (0.0, 0.0), m.point(0.0, 0.0, 0.1), at=(0.0, 0.0))


def geared_rotors_of_no_size(m: Model) -> None:
    one, other = m.point(0.0, 0.0, 0.2), m.point(0.8, 0.0, 0.05)
    driven = Revolute(motor=m.turning(3.0, 0.2))
    m.scene.add_joint(driven, m(0.0, 0.0), one, at=m(0.0, 0.0))
    m.scene.add_joint(Revolute(limits=within(-1.0, 1.0)), m(0.8, 0.0), other, at=m(0.8, 0.0))
    m.scene.add_joint(Gear(ratio=-5 / 3), one, other)
    m.scene.add_joint(Rotary(motor=m.turning(1.0, 0.1)), one, m.point(2.0, 0.0, 0.1))


def chain(m: Model) -> None:
    hinges = (
        Revolute(motor=m.turning(1.0, 3.0), limits=within(-0.3, 0.4)),
        Revolute(spring=m.twisting(30.0, 0.1), limits=within(-0.2, 0.2)),
    )
    above: int | tuple[float, float] = (0.0, 0.0)
    for k in range(5):
        link = m.box(0.5 + k, 0.0, 0.8, 0.1)
        m.scene.add_joint(hinges[k % 2], above, link, at=m(float(k), 0.0))
        above = link


def equal_chains(m: Model) -> None:
    """They are solved side by side."""
    for n in range(10):
        above: int | tuple[float, float] = m(5.0 * n, 0.0)
        for k in range(3):
            link = m.box(5.0 * n + 0.5 + k, 0.0, 0.8, 0.1, mass=1.0 + 0.1 * n)
            hinge = Revolute(spring=m.twisting(20.0, 0.3))
            m.scene.add_joint(hinge, above, link, at=m(5.0 * n + k, 0.0))
            above = link


def four_bars(m: Model) -> None:
    left, top, right = (
        m.box(*at, *size) for at, size in (((0.0, 0.5), (0.1, 0.8)), ((1.0, 1.0), (1.8, 0.1)),
                                           ((2.0, 0.5), (0.1, 0.8)))
    )  # fmt: skip
    driven = Revolute(motor=m.turning(3.0, 5.0), limits=within(-1.0, 1.0))
    m.scene.add_joint(driven, (0.0, 0.0), left, at=(0.0, 0.0))
    m.scene.add_joint(Revolute(), left, top, at=m(0.0, 1.0))
    m.scene.add_joint(Revolute(), top, right, at=m(2.0, 1.0))
    m.scene.add_joint(Revolute(), m(2.0, 0.0), right, at=m(2.0, 0.0))


def slides(m: Model) -> None:
    slide, bob = m.box(0.0, 0.0, 0.3, 0.3), m.disc(0.5, -1.0, 0.2)
    along = Prismatic(axis=(1.0, 0.5), limits=m.between(-1.0, 1.0, 0.3), motor=m.moving(2.0, 12.0))
    m.scene.add_joint(along, (0.0, 0.0), slide, at=(0.0, 0.0))
    m.scene.add_joint(Distance(limits=m.between(0.2, 1.2, 0.4)), slide, bob)
    groove = Groove(axis=(0.0, 1.0), limits=m.between(-0.2, 0.2))
    m.scene.add_joint(groove, bob, m.box(0.5, -1.0, 0.1, 0.1), at=m(0.5, -1.0))


def car(m: Model) -> None:
    """It leans on the ground, and its arm on its limits."""
    ground(m.scene, 0.5)
    body = m.box(0.0, 0.9, 2.0, 0.5, mass=10.0)
    suspension = t2.JointSpring(stiffness=400.0, damping=20.0)
    for x in (-0.8, 0.8):
        wheel = Wheel(axis=(0.0, 1.0), spring=suspension, motor=m.turning(-8.0, 4.0))
        m.scene.add_joint(wheel, body, m.disc(x, 0.3, 0.3), at=m(x, 0.3))
    arm = m.box(0.0, 1.5, 0.1, 0.6)
    m.scene.add_joint(Revolute(limits=within(-0.4, 0.4)), body, arm, at=m(0.0, 1.2))
    m.scene.add_joint(Weld(), arm, m.box(0.0, 1.9, 0.2, 0.2), at=m(0.0, 1.8))


def whirling_bobs(m: Model) -> None:
    """Their springs hold them at their centres, and beside them, while they turn fast."""
    for k in range(4):
        m.disc(k, 0.0, 0.2, spin=30.0)
    m.scene.add_spring(0, 1, stiffness=100.0, rest_length=0.7 * m.unit)
    anchor, other = m(0.1, 0.0), m(-0.1, 0.05)
    m.scene.add_spring(
        2, 3, stiffness=300.0, rest_length=0.6 * m.unit, anchor=anchor, other_anchor=other
    )


MECHANISMS = (
    whirling_bobs, driven_arm, rotor_of_no_size, geared_rotors_of_no_size, chain, equal_chains,
    four_bars, slides, car,
)  # fmt: skip


def moved(build: Callable[[Model], None], unit: float, steps: int) -> Array:
    """Return how bodies are after each step, in units of length, radians and seconds."""
    model = Model(unit)
    build(model)
    sim, found = Simulator(model.scene), []
    for _ in range(steps):
        sim.step()
        lengths = np.hstack((sim.position, sim.velocity)) / unit
        found.append(np.column_stack((lengths, sim.orientation, sim.angular_velocity)))
    return np.array(found)


@pytest.mark.parametrize("build", MECHANISMS)
def test_another_unit_that_rounds_nothing_has_the_same_bits(
    build: Callable[[Model], None],
) -> None:
    there = moved(build, 1.0, 120)
    for unit in (1 / SHIFT, SHIFT):
        assert np.array_equal(moved(build, unit, 120), there)


@pytest.mark.parametrize("unit", [1e-3, 1e-2, 0.1, 10.0, 100.0, 1e3])
@pytest.mark.parametrize("build", MECHANISMS)
def test_another_unit_moves_the_same_way(build: Callable[[Model], None], unit: float) -> None:
    steps = 20  # in the next one the chain strikes a limit, which rounding tells to 1e-4
    assert moved(build, unit, steps) == pytest.approx(moved(build, 1.0, steps), abs=ROUNDING)


def test_points_that_weigh_other_numbers_move_as_if_they_always_had() -> None:
    """The arm at which their angles count as ways follows."""
    sims = []
    for inertia in (0.1, 1e3):
        scene = t2.Scene(gravity=(0.0, 0.0))
        scene.add_body(None, mass=1.0, inertia=inertia, position=(0.0, 0.0))
        hinge = Revolute(limits=within(-0.5, 0.5), motor=t2.Motor(speed=5.0, maximum=300.0))
        scene.add_joint(hinge, (0.0, 0.0), 0, at=(0.0, 0.0))
        sim = Simulator(scene)
        sim._settle_between()
        sim.set_mass(0, mass=1.0, inertia=1e3)
        sim.step(120)
        sims.append(sim)
    assert sims[0].orientation[0] == pytest.approx(0.5, abs=1e-3)  # it leans on its limit
    assert sims[0].digest() == sims[1].digest()
