"""Overlapping bodies, at the start of a run or at the steps of the scheme of 2018."""

import math
from collections.abc import Collection, Iterator, Sequence

import numpy as np

from tamias2d.contact.core import Core, Placed, cores_of, place
from tamias2d.contact.gap import axes, resolution
from tamias2d.contact.refusal import OverlapError, UnlocatedContactError, named
from tamias2d.contact.stepwise import refuse_stepwise
from tamias2d.scene import Scene
from tamias2d.scene.filters import may_touch
from tamias2d.state import Array, History, State

_CLEAR = 1 + 1e-6  # times its reach: a body that is as far from a half-plane does not touch it


def refuse_overlap(
    cores: Sequence[Core],
    states: Sequence[State],
    kept_apart: Collection[tuple[int, int]] = (),
) -> None:
    """Raise `OverlapError` if two bodies overlap at the start; it is about the worst of them.

    Those that are kept apart, (i, j), i < j, do not touch whatever they do.
    """
    found = [
        (depth / min(a.bounding_radius, b.bounding_radius), a.name, b.name, depth)
        for a, b, depth in _overlaps(cores, states)
        if (a.index, b.index) not in kept_apart
    ]
    for share, a, b, depth in sorted(found, reverse=True)[:1]:
        raise OverlapError(named(a, b), depth, share=share)


def refuse_contact(scene: Scene, times: Array, history: History) -> None:
    """Raise `UnlocatedContactError` if two bodies overlap at one of the times (k,), s."""
    refuse_stepwise(scene)
    cores = cores_of(scene)
    for k, time in enumerate(times.tolist()):
        states = [
            State((x, y), orientation, (0.0, 0.0), 0.0)
            for (x, y), orientation in zip(
                history.position[k].tolist(), history.orientation[k].tolist(), strict=True
            )
        ]
        for a, b, depth in _overlaps(cores, states):
            raise UnlocatedContactError(
                f"{named(a.name, b.name)} at {time!r} s: they overlap by {depth:.6g} m, and "
                "Legacy2018() knows no contacts (R8). Use another method, or a shorter duration.",
                time=time,
            )


def _overlaps(cores: Sequence[Core], states: Sequence[State]) -> Iterator[tuple[Core, Core, float]]:
    """Go through the pairs that overlap, with the depth in m."""
    placed = [place(core, state) for core, state in zip(cores, states, strict=True)]
    solid = [body for body in placed if body.core.solid]
    for k, m in sorted(_near(solid)):
        a, b = solid[k], solid[m]
        reach = a.core.bounding_radius + b.core.bounding_radius
        apart = math.dist(a.state.position, b.state.position) > reach
        still = not (a.core.dynamic or b.core.dynamic)
        if apart or still or not may_touch(a.core.filter, b.core.filter):
            continue
        depth = -max(axis.gap for axis in axes(a, b))
        if depth > resolution(a, b, 0.0):
            yield a.core, b.core, depth


def _near(bodies: Sequence[Placed]) -> Iterator[tuple[int, int]]:
    """Go through the pairs whose bounding boxes overlap, by their places, the lower one first.

    A box is compared with those that begin before it ends along x: n log n where few do. An endless
    body is compared with all.
    """
    x, y = np.array([body.state.position for body in bodies]).reshape(-1, 2).T
    reach = np.array([body.core.bounding_radius for body in bodies])
    endless = np.flatnonzero(np.isinf(reach)).tolist()
    for k in endless:
        (ux, uy), (px, py) = bodies[k].turned(bodies[k].core.sides[0].normal), bodies[k].state[0]
        apart = ux * (x - px) + uy * (y - py) - bodies[k].core.sides[0].offset > _CLEAR * reach
        yield from ((min(k, m), max(k, m)) for m in np.flatnonzero(~apart).tolist())
    order = np.argsort(x - reach, kind="stable")
    order = order[len(endless) :]  # these begin nowhere
    x, y, reach = x[order], y[order], reach[order]
    ends = np.searchsorted(x - reach, x + reach, side="right")
    for k, end in enumerate(ends.tolist()):
        near = slice(k + 1, max(end, k + 1))
        meets = ~(np.abs(y[near] - y[k]) > reach[near] + reach[k])
        first = int(order[k])
        yield from ((min(first, m), max(first, m)) for m in order[near][meets].tolist())
