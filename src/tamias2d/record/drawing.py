"""The look of a body: its lines in its own frame, its colour, and the view that holds a run.

The viewer and the plots draw from here, so that a body has one look everywhere.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache
from typing import TYPE_CHECKING

import numpy as np

from tamias2d.record.filling import parallels, rings
from tamias2d.record.held_points import held_points
from tamias2d.record.line_marks import dashes, ticks
from tamias2d.scene import Box, Capsule, Chain, Disc, HalfPlane, pieces_of

if TYPE_CHECKING:
    from collections.abc import Iterator

    from numpy.typing import NDArray

    from tamias2d.record.drawn import Drawn, Frames
    from tamias2d.run_data import RunData
    from tamias2d.scene import Body, Compound, Part
    from tamias2d.scene.shapes import Single

    Points = NDArray[np.float64]

Colour = tuple[int, int, int]

# Mid-tones: the viewer follows the system's theme, so each must stand out on black and on white.
PALETTE: tuple[Colour, ...] = (
    (230, 120, 40), (60, 140, 220), (70, 170, 100), (200, 80, 130),
    (150, 110, 210), (190, 150, 30), (40, 165, 175), (210, 85, 70),
)  # fmt: skip
STATIC_COLOUR: Colour = (130, 135, 140)
KINEMATIC_COLOUR: Colour = (125, 145, 180)
CIRCLE_SIDES = 72
HATCHES = 48
_KEPT = 256  # shapes: bodies that come and go in a loop are of few kinds
_LOST = 6.0  # times as far as half of all go, or the scene is wide at first
_LARGER = 1.2  # times what a view that grows has to hold
FILL_LINES, COARSE_LINES, COARSE_BOX_LINES = 24, 8, 3


@dataclass(frozen=True)
class View:
    """A window of the world, in metres: its centre (x, y) and half its width and height."""

    center: tuple[float, float]
    half: tuple[float, float]

    @property
    def reach(self) -> float:
        """Half the diagonal: no point of the view is farther from its centre, in metres."""
        return math.hypot(*self.half)


def colours(run: RunData) -> list[Colour]:
    """Red, green and blue of each body, 0 to 255; all static bodies have one, and all kinematic."""
    bodies, moving = run.scene.bodies, iter(range(len(run.scene.bodies)))
    still = {False: STATIC_COLOUR, True: KINEMATIC_COLOUR}
    return [
        PALETTE[next(moving) % len(PALETTE)] if b.dynamic else still[b.kinematic] for b in bodies
    ]


def strokes(body: Body, view: View) -> list[Points]:
    """All lines of a body in its own frame, each (v, 2), in metres.

    A sensor has dashes, for nothing is solid there; a chain that is solid from one side has ticks
    where the ground is.
    """
    if body.shape is None:  # a particle: a cross that can be seen in the view
        arm = 0.01 * view.reach
        return [np.array([(-arm, 0.0), (arm, 0.0)]), np.array([(0.0, -arm), (0.0, arm)])]
    mark = view.reach / HATCHES
    if isinstance(body.shape, HalfPlane):
        edge, *hatches = _ground(body, body.shape, view)
        return dashes(edge, mark) if body.sensor else [edge, *hatches]
    lines = outlines(body)
    if body.sensor:
        lines = [dash for line in lines for dash in dashes(line, mark / 2)]
    if isinstance(body.shape, Chain):
        one_sided = body.shape.one_sided and not body.sensor
        return [*lines, *(ticks(lines[0], mark / 2) if one_sided else ())]
    return lines if body.static else [*lines, _spoke(outlines(body)[0])]


def outlines(body: Body) -> list[Points]:
    """Closed lines around what a body is made of, each (v, 2), from its centre of mass, in metres.

    A particle and a half-plane have none; the line of a chain need not be closed.
    """
    if body.shape is None or isinstance(body.shape, HalfPlane):
        return []
    if isinstance(body.shape, Chain):
        closing = body.shape.vertices[:1] if body.shape.loop else ()
        return [np.array([*body.shape.vertices, *closing])]
    return [_outline(piece) for piece in pieces_of(body.shape)]


def is_hollow(body: Body) -> bool:
    """Whether a body is drawn by lines alone: a sensor, or a chain, whose inside is nothing."""
    return body.sensor or isinstance(body.shape, Chain)


def _outline(piece: Part) -> Points:
    """The line around one piece, which has the middle of its right side after its second point."""
    shape = piece.shape
    if not isinstance(shape, Disc | Capsule):
        return np.array([*piece.core, *piece.core[:1]], dtype=np.float64)
    angle = (np.arange(CIRCLE_SIDES + 1) - 1.5) * (2 * np.pi / CIRCLE_SIDES)
    rim = shape.radius * np.column_stack([np.cos(angle), np.sin(angle)])
    if isinstance(shape, Capsule):
        rim[:, 0] += np.copysign(shape.length / 2, rim[:, 0])
    return placed(rim, np.array(piece.position), piece.orientation)


@dataclass(frozen=True)
class Look:
    """A body in its own frame as a viewer can draw it: its 2D areas cannot be filled otherwise."""

    discs: list[tuple[Points, float]]
    """Centre (2,) and radius of each, filled, in metres."""
    bands: list[tuple[Points, float]]
    """Ends (2, 2) and half-width of lines as wide as a capsule, in metres."""
    areas: list[tuple[Points, float]]
    """Lines (l, v, 2) that fill a piece, and their half-width, in metres."""
    lines: list[Points]
    """(v, 2) each: outlines, a spoke that shows how it is turned, the edge of the ground."""


def look(body: Body, view: View, *, balls: bool = False, coarse: bool = False) -> Look:
    """Take a body apart; a sensor is left empty.

    A disc may be one point, which a viewer shades like a ball, and areas filled coarsely.
    """
    if body.shape is None or isinstance(body.shape, HalfPlane) or is_hollow(body):
        return Look([], [], [], strokes(body, view))
    return _look_of(body.shape, spoke=not body.static, balls=balls, coarse=coarse)


@lru_cache(_KEPT)
def _look_of(shape: Single | Compound, *, spoke: bool, balls: bool, coarse: bool) -> Look:
    """Take a shape apart, perhaps with a spoke."""
    rims = [_outline(piece) for piece in pieces_of(shape)]
    found = Look([], [], [], [_spoke(rims[0])] if spoke else [])
    for piece, rim in zip(pieces_of(shape), rims, strict=True):
        if balls and isinstance(piece.shape, Disc | Capsule):
            ends = np.array(piece.core)
            found.discs.extend((end, piece.shape.radius) for end in ends)
            if len(ends) > 1:
                found.bands.append((ends, piece.shape.radius))
        else:
            found.lines.append(rim)
            if np.ptp(rim[:, 1]):
                found.areas.extend(_areas_of(piece, rim, coarse=coarse))
    return found


def titled(run: RunData, what: str) -> str:
    """Return the title of a picture: what it shows, after the name of the scene if it has one."""
    return f"{run.scene.name}: {what}" if run.scene.name else what


def _areas_of(piece: Part, rim: Points, *, coarse: bool) -> Iterator[tuple[Points, float]]:
    if isinstance(piece.shape, Disc | Capsule):
        yield parallels(rim, COARSE_LINES if coarse else FILL_LINES)
    elif coarse:
        yield parallels(rim, COARSE_BOX_LINES if isinstance(piece.shape, Box) else COARSE_LINES)
    else:
        yield from rings(rim)


def _spoke(rim: Points) -> Points:
    return np.array([(0.0, 0.0), (rim[1] + rim[2]) / 2])


def _ground(body: Body, shape: HalfPlane, view: View) -> list[Points]:
    """The edge of a half-plane, and hatching on its solid side, in its own frame.

    It reaches three times as far as the view, because a window may be wider than what it shows.
    """
    normal = np.array(shape.normal)
    along = np.array((-normal[1], normal[0]))
    center = rotation(-body.orientation) @ (np.array(view.center) - body.position)
    foot = shape.offset * normal + (center @ along) * along
    reach = 3 * view.reach
    starts = foot + np.linspace(-reach, reach, 3 * HATCHES)[:, None] * along
    slant = (along - normal) * (view.reach / HATCHES)
    edge = np.array([foot - reach * along, foot + reach * along])
    return [edge, *(np.array([start, start + slant]) for start in starts)]


def rotation(angle: float) -> Points:
    """Matrix (2, 2) of a counter-clockwise turn by `angle` rad."""
    return np.array([[math.cos(angle), -math.sin(angle)], [math.sin(angle), math.cos(angle)]])


def placed(points: Points, position: Points, orientation: float) -> Points:
    """Points (v, 2) of a body's frame in the world, in metres."""
    return points @ rotation(orientation).T + position


