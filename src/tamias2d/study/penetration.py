"""Whether bodies of a run overlap or pass through each other, looked for along the whole run.

It shares nothing with the search for impacts. Over an interval of time one direction must separate
two pieces at both ends and in the middle, by more than what the motion between these can bend;
otherwise the interval is halved. The directions that separate what does not pass follow from one
another without a jump: the opposite one, as below a line instead of above, is reached only around
its end. Only those are looked at whose swept boxes meet (`sweep`).
"""

from collections.abc import Callable, Iterator, Sequence
from itertools import product
from typing import NamedTuple

import numpy as np

from tamias2d.float64 import EPSILON
from tamias2d.motion import Stepped
from tamias2d.run import Run
from tamias2d.scene import Body, HalfPlane
from tamias2d.solve import sampler
from tamias2d.state import Array, History
from tamias2d.study.separation import Flags, SeparableHull, View, divided, hulls_of, joined, view
from tamias2d.study.sweep import beside, meeting, standing_box, swept_boxes

_TOUCH = 1e-9  # of the smaller size: overlaps less deep are touches
_PRESSED = 0.5  # the same where contacts are stepped, which press bodies into each other
_UNSEEN = 1e-6  # of the smaller size: by how much bodies may overlap between samples
_INTERVALS = 240  # of the run, at least, from which halving starts
_HALVINGS = 44
_MOST = 2**16  # intervals of one pair that are still halved
_BODIES = 100  # more than these are a crowd
_TURN = 0.5  # cosine: by how much a direction may turn in half an interval


_Sampler = Callable[[Array, Sequence[int]], History]


class Penetration(NamedTuple):
    """Two bodies that are where solid ones cannot be."""

    bodies: tuple[int, int]
    time: float
    """When it is first seen, s."""
    depth: float
    """How deep they overlap then, m; 0 where one passes through the other unseen."""


class _Leaf(NamedTuple):
    """Intervals that need not be halved any more."""

    start: Array
    """(k,), s"""
    end: Array
    seen: View
    """At the starts."""
    separating: Flags
    """(k, c): which directions separate at the start"""
    common: Flags
    """(k, c): which do so all along"""


def penetrations(run: Run) -> Iterator[Penetration]:
    """Go through the pairs of pieces that overlap or pass through each other."""
    bodies = run.scene.bodies
    solid = [k for k, body in enumerate(bodies) if body.shape is not None and not body.sensor]
    of = {k: hulls_of(k, bodies[k]) for k in solid}
    if not any(bodies[k].dynamic for k in solid):
        return
    sample, nodes = sampler(run), _Nodes(run)
    share = _PRESSED if isinstance(run.method, Stepped) else _TOUCH
    for i, j, chosen in _near_bodies(run, of, sample, nodes):
        times = nodes.within((i, j), chosen)
        both = sample(times, (i, j))
        for a, b in product(of[i], of[j]):
            pair, history = (a, b), both
            if b.offset is not None:
                pair, history = (b, a), _exchanged(both)
            near = _near(*pair, times, history) & nodes.chosen(times[:-1], chosen)
            if near.any():
                touch, unseen = _tolerances(*pair, share, times, history)
                search = _Search(*pair, sample, touch, unseen)
                if found := search.first(times[:-1][near], times[1:][near]):
                    yield found


def crowded(run: Run) -> bool:
    """Whether a run has so many bodies that it takes long to look."""
    solid = sum(body.shape is not None for body in run.scene.bodies)
    return solid > _BODIES


class _Nodes:
    """The times from which the search starts: marks of all bodies, and impacts of each."""

    def __init__(self, run: Run) -> None:
        end = float(run.times[-1])
        known = np.unique(np.concatenate((run.times, np.linspace(0.0, end, _INTERVALS + 1))))
        self.marks = known[known <= end]
        early = run.impacts.time <= end
        self._impacts = run.impacts.time[early]
        order = np.argsort(run.impacts.bodies[early].ravel(), kind="stable")
        self._struck = run.impacts.bodies[early].ravel()[order]
        self._of = order // 2

    def of(self, *bodies: int) -> Array:
        """Return all times of some bodies, s."""
        ends = [np.searchsorted(self._struck, (body, body + 1)) for body in bodies]
        struck = [self._impacts[self._of[first:last]] for first, last in ends]
        return np.unique(np.concatenate((self.marks, *struck)))

    def within(self, bodies: tuple[int, int], chosen: Flags) -> Array:
        """Return those of some bodies in, and at the ends of, chosen intervals of marks, s."""
        times = self.of(*bodies)
        inside = self.chosen(times, chosen)
        inside[1:] |= self.chosen(times[:-1], chosen)
        found: Array = times[inside]
        return found

    def chosen(self, times: Array, chosen: Flags) -> Flags:
        """Return (k,): whether intervals that begin at times, s, are in chosen ones of marks."""
        place = np.searchsorted(self.marks, times, side="right") - 1
        found: Flags = np.append(chosen, False)[place]
        return found


