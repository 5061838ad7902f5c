"""Random pairs of bodies that fly towards each other, for laws that hold whatever the pair."""

import math
from collections.abc import Sequence
from dataclasses import dataclass

from hypothesis import strategies as st

import tamias2d as t2
from tamias2d.contact.core import Core
from tamias2d.contact.mobility import Mobility
from tamias2d.state import Array

Shape = t2.Disc | t2.Box | t2.Polygon
sizes = st.floats(0.1, 2)
angles = st.floats(0, 2 * math.pi)


@dataclass(frozen=True, kw_only=True)
class Thrown:
    """A body: its mass in kg, and how it stands and turns, rad and rad/s."""

    shape: Shape
    mass: float
    orientation: float
    angular_velocity: float


@dataclass(frozen=True, kw_only=True)
class Meeting:
    """The second body comes to the first, from an angle, rad, at a speed, m/s, and aside, m."""

    first: Thrown
    second: Thrown
    aside: float
    speed: float
    towards: float

    @property
    def reach(self) -> float:
        """From within so many metres they may touch."""
        return self.first.shape.bounding_radius + self.second.shape.bounding_radius

    def scene(self, **surface: float) -> t2.Scene:
        """Both bodies, one and a half times their reach apart."""
        c, s = math.cos(self.towards), math.sin(self.towards)
        away = 1.5 * self.reach
        places = ((0, 0), (away * c - self.aside * s, away * s + self.aside * c))
        velocities = ((0, 0), (-self.speed * c, -self.speed * s))
        scene = t2.Scene(gravity=(0, 0))
        for thrown, place, velocity in zip(
            (self.first, self.second), places, velocities, strict=True
        ):
            scene.add_body(**vars(thrown), position=place, velocity=velocity, **surface)
        return scene


def thrown(
    shapes: st.SearchStrategy[Shape], masses: st.SearchStrategy[float]
) -> st.SearchStrategy[Thrown]:
    """Bodies of such shapes and masses."""
    return st.builds(
        Thrown, shape=shapes, mass=masses, orientation=angles, angular_velocity=st.floats(-5, 5)
    )


def meetings(
    first: st.SearchStrategy[Thrown],
    second: st.SearchStrategy[Thrown],
    *,
    aside: float,
    speeds: st.SearchStrategy[float],
) -> st.SearchStrategy[Meeting]:
    """Meetings of such bodies, at most so many metres aside."""
    return st.builds(
        Meeting,
        first=first,
        second=second,
        aside=st.floats(-aside, aside),
        speed=speeds,
        towards=angles,
    )


def without_joints(cores: Sequence[Core]) -> Mobility:
    """Return what impulses do to bodies that no joint holds."""

    def none(*_: object) -> Array:
        raise AssertionError("no joint holds anything")

    return Mobility(cores, none, 0.0, {}.__getitem__)
