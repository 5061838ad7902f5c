"""The search for the next instant at which joints do something else (GD21, GD22, GD23)."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from tamias2d.motion.joint_events import Mode, Of
from tamias2d.motion.joint_instant import Cause, Now, Side
from tamias2d.motion.limited_mechanism import LimitedMechanism, Pusher
from tamias2d.motion.polynomial import DenseStep
from tamias2d.state import Array

LOOKS = 16  # in each step; between two of them a push may not sink below zero and rise again
_NEAREST = 2.0**-20  # of a step: looks at a distance that turns around are no closer
_MOST = 1000  # trials of a zero; in a bounce far shorter than the step it takes more than 100
_FORCE = 1e-10  # of the largest; a smaller one is as good as none
Free = Callable[[float, Array, Array], Array]
"""Accelerations (n, 3) by the loads alone."""


@dataclass(frozen=True)
class _Watch:
    """A number that is positive until something happens."""

    value: Callable[["_Look"], float]
    cause: Callable[[float], Cause]
    slight: float | None
    """So much counts as none; None for a share of the largest."""
    rate: Callable[["_Look"], float] | None = None


class _Look:
    """A mechanism at one time of a step, as far as it is asked for."""

    def __init__(self, search: "JointSearch", time: float) -> None:
        self.time = time
        self._search = search
        self._all = search.step.at(time)
        self._state = self._all[0][search.own], self._all[1][search.own]

    @cached_property
    def values(self) -> Array:
        """Where the freedoms are, rad or m."""
        return self._search.mechanism.measures.values(self.time, self._state[0])

    @cached_property
    def slopes(self) -> Array:
        """How they change with the coordinates (m, n, 3)."""
        return self._search.mechanism.measures.slopes(self.time, self._state[0])

    @cached_property
    def rates(self) -> Array:
        """Their rates, rad/s or m/s."""
        return self._search.mechanism.measures.rates(self.time, *self._state)

    @cached_property
    def shares(self) -> dict[Pusher, float]:
        """What limits and motors exert, N m or N."""
        return self._search.mechanism.shares(self._now, self._search.mode)

    @cached_property
    def spare(self) -> dict[int, float]:
        """What each joint that may break could still bear, as a share."""
        return self._search.mechanism.spare(self._now, self._search.mode)

    @cached_property
    def _now(self) -> Now:
        search = self._search
        free = search.free(self.time, *self._all)[search.own]
        held = search.mechanism.within(search.mode).fitted(self.time, *self._state)
        return Now(self.time, *held, free)


class JointSearch:
    """The first event of one mechanism within a step."""

    def __init__(
        self, mechanism: LimitedMechanism, own: Sequence[int], free: Free, step: DenseStep
    ) -> None:
        """Take a mechanism, the places of its bodies in the step, and the loads."""
        self.mechanism, self.own, self.free, self.step = mechanism, list(own), free, step
        self.mode: Mode = mechanism.mode(step.start)
        self._watches = list(self._all())

    def first(self) -> tuple[float, _Watch] | None:
        """Return when something happens first, s, and what."""
        if not self._watches:
            return None
        looks = self._looks()
        found: list[tuple[float, int]] = []
        for k, watch in enumerate(self._watches):
            time = self._crossing(watch, looks)
            if time is not None:
                found.append((time, k))
        if not found:
            return None
        time, k = min(found)
        return time, self._watches[k]

    def _looks(self) -> list[_Look]:
        """Return looks, so close that none of the shortest distances is passed through unseen."""
        times = np.linspace(self.step.start, self.step.end, LOOKS + 1).tolist()
        looks = [_Look(self, time) for time in times]
        rows = [
            self.mechanism.row[of]
            for of, side in self.mechanism.sides(self.mode)
            if side < 0 and self.mechanism.freedoms[of].measure == "distance"
        ]
        if not rows:
            return looks
        closer = [looks[0]]
        for look in looks[1:]:
            closer += [*self._between(closer[-1], look, rows), look]
        return closer

    def _between(self, first: _Look, last: _Look, rows: list[int]) -> Iterator[_Look]:
        """Yield looks from one to another, until no distance turns by a right angle in between."""
        turned = (first.slopes[rows] * last.slopes[rows]).sum(axis=(1, 2))
        near = last.time - first.time <= _NEAREST * (self.step.end - self.step.start)
        if near or (turned > 0).all():
            return
        middle = _Look(self, (first.time + last.time) / 2)
        yield from self._between(first, middle, rows)
        yield middle
        yield from self._between(middle, last, rows)

    def zero(self, watch: _Watch) -> float:
        """Return where what is watched is zero near the end of the step, s: found along a line."""
        end = self.step.end
        before = end - 1e-3 * (end - self.step.start)
        if not before < end:
            return end
        last = self.value(watch, end)
        slope = (last - self.value(watch, before)) / (end - before)
        return end if slope >= 0 or not np.isfinite(slope) else end - last / slope

    def value(self, watch: _Watch, time: float) -> float:
        """Return what is watched at a time of the step, s."""
        return watch.value(_Look(self, time))

    def _crossing(self, watch: _Watch, looks: Sequence[_Look]) -> float | None:
        values = [watch.value(look) for look in looks]
        most = max((abs(v) for v in values if np.isfinite(v)), default=0.0)
        slight = _FORCE * most if watch.slight is None else watch.slight
        fresh = values[0] <= slight
        for k in range(1, len(looks)):
            below = -slight if fresh else 0.0
            first, last = looks[k - 1].time, looks[k].time
            if watch.rate and values[k] >= below and not fresh:
                last = self._lowest(watch, watch.rate, looks[k - 1], looks[k])
            if self.value(watch, last) < below if last != looks[k].time else values[k] < below:
                if watch.rate and watch.rate(looks[k - 1]) > 0 > watch.rate(looks[k]):
                    first = self._turn(watch.rate, first, last)  # it grew at first
                return self._root(watch, first, last, below)
            fresh = fresh and values[k] <= slight
        return None

    def _lowest(
        self, watch: _Watch, rate: Callable[[_Look], float], first: _Look, last: _Look
    ) -> float:
        """Return where a gap is smallest between two looks, if it could close between them."""
        falls, rises, span = rate(first), rate(last), last.time - first.time
        if not falls < 0 < rises:
            return last.time
        if watch.value(first) + falls * span > 0 and watch.value(last) - rises * span > 0:
            return last.time
        return self._turn(rate, first.time, last.time)

    def _turn(self, rate: Callable[[_Look], float], first: float, last: float) -> float:
        """Return where a gap is smallest or largest between two times, s.

        A distance of zero, which is smallest, has no rate.
        """

        def known(time: float) -> float:
            found = rate(_Look(self, time))
            return found if np.isfinite(found) else 0.0

        return _zero(known, first, last)

    def _root(self, watch: _Watch, first: float, last: float, below: float) -> float:
        if self.value(watch, first) <= below:
            return first
        return _zero(lambda t: self.value(watch, t) - below, first, last)

    def _all(self) -> Iterator[_Watch]:
        mode, mechanism = self.mode, self.mechanism
        place = self.step.first[0][self.own]
        for of, side in mechanism.sides(mode):
            yield self._of_limit(of, side, mechanism.slight(of, place))
        for of, each in mechanism.freedoms.items():
            if each.pitch is not None and of[0] not in mode.broken:
                yield self._of_tooth(of, each.pitch)
        for of, sense in mode.driven:
            most = mechanism.most(of)
            if not np.isfinite(most) or of[0] in mode.broken:
                continue
            if sense and mode.held & {(of, -1), (of, 1)}:
                continue  # its limit keeps it where it is
            if sense:
                yield self._of_slipping(of, sense)
            else:
                yield from (self._of_keeping(of, one, most) for one in (-1, 1))
        yield from map(self._of_breaking, mechanism.breaking(mode))

    def _of_breaking(self, number: int) -> _Watch:
        return _Watch(
            lambda look: look.spare[number],
            lambda t: Cause(t, breaks=frozenset({number})),
            1e-12,
        )

    def _of_limit(self, of: Of, side: int, slight: float) -> _Watch:
        at: Side = (of, side)
        row, end = self.mechanism.row[of], self.mechanism.end(of, side, self.mode)
        if at in self.mode.held:
            return _Watch(
                lambda look: look.shares["limit", at],
                lambda t: Cause(t, left=frozenset({at})),
                None,
            )
        return _Watch(
            lambda look: -side * (float(look.values[row]) - end),
            lambda t: Cause(t, reached=frozenset({at})),
            slight,
            lambda look: -side * float(look.rates[row]),
        )

    def _of_tooth(self, of: Of, pitch: float) -> _Watch:
        row, tooth = self.mechanism.row[of], self.mechanism.end(of, -1, self.mode)
        return _Watch(
            lambda look: tooth + pitch - float(look.values[row]),
            lambda t: Cause(t, clicks={of: tooth + pitch}),
            1e-12,
        )

    def _of_slipping(self, of: Of, sense: int) -> _Watch:
        row, speed = self.mechanism.row[of], self.mechanism.motor_speed(of)
        return _Watch(
            lambda look: sense * (speed - float(look.rates[row])),
            lambda t: Cause(t, arrives=frozenset({of})),
            float(self.mechanism.noise[row]),
        )

    def _of_keeping(self, of: Of, sense: int, most: float) -> _Watch:
        return _Watch(
            lambda look: 1 - sense * look.shares["motor", of] / most,
            lambda t: Cause(t, slips={of: sense}),
            1e-12,
        )


def _zero(function: Callable[[float], float], first: float, last: float) -> float:
    """Return where a function of the time changes its sign between two times, s, to rounding."""
    from scipy.optimize import brentq

    found: float = brentq(
        function, first, last, xtol=1e-300, rtol=4 * float(np.finfo(float).eps), maxiter=_MOST
    )
    return found
