"""How a motion that is a little ahead of a path comes through an impact of it (saltation).

It meets a little earlier or later. So it is moved to where its own gap is closed, answered there by
the same rule, and moved back to the time of the path's impact (Müller, Calculation of Lyapunov
exponents for dynamic systems with discontinuities, Chaos, Solitons & Fractals 5, 1995).
"""

from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np

from tamias2d.contact.core import Core, Placed, place
from tamias2d.contact.frictional_impact import after_frictional_impulse, frictional_impulses
from tamias2d.contact.gap import gaps
from tamias2d.contact.manifold import Contact, normal_velocity, refreshed
from tamias2d.contact.response import after_impulse, impulses
from tamias2d.generated import rotation, translation
from tamias2d.state import Acceleration, Array, State

_TRIALS = 4  # of Newton's method, which begins as near as the motion is to the path
_SLOWER = 0.5  # times as fast as the path a motion meets at least: else it may not meet at all


class SingleImpact(NamedTuple):
    """An impact at one point, beside which nothing happens to its bodies."""

    time: float
    """s"""
    contact: Contact
    restitution: float
    friction: float


class Passing(NamedTuple):
    """The path of a body just before and just after an impact."""

    before: State
    pull_before: Acceleration
    after: State
    pull_after: Acceleration


def after_impact(
    cores: Sequence[Core],
    met: SingleImpact,
    paths: Mapping[int, Passing],
    ahead: Mapping[int, Array],
) -> tuple[float, dict[int, Array]] | None:
    """Return how much later, s, the motion meets, and how far it is ahead of the path afterwards.

    `ahead` is how far it was before: coordinates and rates (2, 3) of each of the bodies that move.
    Nothing is returned where it may not meet.
    """
    contact = met.contact
    pair = contact.a, contact.b
    states = [paths[i].before for i in pair]
    path_gap, path_rate = _gap(cores, contact, states), normal_velocity(contact, *states)
    delay = 0.0
    for _ in range(_TRIALS):
        states = [_moved(cores[i], paths[i], ahead.get(i), delay) for i in pair]
        touch = _touching(cores, contact, states)
        rate = normal_velocity(touch, *states)
        if not rate < _SLOWER * path_rate < 0:
            return None
        delay -= (_gap(cores, touch, states) - path_gap) / rate
    states = [_moved(cores[i], paths[i], ahead.get(i), delay) for i in pair]
    touch = _touching(cores, contact, states)
    answered = _answered(cores, touch, states, met)
    return delay, {
        i: _rows(_later(state, -delay, paths[i].pull_after)) - _rows(paths[i].after)
        for i, state in zip(pair, answered, strict=True)
        if cores[i].dynamic
    }


def _answered(
    cores: Sequence[Core], touch: Contact, states: Sequence[State], met: SingleImpact
) -> tuple[State, State]:
    """Return the states of both bodies after their impact."""
    a, b = states
    if met.friction:
        (both,) = frictional_impulses(cores, [touch], a, b, met.restitution, met.friction)
        return after_frictional_impulse(cores, touch, both, a, b)
    (impulse,) = impulses(cores, [touch], a, b, met.restitution)
    return after_impulse(cores, touch, impulse, a, b)


def _rows(state: State) -> Array:
    """Return coordinates and rates (2, 3)."""
    return np.array(
        [(*state.position, state.orientation), (*state.velocity, state.angular_velocity)]
    )


def _later(state: State, time: float, pull: Acceleration) -> State:
    """Return the state after a time, s, under a constant acceleration (IM1, IM2)."""
    position, turn, velocity, spin = state
    return State(
        translation.position(position, velocity, pull[:2], time),
        rotation.orientation(turn, spin, pull[2], time),
        translation.velocity(velocity, pull[:2], time),
        rotation.angular_velocity(spin, pull[2], time),
    )


def _moved(core: Core, path: Passing, ahead: Array | None, later: float) -> State:
    """Return the state of a body of the motion some time, s, after the path's impact, or before."""
    if not core.dynamic or ahead is None:
        return path.before
    (x, y, turn), (u, v, spin) = (_rows(path.before) + ahead).tolist()
    return _later(State((x, y), turn, (u, v), spin), later, path.pull_before)


def _placed(cores: Sequence[Core], contact: Contact, states: Sequence[State]) -> list[Placed]:
    return [place(cores[i], state) for i, state in zip((contact.a, contact.b), states, strict=True)]


def _touching(cores: Sequence[Core], contact: Contact, states: Sequence[State]) -> Contact:
    """Return the contact of the same corners and sides where the bodies are."""
    return refreshed(contact, *_placed(cores, contact, states))


def _gap(cores: Sequence[Core], contact: Contact, states: Sequence[State]) -> float:
    """Return the gap along the axis of a contact, m."""
    a, b = _placed(cores, contact, states)
    near = gaps(a, b, contact.axis)
    return next(gap.value for gap in near if gap.which == contact.gap.which)
