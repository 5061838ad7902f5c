"""A scene in Pymunk, with settings that are kind to it.

Floors are thick, the slop is small for the scene's lengths, and the iterations are its own default.
"""

import math
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass, field
from itertools import combinations
from typing import Any, TypeAlias

import numpy as np

from tamias2d.errors import SceneError
from tamias2d.run import Impacts
from tamias2d.scene import Body, Box, Capsule, Disc, HalfPlane, Polygon, Scene, Segment
from tamias2d.scene.acting import Load
from tamias2d.scene.filters import filters
from tamias2d.state import Array
from tamias2d.study.engines.refusal import PeerError, imported
from tamias2d.study.pymunk_loads import Loading, loading

_SLOP = 1e-4  # of the smallest body: how far it lets bodies overlap before it pushes them apart
_WIDE = 1e3  # times the size of the scene: a half-plane's surface and its depth


Push: TypeAlias = Callable[[Any], Load]
"""From a body of Pymunk to the force and torque on it, besides weight."""


def _pymunk() -> Any:
    return imported("Pymunk", "pymunk")


def version() -> str:
    """Return that of Pymunk; raise `PeerError` if it is not installed."""
    return str(_pymunk().version)


@dataclass
class Hits:
    """The beginnings of contacts, as the engine tells them."""

    time: list[float] = field(default_factory=list)
    bodies: list[tuple[int, int]] = field(default_factory=list)
    point: list[tuple[float, float]] = field(default_factory=list)
    normal: list[tuple[float, float]] = field(default_factory=list)
    impulse: list[float] = field(default_factory=list)
    normal_velocity: list[float] = field(default_factory=list)

    def impacts(self) -> Impacts:
        """Return them as a run holds them."""
        return Impacts(
            time=np.array(self.time),
            bodies=np.array(self.bodies, dtype=np.int64).reshape(-1, 2),
            point=np.array(self.point).reshape(-1, 2),
            normal=np.array(self.normal).reshape(-1, 2),
            impulse=np.array(self.impulse),
            normal_velocity=np.array(self.normal_velocity),
        )


class World:
    """A scene in Pymunk."""

    def __init__(self, scene: Scene, push: Push | None) -> None:
        pymunk = _pymunk()
        self.hits = Hits()
        self._now = 0.0
        self._scene = scene
        self._space = pymunk.Space()
        self._space.gravity = scene.gravity
        self._space.collision_slop = _SLOP * _smallest(scene)
        elasticity = math.sqrt(_of_all_pairs(scene, scene.restitution, "restitution"))
        friction = math.sqrt(_of_all_pairs(scene, scene.friction, "friction"))
        if scene.joints:
            raise PeerError(
                f"Pymunk: joint '{scene.joints[0].name}': its joints are not translated. Leave "
                "Pymunk out."
            )
        self._bodies = [_body(pymunk, body) for body in scene.bodies]
        self._index = {body: k for k, body in enumerate(self._bodies)}
        self._new: dict[tuple[int, int], int] = {}
        for body, own in zip(scene.bodies, self._bodies, strict=True):
            self._space.add(own)
            if body.shape is not None:
                shape = _shape(pymunk, own, body, _size(scene))
                shape.elasticity, shape.friction = elasticity, friction
                self._space.add(shape)
        self._space.on_collision(begin=self._begun, post_solve=self._solved)
        self._fault: Exception | None = None
        loads = loading(scene, self.state)
        if push is None and loads is not None:
            push = self._by_laws(loads)
        for own in self._bodies:
            if push is not None and own.body_type == pymunk.Body.DYNAMIC:
                own.velocity_func = self._pushed(push)

    def step(self, end: float, dt: float) -> bool:
        """Step for dt to the time `end`, s, and return whether a contact began."""
        self._now = end
        known = len(self.hits.time)
        self._space.step(dt)
        if self._fault:
            raise self._fault
        return len(self.hits.time) > known

    def state(self) -> Array:
        """Return (n, 6): positions, orientations and their rates."""
        return np.array(
            [(*b.position, b.angle, *b.velocity, b.angular_velocity) for b in self._bodies]
        )

    def _pushed(self, push: Push) -> Callable[..., None]:
        """Return what Pymunk calls to change a velocity: by then all places are those at the end
        of the step, which makes its steps symplectic.
        """
        update = _pymunk().Body.update_velocity

        def change(body: Any, gravity: Any, damping: float, dt: float) -> None:
            try:
                x, y, body.torque = push(body)
                body.force = x, y
            except Exception as fault:  # C has no exceptions: `step` raises it
                self._fault = fault
            update(body, gravity, damping, dt)

        return change

    def _by_laws(self, loads: Loading) -> Push:
        return lambda body: loads(self._now, self._index[body])

    def _begun(self, arbiter: Any, space: Any, data: Any) -> None:  # noqa: ARG002
        """Note a contact that begins, before it is solved."""
        one, other = (self._index[shape.body] for shape in arbiter.shapes)
        a, b = min(one, other), max(one, other)
        normal, point = arbiter.normal, arbiter.contact_point_set.points[0].point_a
        if one > other:
            normal = -normal
        apart = [self._bodies[k].velocity_at_world_point(point) for k in (a, b)]
        self._new[a, b] = len(self.hits.time)
        self.hits.time.append(self._now)
        self.hits.bodies.append((a, b))
        self.hits.point.append(tuple(point))
        self.hits.normal.append(tuple(normal))
        self.hits.impulse.append(0.0)
        self.hits.normal_velocity.append(float(normal.dot(apart[1] - apart[0])))

    def _solved(self, arbiter: Any, space: Any, data: Any) -> None:  # noqa: ARG002
        one, other = (self._index[shape.body] for shape in arbiter.shapes)
        place = self._new.pop((min(one, other), max(one, other)), None)
        if place is not None:
            self.hits.impulse[place] = float(arbiter.total_impulse.length)


