"""Queries of an engine: what rays and shapes meet first, and which bodies reach into a box.

The tree that is asked is not that of the step, because users move bodies between steps. Cost:
n log n for a tree after a body was moved, added or removed, then log n for each query.
"""

from collections.abc import Sequence
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from tamias2d.engine import tables as tb
from tamias2d.engine.arrays.store import Store
from tamias2d.engine.menu import QUERY, functions
from tamias2d.engine.query.ray_cast import NO_HIT
from tamias2d.engine.tables import World
from tamias2d.kernels.arrays import Bytes
from tamias2d.kernels.groups import addresses
from tamias2d.state import Array, IntArray

Piece: TypeAlias = tuple[Array, float]
"""All within a radius of a convex core (c, 2), m."""


class QueryTree:
    """A tree over the shapes of a store, for the poses at which its bodies were last found."""

    def __init__(self, store: Store) -> None:
        self._store = store
        self._revision = -1
        self._pose = np.zeros((0, 3))
        self._made_of: World | None = None  # the world whose arrays are asked
        self._argument: Any = None
        self._library: Any = None  # compiled when the first query comes

    def cast_rays(self, rays: Array, mask: int) -> tuple[IntArray, Array]:
        """Return the body (k,) that each ray (k, 4) meets first, -1 for none, and where.

        A ray goes from a point to a point, m. Where it enters a body is told by (k, 3): the
        fraction of the ray, 2 for none, and the outward normal. Bodies that share no bit with the
        mask, sensors, and those in which a ray starts are not met.
        """
        owner = self._store.world.state.body_of_shape
        met, hits = np.empty(len(rays), dtype=np.int64), np.empty((len(rays), 3))
        room = np.empty(len(owner), dtype=np.uint32)
        self._library.cast_rays(self._argument, rays, mask, met, hits, room)
        met[met >= 0] = owner[met[met >= 0]]
        return met, hits

    def cast_pieces(
        self, pieces: Sequence[Piece], ways: Array, mask: int, ignored: Bytes
    ) -> tuple[IntArray, Array]:
        """Return the body (k,) that pieces around a place meet first on its ways (k, 4), and where.

        A way is from a place to a place, m. Where it ends is told by (k, 5): the fraction of the
        way, 2 for none, the outward normal and the point, m. Bodies that are ignored, those that
        share no bit with the mask and sensors are not met.
        """
        world = self._store.world
        best, hits = np.full(len(ways), -1, dtype=np.int64), np.zeros((len(ways), 5))
        hits[:, 0] = NO_HIT
        for core, radius in pieces:
            met, found = np.empty_like(best), np.empty_like(hits)
            room = self._room()
            self._library.cast_core(
                self._argument, ways, core, radius, mask, ignored, room, met, found
            )
            nearer = found[:, 0] < hits[:, 0]
            best[nearer], hits[nearer] = world.state.body_of_shape[met[nearer]], found[nearer]
        return best, hits

    def bodies_in_box(self, low: Array, high: Array, mask: int) -> IntArray:
        """Return the bodies (k,) that reach into a box between two corners (2,), m, by rank."""
        world = self._store.world
        found = np.empty(len(world.state.body_of_shape), dtype=np.uint32)
        total = self._library.shapes_in_box(
            self._argument, *low.tolist(), *high.tolist(), mask, found
        )
        return self._bodies_of(found[:total])

    def bodies_in_shape(self, pieces: Sequence[Piece], mask: int) -> IntArray:
        """Return the bodies (k,) that reach into pieces in the world, by rank."""
        world, found = self._store.world, []
        for core, radius in pieces:
            room = self._room()
            shapes = np.empty(len(world.state.body_of_shape), dtype=np.uint32)
            total = self._library.shapes_in_shape(self._argument, core, radius, mask, room, shapes)
            found.append(shapes[:total])
        return self._bodies_of(np.unique(np.concatenate(found)))

    def _room(self) -> Array:
        """Return room for the corners of any shape."""
        return np.empty((int(self._store.world.shapes.vertex_count.max(initial=1)), 2))

    def _bodies_of(self, shapes: NDArray[np.uint32]) -> IntArray:
        """Return the bodies (k,) of shapes, each once, by rank."""
        world = self._store.world
        ranked = shapes[np.argsort(world.broad_phase.canonical[tb.RANK, shapes])]
        rows = world.state.body_of_shape[ranked].tolist()
        return np.array(list(dict.fromkeys(rows)), dtype=np.int64)

    def holds(self) -> bool:
        """Return whether no body was moved, added or removed since the tree was built."""
        pose = self._store.world.state.pose
        return self._revision == self._store.revision and np.array_equal(self._pose, pose)

    def build(self) -> None:
        """Build the tree for the poses as they are; before it is asked, where it does not hold."""
        store = self._store
        self._revision, self._pose = store.revision, store.world.state.pose.copy()
        if self._made_of is not store.world:
            self._made_of = store.world
            self._take_over(store.world)
        self._library.build_query_tree(self._argument)

    def _take_over(self, world: World) -> None:
        """Ask the arrays of a world, with a tree of one's own."""
        tree = world.tree._replace(
            **{name: np.zeros_like(values) for name, values in world.tree._asdict().items()}
        )
        self._world = world._replace(tree=tree)  # keeps the arrays whose addresses are known
        compiled = self._store.compiled
        self._argument = addresses(self._world) if compiled else self._world
        self._library = functions(QUERY, compiled=compiled)
