"""What a study of stepped contacts compares: engines, each with a ladder of steps and passes."""

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Protocol

import numpy as np

from tamias2d.scene import Scene
from tamias2d.simulator.stepper import SAME_STEP
from tamias2d.state import Array, History, place_between
from tamias2d.study.contact_errors import Followed, hanging
from tamias2d.study.engines.box2d import Box2D
from tamias2d.study.engines.chipmunk import Chipmunk
from tamias2d.study.engines.engine import Engine
from tamias2d.study.engines.overlap import worst
from tamias2d.study.engines.own import Own

RATES = (30, 60, 120, 240, 480, 960, 1920)
"""Steps in a second, where a run is long enough for a few of the longest"""
_LOOKS = 30  # at overlaps of a run


class _Maker(Protocol):
    def __call__(
        self, scene: Scene, time_step: float, passes: int, /, *, listens: bool = False
    ) -> Engine: ...


@dataclass(frozen=True)
class ContactCandidate:
    """One engine with its setting."""

    method: str
    make: _Maker
    time_step: float
    """s"""
    passes: int
    """Substeps or iterations of a step."""
    word: str
    """What the engine calls them."""
    peer: bool
    duration: float
    """Of a run, s"""

    @property
    def setting(self) -> str:
        """As people read it."""
        return f"{self.time_step:.4g} s x {self.passes} {self.word}"

    @property
    def name(self) -> str:
        """Of the engine with so many passes, whatever its step."""
        return f"{self.method} x {self.passes} {self.word}"

    @property
    def steps(self) -> int:
        """How many the duration takes."""
        return self.steps_to(self.duration)

    def steps_to(self, time: float) -> int:
        """Return how many steps a time in s takes."""
        return math.ceil(time / self.time_step - SAME_STEP)


_ENGINES: tuple[tuple[str, _Maker, tuple[int, ...], str, bool], ...] = (
    ("Stepped", Own, (1, 4, 16), "substeps", False),
    ("Pymunk", Chipmunk, (10, 40), "iterations", True),
    ("pyb2d3", Box2D, (4, 16), "substeps", True),
)


def contact_candidates(
    duration: float, *, coarsest: float, rates: Sequence[int] = RATES
) -> Iterator[ContactCandidate]:
    """Yield what can be tried for a duration, s, with steps from the coarsest, s."""
    for method, make, passes, word, peer in _ENGINES:
        for rate in rates:
            step = coarsest * RATES[0] / rate
            for count in passes:
                yield ContactCandidate(method, make, step, count, word, peer, duration)


def follow(
    candidate: ContactCandidate, scene: Scene, times: Array, *, listens: bool, looks: bool
) -> Followed:
    """Run a candidate and look at it at sorted times (k,), s; between steps, as runs are.

    It is asked for contacts only if it `listens`, and overlaps are computed only if one `looks`.
    Raises as the engines do.
    """
    step = candidate.time_step
    engine = candidate.make(scene, step, candidate.passes, listens=listens)
    rows: list[Array] = []
    steps, hung, fast = 0, 0, 0
    before = after = engine.state()
    for time in times.tolist():
        last = candidate.steps_to(time)
        if last > steps:
            engine.step(last - 1 - steps)
            before = engine.state()
            engine.step()
            steps, after = last, engine.state()
            found = hanging(scene, before, after, step)
            hung, fast = hung + found[0], fast + found[1]
        left = min(max((steps * step - time) / step, 0.0), 1.0)
        rows.append(_unwrapped(_between(before, after, left, step), rows))
    states = np.array(rows)
    seen = states[:: max(len(states) // _LOOKS, 1)] if looks else states[:0]
    return Followed(
        History(states[..., :2], states[..., 2], states[..., 3:5], states[..., 5]),
        hung / fast if fast else 0.0,
        engine.met if listens else None,
        worst(scene, *seen).share_of_size,
    )


def _between(before: Array, after: Array, left: float, time_step: float) -> Array:
    """Return the state (n, 6) at a time that is a share `left` of a step, s, before its end."""
    if not left:
        return after
    share = np.array(1.0 - left)
    line = before + share * (after - before)
    at, rate = slice(0, 3), slice(3, 6)
    line[:, at] = place_between(
        before[:, at], after[:, at], before[:, rate], after[:, rate], time_step, share
    )
    return line


def _unwrapped(state: Array, rows: list[Array]) -> Array:
    """Return a state whose orientations are next to the last ones; Box2D's are within a turn."""
    if rows:
        turns = np.round((state[:, 2] - rows[-1][:, 2]) / math.tau)
        state = state.copy()
        state[:, 2] -= math.tau * turns
    return state