def _body(pymunk: Any, body: Body) -> Any:
    if body.kinematic or body.sensor or filters(body) or body.surface_speed:
        raise PeerError(
            f"Pymunk: body '{body.name}': kinematic bodies, sensors, filters and surfaces that run "
            "are not translated. Leave Pymunk out."
        )
    if not body.dynamic:
        own = pymunk.Body(body_type=pymunk.Body.STATIC)
    else:
        own = pymunk.Body(body.mass, body.inertia)
        own.velocity, own.angular_velocity = body.velocity, body.angular_velocity
    own.position, own.angle = body.position, body.orientation
    return own


def _shape(pymunk: Any, own: Any, body: Body, size: float) -> Any:
    shape = body.shape
    if isinstance(shape, Disc):
        return pymunk.Circle(own, shape.radius)
    if isinstance(shape, Box | Polygon):
        return pymunk.Poly(own, list(shape.vertices))
    if isinstance(shape, Capsule | Segment):
        return pymunk.Segment(own, *shape.core, shape.rounding)
    if not isinstance(shape, HalfPlane):
        raise PeerError(f"Pymunk: shape of '{body.name}': there is none such. Leave Pymunk out.")
    (x, y), depth = shape.normal, _WIDE * size
    middle = shape.offset - depth
    ends = [(x * middle - s * y * depth, y * middle + s * x * depth) for s in (-1, 1)]
    return pymunk.Segment(own, *ends, depth)


def _size(scene: Scene) -> float:
    """Return a length in m that nothing in the scene is far beyond."""
    places = [abs(value) for body in scene.bodies for value in body.position]
    return max([*places, _largest(scene), 1e-300])


def _reaches(scene: Scene) -> list[float]:
    shapes = [body.shape for body in scene.bodies if body.shape is not None]
    return [shape.bounding_radius for shape in shapes if math.isfinite(shape.bounding_radius)]


def _largest(scene: Scene) -> float:
    return max(_reaches(scene), default=0.0)


def _smallest(scene: Scene) -> float:
    return min(_reaches(scene), default=1.0)


def _of_all_pairs(scene: Scene, of_pair: Callable[[int, int], float], what: str) -> float:
    """Return what all pairs have in common: Pymunk has a product of two of its own instead."""
    solid = [k for k, body in enumerate(scene.bodies) if body.shape is not None]
    moving = [body.dynamic for body in scene.bodies]
    pairs = [(i, j) for i, j in combinations(solid, 2) if moving[i] or moving[j]]
    found = set()
    for i, j in pairs:
        with suppress(SceneError):  # pairs that never meet need not state any
            found.add(of_pair(i, j))
    if len(found) > 1:
        raise PeerError(
            f"Pymunk: {what}: it differs from pair to pair, which Pymunk's product of two "
            "cannot say. Leave Pymunk out."
        )
    return found.pop() if found else 0.0
