"""Points at which joints and springs hold bodies, at each sample of what is drawn."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from collections.abc import Iterator

    from numpy.typing import NDArray

    from tamias2d.record.drawn import Drawn
    from tamias2d.scene import Joint
    from tamias2d.scene.springs import Spring

    Points = NDArray[np.float64]


def point_of(run: Drawn, body: int | None, at: Any) -> Points:
    """Return where a point of a body, or of the plane, is at each sample, (k, 2)."""
    if body is None:
        return np.tile(np.array(at, dtype=np.float64), (len(run.times), 1))
    turn = run.orientation[:, body]
    x, y = at
    arm = np.column_stack(
        [np.cos(turn) * x - np.sin(turn) * y, np.sin(turn) * x + np.cos(turn) * y]
    )
    return np.asarray(run.position[:, body] + arm)


def ends_of(run: Drawn, spring: Spring) -> tuple[Points, Points]:
    """Return where the two ends of a spring are."""
    other = spring.other_anchor if spring.second is not None else spring.point
    return point_of(run, spring.first, spring.anchor), point_of(run, spring.second, other)


def held_points(run: Drawn) -> Iterator[Points]:
    """Yield the points of all joints and springs, of bodies and of the plane."""
    for joint in run.scene.joints:
        yield from (point_of(run, body, at) for body, at in _ends(joint))
    for spring in run.scene.springs:
        yield from ends_of(run, spring)


def _ends(joint: Joint) -> Iterator[tuple[int | None, Any]]:
    """Yield the bodies of a joint, None for the plane, with the points there."""
    if joint.model == "equation":
        return
    for body, at in zip(joint.ends[:2], joint.anchors[:2], strict=True):
        if body is not None or joint.model != "gear":
            yield body, at
    if joint.model == "pulley":
        given = dict(joint.parameters)
        yield from ((joint.ends[2], given[post]) for post in ("post_a", "post_b"))
