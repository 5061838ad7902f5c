"""Exact histories in 40 digits: of discs and flat boxes that meet, of drag and of oscillators.

Formulas and geometry are written here once more, from textbooks, in mpmath: nothing of the library
but the scene is used, so that its runs can be judged to the last bit.
"""

from dataclasses import dataclass, field
from itertools import combinations
from typing import Any

import mpmath as mp
import numpy as np

from tamias2d.scene import Body, Box, Disc, HalfPlane, Scene
from tamias2d.scene.exact import closed_forms
from tamias2d.state import Array

mp.mp.dps = 40
_NEVER = mp.inf
_ZERO = mp.mpf(10) ** -32
_RESTS = mp.mpf(10) ** -24  # s; a bounce as short as that is the last one


class NotCoveredError(Exception):
    """The scene has something that is not written here."""


@dataclass
class _Moving:
    body: Body
    p: Any
    v: Any
    a: Any
    rows: list[tuple[Any, Any]] = field(default_factory=list)


def exact_history(scene: Scene, times: Array) -> tuple[Array, Array]:
    """Return positions (k, n, 2) and orientations (k, n) at times (k,), rounded once.

    Raises:
        NotCoveredError: the scene has no such solution here.
    """
    forms = closed_forms(scene)
    if len(forms) < sum(body.dynamic for body in scene.bodies) or scene.fields:
        raise NotCoveredError
    if set(forms.values()) - {"constant loads"}:
        positions = _formulas(scene, times)
    else:
        positions = _events(scene, times)
    turns = [[_turn(body, mp.mpf(t)) for body in scene.bodies] for t in times.tolist()]
    return np.array(positions, dtype=np.float64), np.array(turns, dtype=np.float64)


def _turn(body: Body, t: Any) -> Any:
    spin, twist = mp.mpf(body.angular_velocity), mp.mpf(body.torque)
    return body.orientation + spin * t + twist / mp.mpf(body.inertia) * t * t / 2


def _pull(scene: Scene, body: Body) -> Any:
    if not body.dynamic:
        return mp.matrix([0, 0])
    return mp.matrix(
        [
            mp.mpf(g) + mp.mpf(f) / mp.mpf(body.mass)
            for g, f in zip(scene.gravity, body.force, strict=True)
        ]
    )


def _formulas(scene: Scene, times: Array) -> list[list[tuple[Any, Any]]]:
    if len([body for body in scene.bodies if body.shape]) > 1:
        raise NotCoveredError
    return [[tuple(_place(scene, k, mp.mpf(t))) for k in range(len(scene))] for t in times.tolist()]


def _place(scene: Scene, k: int, t: Any) -> Any:
    body = scene.bodies[k]
    p, v, a = mp.matrix(body.position), mp.matrix(body.velocity), _pull(scene, body)
    if body.linear_drag:
        rate = mp.mpf(body.linear_drag) / mp.mpf(body.mass)
        return p + a / rate * t + (v - a / rate) * (-mp.expm1(-rate * t) / rate)
    for spring in scene.springs:
        if k in spring.bodies:
            w = mp.sqrt(mp.mpf(spring.stiffness) / mp.mpf(body.mass))
            c = mp.matrix(spring.point) + a / w**2
            return c + (p - c) * mp.cos(w * t) + v / w * mp.sin(w * t)
    return p + v * t + a * t * t / 2


def _events(scene: Scene, times: Array) -> list[list[tuple[Any, Any]]]:
    bodies = [
        _Moving(b, mp.matrix(b.position), mp.matrix(b.velocity), _pull(scene, b))
        for b in scene.bodies
    ]
    solid = [k for k, one in enumerate(bodies) if one.body.shape is not None]
    pairs = [
        (i, j)
        for i, j in combinations(solid, 2)
        if bodies[i].body.dynamic or bodies[j].body.dynamic
    ]
    now, rows = mp.mpf(0), []
    waiting = [mp.mpf(t) for t in times.tolist()]
    for i, j in pairs:
        _settle(bodies[i], bodies[j])
    known = {pair: now + _meet(bodies[pair[0]], bodies[pair[1]]) for pair in pairs}
    while waiting:
        pair = min(known, key=known.__getitem__) if known else None
        following = known[pair] if pair else _NEVER
        while waiting and waiting[0] < following:
            t = waiting.pop(0) - now
            rows.append([tuple(one.p + one.v * t + one.a * t * t / 2) for one in bodies])
        if not waiting:
            break
        for one in bodies:
            t = following - now
            one.p, one.v = one.p + one.v * t + one.a * t * t / 2, one.v + one.a * t
        now = following
        assert pair is not None
        _part(scene, pair, bodies[pair[0]], bodies[pair[1]])
        for other in pairs:
            if set(other) & set(pair):
                known[other] = now + _meet(bodies[other[0]], bodies[other[1]])
    return rows


def _parallel(one: _Moving, other: _Moving) -> bool:
    """Whether two bodies, as wide as their bounding circles, stay apart while nothing hits them."""
    shapes = [one.body.shape, other.body.shape]
    if any(isinstance(shape, HalfPlane) for shape in shapes):
        return False
    rate, pull = other.v - one.v, other.a - one.a
    if any(_dot(w, w) != 0 for w in (rate, pull)):
        return False
    gap = other.p - one.p
    near = sum(mp.mpf(shape.bounding_radius) for shape in shapes if shape is not None)
    return bool(mp.sqrt(_dot(gap, gap)) > near)


