"""How joints and springs are drawn: lines in the world at each sample, in metres."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from tamias2d.motion.joint_events import BREAKS
from tamias2d.record.drawing import Colour
from tamias2d.record.held_points import ends_of, point_of

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

    from numpy.typing import NDArray

    from tamias2d.record.drawing import View
    from tamias2d.record.drawn import Drawn
    from tamias2d.run_data import RunData
    from tamias2d.scene import Freedom, Joint

    Points = NDArray[np.float64]

COLOURS: dict[str, Colour] = {
    "joint": (225, 225, 225),
    "axis": (140, 170, 200),
    "limit": (220, 90, 90),
    "spring": (120, 200, 140),
}
"""Of each kind of line; mid-tones, as bodies have."""
REACTION: Colour = (235, 120, 190)
_DARKER = 0.6  # times what the viewer shows
_TURNS, _ZIGZAG = 8, 0.025  # of a spring; its half-width, of the view's reach
_PIN, _TICK, _ARC = 0.012, 0.03, 0.1  # of the view's reach
_LIMB = 0.5  # of the smaller body: an arc of limits is no larger, so that heaps stay visible
_SIDES = 12


@dataclass(frozen=True)
class Line:
    """One line of a joint or spring, at k samples; points that coincide draw nothing."""

    name: str
    kind: str
    """Of `COLOURS`."""
    points: Points
    """(k, v, 2)"""


def on_white(kind: str) -> tuple[float, ...]:
    """Return the colour of a kind of line on white paper, where it is darker: 0 to 1."""
    return tuple(_DARKER * (channel / 255) for channel in COLOURS[kind])


def lines(run: Drawn, view: View) -> Iterator[Line]:
    """Yield all lines of all joints and springs; a joint that has broken has none."""
    broken = {e.joint: e.time for e in run.joint_events if e.what == BREAKS}
    for number, joint in enumerate(run.scene.joints):
        gone = run.times >= broken.get(number, np.inf)
        for kind, points in _joint(_Drawn(run, joint, view)):
            shown = np.where(gone[:, None, None], points[:, :1], points)
            yield Line(joint.name, kind, shown)
    for number, spring in enumerate(run.scene.springs):
        name = f"spring {number}"
        yield Line(name, "spring", _coil(*ends_of(run, spring), view))
        for points in _limbs(run, spring.ends):
            yield Line(name, "joint", points)


def reactions(run: RunData, view: View) -> tuple[Points, Points] | None:
    """Return places (k, j, 2) and arrows (k, j, 2), m, of what joints exert on B, or else on A.

    The largest arrow of all is a quarter of the view's reach.
    """
    joints = run.scene.joints
    if not joints:
        return None
    ends = [1 if joint.ends[1] is not None else 0 for joint in joints]
    places = [
        point_of(run, joint.ends[end], joint.anchors[end])
        for joint, end in zip(joints, ends, strict=True)
    ]
    force = run.reactions.force[:, np.arange(len(joints)), ends]
    largest = float(np.hypot(force[..., 0], force[..., 1]).max(initial=0.0))
    if not 0 < largest < np.inf:
        return None
    return np.stack(places, axis=1), force * (0.25 * view.reach / largest)


class _Drawn:
    """A joint with the places of its anchors."""

    def __init__(self, run: Drawn, joint: Joint, view: View) -> None:
        self.run, self.joint, self.view = run, joint, view
        self.a, self.b = (point_of(run, joint.ends[k], joint.anchors[k]) for k in (0, 1))
        body = joint.ends[0]
        still = np.zeros(len(run.times))
        self.turn = still if body is None else run.orientation[:, body]
        """Of body A, rad."""
        held = [run.scene.bodies[k] for k in joint.bodies]
        shapes = [each.shape for each in held if each.dynamic and each.shape is not None]
        self.size = min((shape.bounding_radius for shape in shapes), default=np.inf)
        """How far the smaller of its bodies reaches, m; endless without shapes."""


def _joint(drawn: _Drawn) -> Iterator[tuple[str, Points]]:
    """Yield the kind and points of each line of a joint."""
    joint, view = drawn.joint, drawn.view
    match joint.model:
        case "distance":
            kind = "joint" if joint.rigid else "axis"
            yield kind, np.stack([drawn.a, drawn.b], axis=1)
            yield "joint", _ring(drawn.a, view)
            yield "joint", _ring(drawn.b, view)
        case "prismatic" | "groove":
            yield from _slide(drawn)
        case "pulley":
            posts = [_post(drawn, key) for key in ("post_a", "post_b")]
            yield "joint", np.stack([drawn.a, *posts, drawn.b], axis=1)
        case "gear":
            centres = [point_of(drawn.run, joint.ends[k], joint.anchors[k]) for k in (0, 1)]
            yield "axis", np.stack(centres, axis=1)
        case "weld":
            yield "joint", _cross(drawn.b, view)
        case "angle":
            pass
        case _:
            yield "joint", _ring(drawn.a, view)
            yield "joint", _ring(drawn.b, view)
    for freedom in joint.freedoms:
        yield from _freedom(drawn, freedom)
    ends = zip(joint.ends, joint.anchors, strict=True)
    yield from (("joint", points) for points in _limbs(drawn.run, ends))


def _limbs(run: Drawn, ends: Iterable[tuple[int | None, Any]]) -> Iterator[Points]:
    """Yield lines from the centres of bodies without shapes to the points at which they are held.

    A body that two joints hold is a link from one to the other so.
    """
    for body, anchor in ends:
        if body is not None and run.scene.bodies[body].shape is None and any(anchor):
            yield np.stack([run.position[:, body], point_of(run, body, anchor)], axis=1)


def _freedom(drawn: _Drawn, freedom: Freedom) -> Iterator[tuple[str, Points]]:
    """Yield the spring of a freedom, and the limits of an angle as spokes with an arc."""
    if freedom.spring is not None and freedom.measure != "angle" and not freedom.across:
        yield "spring", _coil(drawn.a, drawn.b, drawn.view)
    limits = freedom.limits
    if freedom.measure != "angle" or limits is None or freedom.pitch is not None:
        return
    lower = limits.lower if limits.lower is not None else (limits.upper or 0.0) - 0.5
    upper = limits.upper if limits.upper is not None else lower + 0.5
    turns = drawn.turn[:, None] + np.linspace(lower, upper, _SIDES)
    around = np.stack([np.cos(turns), np.sin(turns)], axis=-1)
    radius = min(_ARC * drawn.view.reach, _LIMB * drawn.size)
    arc = drawn.b[:, None] + radius * around
    yield "limit", np.concatenate([drawn.b[:, None], arc, drawn.b[:, None]], axis=1)


def _slide(drawn: _Drawn) -> Iterator[tuple[str, Points]]:
    """Yield the line along which a body slides, with ticks at its limits."""
    guide = dict(drawn.joint.parameters)["guide_a"]
    assert isinstance(guide, tuple)
    cosine, sine = np.cos(drawn.turn), np.sin(drawn.turn)
    along = np.column_stack(
        [cosine * guide[0] - sine * guide[1], sine * guide[0] + cosine * guide[1]]
    )
    across = np.column_stack([-along[:, 1], along[:, 0]])
    travel = np.einsum("ki,ki->k", drawn.b - drawn.a, along)
    reach = _TICK * drawn.view.reach
    low, high = float(travel.min()) - reach, float(travel.max()) + reach
    for freedom in drawn.joint.freedoms:
        if freedom.measure == "travel" and freedom.limits is not None:
            low = low if freedom.limits.lower is None else freedom.limits.lower
            high = high if freedom.limits.upper is None else freedom.limits.upper
            for end in (freedom.limits.lower, freedom.limits.upper):
                if end is not None:
                    at = drawn.a + end * along
                    yield "limit", np.stack([at - reach * across, at + reach * across], axis=1)
    yield "axis", np.stack([drawn.a + low * along, drawn.a + high * along], axis=1)
    yield "joint", _ring(drawn.b, drawn.view)


def _post(drawn: _Drawn, key: str) -> Points:
    return point_of(drawn.run, drawn.joint.ends[2], dict(drawn.joint.parameters)[key])


def _ring(at: Points, view: View) -> Points:
    turns = np.linspace(0, 2 * np.pi, _SIDES + 1)
    around = np.column_stack([np.cos(turns), np.sin(turns)])
    return at[:, None] + _PIN * view.reach * around


def _cross(at: Points, view: View) -> Points:
    arm = _PIN * view.reach
    corners = arm * np.array([(-1, -1), (1, 1), (0, 0), (-1, 1), (1, -1)])
    return at[:, None] + corners


def _coil(first: Points, second: Points, view: View) -> Points:
    """Return a zigzag line between two points."""
    way = second - first
    length = np.hypot(way[:, 0], way[:, 1])[:, None]
    across = np.column_stack([-way[:, 1], way[:, 0]]) / np.maximum(length, 1e-300)
    shares = np.array([0.0, 0.1, *np.linspace(0.15, 0.85, _TURNS), 0.9, 1.0])
    sides = np.array([0.0, 0.0, *[(-1.0) ** k for k in range(_TURNS)], 0.0, 0.0])
    middle = first[:, None] + shares[None, :, None] * way[:, None]
    coil: Points = middle + (_ZIGZAG * view.reach) * sides[None, :, None] * across[:, None]
    return coil
