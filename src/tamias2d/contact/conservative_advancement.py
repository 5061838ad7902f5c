"""The time of impact of a pair: conservative advancement of second order.

At a time an axis gives for every corner a gap with its rate, and a lower bound of its second
derivative in a window of time (DD47), from which follows a step that passes no impact (DD46). The
largest such step over the axes is taken, again and again (IM12).
"""

import math
from collections.abc import Callable, Sequence

from tamias2d.contact.core import Core, Placed, place, rounded
from tamias2d.contact.gap import Axis, Gap, axes, from_side, gaps, nearest_gap, resolution
from tamias2d.contact.gap_acceleration import LeastGapAcceleration, least_of_centres
from tamias2d.contact.manifold import Contact
from tamias2d.contact.refusal import UndecidedContactError, named
from tamias2d.contact.terrain import normals
from tamias2d.generated.continuous_collision import (
    advance_closing,
    advance_opening,
    discriminant,
)
from tamias2d.generated.impact import normal_velocity
from tamias2d.path import Bounds, PathPiece
from tamias2d.state import Vector

_MAX_STEPS = 100_000  # of one search; a hundred are many
_TURNED = 0.5  # cosine of a turn by which no side is mistaken for another (`from_side`)
_BESIDE = 2.0**-20  # of the size: how far a body goes between looks beside a piece of a chain
_TINY_STEP, _TINY_STEPS = (
    2.0**-48,
    1000,
)  # so many steps of so small a part of the time, or at no gap


