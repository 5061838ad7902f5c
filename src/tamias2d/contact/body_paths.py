"""Where bodies are: on paths in tracks of their own, or on those that a follower has."""

from collections.abc import Collection, Sequence

from tamias2d.contact.core import Core
from tamias2d.contact.follower import Follower
from tamias2d.contact.swept_aabb import SweptAabbs
from tamias2d.path import PathPiece
from tamias2d.state import State


class BodyPaths:
    """The paths of all bodies so far, and what is near them now."""

    def __init__(self, cores: Sequence[Core], kept_apart: Collection[tuple[int, int]]) -> None:
        """Take the bodies, and the pairs (i, j), i < j, that do not touch whatever they do."""
        self.tracks: list[list[PathPiece]] = [[] for _ in cores]
        """The paths of each body, in order; all but the last ones while a follower has them."""
        self.follower: Follower | None = None
        """Who has all bodies now."""
        self._aabbs = SweptAabbs(cores, kept_apart)

    def path(self, body: int) -> PathPiece:
        """Return the path of a body now."""
        return self.follower.path(body) if self.follower else self.tracks[body][-1]

    def state(self, body: int, time: float) -> State:
        """Return the state of a body at a time on its path, s."""
        return self.path(body).at(time)

    def set_path(self, body: int, path: PathPiece) -> None:
        """Put a body on another path from now on."""
        if self.follower:
            self.follower.set_path(body, path)
        else:
            self.tracks[body].append(path)
            self._aabbs.update(body, path)

    def near(self, body: int) -> list[int]:
        """Return the bodies, in order, that may touch a body now."""
        return self.follower.near(body) if self.follower else self._aabbs.overlapping(body)

    def take_back(self) -> None:
        """Take all bodies back from a follower."""
        assert self.follower is not None
        self.follower.give_back()
        self.follower = None

    def update_boxes(self) -> None:
        """Set the bounding boxes of all bodies, which a follower does not keep."""
        for body, track in enumerate(self.tracks):
            self._aabbs.update(body, track[-1])
