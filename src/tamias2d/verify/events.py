"""An independent simulation: scipy integrates, finds the impacts, and solves for the velocities.

It takes from the library the scene, with the inertias and restitutions in it, and shares no formula
of motion or impact with the generated models, so that it can judge them: distances come from
geometry, motion from Newton's law, and the velocities after an impact from a system of linear
equations (both momentum balances and Newton's law of restitution). It knows discs against discs and
half-planes, and polygons against half-planes.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass, field
from itertools import combinations

import numpy as np

from tamias2d.errors import InputError
from tamias2d.scene import Body, Box, Disc, HalfPlane, Polygon, Scene
from tamias2d.state import Array

Gap = Callable[[Array], tuple[float, Array, Array]]
"""From the state (n, 6) to separation, normal from A to B, and contact point."""

RTOL = 1e-12
_PIECES = 200  # the longest step is this part of the run, so that no impact is stepped over
_TOUCH = 1e-8  # m; nearer than this at an impact counts as touching
_SHORTEST = 1e-6  # s; bounces that follow each other faster are about to come to rest


@dataclass
class Events:
    """What happened. The state has a row for each body: x, y, orientation and their rates."""

    time: list[float] = field(default_factory=list)
    bodies: list[tuple[int, int]] = field(default_factory=list)
    state: Array = field(default_factory=lambda: np.empty((0, 6)))


def simulate_by_events(scene: Scene, *, duration: float) -> Events:
    """Simulate a scene for a duration in s.

    Raises:
        InputError: two bodies that could meet have shapes which are not covered here, or bounces
            come to rest, which a search for single impacts never ends with.
    """
    from scipy.integrate import solve_ivp

    gaps = separations(scene)
    rates = _rates(scene)
    found = Events(state=_start(scene))
    time = 0.0
    hits = [_closing(gap) for gap in gaps.values()]
    while time < duration:
        piece = solve_ivp(
            rates,
            (time, duration),
            found.state.ravel(),
            method="DOP853",
            rtol=RTOL,
            atol=RTOL,
            max_step=duration / _PIECES,
            events=hits,
        )
        time, found.state = float(piece.t[-1]), piece.y[:, -1].reshape(-1, 6)
        if piece.status == 1:
            _respond(scene, gaps, found, time)
    return found


def _start(scene: Scene) -> Array:
    return np.array(
        [
            (*body.position, body.orientation, *body.velocity, body.angular_velocity)
            for body in scene.bodies
        ]
    )


def _rates(scene: Scene) -> Callable[[float, Array], Array]:
    inverse = np.array(
        [(body.inverse_mass, body.inverse_mass, body.inverse_inertia) for body in scene.bodies]
    )
    weight = np.array(
        [(*scene.gravity, 0.0) if body.dynamic else (0.0, 0.0, 0.0) for body in scene.bodies]
    )

    def rates(time: float, flat: Array) -> Array:
        loads = np.array([(*body.force_at(time), body.torque_at(time)) for body in scene.bodies])
        state = flat.reshape(-1, 6)
        return np.hstack((state[:, 3:], loads * inverse + weight)).ravel()

    return rates


def _closing(gap: Gap) -> Callable[[float, Array], float]:
    """Return the event at which a separation falls below 0."""

    def separation(_time: float, flat: Array) -> float:
        return gap(flat.reshape(-1, 6))[0]

    separation.terminal, separation.direction = True, -1  # type: ignore[attr-defined]
    return separation


def _respond(
    scene: Scene, gaps: dict[tuple[int, int, int], Gap], found: Events, time: float
) -> None:
    """Let every pair that touches and approaches part again, one after the other."""
    for (a, b, _), gap in gaps.items():
        separation, normal, point = gap(found.state)
        if separation < _TOUCH and _approach(found.state, a, b, normal, point) < 0:
            _part(scene, found.state, a, b, normal, point)
            if (a, b) in found.bodies and time - _last(found, (a, b)) < _SHORTEST:
                raise InputError(
                    f"bodies '{scene.bodies[a].name}' and '{scene.bodies[b].name}': their bounces "
                    f"come to rest at {time:.6g} s (TC13). Compare a shorter run."
                )
            found.time.append(time)
            found.bodies.append((a, b))


def _last(found: Events, pair: tuple[int, int]) -> float:
    """Return when a pair met last."""
    return max(time for time, met in zip(found.time, found.bodies, strict=True) if met == pair)


def _approach(state: Array, a: int, b: int, normal: Array, point: Array) -> float:
    rows = [_point_row(state[k], point, normal) for k in (a, b)]
    return float(rows[1] @ state[b, 3:] - rows[0] @ state[a, 3:])


def _point_row(row: Array, point: Array, normal: Array) -> Array:
    """Return what takes (vx, vy, angular velocity) to the point's velocity along the normal."""
    x, y = point - row[:2]
    return np.array([normal[0], normal[1], x * normal[1] - y * normal[0]])


