"""The protocol of code that takes many steps of some bodies at once."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple, Protocol

from tamias2d.generated import schemes
from tamias2d.state import Array


def name_of(scheme: object) -> str:
    """Return the name of a generated scheme; none of any other function."""
    name = getattr(scheme, "__name__", "")
    return name if getattr(schemes, name, None) is scheme else ""


class Start(NamedTuple):
    """Coordinates, rates and accelerations (n, 3) of n bodies."""

    position: Array
    velocity: Array
    acceleration: Array | None
    """None where they are not known."""


@dataclass(frozen=True)
class Steps:
    """Steps of n bodies that were taken, and what they cost."""

    times: list[float]
    """(k + 1,), s; fewer than asked for where a force has no value further on."""
    knots: Array
    """(k + 1, 3, n, 3): coordinates, rates and accelerations at these times."""
    last_known: bool
    """Whether the last of the accelerations are known."""
    dense: Array
    """(m, k, n, 3): of an embedded pair, the slopes of the velocity within each step."""
    evaluations: int
    rejected: int
    reached: Array | None = None
    """(k, 3, n, 3): where each step led, before joints moved its end; None where none did."""


@dataclass
class Control:
    """What an embedded pair is allowed, and what one step leaves to the next."""

    step: float
    """The length that the next step should have, s."""
    error: float
    """Of the last step, in shares of what is allowed."""
    relative: float
    length: float
    rate: float
    power: float
    damping: float


class Kick(NamedTuple):
    """What loads alone gave to n bodies at a time in s: coordinates, rates, accelerations."""

    time: float
    position: Array
    velocity: Array
    acceleration: Array


class Rule(NamedTuple):
    """A quadrature with m nodes of a step, and from its nodes to any of them."""

    nodes: Array
    """(m,), from 0 to 1"""
    early: Array
    """(2, m, m): from the nodes before a node, of the integral up to it, and of that once more"""
    whole: Array
    """The same from all nodes"""


class Error(NamedTuple):
    """How far exact motion is ahead of a path."""

    state: Array
    """(3, n, 3): in coordinates and rates, and the accelerations of the exact motion"""
    largest: Array
    """(n, 3): in coordinates so far"""


class Marching(Protocol):
    """The steps of some bodies that no contact holds, with the bits of the general code.

    None are returned for what it does not know.
    """

    def accelerations(self, time: float, position: Array, velocity: Array) -> Array | None:
        """Return the accelerations (n, 3) at a time in s; None where one is not finite."""

    def fixed(
        self, scheme: str, times: Sequence[float], start: Start, ahead: float
    ) -> Steps | None:
        """Step by a generated scheme from each of the times, s, to the next, or to some of them.

        About as many steps as are `ahead` will be asked for in the end.
        """

    def adaptive(
        self, scheme: str, time: float, limit: float, most: int, start: Start, control: Control
    ) -> Steps | None:
        """Take at most some steps of a generated pair from a time towards a limit, s.

        None are taken where the first has to be looked at: forces have no value on its way, or it
        gets very short. Otherwise the control is set for the step that follows.
        """

    def along(self, scheme: str, times: Sequence[float], start: Start) -> Steps | None:
        """Step by a generated pair from each of the times, s, to the next, whatever it errs.

        Fewer steps are taken, or none, where forces have no value further on.
        """

    def follow(
        self, times: Sequence[float], paths: Array, rule: Rule, sweeps: int, error: Error
    ) -> bool | None:
        """Integrate the error of steps along their paths (k, 3, m, n, 3), and change it.

        Return whether forces have values beside them all.
        """


class HeldMarching(Protocol):
    """The steps of some bodies that joints hold, likewise: they end where these do.

    None are returned, or fewer, where it is open what joints exert.
    """

    def fixed(
        self, scheme: str, times: Sequence[float], start: Start, ahead: float
    ) -> Steps | None:
        """Step by a generated scheme of slopes, as free bodies do."""

    def kicked(
        self, scheme: str, times: Sequence[float], start: Start, kick: Kick | None, ahead: float
    ) -> tuple[Steps, Kick | None] | None:
        """Step by a splitting scheme, likewise; the last kick before comes, and the last goes."""

    def adaptive(
        self, scheme: str, time: float, limit: float, most: int, start: Start, control: Control
    ) -> Steps | None:
        """Step by a generated pair, as free bodies do."""

    def follow(
        self,
        times: Sequence[float],
        paths: Array,
        ends: Array,
        rule: Rule,
        sweeps: int,
        error: Error,
    ) -> bool:
        """Integrate the error of steps along their paths (k, 3, m, n, 3), and change it.

        Exact motion returns to joints beside the end (k, 2, n, 3) of each. Nothing is changed where
        that is not known for all, which is returned.
        """
