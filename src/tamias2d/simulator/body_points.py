"""Points of bodies: where they are in the world and in a body's own axes, and how they move."""

import numpy as np

from tamias2d.engine.engine import Engine
from tamias2d.generated import definitions
from tamias2d.scene.springs import arm
from tamias2d.simulator.columns import as_array, vectors
from tamias2d.state import Array, IntArray

_OF = "the bodies"


class BodyPoints:
    """Points (m, 2), m, each of one of m bodies: given for each, or one for all."""

    def __init__(self, engine: Engine, rows: IntArray, points: object, *, one: bool) -> None:
        """Take points of bodies in rows (k,), of each its own; any number of them if k is 1.

        If one body and `one` point are asked for, one vector is returned.

        Raises:
            InputError: they are no points, or not so many.
        """
        remedy = "Give (x, y) in m, or a row for each body."
        given = as_array(points, "points", _OF, remedy)
        count = len(given) if given.ndim == 2 and len(rows) == 1 else len(rows)
        self._points = vectors(points, "points", _OF, remedy, count=count, symbol="position")
        self._rows = np.broadcast_to(rows, count) if len(rows) == 1 else rows
        self._one = one and given.ndim == 1
        self._engine = engine

    def in_world(self) -> Array:
        """Return where points in the bodies' own axes are in the world, m."""
        pose = self._engine.pose[self._rows]
        return self._told(pose[:, :2] + _turned(self._points, pose[:, 2]))

    def in_body(self) -> Array:
        """Return where points of the world are in the bodies' own axes, m."""
        pose = self._engine.pose[self._rows]
        return self._told(_turned(self._points - pose[:, :2], -pose[:, 2]))

    def velocity(self) -> Array:
        """Return how bodies move at points of the world, m/s (DD9)."""
        x, y = (self._points - self._engine.pose[self._rows, :2]).T
        u, v, spin = self._engine.velocity[self._rows].T
        return self._told(np.column_stack(definitions.point_velocity((u, v), spin, (x, y))))

    def _told(self, vectors: Array) -> Array:
        found: Array = vectors[0] if self._one else vectors
        return found


def _turned(points: Array, angles: Array) -> Array:
    return np.column_stack(arm((points[:, 0], points[:, 1]), angles))
