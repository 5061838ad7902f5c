"""Questions about places: what a ray meets first, what lies at a point or in a box.

Serves: `ray_cast`, `at_point` and `in_box`. Hides: the tree that is asked, and when it is made.
"""

from dataclasses import dataclass
from functools import cache
from types import SimpleNamespace

import numpy as np
from numpy.typing import NDArray

from tamias2d.engine.engine import Engine
from tamias2d.engine.menu import QUERY
from tamias2d.kernels.groups import addresses
from tamias2d.scene.filters import checked_mask
from tamias2d.scene.rules import RuleError
from tamias2d.simulator.columns import as_array, vectors
from tamias2d.state import Array

Whole = NDArray[np.int64]
_POINT = "Give (x, y) in m."


@dataclass(frozen=True, kw_only=True)
class Hits:
    """What k rays met first."""

    body: Whole
    """(k,), index, or -1 where a ray met nothing"""
    point: Array
    """(k, 2), where it was met, m; the end of the ray where that met nothing"""
    normal: Array
    """(k, 2), unit, out of the body; (0, 0) where the ray met nothing"""
    fraction: Array
    """(k,), of the ray up to there; 1 where it met nothing"""

    def __len__(self) -> int:
        return len(self.body)


class Questions:
    """A engine that is asked, with a tree for the places at which its bodies were last found."""

    def __init__(self, engine: Engine) -> None:
        self._engine = engine
        self._revision = -1
        self._pose = np.zeros((0, 3))

    def rays(self, start: object, end: object, mask: object) -> Hits:
        """Return what rays from points to points, (2,) or (k, 2) each, meet first."""
        engine, of = self._engine, "the rays"
        count = max(_rows(start, "start", of), _rows(end, "end", of))
        rays = np.hstack(
            [
                vectors(points, key, of, _POINT, count=count, symbol="position")
                for key, points in (("start", start), ("end", end))
            ]
        )
        still = np.flatnonzero((rays[:, :2] == rays[:, 2:]).all(axis=1))
        if len(still):
            raise RuleError(
                f"end[{still[0]}] of the rays: found the start: must be another point (R4). Give "
                "rays with a length, or ask at_point.",
                "end",
            )
        self._look()
        met, hits = np.empty(count, dtype=np.int64), np.empty((count, 3))
        _library().cast_rays(
            self._argument, rays, checked_mask(mask, of), met, hits,
            np.empty(len(engine.world.state.body_of_shape), dtype=np.uint32),
        )  # fmt: skip
        fraction = np.minimum(hits[:, 0], 1.0)
        return Hits(
            body=np.where(met >= 0, engine.world.state.body_of_shape[met].astype(np.int64), -1)
            if len(engine.world.state.body_of_shape)
            else met,
            point=rays[:, :2] + fraction[:, None] * (rays[:, 2:] - rays[:, :2]),
            normal=hits[:, 1:].copy(),
            fraction=fraction,
        )

    def within(self, low: Array, high: Array, mask: object) -> Whole:
        """Return the bodies (k,) that reach into a box between two corners (2,), by rank."""
        engine = self._engine
        self._look()
        found = np.empty(len(engine.world.state.body_of_shape), dtype=np.uint32)
        total = _library().shapes_in_box(
            self._argument, *low.tolist(), *high.tolist(), checked_mask(mask, "the question"), found
        )
        shapes = found[:total][np.argsort(engine.world.broad_phase.canonical[1, found[:total]])]
        return np.array(
            list(dict.fromkeys(engine.world.state.body_of_shape[shapes].tolist())), dtype=np.int64
        )

    def _look(self) -> None:
        """Make the tree anew if a body was moved, added or removed."""
        engine = self._engine
        world = engine.world
        if self._revision == engine.revision and np.array_equal(self._pose, world.state.pose):
            return
        if not np.isfinite(engine.world.state.pose).all():
            row = int(np.argmin(np.isfinite(engine.world.state.pose).all(axis=1)))
            raise RuleError(
                f"position or orientation[{row}]: must be finite to be asked for (R4). Set it to "
                "a number."
            )
        self._revision, self._pose = engine.revision, world.state.pose.copy()
        tree = world.tree._replace(
            **{name: np.zeros_like(values) for name, values in world.tree._asdict().items()}
        )
        self._world = world._replace(tree=tree)  # keeps the arrays whose addresses are known
        self._argument = addresses(self._world)
        _library().build_query_tree(self._argument)


def _rows(points: object, key: str, of: str) -> int:
    given = as_array(points, key, of, _POINT)
    return len(given) if given.ndim == 2 else 1


def box_corners(low: object, high: object) -> tuple[Array, Array]:
    """Return the corners of a box, or raise `RuleError`."""
    of = "the box"
    least, most = (
        vectors(corner, key, of, _POINT, count=1, symbol="position")[0]
        for key, corner in (("low", low), ("high", high))
    )
    if (least > most).any():
        raise RuleError(
            f"low {least.tolist()} of the box: is beyond high {most.tolist()} (R4). Give the "
            "lower left and the upper right corner.",
            "low",
        )
    return least, most


def one_point(point: object) -> Array:
    """Return a point (2,), or raise `RuleError`."""
    place: Array = vectors(point, "point", "the question", _POINT, count=1, symbol="position")[0]
    return place


@cache
def _library() -> SimpleNamespace:
    return QUERY.compiled()