def view_of(run: Drawn) -> View:
    """The view that holds every bounded body during the whole run, with a margin of 8 %."""
    return _around(*_boxes(run))


def view_of_most(frames: Frames) -> View:
    """Likewise, but of what flies off, many times as far as others go, the beginning alone.

    What half of all do is not flying off, unless it leads away from ground that is known.
    """
    (lows, highs), (first_lows, first_highs) = _boxes(frames), _boxes(frames.first())
    centre = first_lows.min(axis=0) / 2 + first_highs.max(axis=0) / 2
    reach, first_reach = _reach(lows, highs, centre), _reach(first_lows, first_highs, centre)
    begun, half = float(first_reach.max()), float(np.sort(reach)[(len(reach) - 1) // 2])
    known = any(body.static and _is_bounded(body) for body in frames.scene.bodies)
    most = min(half, _LOST * begun) if known else half
    near = (reach <= _LOST * max(begun, most))[:, None]
    return _around(np.where(near, lows, first_lows), np.where(near, highs, first_highs))


def _is_bounded(body: Body) -> bool:
    return body.shape is not None and not isinstance(body.shape, HalfPlane)


def _reach(lows: Points, highs: Points, centre: Points) -> Points:
    """How far boxes (b, 2) go from a centre, (b,), in metres."""
    farthest: Points = np.maximum(np.abs(lows - centre), np.abs(highs - centre)).max(axis=1)
    return farthest


def _around(lows: Points, highs: Points) -> View:
    """The view that holds boxes by their corners (b, 2), with a margin."""
    low, high = lows.min(axis=0), highs.max(axis=0)
    span = float((high - low).max()) or 2.0  # one particle at rest: 2 m around it
    half = 0.54 * np.maximum(high - low, span / 4)  # in a narrow strip nothing could be seen
    return _view(low / 2 + high / 2, half)


def grown(view: View, other: View) -> View:
    """Return a view that holds another one, too: a larger one at once, so that it seldom grows."""
    low, high = _corners(view)
    other_low, other_high = _corners(other)
    if np.all(other_low >= low) and np.all(other_high <= high):
        return view
    center, half = _between(np.minimum(low, other_low), np.maximum(high, other_high))
    return _view(center, _LARGER * half)


def within(view: View, other: View, times: float) -> View:
    """Return what of a view is within another one that is made so many times as large."""
    least, most = _corners(View(other.center, (times * other.half[0], times * other.half[1])))
    low, high = _corners(view)
    return _view(*_between(np.clip(low, least, most), np.clip(high, least, most)))


def _corners(view: View) -> tuple[Points, Points]:
    center, half = np.array(view.center), np.array(view.half)
    return center - half, center + half


def _between(low: Points, high: Points) -> tuple[Points, Points]:
    """Return the centre of what is between two corners, and half of its size."""
    return low / 2 + high / 2, high / 2 - low / 2


def _view(center: Points, half: Points) -> View:
    return View((float(center[0]), float(center[1])), (float(half[0]), float(half[1])))


def _boxes(run: Drawn) -> tuple[Points, Points]:
    """Lower left and upper right corners (b, 2) of where each bounded body has been, in metres.

    The points at which joints and springs hold have boxes, too: of bodies without shapes they are
    all that there is to see.
    """
    boxes = []
    for index, body in enumerate(run.scene.bodies):
        if not isinstance(body.shape, HalfPlane):
            path = run.position[:, index]
            size = body.shape.bounding_radius if body.shape else 0.0
            if isinstance(body.shape, Chain) and not body.kinematic:
                path, size = placed(outlines(body)[0], path[0], body.orientation), 0.0
            boxes.append((path.min(axis=0) - size, path.max(axis=0) + size))
    boxes += [(path.min(axis=0), path.max(axis=0)) for path in held_points(run)]
    lows, highs = zip(*boxes or [(np.full(2, -1.0), np.full(2, 1.0))], strict=True)
    return np.array(lows), np.array(highs)


def round_length(length: float) -> float:
    """The largest 1, 2 or 5 times a power of ten that is not above `length`, in metres."""
    power = 10.0 ** math.floor(math.log10(length))
    return float(max(step * power for step in (1, 2, 5) if step * power <= length * (1 + 1e-9)))
