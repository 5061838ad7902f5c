"""The path of a body between two times, and the protocol of motions that make such paths."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import NamedTuple, Protocol

from tamias2d.state import Acceleration, Array, Constraint, State, Vector


class Bounds(NamedTuple):
    """What holds at every time of a window."""

    acceleration: Vector
    """The acceleration in the middle of the window's range, m/s^2."""
    deviation: float
    """How far any acceleration of the window is from it at most, m/s^2."""
    speed: float
    """At most, m/s."""
    angular_speed: float
    """At most, rad/s."""
    angular_acceleration: float
    """Its size at most, rad/s^2."""


class PathPiece(Protocol):
    """The path of one body between two times, with continuous velocity."""

    start: float
    end: float

    def at(self, time: float) -> State:
        """Return the state at a time of the piece, s; at `start` to the bit as it was given."""

    def acceleration(self, time: float) -> Acceleration:
        """Return the acceleration at a time of the piece, s."""

    def bounds(self, first: float, last: float) -> Bounds:
        """Return what holds from the time `first` to the time `last`, s."""

    def sample(self, times: Array) -> Array:
        """Return (k, 6): position, orientation, velocity, angular velocity at times (k,), s."""


class Paths(Protocol):
    """Whoever makes paths for the bodies of one scene, up to the end of one run."""

    def segment(
        self, start: float, states: Sequence[State], constraints: Sequence[Constraint | None]
    ) -> tuple[float, Sequence[PathPiece]]:
        """Return a time and the path of every body from `start` (s) to that time."""

    def restart(
        self,
        bodies: Iterable[int],
        start: float,
        state: Callable[[int], State],
        end: float,
        constraints: Sequence[Constraint | None],
    ) -> Mapping[int, PathPiece]:
        """Return the paths from `start` towards `end`, s, of some bodies and of all they act on.

        A path may end before, where a constraint depends on the state.
        """

    def approach(
        self,
        bodies: Iterable[int],
        time: float,
        path: Callable[[int], PathPiece],
        constraints: Sequence[Constraint | None],
    ) -> Mapping[int, PathPiece]:
        """Return better paths of some bodies, and of all they act on, for a meeting at `time`, s.

        They begin and end where their paths of now do; nothing is returned for good ones.
        """

    def struck(
        self,
        time: float,
        impulses: Mapping[int, Acceleration],
        state: Callable[[int], State],
    ) -> Mapping[int, Acceleration]:
        """Return what impulses on jointed bodies change at a time, s, and all that joints move.

        Impulses are in N s and N m s, changes of velocities in m/s and rad/s.
        """

    def moved(
        self,
        time: float,
        bodies: Sequence[int],
        impulses: Array,
        state: Callable[[int], State],
        *,
        in_turns: bool = False,
    ) -> Array:
        """Return the changes (m, n, 3) of velocities by impulses (m, n, 3), joints being linear.

        `bodies` are whole mechanisms, and others; impulses are in N s and N m s. Limits that hold
        are refused, but where contacts and limits answer `in_turns`.
        """

    def pushed(
        self,
        time: float,
        bodies: Sequence[int],
        forces: Array,
        state: Callable[[int], State],
    ) -> Array:
        """Return the accelerations (m, n, 3) by forces (m, n, 3), N and N m, with joints' answer.

        Limits that hold, and motors that keep their speed, answer whatever the sign of a force.
        `bodies` are whole mechanisms, and others.
        """

    def joint_changes(self, bodies: Sequence[int], time: float) -> Sequence[object]:
        """Return what is other as soon as joints of some bodies do something else at a time, s."""

    def free(self, body: int, time: float, state: Callable[[int], State]) -> Acceleration:
        """Return the acceleration of an unconstrained body, at a time in s."""
