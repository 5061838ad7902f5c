"""Positions and velocities of bodies: at one instant, between two, and over a run."""

from collections.abc import Sequence
from typing import NamedTuple, Protocol, TypeAlias, runtime_checkable

import numpy as np
from numpy.typing import NDArray

from tamias2d.scene.rules import Vector as Vector

Array: TypeAlias = NDArray[np.float64]
IntArray: TypeAlias = NDArray[np.int64]
Acceleration: TypeAlias = tuple[float, float, float]
"""Both components in m/s^2, and the angular one in rad/s^2."""


class State(NamedTuple):
    """The state of one body: of its centre of mass, and of its rotation."""

    position: Vector
    """m"""
    orientation: float
    """rad, counter-clockwise, unbounded"""
    velocity: Vector
    """m/s"""
    angular_velocity: float
    """rad/s"""


class Constraint(Protocol):
    """The acceleration of a body on lasting contacts, as a function of that by the loads."""

    @property
    def state_dependent(self) -> bool:
        """Whether it depends on the state, so that constant loads give no constant acceleration."""

    def __call__(self, acceleration: Acceleration, state: State) -> Acceleration:
        """Return the constrained acceleration for one by the loads alone, in a state."""


@runtime_checkable
class SharedConstraint(Protocol):
    """The accelerations of several bodies on lasting contacts that couple them."""

    bodies: tuple[int, ...]

    def together(self, time: float, accelerations: Array, states: Sequence[State]) -> Array:
        """Return the constrained accelerations (n, 3) for those without contacts, in states."""


@runtime_checkable
class ExertingConstraint(Protocol):
    """A constraint on several bodies, some of which joints hold, that tells its forces."""

    bodies: tuple[int, ...]

    def exerted(self, time: float, accelerations: Array, states: Sequence[State]) -> Array:
        """Return the forces and torques (n, 3), N and N m, for accelerations without contacts."""


class History(NamedTuple):
    """The states of n bodies at k times."""

    position: Array
    """(k, n, 2), m"""
    orientation: Array
    """(k, n), rad"""
    velocity: Array
    """(k, n, 2), m/s"""
    angular_velocity: Array
    """(k, n), rad/s"""


def place_between(
    place: Array,
    next_place: Array,
    rate: Array,
    next_rate: Array,
    time_step: float | Array,
    share: Array,
) -> Array:
    """Return where coordinates are at a share of the time, s, between two states of a step.

    They bend as far as both rates agree with the way: without an impact the path of a constant
    acceleration is exact; where the rate jumped near an end of the step it is a straight line,
    because a parabola would lead through what was met.
    """
    way, change = next_place - place, next_rate - rate
    jumped = np.abs(way - time_step * (rate + next_rate) / 2)
    most = time_step * np.abs(change) / 2
    bent = 1.0 - np.divide(jumped, most, out=np.ones_like(most), where=most > jumped)
    bow: Array = bent * time_step * change * share * (1.0 - share) / 2
    return place + share * way - bow