def _near_bodies(
    run: Run, of: dict[int, list[SeparableHull]], sample: _Sampler, nodes: _Nodes
) -> Iterator[tuple[int, int, Flags]]:
    """Go through pairs of bodies that must not overlap, and in which intervals they come near."""
    bodies = run.scene.bodies
    boxed = [k for k in of if not isinstance(bodies[k].shape, HalfPlane)]
    boxes = [_boxes(k, bodies[k], of[k], sample, nodes) for k in boxed]
    low, high = (np.stack([box[side] for box in boxes]) for side in (0, 1))
    near = {(boxed[a], boxed[b]): chosen for (a, b), chosen in meeting(low, high).items()}
    for k in of:
        shape = bodies[k].shape
        if isinstance(shape, HalfPlane):
            reached = beside(shape, low, high)
            near |= {(k, boxed[n]): reached[n] for n in np.flatnonzero(reached.any(axis=1))}
    for (i, j), chosen in sorted(near.items(), key=lambda item: item[0]):
        if (bodies[i].dynamic or bodies[j].dynamic) and run.scene.collides(i, j):
            yield i, j, chosen


def _boxes(
    index: int, body: Body, parts: list[SeparableHull], sample: _Sampler, nodes: _Nodes
) -> tuple[Array, Array]:
    """Return the least and the largest (i, 2), m, that a body reaches in each interval of marks."""
    if not (body.dynamic or body.kinematic):
        low, high = standing_box(body, parts)
        shape = (len(nodes.marks) - 1, 2)
        return np.broadcast_to(low, shape), np.broadcast_to(high, shape)
    times = nodes.of(index)
    history = sample(times, (index,))
    reach = max(part.reach + part.radius for part in parts)
    return swept_boxes(nodes.marks, times, history.position[:, 0], history.velocity[:, 0], reach)


def _exchanged(history: History) -> History:
    """Return the history of two bodies, the second one first."""
    return History(*(part[:, ::-1] for part in history))


def _near(a: SeparableHull, b: SeparableHull, nodes: Array, history: History) -> Flags:
    """Return (k - 1,): in which intervals a pair may come near, by circles around both."""
    between = history.position[:, 1] - history.position[:, 0]
    if a.offset is None:
        away = np.hypot(*between.T) - a.reach - a.radius - b.reach - b.radius
    else:
        away = between @ a.normals[0] - a.offset - b.reach - b.radius
    speed = np.linalg.norm(history.velocity, axis=-1).sum(axis=1)
    way = np.hypot(*np.diff(between, axis=0).T) + np.diff(nodes) * np.maximum(speed[1:], speed[:-1])
    near: Flags = np.minimum(away[1:], away[:-1]) <= 2 * way
    return near


def _tolerances(
    a: SeparableHull, b: SeparableHull, share: float, nodes: Array, history: History
) -> tuple[float, float]:
    """Return the overlap that counts as a touch, and the one that may go unseen, m."""
    size = min(a.size, b.size)
    far = float(np.abs(history.position).max())
    wide = b.reach + b.radius + (a.reach + a.radius if a.offset is None else abs(a.offset))
    fast = float(np.abs(history.velocity).max())
    blur = EPSILON * (64 * (far + wide) + 16 * fast * float(nodes[-1]))
    return share * size + blur, max(share, _UNSEEN) * size + blur


