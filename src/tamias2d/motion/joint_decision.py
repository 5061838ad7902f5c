"""What the joints of a mechanism do at an instant: who bounces, who rests, who gives way (GD21-23).

Serves: mechanisms whose joints have limits or motors, or break. Hides: that all who could push are
asked at once, by Gauss's principle.
"""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from tamias2d.generated import impact, rest
from tamias2d.motion.bounded_least import bounded_shares, bounded_sum
from tamias2d.motion.joint_events import STRIKES, JointEvent, Mode, Of
from tamias2d.motion.joint_instant import Cause, Now, Side
from tamias2d.motion.limited_mechanism import LimitedMechanism
from tamias2d.motion.mechanism import JointError
from tamias2d.scene.freedoms import last_tooth
from tamias2d.state import Array

_NOISE = 1e-10  # of the speeds that make up a rate
_ROUNDING = 1e-14  # of the speeds that there have been
_SHARE = 1e-12  # of the largest force, or of the most that a motor exerts: more is no rounding


def begin(mechanism: LimitedMechanism, now: Now, *, anew: bool = False) -> Array:
    """Decide what the joints do from now on; return the velocities (n, 3) after it.

    What was decided for later is forgotten: a path may be found anew after an impact. What broke
    at this time is asked `anew` where it was not known what contacts bear.

    Raises:
        JointError: everything breaks.
    """
    cause = mechanism.rewind(now.time)
    known = mode = mechanism.mode(now.time)
    if anew:
        mode = replace(mode, broken=mechanism.broken_before(now.time))
    decision = Decision(mechanism, now, mode, cause or Cause(now.time))
    if mechanism.begun and cause is None and mode == known and not decision.disturbed():
        return now.velocity
    velocity, strikes = decision.impacts()
    mode = decision.mode()
    mechanism.enter(now.time, mode, strikes, decision.borne)
    return mechanism.within(mode).paced(now.time, now.position, velocity)


