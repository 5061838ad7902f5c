"""A scene in Box2D v3 by way of pyb2d3: 4 substeps if nothing else is asked, no sleeping.

Serves: studies and measurements of contacts. Hides: how pyb2d3 is told a scene, and asked.
"""

from math import atan2, cos, sin
from typing import Any

import numpy as np

from tamias2d.scene import Body, Scene
from tamias2d.state import Array
from tamias2d.study.engines.engine import Pair
from tamias2d.study.engines.pieces import ConvexPart, pieces, size_of
from tamias2d.study.engines.refusal import imported, refuse_untranslated
from tamias2d.study.engines.surfaces import friction, restitution

SUBSTEPS = 4
_SLOWEST_HIT = 1e-3  # m/s


class Box2D:
    """A world of Box2D v3."""

    name = "pyb2d3"

    def __init__(
        self,
        scene: Scene,
        time_step: float,
        substeps: int = SUBSTEPS,
        *,
        listens: bool = False,
        slowest_bounce: float = 1.0,
    ) -> None:
        """Take a scene; what meets more slowly than the slowest bounce, m/s, stays together."""
        pyb2d3 = imported(self.name, "pyb2d3")
        refuse_untranslated(scene, self.name)
        self._time_step, self._substeps, self._listens = time_step, substeps, listens
        self._steps = 0
        self.met: dict[Pair, float] = {}
        self.hits: list[tuple[float, Pair]] = []
        """Ends of steps, s, in which pairs hit each other; only what listens fills it."""
        self._world = pyb2d3.World(gravity=scene.gravity)
        self._world.sleeping_enabled = False
        self._world.restitution_threshold = slowest_bounce
        self._world.hit_event_threshold = _SLOWEST_HIT
        size = size_of(scene)
        rubs, parts = friction(scene), restitution(scene)
        self.bodies = [_body(pyb2d3, self._world, body) for body in scene.bodies]
        self._moving = pyb2d3.Bodies()
        for k, (body, own) in enumerate(zip(scene.bodies, self.bodies, strict=True)):
            for piece, rub, part in zip(pieces(body, size), rubs[k], parts[k], strict=True):
                shape = pyb2d3.shape_def(
                    material=pyb2d3.surface_material(friction=rub, restitution=part),
                    enable_contact_events=listens,
                    enable_hit_events=listens,
                )
                own.create_shape(shape, _shape(pyb2d3, piece))
            if body.dynamic:
                own.mass_data = _mass(pyb2d3, body)
                self._moving.append(own.id)
        self._index = {own.id: k for k, own in enumerate(self.bodies)}

    def step(self, count: int = 1) -> None:
        """Go so many time steps ahead, one by one."""
        for _ in range(count):
            self._steps += 1
            self._world.step(self._time_step, self._substeps)
            if self._listens:
                self._hear()

    def drive(self, body: int, velocity: tuple[float, float]) -> None:
        """Give a kinematic body another velocity, m/s."""
        self.bodies[body].linear_velocity = velocity

    def read(self) -> Array:
        """Return the positions (n, 2) of what moves, m, in the way that is the fastest."""
        return np.asarray(self._moving.get_positions())

    def state(self) -> Array:
        """Return (n, 6): positions, orientations and their rates."""
        rows = [
            (b.position, b.rotation, b.linear_velocity, b.angular_velocity) for b in self.bodies
        ]
        return np.array([(p.x, p.y, atan2(q.s, q.c), v.x, v.y, spin) for p, q, v, spin in rows])

    def _hear(self) -> None:
        """Note the pairs that began to touch in the last step, and those that hit each other.

        What begins to touch may still be 2 cm apart.
        """
        time, told = self._steps * self._time_step, self._world.get_contact_events()
        for begun in told.begin_events():
            self.met.setdefault(self._pair(begun), time)
        self.hits += [(time, self._pair(hit)) for hit in told.hit_events()]

    def _pair(self, event: Any) -> Pair:
        a, b = sorted(self._index[shape.body.id] for shape in (event.shape_a, event.shape_b))
        return a, b

    def masses(self) -> Array:
        """Return (n, 2): mass, kg, and inertia, kg m^2; what does not move has zeros."""
        return np.array([(body.mass, body.rotational_inertia()) for body in self.bodies])


def _body(pyb2d3: Any, world: Any, body: Body) -> Any:
    kind = "DYNAMIC" if body.dynamic else "KINEMATIC" if body.kinematic else "STATIC"
    return world.create_body(
        type=getattr(pyb2d3.BodyType, kind),
        position=body.position,
        rotation=_rotation(pyb2d3, body.orientation),
        linear_velocity=body.velocity,
        angular_velocity=body.angular_velocity,
    )


def _rotation(pyb2d3: Any, angle: float) -> Any:
    """Return a rotation; Box2D's own cosine is off by up to 1e-3, as is its angle of a rotation."""
    rotation = pyb2d3.Rot()
    rotation.c, rotation.s = cos(angle), sin(angle)
    return rotation


def _mass(pyb2d3: Any, body: Body) -> Any:
    mass = pyb2d3.MassData()
    inertia = body.inertia if body.inverse_inertia else 0.0  # Box2D does not turn what has none
    mass.mass, mass.rotational_inertia, mass.center = body.mass, inertia, (0.0, 0.0)
    return mass


def _shape(pyb2d3: Any, piece: ConvexPart) -> Any:
    corners, radius = piece.corners, piece.radius
    if len(corners) == 1:
        return pyb2d3.circle(corners[0], radius)
    if len(corners) == 2:
        return pyb2d3.capsule(*corners, radius) if radius else pyb2d3.segment(*corners)
    return pyb2d3._pyb2d3._make_polygon(pyb2d3.compute_hull(np.array(corners, np.float32)), radius)
