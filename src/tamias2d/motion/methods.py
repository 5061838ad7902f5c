"""The ways of finding smooth motion: one small value each, which the user hands to `simulate`.

Serves: users, who choose one. Hides: which motion a method makes, and how it is made.
"""

import math
from abc import ABC, abstractmethod
from dataclasses import dataclass
from typing import ClassVar

from tamias2d.errors import InputError
from tamias2d.generated import schemes
from tamias2d.motion.closed_form import ClosedFormMotion
from tamias2d.motion.integrated import IntegratedMotion
from tamias2d.motion.loads import Loads
from tamias2d.motion.piece import Motion
from tamias2d.motion.reference import Dop853
from tamias2d.motion.stepped import Grid, Scheme
from tamias2d.scene import Scene


class Method(ABC):
    """A way of finding smooth motion. A `stepped` one needs a time step."""

    stepped: ClassVar[bool] = False

    @abstractmethod
    def motion(self, scene: Scene, duration: float, time_step: float) -> Motion:
        """Return the motion of a scene's bodies over a duration in s, in time steps in s."""


@dataclass(frozen=True)
class ClosedForm(Method):
    """The exact solution, where every force and torque is constant (IM1, IM2)."""

    def motion(self, scene: Scene, duration: float, time_step: float) -> Motion:  # noqa: ARG002
        """Return exact motion; raise `InputError` if a load varies with time."""
        for body in scene.bodies:
            if not body.constant:
                raise InputError(
                    f"method ClosedForm(): force or torque of body '{body.name}' varies with "
                    "time: the closed form needs constant ones (IM1, IM2). Use Reference(), or a "
                    "stepped method."
                )
        return ClosedFormMotion(scene, duration)


class _Stepped(Method):
    """A generated scheme on equal steps."""

    stepped = True
    scheme: ClassVar[str]

    def motion(self, scene: Scene, duration: float, time_step: float) -> Motion:
        """Return motion by the scheme."""
        step: Scheme = getattr(schemes, self.scheme)
        return IntegratedMotion(scene, duration, Grid(step, duration, time_step))


@dataclass(frozen=True)
class ExplicitEuler(_Stepped):
    """Order 1; gains energy on whatever oscillates."""

    scheme = "explicit_euler"


@dataclass(frozen=True)
class SemiImplicitEuler(_Stepped):
    """Order 1, symplectic: what game engines use."""

    scheme = "semi_implicit_euler"


@dataclass(frozen=True)
class VelocityVerlet(_Stepped):
    """Order 2, symplectic; exact under constant force."""

    scheme = "velocity_verlet"


@dataclass(frozen=True)
class RungeKutta4(_Stepped):
    """Order 4."""

    scheme = "runge_kutta_4"


@dataclass(frozen=True)
class Legacy2018(Method):
    """What the 2018 program did, wrong as it was: for scenes in which nothing meets."""

    stepped = True

    def motion(self, scene: Scene, duration: float, time_step: float) -> Motion:
        """Raise: this scheme has no path between its steps (see `legacy_history`)."""
        raise NotImplementedError


@dataclass(frozen=True)
class Reference(Method):
    """scipy's DOP853 at a relative tolerance `rtol`, for loads that vary with time."""

    rtol: float = 1e-12

    def __post_init__(self) -> None:
        if not 1e-13 <= self.rtol < 1:
            raise InputError(
                f"rtol {self.rtol!r} of Reference: must lie from 1e-13, which is as far as float64 "
                "goes, to 1 (R5). Give a relative tolerance such as 1e-12."
            )

    def motion(self, scene: Scene, duration: float, time_step: float) -> Motion:  # noqa: ARG002
        """Return motion by adaptive steps."""
        return IntegratedMotion(scene, duration, Dop853(self.rtol, _scale(scene, duration)))


def _scale(scene: Scene, duration: float) -> tuple[float, float]:
    """Return a length in m and a time in s that are not small in a scene."""
    moving = [(i, body) for i, body in enumerate(scene.bodies) if body.dynamic]
    sizes = [body.shape.bounding_radius for _, body in moving if body.shape is not None]
    if not sizes:
        loads = Loads(scene)
        sizes = [
            math.hypot(*body.velocity) * duration
            + math.hypot(*loads.acceleration(i, 0.0)[:2]) * duration**2
            for i, body in moving
        ]
    return max(sizes, default=0.0) or 1.0, duration
