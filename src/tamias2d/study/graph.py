"""The distance between the graphs of two histories, over time and all coordinates of the state.

If two runs put a jump at slightly different instants, their graphs are only as far apart as these
are. So the distance tells a run that is late from one that is wrong.
"""

from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from tamias2d.run import Run
from tamias2d.state import Array
from tamias2d.study.scale import radii, scale

VertexIndices: TypeAlias = NDArray[np.int64]

_NEAREST = 4  # vertices whose segments are looked at: the nearest segment ends at one of these
_LONGEST = 0.02  # of a segment: longer ones are divided, so that the nearest vertex is near


def graph_distance(run: Run, exact: Run) -> float:
    """Return the Hausdorff distance of the graphs of all bodies, the worst of them.

    The axes are time by the duration, places by the scale and velocities by the largest speed of
    the exact run. Between samples graphs are straight, which of two runs with the same common times
    is off by the same: what that leaves of it is a floor that falls with the distance itself.
    """
    with np.errstate(all="ignore"):
        ours, true = _graphs(run, exact), _graphs(exact, exact)
    if not (np.isfinite(ours).all() and np.abs(ours).max() < 1e3):
        return float("inf")
    moving = [k for k, body in enumerate(run.scene.bodies) if body.dynamic]
    return max((_hausdorff(ours[:, k], true[:, k]) for k in moving), default=0.0)


def fastest(run: Run) -> float:
    """Return the largest speed of any point of a body, m/s; 1 m/s where nothing moves."""
    speeds = np.linalg.norm(run.velocity, axis=-1)
    speeds = speeds + np.abs(run.angular_velocity) * radii(run.scene)
    return float(speeds.max(initial=0.0)) or 1.0


def _graphs(run: Run, exact: Run) -> Array:
    """Return (k, n, 7): the graph of each body."""
    reach = radii(run.scene)
    time = np.broadcast_to(run.times[:, None, None], (*run.orientation.shape, 1))
    turned = (run.orientation * reach)[..., None]
    turning = (run.angular_velocity * reach)[..., None]
    places = np.concatenate((run.position, turned), axis=-1) / scale(exact)
    rates = np.concatenate((run.velocity, turning), axis=-1) / fastest(exact)
    return np.concatenate((time / exact.duration, places, rates), axis=-1)


def _hausdorff(one: Array, other: Array) -> float:
    one, other = _divided(one), _divided(other)
    return max(_farthest(one, other), _farthest(other, one))


def _divided(graph: Array) -> Array:
    """Return the vertices of a graph, no two neighbours of which are far apart."""
    lengths = np.linalg.norm(np.diff(graph, axis=0), axis=1)
    parts = np.maximum(np.ceil(lengths / _LONGEST).astype(int), 1)
    which = np.repeat(np.arange(len(parts)), parts)
    share = np.concatenate([np.arange(count) / count for count in parts])[:, None]
    points = graph[which] + share * (graph[which + 1] - graph[which])
    return np.concatenate((points, graph[-1:]))


def _farthest(points: Array, graph: Array) -> float:
    """Return how far the farthest of some points is from the nearest segment of a graph."""
    from scipy.spatial import cKDTree

    nearest = cKDTree(graph).query(points, k=min(_NEAREST, len(graph)))[1]
    nearest = nearest.reshape(len(points), -1)
    distances = [
        _to_segment(points, graph[start], graph[end])
        for k in range(nearest.shape[1])
        for start, end in _segments(nearest[:, k], len(graph))
    ]
    return float(np.min(distances, axis=0).max())


def _segments(vertices: VertexIndices, count: int) -> list[tuple[VertexIndices, VertexIndices]]:
    before, after = np.maximum(vertices - 1, 0), np.minimum(vertices + 1, count - 1)
    return [(before, vertices), (vertices, after)]


def _to_segment(points: Array, start: Array, end: Array) -> Array:
    edge = end - start
    length = np.einsum("ij,ij->i", edge, edge)
    along = np.einsum("ij,ij->i", points - start, edge) / np.where(length > 0, length, 1.0)
    foot = start + np.clip(along, 0.0, 1.0)[:, None] * edge
    result: Array = np.linalg.norm(points - foot, axis=1)
    return result