class Pair:
    """Two bodies on their paths."""

    def __init__(
        self,
        a: Core,
        b: Core,
        path_a: PathPiece,
        path_b: PathPiece,
        lasting: Sequence[Contact] = (),
        separating_direction: Vector | None = None,
    ) -> None:
        """Take two bodies, and the lasting contacts that do not count as an impact.

        `separating_direction` is the direction from A to B in which they were last apart.
        """
        self.cores = (a, b)
        self._direction = separating_direction
        self.apart: list[tuple[float, Vector]] = []
        """When, s, and in which direction they were found apart: the last, and each turn before."""
        self._lasting = lasting
        self._touching = False
        self._paths = (path_a, path_b)

    def placed(self, time: float) -> tuple[Placed, Placed]:
        """Return both bodies at a time in s."""
        (a, b), (path_a, path_b) = self.cores, self._paths
        return place(a, path_a.at(time)), place(b, path_b.at(time))

    def time_of_impact(self, start: float, end: float) -> float | None:
        """Return the first time in s from `start` to `end` at which they touch and do not separate.

        Raises:
            UndecidedContactError: float64 cannot tell it in a bounded number of steps.
        """
        return self._first(self._safe_step, start, end, self._time_apart)

    def _first(
        self,
        safe_step: Callable[[float, float], float | None],
        start: float,
        end: float,
        time_apart: Callable[[float, float, float], float | None] = lambda *_: None,
    ) -> float | None:
        """Return the first time in s from `start` to `end` from which there is no safe step.

        Where steps become tiny, it goes on when they are apart, if `time_apart` tells that.
        """
        time, tiny_steps, tiny = start, 0, _TINY_STEP * max(abs(end), end - start)
        for _ in range(_MAX_STEPS):
            if not time < end:
                return None
            step = safe_step(time, end)
            if step is None or time + step == time:
                return time
            tiny_steps += self._touching or step < tiny
            if tiny_steps > _TINY_STEPS:
                if self._lasting and self._closes(time):
                    return time
                apart = time_apart(time, tiny, end)
                if apart is None and self._tied_to_lie(time):
                    return time
                if apart is None:
                    break
                time, tiny_steps = apart, 0
                continue
            time += step
        raise self._undecided(time)

    def _time_apart(self, start: float, step: float, end: float) -> float | None:
        """Return a time in s soon after `start` at which a pair that opens is apart, if it is.

        Where bodies turn, bounds hide for long that they open.
        """
        least, _ = self._nearest(start)
        while start + step < end:
            nearest, tolerance = self._nearest(start + step)
            if nearest.rate <= 0 or nearest.value < least.value - tolerance:
                return None
            if nearest.value > tolerance:
                return start + step
            step *= 2
        return None

    def _closes(self, time: float) -> bool:
        """Whether a corner that comes down beside a lasting contact is there, but for rounding.

        Angles in float64 may stand still for longer than it takes.
        """
        nearest, tolerance = self._nearest(time)
        return nearest.value <= tolerance and nearest.rate < 0

    def _tied_to_lie(self, time: float) -> bool:
        """Whether they touch, and joints may tie one to what lies on the other: it hardly moves."""
        nearest, tolerance = self._nearest(time)
        return any(core.jointed for core in self.cores) and nearest.value <= tolerance

    def _undecided(self, time: float) -> UndecidedContactError:
        return UndecidedContactError(
            f"{named(*(core.name for core in self.cores))} at {time!r} s: float64 cannot tell "
            "whether they part or press (R7). End the run before, or change the scene a little.",
            time=time,
        )

    def separation_time(
        self, start: float, step: float, acceleration: float, touching: Sequence[Contact]
    ) -> float:
        """Return a time in s soon after `start` at which a parting pair is apart and opens.

        It is earlier where they come back, or where another corner comes into contact than those of
        the contacts that are `touching`. `step` is the first guess of how long that takes; it is
        doubled until float64 can tell. The `acceleration`, m/s^2, takes back what contacts that
        settle leave of an approach.

        Raises:
            UndecidedContactError: they come to overlap instead, by more than they did before.
        """
        end = min(path.end for path in self._paths)
        now, _ = self._nearest(start)
        left = min(now.value, 0.0) - min(now.rate, 0.0) ** 2 / acceleration  # twice how far it goes
        before, last = start, now.value
        while True:
            time = min(start + step, end)
            met = self._others_meet(touching, before, time)
            if met is not None or time == end:
                return end if met is None else met
            nearest, tolerance = self._nearest(time)
            if nearest.value > tolerance and nearest.rate > 0:
                return time
            if nearest.value < left - 4 * tolerance:
                if last < -4 * tolerance or start + step / 2 == start:
                    raise self._undecided(start)
                if before > start:
                    return before  # they opened too little, and come back
                step /= 2
                continue
            before, last, step = time, nearest.value, 2 * step

    def _others_meet(self, touching: Sequence[Contact], start: float, end: float) -> float | None:
        """Return the first time in s at which another corner meets the side that one touches.

        The sides of both bodies are flat on each other then, so that one of them tells it.
        """
        if len(touching) > 1 or touching[0].axis.side is None:  # there is no other
            return None

        def safe_step(time: float, end: float) -> float | None:
            a, b = self.placed(time)
            axis, near = self._other_corners(touching, a, b)
            if axis[:2] == touching[0].axis[:2]:
                near = _distinct(near, touching[0], a, b, time)
            return self._step_to(near, axis, a, b, time, end)

        self._touching = False
        return self._first(safe_step, start, end)

    def _nearest(self, time: float) -> tuple[Gap, float]:
        """Return the least gap of corners that no contact holds, and what is none of it, m."""
        a, b = self.placed(time)
        tolerance = resolution(a, b, time)
        if self._lasting:
            _, near = self._other_corners(self._lasting, a, b)
            return min(near, key=lambda gap: gap.value), tolerance
        axis = max(self._axes(a, b, time, tolerance) or axes(a, b), key=_gap_of)
        return nearest_gap(a, b, axis), tolerance

    def _safe_step(self, time: float, end: float) -> float | None:
        """Return how long no contact can come about, s, or None if one is there."""
        a, b = self.placed(time)
        tolerance = resolution(a, b, time)
        far, step = self._bounding_circle_step(a, b, time, end)
        if far:
            return step
        if self._lasting:
            return self._step_to_other_corners(a, b, time, end)
        step = max(step, self._spinning_step(a, b, time, end))
        found = self._axes(a, b, time, tolerance)
        if not found:
            return max(step, _step_beside(a, b, tolerance, end - time))
        largest = max(axis.gap for axis in found)
        steps = []
        for axis in found:
            if axis.gap >= largest - tolerance:
                near = gaps(a, b, axis)
                if any(gap.value <= 0 and gap.rate <= 0 for gap in near):
                    continue
                steps.append(self._step_along(axis, near, a, b, time, end))
        return max(max(steps), step) if steps else None

    def _axes(self, a: Placed, b: Placed, time: float, tolerance: float) -> list[Axis]:
        """Return the axes, where they touch only those of the side on which they were."""
        found = axes(a, b)
        best = max(found, key=_gap_of)
        self._touching = best.gap <= tolerance
        if self._touching:
            found = normals(a, b, found)
            return from_side(a, b, found, self._direction) if found else []
        self._note_apart(time, best.separating_direction)
        return found

    def _note_apart(self, time: float, direction: Vector) -> None:
        """Note in which direction they are apart; of times between two turns the last one stays."""
        self._direction = x, y = direction
        if len(self.apart) > 1:
            _, (u, v) = self.apart[-2]
            if x * u + y * v > _TURNED:
                self.apart.pop()
        self.apart.append((time, direction))

    def _step_to_other_corners(self, a: Placed, b: Placed, time: float, end: float) -> float | None:
        """Return the safe step for all other corners along the axis of a lasting contact."""
        if self._lasting[0].axis.side is None:  # around a corner there is only one
            return math.inf
        if len(self._lasting) > 1:  # sides that lie flat on each other do not turn
            return math.inf
        axis, near = self._other_corners(self._lasting, a, b)
        same = axis[:2] == self._lasting[0].axis[:2]
        if same:
            near = _distinct(near, self._lasting[0], a, b, time)
            near = [self._gap_from_lasting(gap, axis, a, b) for gap in near]
        return self._step_to(near, axis, a, b, time, end, relative=same)

    def _step_to(
        self,
        near: list[Gap],
        axis: Axis,
        a: Placed,
        b: Placed,
        time: float,
        end: float,
        *,
        relative: bool = False,
    ) -> float | None:
        """Return the safe step for some corners along an axis; infinity if there are none."""
        if any(gap.value <= 0 and gap.rate <= 0 for gap in near):
            return None
        return (
            self._step_along(axis, near, a, b, time, end, relative=relative) if near else math.inf
        )

    def _gap_from_lasting(self, gap: Gap, axis: Axis, a: Placed, b: Placed) -> Gap:
        """Return the gap to a corner relative to the lasting contact: only turning changes it."""
        p, q = (b, a) if axis.swapped else (a, b)
        ux, uy = axis.direction
        kx, ky = q.corners[self._lasting[0].gap.which[1]]
        x, y = gap.corner[0] - kx, gap.corner[1] - ky
        spin = q.state.angular_velocity - p.state.angular_velocity
        still, centre = 0.0, (0.0, 0.0)
        rate = normal_velocity(centre, still, centre, centre, spin, (x, y), axis.direction)
        return gap._replace(value=ux * x + uy * y, rate=rate, reach=(0.0, math.hypot(x, y)))

    def _other_corners(
        self, contacts: Sequence[Contact], a: Placed, b: Placed
    ) -> tuple[Axis, list[Gap]]:
        """Return the axis of contacts, and the gaps along it to all corners but theirs."""
        owner = contacts[0].axis
        found = axes(a, b)
        same = [each for each in found if each[:2] == owner[:2]]
        axis = same[0] if same else max(from_side(a, b, found, self._direction), key=_gap_of)
        corners = {contact.gap.which[1] for contact in contacts if contact.axis[:2] == axis[:2]}
        corners |= {c.found[1] for c in contacts if c.found[0] == axis.swapped}
        return axis, [gap for gap in gaps(a, b, axis) if gap.which[1] not in corners]

    def _bounding_circle_step(
        self, a: Placed, b: Placed, time: float, end: float
    ) -> tuple[bool, float]:
        """Return whether circles around the bodies are well apart, and how long they stay so."""
        radius = a.core.bounding_radius + b.core.bounding_radius
        if math.isinf(radius) or len(a.corners) == len(b.corners) == 1:
            return False, 0.0
        (ax, ay), (bx, by) = a.state.position, b.state.position
        x, y = bx - ax, by - ay
        distance = math.hypot(x, y)
        if distance <= radius:
            return False, 0.0
        ux, uy = x / distance, y / distance
        still, centre = 0.0, (0.0, 0.0)
        rate = normal_velocity(
            a.state.velocity, still, centre, b.state.velocity, still, centre, (ux, uy)
        )
        least = least_of_centres((ux, uy), *self._bounds(time, end))
        return distance > 1.1 * radius, _root(distance - radius, rate, least)

    def _spinning_step(self, a: Placed, b: Placed, time: float, end: float) -> float:
        """Return how long the circle around a body that turns often stays off the sides of another.

        It is 0 where there is none such. Without it, every turn before the impact would be
        examined.
        """
        often = [
            len(x.corners) > 1 and abs(x.state.angular_velocity) * (end - time) > math.tau
            for x in (a, b)
        ]
        if often[0] == often[1] or not (b if often[0] else a).core.sides:
            return 0.0
        a, b = (rounded(a), b) if often[0] else (a, rounded(b))
        axis = max(axes(a, b), key=_gap_of)
        if axis.gap <= 0:
            return 0.0
        return self._step_along(axis, gaps(a, b, axis), a, b, time, end)

    def _step_along(
        self,
        axis: Axis,
        near: list[Gap],
        a: Placed,
        b: Placed,
        time: float,
        end: float,
        *,
        relative: bool = False,
    ) -> float:
        """Return the safe step along one axis, from bounds over a window that suits it.

        The window is how long the step could be if what bounds it held on, as it is now; no longer
        one helps. Where gaps are `relative` to another corner, only turning changes them.
        """

        def smallest_root(window: float) -> float:
            bounds = self._bounds(time, time + window)
            least_of = LeastGapAcceleration(axis, a, b, *bounds, window, relative=relative)
            return min(_root(gap.value, gap.rate, least_of(gap)) for gap in near)

        longest = smallest_root(0.0)
        return min(longest, smallest_root(min(longest, end - time)))

    def _bounds(self, first: float, last: float) -> tuple[Bounds, Bounds]:
        path_a, path_b = self._paths
        return path_a.bounds(first, last), path_b.bounds(first, last)


