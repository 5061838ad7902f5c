"""A body: its shape, its mass and inertia, and the state in which it starts."""

import math
from dataclasses import dataclass, field

from tamias2d.attribute_suggestions import suggests_attributes
from tamias2d.scene.compound import Shape
from tamias2d.scene.filters import ALL
from tamias2d.scene.law import Law, Value, value_at, varies
from tamias2d.scene.rules import Vector
from tamias2d.suggestions import suggests


@suggests_attributes()
@suggests
@dataclass(frozen=True, kw_only=True)
class Body:
    """One rigid body of a scene, checked; made by `Scene.add_body` and its like.

    A static body has infinite mass and inertia, so that both inverses are 0. So has a kinematic
    one, which moves with the velocity that it is given, and, for its rotation, a body without shape
    (a particle, which touches nothing) whose inertia is not stated.
    """

    name: str
    shape: Shape | None
    dynamic: bool
    mass: float = math.inf
    """kg"""
    inertia: float = math.inf
    """About the centre of mass, kg m^2."""
    position: Vector = (0.0, 0.0)
    """Of the centre of mass at the start, m."""
    orientation: float = 0.0
    """At the start, counter-clockwise, rad."""
    velocity: Vector = (0.0, 0.0)
    """At the start, m/s."""
    angular_velocity: float = 0.0
    """At the start, rad/s."""
    force: tuple[Law, Law] = (0.0, 0.0)
    """Applied besides gravity, N; numbers, or laws of time and the body's state."""
    torque: Law = 0.0
    """Applied, N m; a number, or a law of time and the body's state."""
    linear_drag: float = 0.0
    """Drag force per velocity, kg/s."""
    quadratic_drag: float = 0.0
    """Drag force per squared speed, kg/m."""
    angular_drag: float = 0.0
    """Drag torque per angular velocity, kg m^2/s."""
    restitution: float | None = None
    """0 to 1, or None where only the other body of a pair or the scene says it."""
    friction: float | None = None
    """Coefficient of dry friction, or None where only the other body or the scene says it."""
    surface_speed: float = 0.0
    """At which its surface runs along itself, counter-clockwise around it, m/s."""
    inertia_stated: bool = False
    """Whether the inertia was given, rather than found from mass and shape."""
    kinematic: bool = False
    """Whether it moves with a given velocity and angular velocity, whatever it meets."""
    category: int = 1
    """Bits of the kinds of bodies that it is."""
    mask: int = ALL
    """Bits of the kinds of bodies that it may touch."""
    group: int = 0
    """Those of one group always touch where it is positive, and never where it is negative."""
    sensor: bool = False
    """Whether it only tells what overlaps it, and pushes nothing."""
    where: str = field(default="", compare=False, repr=False)
    """Its place in a scene file, as file:line:column; empty for one that code added."""

    @property
    def inverse_mass(self) -> float:
        """1/mass, 1/kg; 0 for what nothing can push."""
        return 1 / self.mass

    @property
    def inverse_inertia(self) -> float:
        """1/inertia, 1/(kg m^2); 0 for what cannot be turned."""
        return 1 / self.inertia

    @property
    def static(self) -> bool:
        """Whether it stands still whatever happens."""
        return not (self.dynamic or self.kinematic)

    @property
    def constant(self) -> bool:
        """Whether its own force and torque are the same at all times."""
        return not any(varies(law) for law in (*self.force, self.torque))

    @property
    def start(self) -> dict[str, Value]:
        """What laws may use, as it is at the start: time, state and mass."""
        return {
            "time": 0.0,
            "position": self.position,
            "velocity": self.velocity,
            "orientation": self.orientation,
            "angular_velocity": self.angular_velocity,
            "mass": self.mass,
        }

    def force_at(self, time: float, **state: Value) -> Vector:
        """Return the applied force at a time in s, N; `state` holds what else its laws use."""
        x, y = self.force
        known = {"time": time, "mass": self.mass, **state}
        return value_at(x, known), value_at(y, known)

    def torque_at(self, time: float, **state: Value) -> float:
        """Return the applied torque at a time in s, N m; `state` holds what else its law uses."""
        return float(value_at(self.torque, {"time": time, "mass": self.mass, **state}))
