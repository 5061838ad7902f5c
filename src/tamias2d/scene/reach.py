"""Which bodies can meet: the bounds that their free motion sweeps within a duration.

A pair whose swept bounds stay apart cannot be the first to meet. If no bounds meet, nothing does,
and all motion is free to the end. Bounds may be too large, never too small: a pair too many costs
time, a pair too few an impact.
"""

import math
from collections.abc import Iterator
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from tamias2d.generated import detection, translation
from tamias2d.scene.acting import Load, steady_load, varying_loads
from tamias2d.scene.bodies import Body
from tamias2d.scene.compound import pieces_of
from tamias2d.scene.filters import filters, may_touch
from tamias2d.scene.rules import Vector
from tamias2d.scene.scene import Scene
from tamias2d.scene.shapes import Disc, HalfPlane

_MARGIN = 1e-12  # of all lengths involved: more than rounding can do to a bound
_X, _Y = (1.0, 0.0), (0.0, 1.0)

_Bounds: TypeAlias = tuple[Vector, float, float]
"""An axis-parallel box as IM4 takes it: its middle, width and height, m."""


def pairs_that_can_meet(scene: Scene, duration: float) -> list[tuple[int, int]]:
    """Return all pairs (i, j), i < j, that may meet: one moves, and their swept bounds meet."""
    varying = varying_loads(scene)
    loads = {k: steady_load(scene, k) for k in range(len(scene)) if k not in varying}
    solid = [
        (k, body)
        for k, body in enumerate(scene.bodies)
        if body.shape is not None and not body.sensor
    ]
    solid = _sociable(solid)
    walls = [(k, body.shape) for k, body in solid if isinstance(body.shape, HalfPlane)]
    bounded = [(k, body) for k, body in solid if not isinstance(body.shape, HalfPlane)]
    found = [
        _ordered(j, k)
        for j, wall in walls
        for k, body in bounded
        if body.dynamic and _reaches(body, wall, scene.gravity, loads.get(k), duration)
    ]
    moves = np.array([body.dynamic for _, body in bounded], dtype=bool)
    index = [k for k, _ in bounded]
    for gravity, both in ((scene.gravity, False), ((0.0, 0.0), True)):  # all fall alike
        bounds = [_swept(body, gravity, loads.get(k), duration) for k, body in bounded]
        met = _overlaps(bounds, moves, both=both)
        found += [_ordered(index[one], index[other]) for one, other in met]
    if scene.joints or any(filters(body) for _, body in solid):
        apart = scene.kept_apart
        found = [
            (i, j)
            for i, j in found
            if may_touch(scene.bodies[i], scene.bodies[j]) and (i, j) not in apart
        ]
    return sorted(found)


def _sociable(solid: list[tuple[int, Body]]) -> list[tuple[int, Body]]:
    """Return the bodies that may touch some other, by groups, categories and masks."""
    kinds: dict[tuple[int, int, int], list[Body]] = {}
    for _, body in solid:
        kinds.setdefault(_kind(body), []).append(body)
    first = {kind: bodies[0] for kind, bodies in kinds.items()}
    met = {
        kind
        for kind, body in first.items()
        if any(
            may_touch(body, other) and (kind != of or len(kinds[kind]) > 1)
            for of, other in first.items()
        )
    }
    return [(k, body) for k, body in solid if _kind(body) in met]


def _kind(body: Body) -> tuple[int, int, int]:
    return body.category, body.mask, body.group


def _overlaps(
    bounds: list[_Bounds], moves: NDArray[np.bool_], *, both: bool
) -> Iterator[tuple[int, int]]:
    """Find all overlaps, by place, of which both move, or one.

    A box is compared with those that start before it ends (along x).
    """
    rows = [(*middle, width, height) for middle, width, height in bounds]
    left = np.array([x - width / 2 for x, _, width, _ in rows])
    order = np.argsort(left, kind="stable")
    x, y, width, height = np.array(rows, dtype=np.float64).reshape(-1, 4)[order].T
    moves = moves[order]
    ends = np.searchsorted(left[order], x + width / 2, side="right")
    for k, end in enumerate(ends.tolist()):
        near = slice(k + 1, max(end, k + 1))
        meets = detection.overlap(
            (x[k], y[k]), width[k], height[k], (x[near], y[near]), width[near], height[near]
        )
        wanted = moves[near] & moves[k] if both else moves[near] != moves[k]
        others = order[near][meets & wanted]
        yield from ((int(order[k]), other) for other in others.tolist())


def _ordered(i: int, j: int) -> tuple[int, int]:
    return min(i, j), max(i, j)


def _swept(body: Body, gravity: Vector, load: Load | None, duration: float) -> _Bounds:
    left, right = _shadow(body, gravity, load, duration, _X)
    low, high = _shadow(body, gravity, load, duration, _Y)
    center = ((left + right) / 2, (low + high) / 2)
    if not all(map(math.isfinite, center)):  # without bound: everywhere
        return body.position, math.inf, math.inf
    return center, right - left, high - low


def _reaches(
    body: Body, wall: HalfPlane, gravity: Vector, load: Load | None, duration: float
) -> bool:
    low, _ = _shadow(body, gravity, load, duration, wall.normal)
    return not low > wall.offset + _MARGIN * abs(wall.offset)


def _shadow(
    body: Body, gravity: Vector, load: Load | None, duration: float, axis: Vector
) -> tuple[float, float]:
    """Return the interval of an axis over which a body sweeps; no `load` says that it varies."""
    below, above = _extent(body, load, axis)
    if body.static:
        start = _dot(body.position, axis)
        margin = _MARGIN * (abs(start) + above - below)
        return start + below - margin, start + above + margin
    if load is None:
        return -math.inf, math.inf
    path = _path(body, gravity, load, duration, axis)
    if not all(map(math.isfinite, path)):
        return -math.inf, math.inf
    margin = _MARGIN * (max(map(abs, path)) + above - below)
    return min(path) + below - margin, max(path) + above + margin


def _path(body: Body, gravity: Vector, load: Load, duration: float, axis: Vector) -> list[float]:
    """Return where a centre starts, ends and turns back, along an axis."""
    start, speed = _dot(body.position, axis), _dot(body.velocity, axis)
    push = 0.0
    if body.dynamic:
        push = _dot(translation.acceleration(gravity, load[:2], body.mass), axis)
    times = [0.0, duration]
    if push and 0 < -speed / push < duration:
        times.append(-speed / push)
    return [
        translation.position((start, 0.0), (speed, 0.0), (push, 0.0), time)[0] for time in times
    ]


def _extent(body: Body, load: Load | None, axis: Vector) -> tuple[float, float]:
    """Return how far a shape reaches against and along an axis from its centre of mass."""
    shape = body.shape
    if shape is None or isinstance(shape, HalfPlane):
        return 0.0, 0.0
    turned = load is None or load[2] != 0 or body.angular_velocity != 0
    if isinstance(shape, Disc) or turned:
        return -shape.bounding_radius, shape.bounding_radius
    cos, sin = math.cos(body.orientation), math.sin(body.orientation)
    own = (cos * axis[0] + sin * axis[1], cos * axis[1] - sin * axis[0])
    reaches = [
        (_dot(corner, own), piece.shape.rounding)
        for piece in pieces_of(shape)
        for corner in piece.core
    ]
    return min(at - round_ for at, round_ in reaches), max(at + round_ for at, round_ in reaches)


def _dot(a: Vector, b: Vector) -> float:
    return a[0] * b[0] + a[1] * b[1]