class _Search:
    """Two pieces along a run."""

    def __init__(
        self,
        a: SeparableHull,
        b: SeparableHull,
        sample: _Sampler,
        touch: float,
        unseen: float,
    ) -> None:
        self._a, self._b = a, b
        self._sample = sample
        self._touch, self._unseen = touch, unseen

    def first(self, start: Array, end: Array) -> Penetration | None:
        """Return what is wrong within the intervals from `start` to `end` (k,), s, or None."""
        leaves = []
        for level in range(_HALVINGS):
            middle = start + (end - start) / 2
            times = np.concatenate((start, middle, end))
            seen = view(self._a, self._b, self._states(times))
            if (found := self._overlap(times, seen)) is not None:
                return found
            common, clear = self._common(seen, len(start))
            last = level == _HALVINGS - 1 or len(start) > _MOST
            done = np.asarray(clear | (middle <= start) | (middle >= end) | last)
            first = seen.rows(slice(len(start))).rows(np.flatnonzero(done))
            leaves.append(
                _Leaf(start[done], end[done], first, self._separating(first), common[done])
            )
            if done.all():
                break
            left = ~done
            start, end = (
                np.concatenate((start[left], middle[left])),
                np.concatenate((middle[left], end[left])),
            )
        return self._jump(leaves)

    def _states(self, times: Array) -> History:
        """Return the states of both bodies at times (k,) of any order, s."""
        known, back = np.unique(times, return_inverse=True)
        history = self._sample(known, (self._a.body, self._b.body))
        return History(*(part[back] for part in history))

    def _separating(self, seen: View) -> Flags:
        found: Flags = seen.separation >= -self._touch
        return found

    def _named(self, time: float, depth: float) -> Penetration:
        return Penetration(tuple(sorted((self._a.body, self._b.body))), time, depth)  # type: ignore[arg-type]

    def _overlap(self, times: Array, seen: View) -> Penetration | None:
        """Return the earliest overlap at one of the times."""
        depth = -seen.separation.max(axis=1)
        deep = np.flatnonzero(depth > self._touch)
        if not len(deep):
            return None
        k = deep[np.argmin(times[deep])]
        return self._named(float(times[k]), float(depth[k]))

    def _common(self, seen: View, count: int) -> tuple[Flags, Flags]:
        """Return which directions separate all along (k, c), and if some surely does (k,)."""
        one, two, three = (seen.rows(slice(k * count, (k + 1) * count)) for k in range(3))
        common = np.ones(one.separation.shape, dtype=bool)
        for each in (one, two, three):
            common &= self._separating(each)
        for first, second in ((one, two), (two, three)):
            common &= (first.directions * second.directions).sum(axis=-1) > _TURN
        least = np.minimum(np.minimum(one.separation, two.separation), three.separation)
        with np.errstate(over="ignore", invalid="ignore"):  # a bend without bound is never clear
            clear = common & (least - self._bend(one, two, three) >= -self._unseen)
        return common, np.any(clear, axis=1)

    def _bend(self, one: View, two: View, three: View) -> Array:
        """Return (k, c), m: how far separations may lie below those at the ends and between."""
        reach = np.array([self._a.reach if self._a.offset is None else 0.0, self._b.reach])
        sag = np.hypot(*(two.between - (one.between + three.between) / 2).T)[:, None]
        way = np.hypot(*(three.between - one.between).T)[:, None]
        turns = np.abs(three.angles - one.angles)
        arcs = (turns * reach).sum(axis=1)[:, None]
        far = np.hypot(*two.between.T)[:, None] + reach.sum()
        owners = [0] * len(self._a.normals) + [1] * len(self._b.normals)
        turn = turns[:, owners[: one.distance.shape[1]]]
        normals = turn**2 * far + 2 * turn * (way + sag + arcs)
        least = np.minimum(np.minimum(one.distance, two.distance), three.distance)
        lines = (way + arcs) ** 2 / np.maximum(least[:, turn.shape[1] :], 1e-300)
        own = np.concatenate((normals, lines), axis=1)
        corners = (reach * turns**2).sum(axis=1)[:, None]
        bend: Array = (sag + corners / 8 + own / 8) / 2
        return bend

    def _jump(self, leaves: list[_Leaf]) -> Penetration | None:
        """Return the first interval that no direction separates from what was reached before."""
        start = np.concatenate([leaf.start for leaf in leaves])
        order = np.argsort(start)
        end = np.concatenate([leaf.end for leaf in leaves])[order]
        start = start[order]
        columns = zip(*(leaf.seen for leaf in leaves), strict=True)
        seen = View(*(np.concatenate(column)[order] for column in columns))
        separating = np.concatenate([leaf.separating for leaf in leaves])[order]
        common = np.concatenate([leaf.common for leaf in leaves])[order]
        lost = ~common.any(axis=1)
        if divided(separating, seen).any():
            lost = self._lost(start, end, seen, separating, common)
        return self._named(float(end[np.argmax(lost)]), 0.0) if lost.any() else None

    def _lost(
        self, start: Array, end: Array, seen: View, separating: Flags, common: Flags
    ) -> Flags:
        """Return (k,): after which intervals nothing that was reached separates."""
        lost = np.zeros(len(start), dtype=bool)
        reached = separating[0]
        for k in range(len(start)):
            if k and end[k - 1] != start[k]:
                reached = separating[k]
            reached = joined(reached, separating[k], seen.directions[k]) & common[k]
            if not reached.any():
                lost[k] = True
                break
        return lost
