"""The error of paths with located impacts: integrated along them, and carried through these (R5).

Between impacts it solves the equation of the error (`motion.error_equation`); at each the motion
that is ahead by it meets in its own time (`contact.saltation`).
"""

from bisect import bisect_right
from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from tamias2d.contact import Located, Passing, SingleImpact, after_impact
from tamias2d.errors import SimulationError
from tamias2d.motion.error_equation import follow_step
from tamias2d.motion.integrated import IntegratedMotion
from tamias2d.motion.marching import Error
from tamias2d.motion.step_batch import breaks
from tamias2d.path import PathPiece
from tamias2d.state import Array


def error_through_impacts(located: Located, motion: IntegratedMotion, end: float) -> Array | None:
    """Return the largest error (n, 3) of coordinates up to a time, s, in m and rad.

    None where contacts last or bodies meet at several points at once, where the exact motion may
    not meet as the path does, and where a force has no value beside the path.
    """
    if located.single is None or motion.missed:
        return None
    try:
        largest = _Carried(located, motion, end).through(located.single)
    except SimulationError:
        return None
    return largest if largest is not None and np.isfinite(largest).all() else None


class _Carried:
    """The error of all bodies that move, carried along their paths."""

    def __init__(self, located: Located, motion: IntegratedMotion, end: float) -> None:
        self._located = located
        self._tracks = located.tracks
        self._moving = motion.moving
        self._row = {body: row for row, body in enumerate(self._moving)}
        self._starts = [[piece.start for piece in track] for track in self._tracks]
        self._field = motion.beside()
        self._rule, self._sweeps = motion.error_rule
        self._end = end
        still = np.zeros((3, len(self._moving), 3))
        self._error = Error(still, still[0].copy())
        self._met: dict[int, float] = {}
        """When bodies have met last on the exact motion, s."""

    def through(self, impacts: Sequence[SingleImpact]) -> Array | None:
        """Return the largest error of each coordinate."""
        times = [met.time for met in impacts]
        edges = sorted({time for body in self._moving for time in self._breaks(body)} | {*times})
        self._begin(edges[0])
        done = bisect_right(times, edges[0])
        for time, later in pairwise(edges):
            path = self._path(time, later)
            follow_step(
                self._field, self._rule, self._sweeps, time, later - time, path, self._error
            )
            reached = bisect_right(times, later)
            if not all(self._carry(met) for met in impacts[done:reached]):
                return None
            if reached > done:
                self._begin(later)
            done = reached
        return self._rows()

    def _rows(self) -> Array:
        rows = np.zeros((len(self._tracks), 3))
        rows[self._moving] = self._error.largest
        return rows

    def _begin(self, time: float) -> None:
        """Find the accelerations of the exact motion from a time on, s."""
        place, rate = (
            np.array([self._numbers(body, time)[part] for body in self._moving]) for part in (0, 1)
        )
        ahead, ahead_rate = self._error.state[:2]
        self._error.state[2] = self._field(time, place + ahead, rate + ahead_rate)

    def _breaks(self, body: int) -> list[float]:
        """Return the times, s, between which the path of a body is a polynomial."""
        found: list[float] = []
        track = self._tracks[body]
        for k, piece in enumerate(track):
            until = self._starts[body][k + 1] if k + 1 < len(track) else self._end
            found += [time for time in (piece.start, *breaks(piece), until) if time <= until]
        return found

    def _piece(self, body: int, time: float) -> PathPiece:
        """Return the path of a body from a time on, s."""
        return self._tracks[body][bisect_right(self._starts[body], time) - 1]

    def _numbers(self, body: int, time: float) -> tuple[Array, Array]:
        """Return coordinates and rates (3,) of a body from a time on, s."""
        position, turn, velocity, spin = self._piece(body, time).at(time)
        return np.array([*position, turn]), np.array([*velocity, spin])

    def _path(self, time: float, later: float) -> Array:
        """Return coordinates, rates, accelerations (3, m, n, 3) at the nodes between two times."""
        nodes = self._rule.nodes
        times = time + (later - time) * nodes
        times[-1] = later
        found = np.empty((3, len(nodes), len(self._moving), 3))
        for row, body in enumerate(self._moving):
            piece = self._piece(body, time)
            states = piece.sample(times)
            found[0, :, row], found[1, :, row] = states[:, :3], states[:, 3:]
            found[2, :, row] = [piece.acceleration(at) for at in times.tolist()]
        return found

    def _carry(self, met: SingleImpact) -> bool:
        """Carry the error through an impact; return whether that can be said."""
        pair = met.contact.a, met.contact.b
        paths, ahead = {}, {}
        for body in pair:
            k = bisect_right(self._starts[body], met.time) - 1
            after = self._tracks[body][k]
            before = self._tracks[body][k - 1] if after.start == met.time and k else after
            time = met.time
            paths[body] = Passing(
                before.at(time), before.acceleration(time), after.at(time), after.acceleration(time)
            )
            if body in self._row:
                ahead[body] = self._error.state[:2, self._row[body]].copy()
        carried = after_impact(self._located.cores, met, paths, ahead)
        if carried is None:
            return False
        delay, now = carried
        for body, rows in now.items():
            if not met.time + delay > self._met.get(body, 0.0):
                return False  # it meets in another order
            self._met[body] = met.time + delay
            row = self._row[body]
            self._error.state[:2, row] = rows
            self._error.largest[row] = np.maximum(self._error.largest[row], np.abs(rows[0]))
        return True
