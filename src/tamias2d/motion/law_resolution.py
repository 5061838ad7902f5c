"""Whether steps resolve the laws of a scene: what a law does between their stages can be missed.

Each law is asked at times spread over the run, and compared with the polynomial through its values
at nodes of the step. A push that all nodes step over is nothing of that polynomial.
"""

from collections.abc import Callable, Iterator, Sequence
from functools import cache
from typing import NamedTuple

import numpy as np
from numpy.polynomial.chebyshev import chebvander
from numpy.typing import NDArray

from tamias2d.scene import Scene
from tamias2d.scene.acting import varying_laws
from tamias2d.scene.law import StateLaw
from tamias2d.state import Array

LOOKS = 1000
"""Times at which each law is asked, over a run."""
_GOLDEN = (5.0**0.5 - 1.0) / 2.0  # multiples of it, less what is whole, are spread most evenly
_CHOSEN, _GIVEN = 8, 2  # degrees of the polynomial, for steps that are chosen or given
_TRUSTED = 32.0  # times its last two terms may a law be away from the polynomial
_SHARE = 0.25  # of what the law changes in the step; steps that are given need not resolve jumps
_ROUNDING = 2.0**-40  # of the largest value is none of it

States = Callable[[Array], Array]
"""From times (k,), s, to coordinates and rates (k, 2, n, 3)."""


class Unresolved(NamedTuple):
    """A step that has missed what a law does."""

    step: int
    time: float
    """Within it, s, where the law is farthest from what the step could know."""
    law: StateLaw

    def __str__(self) -> str:
        return f"steps miss what a law does: {self.law.what}, near {self.time:.6g} s"


class _Load(NamedTuple):
    """A law that is asked, and the m bodies that feel it, by their rows."""

    law: StateLaw
    component: int
    rows: list[int]
    mass: Array
    """(m,), kg."""
    inert: Array
    """(m,): what the law accelerates, kg or kg m^2."""


class _Asked(NamedTuple):
    """The nodes of s steps, and k times within them."""

    steps: NDArray[np.intp]
    nodes: Array
    """(s, degree + 1), s."""
    looks: Array
    """(k,), s."""
    of: NDArray[np.intp]
    """(k,): to which of the s steps each belongs."""

    @property
    def length(self) -> Array:
        """(k,): of the step of each time, s."""
        return np.asarray((self.nodes[:, -1] - self.nodes[:, 0])[self.of])

    @property
    def place(self) -> Array:
        """(k,): of each time in its step, from -1 to 1."""
        gone = (self.looks - self.nodes[self.of, 0]) / self.length
        return np.asarray(2.0 * gone - 1.0)


class LawResolution:
    """The laws of a scene that may do something for a moment, and when they are asked."""

    def __init__(self, scene: Scene, duration: float) -> None:
        self._scene = scene
        self.shortest = duration / LOOKS
        """Steps of this length, s, are as close to each other as the times."""
        self._times = (np.arange(LOOKS) + np.arange(LOOKS) * _GOLDEN % 1.0) * self.shortest
        self._loads = cache(self._loads_on)

    def unresolved(
        self,
        bodies: tuple[int, ...],
        times: Sequence[float],
        states: States,
        *,
        relative: float = 0.0,
        rate: float = 0.0,
        given: bool = False,
    ) -> Unresolved | None:
        """Return the first of the steps between some times, s, that has missed something.

        What changes velocities by less than `rate`, m/s or rad/s, and by less than a `relative`
        share, does not matter. Steps of a `given` length may show little of a law, but not nothing.
        """
        loads = self._loads(bodies)
        asked = self._asked(times, _GIVEN if given else _CHOSEN) if loads else None
        if asked is None:
            return None
        moments = np.concatenate((asked.nodes.ravel(), asked.looks))
        rows = states(moments)
        slight = rate + relative * np.abs(rows[asked.nodes.size :, 1])
        found: list[Unresolved] = []
        for load in loads:
            values = _values(load, moments, rows)
            little = slight[:, load.rows, load.component] * load.inert / asked.length[:, None]
            worst = _missed(asked, values, little, strict=not given)
            if worst is not None:
                step, time = int(asked.steps[asked.of[worst]]), float(asked.looks[worst])
                found.append(Unresolved(step, time, load.law))
        return min(found, key=lambda one: one.step, default=None)

    def _asked(self, times: Sequence[float], degree: int) -> _Asked | None:
        """Return when laws are asked in some steps; None where all of these are short."""
        if max(np.diff(times), default=0.0) <= self.shortest:
            return None
        first, last = np.searchsorted(self._times, (times[0], times[-1]), side="right")
        looks = self._times[first:last]
        steps = np.searchsorted(times, looks) - 1
        long = np.diff(times)[steps] > self.shortest
        if not long.any():
            return None
        steps, of = np.unique(steps[long], return_inverse=True)
        start, end = np.take(times, steps)[:, None], np.take(times, steps + 1)[:, None]
        nodes = start + (end - start) / 2 * (_nodes(degree) + 1.0)
        nodes[:, -1] = end[:, 0]
        return _Asked(steps, nodes, looks[long], of)

    def _loads_on(self, bodies: tuple[int, ...]) -> list[_Load]:
        return list(self._found(bodies))

    def _found(self, bodies: tuple[int, ...]) -> Iterator[_Load]:
        for (component, law), rows in varying_laws(self._scene, bodies).items():
            if law.brief:
                felt = [self._scene.bodies[bodies[row]] for row in rows]
                mass = np.array([body.mass for body in felt])
                inertia = np.array([body.inertia for body in felt])
                yield _Load(law, component, rows, mass, mass if component < 2 else inertia)


