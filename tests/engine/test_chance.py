"""Hundreds of bodies by chance, in each other or not: what no collision may break stays whole.

Oracles are the laws: momentum, angular momentum and energy, from masses and views alone.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np
import pytest
from hypothesis import example, given, settings, strategies as st

import tamias2d as t2
from tamias2d.engine.tables import INVERSE_INERTIA
from tamias2d.state import Array

ROUNDING = 1e-12
"""Of the sum of sizes: some thousand additions in float64, each off by 1e-16."""


@dataclass(frozen=True)
class Chance:
    """What a scene is made of."""

    seed: int
    count: int
    crowded: bool
    """Whether bodies start in each other"""
    restitution: float
    friction: float
    scale: float
    """m: how large bodies are, about"""
    speed: float
    """of bodies, in their sizes a second"""


def chances(most: int, speed: float = 10.0) -> st.SearchStrategy[Chance]:
    return st.builds(
        Chance,
        seed=st.integers(0, 2**32 - 1),
        count=st.integers(2, most),
        crowded=st.booleans(),
        restitution=st.sampled_from((0.0, 0.5, 1.0)) | st.floats(0, 1),
        friction=st.sampled_from((0.0, 1.0)) | st.floats(0, 1),
        scale=st.sampled_from((1e-3, 1.0, 1e3)),
        speed=st.sampled_from((0.0, speed)) | st.floats(0, speed),
    )


class Crowd:
    """A simulator with bodies by chance, and what physics says of them."""

    def __init__(self, chance: Chance, *, pull: float, thin: bool = True) -> None:
        rng, size = np.random.default_rng(chance.seed), chance.scale
        shapes: list[t2.Disc | t2.Box | t2.Capsule | t2.Polygon] = [
            t2.Disc(radius=0.4 * size),
            t2.Box(width=0.8 * size, height=0.6 * size),
            t2.Capsule(length=0.5 * size, radius=0.25 * size),
            t2.Polygon(vertices=[(0.0, 0.0), (size, 0.1 * size), (0.4 * size, 0.9 * size)]),
        ]
        if thin:
            shapes.append(t2.Box(width=1.5 * size, height=0.05 * size))
        picked = [shapes[k] for k in rng.integers(len(shapes), size=chance.count)]
        self.width = np.sqrt(chance.count) * size * (0.3 if chance.crowded else 1.0) + size
        self.surface: Any = {"restitution": chance.restitution, "friction": chance.friction}
        self.sim = t2.Simulator(t2.Scene(gravity=(0.0, -pull * size)))
        speed = chance.speed * size
        self.mass = rng.uniform(0.1, 10.0, chance.count)
        self.bodies = self.sim.add(
            picked,
            mass=self.mass,
            position=rng.uniform(-self.width, self.width, (chance.count, 2)),
            orientation=rng.uniform(-3, 3, chance.count),
            velocity=rng.uniform(-speed, speed, (chance.count, 2)),
            angular_velocity=rng.uniform(-chance.speed, chance.speed, chance.count),
            **self.surface,
        )
        self.inertia = 1 / self.sim._engine.world.state.properties[self.bodies, INVERSE_INERTIA]

    def wall_in(self) -> None:
        """Put the bodies into a box without a lid."""
        for normal in ((0.0, 1.0), (1.0, 0.0), (-1.0, 0.0)):
            wall = t2.HalfPlane(normal=normal, offset=-self.width)
            self.sim.add_static(wall, **self.surface)

    def step(self) -> None:
        """Take a step; whatever happens, all that is told is a number."""
        self.sim.step()
        for values in (self.sim.position, self.sim.orientation, self.sim.velocity):
            assert np.isfinite(values).all()
        assert np.isfinite(self.sim.angular_velocity).all()

    @property
    def place(self) -> Array:
        place: Array = self.sim.position[self.bodies].copy()
        return place

    @property
    def energy(self) -> float:
        """Kinetic, J."""
        speed, spin = self.sim.velocity[self.bodies], self.sim.angular_velocity[self.bodies]
        return float(self.mass @ (speed**2).sum(axis=1) + self.inertia @ spin**2) / 2

    @property
    def momentum(self) -> Array:
        total: Array = self.mass @ self.sim.velocity[self.bodies]
        return total

    @property
    def momentum_size(self) -> float:
        return float(self.mass @ np.abs(self.sim.velocity[self.bodies]).sum(axis=1))

    def angular_momentum(self, place: Array) -> Array:
        """Return that of each body, as if it were somewhere."""
        speed, spin = self.sim.velocity[self.bodies], self.sim.angular_velocity[self.bodies]
        round_origin = place[:, 0] * speed[:, 1] - place[:, 1] * speed[:, 0]
        terms: Array = np.concatenate((self.mass * round_origin, self.inertia * spin))
        return terms


@settings(max_examples=25)
@given(chances(200))
def test_free_bodies_keep_their_momentum_and_never_gain_energy(chance: Chance) -> None:
    """What overlaps at the start is moved apart, and gets no energy from it."""
    crowd = Crowd(chance, pull=0.0)
    momentum, most = crowd.momentum, crowd.energy
    size, rounding = crowd.momentum_size, 0.0
    for _ in range(40):
        place = crowd.place
        crowd.step()
        # pushing apart has been a motion as well, though none of it is left
        apart = np.abs(crowd.place - place).sum(axis=1) / crowd.sim.time_step
        size = max(size, crowd.momentum_size) + float(crowd.mass @ apart)
        assert crowd.momentum == pytest.approx(momentum, abs=ROUNDING * size)
        now = crowd.energy
        rounding += ROUNDING * float(np.sqrt(crowd.mass @ apart**2))  # of velocities: a root of J
        assert np.sqrt(now) <= np.sqrt(most) * (1 + 5 * ROUNDING) + rounding
        most = min(now, most)


@settings(max_examples=15)
@given(chances(100, speed=0.3))
def test_slow_bodies_keep_their_angular_momentum_as_seen_where_they_meet(
    chance: Chance,
) -> None:
    """Arms are those of the start of a step, or of the instant at which bodies will meet.

    With the places of the start, angular momentum differs by no more than the momentum that bodies
    give each other across their way until they meet, of first order in the time step.
    """
    crowd = Crowd(chance, pull=0.0, thin=False)
    for _ in range(20):
        place, turn = crowd.place, crowd.sim.orientation[crowd.bodies].copy()
        before = crowd.angular_momentum(place)
        crowd.step()
        way = np.abs(crowd.place - place).sum(axis=1)
        way += np.abs(crowd.sim.orientation[crowd.bodies] - turn) * chance.scale
        if way.max() > 0.05 * chance.scale:
            continue
        after = crowd.angular_momentum(place)
        apart = np.abs(crowd.place - place).sum(axis=1) / crowd.sim.time_step
        # overlaps of 1e-3 sizes push, and relaxing takes that back: both are rounded
        apart += 1e-3 * chance.scale / crowd.sim.time_step
        size = max(np.abs(before).sum(), np.abs(after).sum()) + crowd.mass @ apart * crowd.width
        across = (crowd.mass * apart) @ way
        assert after.sum() == pytest.approx(before.sum(), abs=float(ROUNDING * size + across))


FALLING = (
    # too many impacts for a step: what waits has not fallen
    (Chance(0, 115, True, 0.0, 0.0, 1e-3, 0.0), 5.0),
    (Chance(51, 51, True, 0.0, 0.0, 1e-3, 0.0), 21.0),
    (Chance(0, 135, True, 0.0, 0.0, 1e-3, 0.0), 13.0),
    # what has contacts falls far and meets a wall
    (Chance(1382708027, 8, True, 1.0, 0.0, 1e3, 4.545682851856529), 27.0),
    (Chance(20, 2, True, 1.0, 0.0, 1e3, 0.0), 29.665610309736746),
    (Chance(4871717, 4, True, 1.0, 0.0, 1e-3, 0.0), 5.847563660623238),
    (Chance(1016746406, 114, False, 0.5, 0.0, 1.0, 9.274865957485265), 28.0),
    (Chance(2358350915, 135, True, 0.01743619166601207, 0.0, 1e-3, 10.0), 26.0),
    # what slides is pushed out of the ground by far less than it falls in a step
    (Chance(316512, 2, False, 0.0, 0.0, 1e-3, 6.3515625), 26.5),
)


def falling(test: Any) -> Any:
    """Let a test look at all of `FALLING`, too."""
    for chance, pull in FALLING:
        test = example(chance, pull)(test)
    return test


@falling
@settings(max_examples=25)
@given(chances(150), st.floats(0.1, 30.0))
def test_what_falls_gains_no_more_than_gravity_gives(chance: Chance, pull: float) -> None:
    """In a step, kinetic energy rises by no more than the work on those that went down.

    Total energy may rise by what it costs to lift bodies out of each other, and not otherwise.
    """
    crowd = Crowd(chance, pull=pull)
    crowd.wall_in()
    weight = crowd.mass * pull * chance.scale
    for _ in range(40):
        place, before = crowd.place, crowd.energy
        crowd.step()
        if crowd.sim.warnings:
            return  # it is told that steps do not hold what lies this deep in each other
        fallen = np.maximum(place[:, 1] - crowd.place[:, 1], 0.0)
        given_by = before + float(weight @ fallen)
        gained = pull * chance.scale * crowd.sim.time_step
        if np.abs(crowd.place - place).max() > gained * crowd.sim.time_step:
            # what meets goes along straight lines, which differ from parabolas in second order;
            # only what is faster than gravity makes it in a step meets on its way
            given_by += float(crowd.mass.sum()) * gained**2
        # a place is known to 1e-16 of its distance from the origin
        known = float(weight.sum()) * crowd.width * 1e-15
        assert crowd.energy <= given_by * (1 + 10 * ROUNDING) + known


@settings(max_examples=15)
@given(chances(150), st.floats(-5.0, 5.0), st.floats(-5.0, 5.0), st.floats(-20.0, 20.0))
def test_walls_that_move_break_nothing(
    chance: Chance, speed_x: float, speed_y: float, spin: float
) -> None:
    crowd = Crowd(chance, pull=10.0)
    crowd.wall_in()
    crowd.sim.add_kinematic(
        t2.Box(width=crowd.width, height=0.3 * chance.scale),
        position=(0.0, 0.0),
        velocity=(speed_x * chance.scale, speed_y * chance.scale),
        angular_velocity=spin,
        **crowd.surface,
    )
    for _ in range(40):
        crowd.step()