def _axis(one: _Moving, other: _Moving) -> tuple[Any, Any] | None:
    """Return normal from one to other and how near they can come, for what meets along an axis."""
    a, b = one.body.shape, other.body.shape
    if isinstance(a, HalfPlane):
        n = mp.matrix(a.normal)
        return n, a.offset + _reach(b, n)
    if isinstance(b, HalfPlane):
        n = -mp.matrix(b.normal)
        return n, b.offset + _reach(a, n)
    if isinstance(a, Disc) and isinstance(b, Disc):
        return None
    gap, rate, pull = other.p - one.p, other.v - one.v, other.a - one.a
    for k in (0, 1):
        across = 1 - k
        still = rate[across] == 0 and pull[across] == 0
        if isinstance(a, Disc) or isinstance(b, Disc):
            flat = a if isinstance(b, Disc) else b
            side = mp.mpf((flat.width, flat.height)[across]) / 2  # type: ignore[union-attr]
            fits = still and abs(gap[across]) < side
        else:
            fits = still and gap[across] == 0
        if fits:
            n = mp.matrix([0, 0])
            n[k] = 1 if gap[k] > 0 else -1
            return n, _reach(a, n) + _reach(b, n)
    raise NotCoveredError


def _reach(shape: Any, n: Any) -> Any:
    if isinstance(shape, Disc):
        return mp.mpf(shape.radius)
    if isinstance(shape, Box) and (n[0] == 0 or n[1] == 0):
        return mp.mpf(shape.width if n[1] == 0 else shape.height) / 2
    raise NotCoveredError


def _gap(one: _Moving, other: _Moving) -> tuple[Any, Any, Any]:
    """Return a, b, c of the gap a t^2 + b t + c for what meets along an axis."""
    n, near = _axis(one, other)  # type: ignore[misc]
    planes = [isinstance(x.body.shape, HalfPlane) for x in (one, other)]
    if any(planes):
        free = other if planes[0] else one
        m = n if planes[0] else -n
        return _dot(free.a, m) / 2, _dot(free.v, m), _dot(free.p, m) - near
    gap, rate, pull = other.p - one.p, other.v - one.v, other.a - one.a
    return _dot(pull, n) / 2, _dot(rate, n), _dot(gap, n) - near


def _meet(one: _Moving, other: _Moving) -> Any:
    if _parallel(one, other):
        return _NEVER
    if isinstance(one.body.shape, Disc) and isinstance(other.body.shape, Disc):
        gap, rate, pull = other.p - one.p, other.v - one.v, other.a - one.a
        if _dot(pull, pull) != 0:
            raise NotCoveredError
        near = mp.mpf(one.body.shape.radius) + mp.mpf(other.body.shape.radius)
        a, b, c = _dot(rate, rate), 2 * _dot(gap, rate), _dot(gap, gap) - near**2
    else:
        a, b, c = _gap_if_flat(one, other)
    return _first(a, b, c)


def _gap_if_flat(one: _Moving, other: _Moving) -> tuple[Any, Any, Any]:
    for x in (one, other):
        turned = (x.body.orientation, x.body.angular_velocity, x.body.torque) != (0, 0, 0)
        if x.body.dynamic and isinstance(x.body.shape, Box) and turned:
            raise NotCoveredError
    return _gap(one, other)


def _first(a: Any, b: Any, c: Any) -> Any:
    """Return the first positive root at which a t^2 + b t + c falls through 0."""
    if abs(c) < _ZERO:
        if b < 0:
            return mp.mpf(0)
        return -b / a if a < 0 and b > 0 else _NEVER
    if a == 0:
        return -c / b if b < 0 else _NEVER
    inside = b * b - 4 * a * c
    if inside < 0:
        return _NEVER
    q = -(b + mp.sign(b) * mp.sqrt(inside)) / 2 if b != 0 else mp.sqrt(inside) / 2
    roots = [q / a, c / q] if b != 0 else [q / a, -q / a]
    falling = [t for t in roots if t > 0 and 2 * a * t + b < 0]
    return min(falling, default=_NEVER)


def _part(scene: Scene, pair: tuple[int, int], one: _Moving, other: _Moving) -> None:
    if isinstance(one.body.shape, Disc) and isinstance(other.body.shape, Disc):
        n = other.p - one.p
        n = n / mp.sqrt(_dot(n, n))
    else:
        n, _ = _axis(one, other)  # type: ignore[misc]
    masses = [mp.mpf(1) / x.body.mass if x.body.dynamic else mp.mpf(0) for x in (one, other)]
    rate = _dot(other.v - one.v, n)
    impulse = -(1 + mp.mpf(scene.restitution(*pair))) * rate / (masses[0] + masses[1])
    one.v = one.v - n * (impulse * masses[0])
    other.v = other.v + n * (impulse * masses[1])
    _settle(one, other)


def _settle(one: _Moving, other: _Moving) -> None:
    """Let a body rest on a half-plane, where its bounces have come to their end."""
    planes = [x for x in (one, other) if isinstance(x.body.shape, HalfPlane)]
    if not planes:
        return
    a, b, c = _gap_if_flat(one, other)
    if abs(c) < _ZERO and a < 0 and 0 <= -b / a < _RESTS:
        free = other if planes[0] is one else one
        n = mp.matrix(planes[0].body.shape.normal)  # type: ignore[union-attr]
        free.v, free.a = free.v - n * _dot(free.v, n), free.a - n * _dot(free.a, n)


def _dot(a: Any, b: Any) -> Any:
    return a[0] * b[0] + a[1] * b[1]