def _part(scene: Scene, state: Array, a: int, b: int, normal: Array, point: Array) -> None:
    """Solve the balances of both bodies and Newton's law for six velocities and the impulse."""
    matrix, right = np.zeros((7, 7)), np.zeros(7)
    for place, k, sign in ((0, a, 1.0), (3, b, -1.0)):
        body, rows = scene.bodies[k], slice(place, place + 3)
        row = _point_row(state[k], point, normal)
        inverse = np.array([body.inverse_mass, body.inverse_mass, body.inverse_inertia])
        matrix[rows, rows] = np.eye(3)
        matrix[rows, 6] = sign * inverse * row
        right[rows] = state[k, 3:]
        matrix[6, rows] = -sign * row
    right[6] = -scene.restitution(a, b) * _approach(state, a, b, normal, point)
    solution = np.linalg.solve(matrix, right)
    state[a, 3:], state[b, 3:] = solution[0:3], solution[3:6]


def separations(scene: Scene) -> dict[tuple[int, int, int], Gap]:
    """Return the separation function of every contact that could come about."""
    gaps: dict[tuple[int, int, int], Gap] = {}
    for a, b in combinations(range(len(scene.bodies)), 2):
        first, second = scene.bodies[a], scene.bodies[b]
        if first.shape is None or second.shape is None or not (first.dynamic or second.dynamic):
            continue
        if not scene.collides(a, b):
            continue
        for k, gap in enumerate(_gaps_of_pair(first, second, a, b)):
            gaps[a, b, k] = gap
    return gaps


def _gaps_of_pair(first: Body, second: Body, a: int, b: int) -> list[Gap]:
    match first.shape, second.shape:
        case Disc(radius=p), Disc(radius=q):
            return [_disc_disc(a, b, p, q)]
        case Disc(radius=p), HalfPlane() as plane:
            return [_vertex_plane(a, (0.0, 0.0), p, plane)]
        case (Box() | Polygon()) as shape, HalfPlane() as plane:
            return [_vertex_plane(a, corner, 0.0, plane) for corner in _corners(shape)]
    raise InputError(
        f"bodies '{first.name}' and '{second.name}': this pair of shapes is not covered by the "
        "event search (TC13). Compare another scene."
    )


def _corners(shape: Box | Polygon) -> tuple[tuple[float, float], ...]:
    if isinstance(shape, Polygon):
        return shape.vertices
    x, y = shape.width / 2, shape.height / 2
    return ((x, y), (-x, y), (-x, -y), (x, -y))


def _disc_disc(a: int, b: int, first: float, second: float) -> Gap:
    def gap(state: Array) -> tuple[float, Array, Array]:
        offset = state[b, :2] - state[a, :2]
        length = math.hypot(*offset)
        normal = offset / length
        return length - first - second, normal, state[a, :2] + first * normal

    return gap


def _vertex_plane(a: int, corner: tuple[float, float], radius: float, plane: HalfPlane) -> Gap:
    """The normal points from the body into the plane's solid side."""
    inward = -np.array(plane.normal)

    def gap(state: Array) -> tuple[float, Array, Array]:
        x, y, angle = state[a, :3]
        cos, sin = math.cos(angle), math.sin(angle)
        spot = np.array(
            [x + cos * corner[0] - sin * corner[1], y + sin * corner[0] + cos * corner[1]]
        )
        lowest = spot + radius * inward
        return float(-inward @ lowest) - plane.offset, inward, lowest

    return gap
