"""The protocol of compiled code that goes on from impact to impact where it can (`Located`)."""

from collections.abc import Iterable, Mapping, Sequence
from typing import NamedTuple, Protocol

from tamias2d.contact.rest_time import Estimate
from tamias2d.path import PathPiece
from tamias2d.state import Array

Tracks = Sequence[list[PathPiece]]
"""The paths of each body so far, in order."""


class Memory(NamedTuple):
    """What is known of some bodies besides their paths."""

    supports: Mapping[int, int]
    """On which one body others rest."""
    bounces: dict[tuple[int, int], Estimate]
    """When the bounces of pairs end."""
    stalled: Mapping[int, int]
    """New paths of a body, in a row, that did not advance in time; 0 where it is not said."""


class Follower(Protocol):
    """All bodies of a scene on their paths, followed from impact to impact."""

    @property
    def now(self) -> float:
        """The time that is reached, s."""

    def pays(self, time: float, until: float) -> bool:
        """Return whether to follow from a time on, s, is faster than not to."""

    def take(self, time: float, until: float, tracks: Tracks, *, begun: bool) -> None:
        """Take all bodies over at a time, s, on the last paths of their tracks.

        Only where a run has `begun` may bodies touch at its start.
        """

    def go(self, limit: float) -> tuple[int, ...] | None:
        """Go on to a time, s, or until something is not decided.

        Return the pair about which it is, nothing where that cannot be said, or None at the limit.
        """

    def impacts(self) -> Array:
        """Return the impacts (m, 9) since this was last asked, as `Located.impacts` has them."""

    def path(self, body: int) -> PathPiece:
        """Return the path of a body now."""

    def set_path(self, body: int, path: PathPiece) -> None:
        """Put a body on another path from now on."""

    def near(self, body: int) -> list[int]:
        """Return all bodies, in order, that may touch a body now."""

    def recall(self) -> Memory:
        """Return what is known of all bodies."""

    def remember(self, bodies: Iterable[int], memory: Memory) -> None:
        """Replace what is known of some bodies."""

    def give_back(self) -> None:
        """Add the paths that all bodies have now to their tracks."""
