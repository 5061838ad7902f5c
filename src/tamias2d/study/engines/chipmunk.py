"""A scene in Pymunk, as a game would have it: 10 iterations if nothing else is asked, no sleeping.

Serves: studies and measurements of contacts. Hides: how Pymunk is told a scene, and asked.
"""

import math
from typing import Any

import numpy as np

from tamias2d.scene import Body, Scene
from tamias2d.state import Array
from tamias2d.study.engines.deferred import deferred_interrupts
from tamias2d.study.engines.engine import Pair
from tamias2d.study.engines.pieces import ConvexPart, pieces, reaches, size_of
from tamias2d.study.engines.refusal import imported, refuse_untranslated
from tamias2d.study.engines.surfaces import friction, restitution

ITERATIONS = 10
_SLOP = 0.005  # of the smallest body's size; its own 0.1 is for lengths in pixels


class Chipmunk:
    """A world of Pymunk."""

    name = "Pymunk"

    def __init__(
        self,
        scene: Scene,
        time_step: float,
        iterations: int = ITERATIONS,
        *,
        listens: bool = False,
    ) -> None:
        pymunk = imported(self.name, "pymunk")
        refuse_untranslated(scene, self.name)
        self._batch, self._time_step = imported(self.name, "pymunk.batch"), time_step
        self._listens, self._steps = listens, 0
        self.met: dict[Pair, float] = {}
        self._space = pymunk.Space()
        self._space.gravity = scene.gravity
        self._space.iterations = iterations
        self._space.collision_slop = _SLOP * 2 * min(reaches(scene))
        size = size_of(scene)
        rubs, parts = friction(scene), restitution(scene)
        self.bodies = [_body(pymunk, body) for body in scene.bodies]
        for k, (body, own) in enumerate(zip(scene.bodies, self.bodies, strict=True)):
            self._space.add(own)
            for piece, rub, part in zip(pieces(body, size), rubs[k], parts[k], strict=True):
                shape = _shape(pymunk, own, piece)
                shape.friction, shape.elasticity = math.sqrt(rub), math.sqrt(part)
                self._space.add(shape)
        self._buffer = self._batch.Buffer()
        self._places = self._batch.BodyFields.POSITION
        self._index = {body: k for k, body in enumerate(self.bodies)}
        if listens:
            self._space.on_collision(begin=self._begun)

    def step(self, count: int = 1) -> None:
        """Go so many time steps ahead, one by one."""
        if not self._listens:
            for _ in range(count):
                self._space.step(self._time_step)
            return
        with deferred_interrupts() as raise_interrupt:
            for _ in range(count):
                self._steps += 1
                self._space.step(self._time_step)
                raise_interrupt()

    def drive(self, body: int, velocity: tuple[float, float]) -> None:
        """Give a kinematic body another velocity, m/s."""
        self.bodies[body].velocity = velocity

    def read(self) -> Array:
        """Return the positions (n, 2) of what moves, m, in the way that is the fastest."""
        self._buffer.clear()
        self._batch.get_space_bodies(self._space, self._places, self._buffer)
        return np.frombuffer(self._buffer.float_buf()).reshape(-1, 2)

    def state(self) -> Array:
        """Return (n, 6): positions, orientations and their rates."""
        rows = [(*b.position, b.angle, *b.velocity, b.angular_velocity) for b in self.bodies]
        return np.array(rows, dtype=float)

    def _begun(self, arbiter: Any, space: Any, data: Any) -> None:  # noqa: ARG002
        a, b = sorted(self._index[shape.body] for shape in arbiter.shapes)
        self.met.setdefault((a, b), self._steps * self._time_step)

    def masses(self) -> Array:
        """Return (n, 2): mass, kg, and inertia, kg m^2; what does not move has infinite ones."""
        return np.array([(body.mass, body.moment) for body in self.bodies])


def _body(pymunk: Any, body: Body) -> Any:
    if body.dynamic:
        own = pymunk.Body(body.mass, body.inertia)
    else:
        kinds = pymunk.Body
        own = pymunk.Body(body_type=kinds.KINEMATIC if body.kinematic else kinds.STATIC)
    own.position, own.angle = body.position, body.orientation
    own.velocity, own.angular_velocity = body.velocity, body.angular_velocity
    return own


def _shape(pymunk: Any, own: Any, piece: ConvexPart) -> Any:
    if len(piece.corners) == 1:
        return pymunk.Circle(own, piece.radius, piece.corners[0])
    if len(piece.corners) == 2:
        return pymunk.Segment(own, *piece.corners, piece.radius)
    return pymunk.Poly(own, piece.corners, radius=piece.radius)