def _values(load: _Load, times: Array, states: Array) -> Array:
    """Return a law (k, m) at times (k,), s, for the m bodies that feel it."""
    q, rate = (states[:, part, load.rows].reshape(-1, 3).T for part in (0, 1))
    state = {
        "time": np.repeat(times, len(load.rows)),
        "position": (q[0], q[1]),
        "orientation": q[2],
        "velocity": (rate[0], rate[1]),
        "angular_velocity": rate[2],
        "mass": np.tile(load.mass, len(times)),
    }
    return np.broadcast_to(load.law.values(state), len(q[0])).reshape(len(times), -1)


def _missed(asked: _Asked, values: Array, slight: Array, *, strict: bool) -> int | None:
    """Return the look of the first step that has missed the most there; None where none has.

    Values (., m) are those at all nodes, then those at all looks. What is `slight` (k, m) does not
    matter. A `strict` step has to resolve jumps, too.
    """
    degree, of = asked.nodes.shape[1] - 1, asked.of
    looks = values[asked.nodes.size :]
    nodes = values[: asked.nodes.size].reshape(*asked.nodes.shape, -1)
    with np.errstate(all="ignore"):
        terms = np.einsum("cj,sjm->scm", _terms(degree), nodes)
        known = np.einsum("kc,kcm->km", chebvander(asked.place, degree), terms[of])
        away = np.abs(looks - known)
        allowed = _TRUSTED * np.abs(terms[:, -2:]).sum(axis=1)[of]
        if strict:
            allowed = np.minimum(allowed, _SHARE * _spread(nodes, looks, of))
        size = np.maximum(np.abs(nodes).max(axis=1)[of], np.abs(looks))
        bad = ~(away <= allowed + slight + _ROUNDING * size).all(axis=1)
    if not bad.any():
        return None
    inside = np.flatnonzero(bad & (of == of[np.argmax(bad)]))
    return int(inside[np.argmax(away[inside].max(axis=1))])


def _spread(nodes: Array, looks: Array, of: NDArray[np.intp]) -> Array:
    """Return how far the values of a step are apart, for each look that is of it."""
    least, most = nodes.min(axis=1), nodes.max(axis=1)
    np.minimum.at(least, of, looks)
    np.maximum.at(most, of, looks)
    return np.asarray((most - least)[of])


@cache
def _terms(degree: int) -> Array:
    """Return the matrix from values at the nodes to the terms in Chebyshev polynomials."""
    return np.asarray(np.linalg.inv(chebvander(_nodes(degree), degree)), dtype=np.float64)


@cache
def _nodes(degree: int) -> Array:
    """Return the Chebyshev points of a step, from -1 to 1."""
    return np.asarray(-np.cos(np.pi * np.arange(degree + 1) / degree))
