"""Random sequences of calls of a simulator, with odd values among sound ones."""

import pickle
import random
import warnings
from typing import Any

import numpy as np

import tamias2d as t2

ODD = (0.0, -1.0, 1e-320, 1e-150, 1e-30, 1e15, 1e30, 1e80, 1e154, 1e200, 1e300, np.nan, np.inf)
_BOX = t2.Box(width=0.8, height=0.5)
_PARTS = [t2.Part(shape=_BOX), t2.Part(shape=t2.Disc(radius=0.3), position=(0.6, 0.1))]
BODIES = (
    t2.Disc(radius=0.4),
    _BOX,
    t2.Polygon(vertices=[(0, 0), (0.9, 0.1), (0.7, 0.8), (0.2, 0.9)]),
    t2.Capsule(length=0.8, radius=0.2),
    t2.Compound(parts=_PARTS),
    t2.Segment(length=0.7),
    t2.Disc(radius=0.01),
    t2.Box(width=5.0, height=0.01),
)
VIEWS = ("position", "orientation", "velocity", "angular_velocity", "force", "torque", "gravity")


class Fuzz:
    """A simulator, and what is done to it at random."""

    def __init__(self, seed: int) -> None:
        self.chance = random.Random(seed)
        scene = t2.Scene(gravity=(0.0, self.chance.choice((0.0, -9.81, 1e3))))
        if self.chance.random() < 0.8:
            floor = t2.HalfPlane(normal=(0.0, 1.0), offset=-2.0)
            scene.add_static(floor, friction=0.5, restitution=0.2)
        self.odd = self.chance.choice((0.0, 0.02, 0.2))  # share of odd values
        self.sim = t2.Simulator(
            scene,
            time_step=self.chance.choice((1 / 60, 1 / 60, 1e-3, 0.5, 1e-70, 1e60)),
            substeps=self.chance.choice((1, 4, 4, 9)),
            sleeping=self.chance.random() < 0.3,
        )

    def number(self, low: float = -3.0, high: float = 3.0) -> float:
        """Return a number of a range, or an odd one."""
        if self.chance.random() < self.odd:
            return self.chance.choice((1.0, -1.0)) * self.chance.choice(ODD)
        return self.chance.uniform(low, high)

    def pair(self) -> tuple[float, float]:
        """Return two numbers."""
        return self.number(), self.number()

    def some(self) -> list[int]:
        """Return up to three bodies that are there."""
        there = np.flatnonzero(self.sim.present).tolist()
        return self.chance.sample(there, min(len(there), self.chance.randint(0, 3)))

    def add(self) -> None:
        """Add bodies."""
        count = self.chance.randint(1, 5)
        self.sim.add(
            [self.chance.choice((*BODIES, None)) for _ in range(count)],
            mass=abs(self.number(0.1, 9.0)),
            position=[self.pair() for _ in range(count)],
            velocity=self.pair(),
            orientation=self.number(),
            linear_drag=abs(self.number(0.0, 0.5)) if self.chance.random() < 0.3 else 0.0,
            restitution=self.chance.choice((0.0, 0.5, 1.0)),
            friction=abs(self.number(0.0, 1.0)),
            sensor=self.chance.random() < 0.1,
        )

    def add_wall(self) -> None:
        """Add a body that stands, or is driven."""
        wall: dict[str, Any] = {"position": self.pair(), "friction": 0.3, "restitution": 0.1}
        shape = self.chance.choice(BODIES)
        if self.chance.random() < 0.5:
            self.sim.add_static(shape, orientation=self.number(), **wall)
        else:
            self.sim.add_kinematic(shape, velocity=self.pair(), **wall)

    def write(self) -> None:
        """Write a number into a view."""
        view = getattr(self.sim, self.chance.choice(VIEWS))
        if view.size:
            view.flat[self.chance.randrange(view.size)] = self.number()

    def mend(self) -> None:
        """Set all that can be set to something sound."""
        sim = self.sim
        for view in (sim.velocity, sim.angular_velocity, sim.force, sim.torque, sim.orientation):
            view[...] = 0.0
        sim.position = np.nan_to_num(np.clip(sim.position, -9.0, 9.0))
        sim.gravity = 0.0, -9.81

    def act(self) -> None:
        """Do something at random."""
        sim, chance = self.sim, self.chance
        match chance.randrange(12):
            case 0 | 1 | 2:
                sim.step(chance.choice((1, 1, 3, 20)))
            case 3:
                self.add()
            case 4:
                self.add_wall()
            case 5:
                sim.remove(self.some())
            case 6:
                self.write()
            case 7:
                sim.apply_impulse(self.some(), self.pair(), at=self.pair())
            case 8:
                sim.apply_force(self.some(), self.pair())
            case 9:
                sim.ray_cast(self.pair(), self.pair())
                sim.in_box((-1.0, -1.0), (self.number(0, 2), self.number(0, 2)))
            case 10:
                saved = pickle.dumps(sim)
                try:
                    self.sim = pickle.loads(saved)
                except t2.RecordingError as error:
                    raise AssertionError from error
            case _:
                sim.wake(self.some())


def case(seed: int) -> str:
    """Run a sequence; return what came of it."""
    return "refused" if sequence(seed) else "done"


def sequence(seed: int, calls: int = 25) -> int:
    """Run a sequence; return how many calls were refused by name. All else is an error."""
    return refused_of(Fuzz(seed), calls)


def refused_of(fuzz: Fuzz, calls: int = 25) -> int:
    """Let something be done at random, so many times; return how many calls were refused."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", t2.StepWarning)
        return _refused(fuzz, calls)


def _refused(fuzz: Fuzz, calls: int) -> int:
    refused = 0
    for _ in range(calls):
        try:
            fuzz.act()
        except t2.TamiasError:
            refused += 1
            if fuzz.chance.random() < 0.5:
                fuzz.mend()
    fuzz.mend()
    try:
        fuzz.sim.step(3)
    except t2.TamiasError:  # of a time step of 1e60 s
        refused += 1
    for values in (fuzz.sim.position, fuzz.sim.velocity, fuzz.sim.orientation):
        assert np.isfinite(values).all()
    assert np.isfinite(fuzz.sim.contacts.impulse).all()
    return refused