def _step_beside(a: Placed, b: Placed, tolerance: float, longest: float) -> float:
    """Return a short time, s, in which a body goes on that is beside a piece of a chain.

    One that is in it has met a neighbour before.
    """
    if max(axis.gap for axis in axes(a, b)) < -4 * tolerance:
        return longest
    (au, av), (bu, bv) = a.state.velocity, b.state.velocity
    size = max(core.bounding_radius for core in (a.core, b.core) if core.dynamic)
    turning = sum(abs(x.state.angular_velocity) * x.core.bounding_radius for x in (a, b))
    speed = math.hypot(bu - au, bv - av) + turning
    return min(_BESIDE * size / speed, longest) if speed > 0 else longest


def _distinct(
    near: Sequence[Gap], contact: Contact, a: Placed, b: Placed, time: float
) -> list[Gap]:
    """Return the gaps of those corners that float64 can tell from the one of a contact."""
    q = a if contact.axis.swapped else b
    x, y = q.corners[contact.gap.which[1]]
    one = resolution(a, b, time)
    return [gap for gap in near if math.hypot(gap.corner[0] - x, gap.corner[1] - y) > one]


def _gap_of(axis: Axis) -> float:
    return axis.gap


def _root(value: float, rate: float, least: float) -> float:
    """Return the first time until which a gap may close, s, or infinity (DD46).

    A value that is 0 or, by rounding, less is being left: the rate is positive there.
    """
    inside = discriminant(value, rate, least)
    if inside < 0:
        if value > 0:
            return math.inf
        inside = discriminant(0.0, rate, least)
    if rate > 0:
        return float(advance_opening(rate, least, inside)) if least < 0 else math.inf
    if inside == rate == 0:
        return math.inf
    return float(advance_closing(value, rate, inside))