class Decision:
    """What follows at one instant."""

    def __init__(self, mechanism: LimitedMechanism, now: Now, mode: Mode, cause: Cause) -> None:
        """Take a mechanism, its state, its mode before and why it is asked."""
        self._mechanism = mechanism
        self._now = now
        self._cause = cause
        self._base = self._with_teeth(mode.without(cause.breaks))
        self._slopes = mechanism.measures.slopes(now.time, now.position)
        self._values = mechanism.measures.values(now.time, now.position)
        self._rates = mechanism.measures.rates(now.time, now.position, now.velocity)
        self._noise = self._noises()
        self.borne: dict[int, float] = {}
        """By joints that break at more than they bear, at which share of it."""

    def disturbed(self) -> bool:
        """Whether something beside the joints has ended what they do, such as an impact.

        They would have told of the end of it themselves before it came about.
        """
        mode = self._base
        return (
            any(self._moved(of, side) for of, side in self._mechanism.sides(mode))
            or any(self._turned(of, how) for of, how in mode.driven if of[0] not in mode.broken)
            or self._overpressed()
            or bool(self._mechanism.overloaded(self._now, mode))
        )

    def _moved(self, of: Of, side: int) -> bool:
        """Whether a limit is struck, or left by a rate."""
        rate, noise = self._rate(of), self._noise_of(of)
        if (of, side) in self._base.held:
            return abs(rate) > noise
        return self._touches(of, side) and side * rate > noise

    def _turned(self, of: Of, sense: int) -> bool:
        """Whether a motor lags where it kept its speed, or is past it where it pushed."""
        lag, noise = self._lag(of), self._noise_of(of)
        if not sense:
            return abs(lag) > noise
        at_limit = self._base.held & {(of, -1), (of, 1)}  # which keeps it where it is
        return not at_limit and sense * lag < -noise

    def _overpressed(self) -> bool:
        """Whether a limit that holds would have to pull, or a motor to push beyond its maximum."""
        shares = self._mechanism.shares(self._now, self._base)
        slight = _SHARE * max(map(abs, shares.values()), default=0.0)
        for pusher, share in shares.items():
            if pusher[0] == "limit":
                if share < -slight:
                    return True
            elif abs(share) > self._mechanism.most(pusher[1]) * (1 + _SHARE):
                return True
        return False

    def impacts(self) -> tuple[Array, list[JointEvent[int]]]:
        """Return the velocities (n, 3) after limits were struck, and the events."""
        touched = [
            (of, side)
            for of, side in self._mechanism.sides(self._base)
            if (of, side) in self._cause.reached or self._touches(of, side)
        ]
        if not any(side * self._rate(of) > self._noise_of(of) for of, side in touched):
            self._resting = [side for side in touched if self._still(side)]
            return self._now.velocity, []
        after, shares = self._rebound(touched, frozenset())
        if low := self._low(touched, after):
            after, shares = self._rebound(touched, low)
        self._now = self._now._replace(velocity=after)
        self._rates = self._mechanism.measures.rates(*self._now[:3])
        self._resting = [side for side in touched if self._still(side)]
        return after, [
            JointEvent(self._now.time, of[0], of[1], STRIKES + (side > 0), share)
            for (of, side), share in zip(touched, shares, strict=True)
            if share > 0
        ]

    def mode(self) -> Mode:
        """Return what the joints do from here on, after the impacts.

        Raises:
            JointError: what is left should break, too, and nothing is left.
        """
        for _ in range(len(self._mechanism.joints) + 1):
            mode = self._balanced()
            broken = self._mechanism.overloaded(self._now, mode)
            if not broken:
                return mode
            self.borne |= broken
            self._base = self._base.without(broken)
            self._resting = [side for side in self._resting if side[0][0] not in broken]
        raise JointError(
            f"joints at {self._now.time!r} s: all have broken, and still more should (GD23). End "
            "the run before."
        )

    def _with_teeth(self, mode: Mode) -> Mode:
        """Return a mode with the teeth that ratchets are on."""
        mechanism = self._mechanism
        teeth = {**dict(mode.teeth), **self._cause.clicks}
        for of, each in mechanism.freedoms.items():
            if each.pitch is not None and of not in teeth:
                values = mechanism.measures.values(self._now.time, self._now.position)
                teeth[of] = last_tooth(float(values[mechanism.row[of]]), each.pitch)
        return replace(mode, teeth=tuple(teeth.items()))

    def _noises(self) -> Array:
        """Return how large a rate of each freedom counts as none.

        It is a share of the speeds that make it up, and of those that there have been, or that the
        loads give over its length, be it by way of other bodies: what is held at rest has no speed
        but by rounding.
        """
        mechanism, slopes = self._mechanism, np.abs(self._slopes)
        length, free = mechanism.length(self._now.position), np.abs(self._now.free)
        strength = free[:, :2].max(initial=0.0) + length * free[:, 2].max(initial=0.0)
        size = np.einsum("ijk,jk->i", slopes, np.abs(self._now.velocity))
        pull = np.einsum("ijk,jk->i", slopes, free)
        for of, row in mechanism.row.items():
            size[row] += abs(mechanism.motor_speed(of))
            angle = mechanism.freedoms[of].measure == "angle"
            pull[row] *= 1.0 if angle else length
            pull[row] = max(pull[row], strength / length if angle else strength * length)
        mechanism.fastest = np.maximum(mechanism.fastest, size)
        noise: Array = _NOISE * size + _ROUNDING * (mechanism.fastest + np.sqrt(pull)) + 1e-300
        mechanism.noise = noise
        return noise

    def _noise_of(self, of: Of) -> float:
        return float(self._noise[self._mechanism.row[of]])

    def _rate(self, of: Of) -> float:
        return float(self._rates[self._mechanism.row[of]])

    def _lag(self, of: Of) -> float:
        return self._mechanism.motor_speed(of) - self._rate(of)

    def _still(self, side: Side) -> bool:
        return abs(self._rate(side[0])) <= self._noise_of(side[0])

    def _touches(self, of: Of, side: int) -> bool:
        mechanism = self._mechanism
        beyond = side * (self._values[mechanism.row[of]] - mechanism.end(of, side, self._base))
        return bool(beyond >= -mechanism.slight(of, self._now.position))

    def _rebound(self, touched: Sequence[Side], low: frozenset[Side]) -> tuple[Array, list[float]]:
        """Return the velocities after impacts on limits, and their impulses (GD21).

        Those whose bounce would be too `low` keep no rate, wherever it comes from.
        """
        mechanism, now = self._mechanism, self._now
        rows, ends = mechanism.stiff(now.time, now.position, self._base, touched)
        wanted, lower = np.zeros(len(rows)), np.full(len(rows), -np.inf)
        for k, (side, rate) in enumerate(zip(ends, rows @ now.velocity.ravel(), strict=True)):
            limits = side and mechanism.freedoms[side[0]].limits
            if side in low:
                wanted[k] = -rate
            elif limits:
                lower[k] = 0.0
                wanted[k] = impact.impulse(limits.restitution, float(rate), 1.0)
                wanted[k] = wanted[k] if rate < 0 else -rate
        change, shares = bounded_sum(rows, mechanism.inverse, wanted, lower)
        pushes = [float(s) for s, side in zip(shares, ends, strict=True) if side is not None]
        return now.velocity + change, pushes

    def _low(self, touched: Sequence[Side], velocity: Array) -> frozenset[Side]:
        """Return the limits whose next bounce is too low to be told from none.

        The others hold meanwhile, where they rest: so a body that rocks on two ends comes to rest.
        """
        mechanism = self._mechanism
        now = self._now._replace(velocity=velocity)
        rates = mechanism.measures.rates(*now[:3])
        resting = [s for s in touched if abs(rates[mechanism.row[s[0]]]) <= self._noise_of(s[0])]
        by = mechanism.accelerated(now, replace(self._base, held=frozenset(resting)))
        bend = np.einsum("ijk,jk->i", self._slopes, by)
        bend = bend + mechanism.measures.convective(*now[:3])
        found: set[Side] = set()
        for of, side in touched:
            row = mechanism.row[of]
            rate, falls = -side * rates[row], -side * bend[row]
            if rate > self._noise_of(of) and falls < 0:
                height = float(rest.bounce_height(rate, falls))
                if height <= mechanism.slight(of, now.position):
                    found.add((of, side))
        return frozenset(found)

    def _balanced(self) -> Mode:
        """Return the limits that hold and what motors do, by Gauss's principle."""
        base = self._base
        resting = [side for side in self._resting if side not in self._cause.left]
        driven: dict[Of, int] = {}
        kept: list[Of] = []
        for of, each in self._mechanism.freedoms.items():
            if each.motor is None or of[0] in base.broken:
                continue
            if of in self._cause.slips:
                driven[of] = self._cause.slips[of]
            elif (
                each.motor.maximum is None
                or of in self._cause.arrives
                or abs(self._lag(of)) <= self._noise_of(of)
            ):
                kept.append(of)
            else:
                driven[of] = 1 if self._lag(of) > 0 else -1
        bare = replace(base, held=frozenset(), driven=tuple(sorted(driven.items())))
        if not resting and not kept:
            return bare
        at = self._bounds_met(bare, resting, kept)
        held = {side for side, met in zip(resting, at, strict=False) if not met}
        driven |= dict(zip(kept, at[len(resting) :], strict=True))
        return replace(base, held=frozenset(held), driven=tuple(sorted(driven.items())))

    def _bounds_met(self, bare: Mode, resting: Sequence[Side], kept: Sequence[Of]) -> list[int]:
        """Return at which of their bounds the pushes of limits, then of motors, are."""
        mechanism, now = self._mechanism, self._now
        own = mechanism.within(bare).rows
        more = [(-side, mechanism.row[of]) for of, side in resting]
        more += [(1, mechanism.row[of]) for of in kept]
        bends = mechanism.measures.convective(*now[:3])
        rows = np.array(
            [*own.slopes(now.time, now.position), *(sign * self._slopes[k] for sign, k in more)]
        ).reshape(-1, now.position.size)
        convective = np.array([*own.convective(*now[:3]), *(sign * bends[k] for sign, k in more)])
        most = [mechanism.most(of) for of in kept]
        stiff = np.full(own.count, np.inf)
        lower = np.array([*-stiff, *[0.0] * len(resting), *(-m for m in most)])
        upper = np.array([*stiff, *[np.inf] * len(resting), *most])
        wanted = -(rows @ mechanism.pulled(now, bare).ravel() + convective)
        _, at = bounded_shares(rows * np.sqrt(mechanism.inverse).ravel(), wanted, lower, upper)
        found: list[int] = at[own.count :].tolist()
        return found
