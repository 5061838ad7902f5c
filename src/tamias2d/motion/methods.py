"""The methods: one small value each, which the user hands to `simulate`.

Most find paths along which impacts are located (`PathMethod`). `Legacy2018` gives states at the
ends of its steps only, and `Stepped` solves contacts within its steps.
"""

import math
from abc import ABC, abstractmethod
from dataclasses import dataclass
from typing import ClassVar, TypeAlias

import numpy as np

from tamias2d.errors import InputError
from tamias2d.float64 import EPSILON
from tamias2d.generated import schemes
from tamias2d.motion.adaptive import Adaptive, Tolerance
from tamias2d.motion.closed_form import ClosedFormMotion
from tamias2d.motion.exponential import ExponentialSteps
from tamias2d.motion.fixed_steps import FixedSteps, Scheme
from tamias2d.motion.halved import Halved
from tamias2d.motion.integrated import IntegratedMotion
from tamias2d.motion.law_resolution import LawResolution
from tamias2d.motion.legacy import Legacy2018
from tamias2d.motion.loads import Loads, coordinates, start_states
from tamias2d.motion.method import Method
from tamias2d.motion.motion import Motion
from tamias2d.motion.reference import ScipyDop853
from tamias2d.motion.stability import check
from tamias2d.scene import Scene
from tamias2d.scene.acting import varying_loads
from tamias2d.scene.exact import closed_forms
from tamias2d.scene.joints import refuse_joints
from tamias2d.scene.rules import checked_count, is_number
from tamias2d.suggestions import suggests


class PathMethod(Method, ABC):
    """A method that finds the paths of bodies between impacts."""

    @abstractmethod
    def motion(self, scene: Scene, duration: float, time_step: float) -> Motion:
        """Return the motion of a scene's bodies over a duration in s, in time steps in s."""


@suggests
@dataclass(frozen=True)
class ClosedForm(PathMethod):
    """The exact solution, where all bodies have one (IM1, IM2, IM6, IM7)."""

    def motion(self, scene: Scene, duration: float, time_step: float) -> Motion:  # noqa: ARG002
        """Return exact motion; raise `InputError` if a body has none."""
        solved = closed_forms(scene)
        for body, why in varying_loads(scene).items():
            if body not in solved:
                raise InputError(
                    f"method ClosedForm(): body '{scene.bodies[body].name}' is {why}: it has no "
                    "closed form (IM1, IM2, IM6, IM7). Use Reference(), or a stepped method."
                )
        return ClosedFormMotion(scene, duration)


class _FixedStep(PathMethod):
    """A generated scheme on equal steps."""

    fixed_step = True
    scheme: ClassVar[str]

    def motion(self, scene: Scene, duration: float, time_step: float) -> Motion:
        """Return motion by the scheme; raise `StabilityError` if the steps are too long for it."""
        steps = self._steps(scene, duration, time_step)
        length, _ = _scale(scene, duration)
        notes = check(scene, f"{self}", steps, duration=duration, time_step=time_step, scale=length)
        return IntegratedMotion(scene, duration, steps, notes)

    def _steps(self, scene: Scene, duration: float, time_step: float) -> FixedSteps:  # noqa: ARG002
        step: Scheme = getattr(schemes, self.scheme)
        return FixedSteps(step, duration, time_step)


@suggests
@dataclass(frozen=True)
class ExplicitEuler(_FixedStep):
    """Order 1; gains energy on whatever oscillates."""

    scheme = "explicit_euler"


@suggests
@dataclass(frozen=True)
class SemiImplicitEuler(_FixedStep):
    """Order 1, symplectic: what game engines use."""

    scheme = "semi_implicit_euler"


@suggests
@dataclass(frozen=True)
class VelocityVerlet(_FixedStep):
    """Order 2, symplectic; exact under constant force."""

    scheme = "velocity_verlet"


@suggests
@dataclass(frozen=True)
class RungeKutta4(_FixedStep):
    """Order 4."""

    scheme = "runge_kutta_4"


@suggests
@dataclass(frozen=True)
class Yoshida4(_FixedStep):
    """Order 4, symplectic."""

    scheme = "yoshida_4"


@suggests
@dataclass(frozen=True)
class ExponentialDrag(_FixedStep):
    """Order 2; exact under linear drag and constant loads, which set its steps no limit."""

    scheme = "exponential_verlet"

    def _steps(self, scene: Scene, duration: float, time_step: float) -> FixedSteps:
        refuse_joints(scene.joints, f"method {self}", "Take RungeKutta4(), Reference(), or none.")
        return ExponentialSteps(scene, duration, time_step)


def _is_within(value: object, least: float, below: float) -> bool:
    """Return whether a value is a number in a range."""
    return is_number(value) and bool(least <= value < below)


class _Embedded(PathMethod):
    """A generated pair, with steps as long as a tolerance allows."""

    scheme: ClassVar[str]
    estimates: ClassVar[tuple[int, ...]]
    damping: ClassVar[float]
    rtol: float
    atol: float | None
    halved: bool

    def __str__(self) -> str:
        given = {"rtol": self.rtol, "atol": self.atol, "halved": self.halved or None}
        told = ", ".join(f"{name}={value}" for name, value in given.items() if value is not None)
        return f"{type(self).__name__}({told})"

    def __post_init__(self) -> None:
        if not _is_within(self.rtol, 1e-14, 1.0):
            raise InputError(
                f"rtol {self.rtol!r} of {type(self).__name__}: must lie from 1e-14, which is as "
                "far as float64 goes, to 1 (R5). Give a relative tolerance such as 1e-8."
            )
        if self.atol is not None and not _is_within(self.atol, math.ulp(0.0), math.inf):
            raise InputError(
                f"atol {self.atol!r} m of {type(self).__name__}: must be > 0 (R5). Give a length "
                "in m that does not matter, or leave it out."
            )

    def motion(self, scene: Scene, duration: float, time_step: float) -> Motion:  # noqa: ARG002
        """Return motion by adaptive steps."""
        length, time = _scale(scene, duration)
        small = self.rtol * length if self.atol is None else self.atol
        steps = Adaptive(
            f"{self}",
            getattr(schemes, self.scheme),
            orders=self.estimates,
            tolerance=Tolerance(self.rtol, small, small / time),
            damping=self.damping,
            resolution=LawResolution(scene, duration),
        )
        return IntegratedMotion(scene, duration, Halved(steps) if self.halved else steps)


@suggests
@dataclass(frozen=True)
class DormandPrince5(_Embedded):
    """Order 5, adaptive: the error of each step within `rtol` of every value.

    Of values that are small it is within `atol`, m; without it, `rtol` of the size of the bodies.
    Where they are `halved`, steps of that length are taken in two halves, of smaller errors.
    """

    rtol: float = 1e-6
    atol: float | None = None
    halved: bool = False
    scheme = "dormand_prince_5"
    estimates = (4,)
    damping = 0.04


@suggests
@dataclass(frozen=True)
class Dop853(_Embedded):
    """Order 8, adaptive as `DormandPrince5` is: for tolerances below about 1e-8."""

    rtol: float = 1e-10
    atol: float | None = None
    halved: bool = False
    scheme = "dop853"
    estimates = (5, 3)
    damping = 0.0


@suggests
@dataclass(frozen=True)
class Stepped(Method):
    """Contacts solved in `substeps` of each step: for piles, stacks and all that stays in touch.

    Impacts are not located, and what several contacts at once leave open is decided by the order in
    which they are solved. Free flight is exact; bodies that overlap are pushed apart.
    """

    substeps: int = 4
    fixed_step = True

    def __post_init__(self) -> None:
        remedy = "Give one such as 4; more make contacts firmer."
        checked = checked_count(self.substeps, "substeps", 1, remedy=remedy)
        object.__setattr__(self, "substeps", checked)  # a plain number, as recordings keep it


@suggests
@dataclass(frozen=True)
class Reference(PathMethod):
    """scipy's DOP853 at a relative tolerance `rtol`, for loads that vary with time."""

    rtol: float = 1e-12

    def __post_init__(self) -> None:
        if not _is_within(self.rtol, 1e-13, 1.0):
            raise InputError(
                f"rtol {self.rtol!r} of Reference: must lie from 1e-13, which is as far as float64 "
                "goes, to 1 (R5). Give a relative tolerance such as 1e-12."
            )

    def motion(self, scene: Scene, duration: float, time_step: float) -> Motion:  # noqa: ARG002
        """Return motion by adaptive steps."""
        resolution = LawResolution(scene, duration)
        steps = ScipyDop853(self.rtol, _scale(scene, duration), resolution)
        return IntegratedMotion(scene, duration, steps)


Solvable: TypeAlias = PathMethod | Legacy2018 | Stepped
"""The methods that `simulate` takes."""


_HELD = 2.0**-40  # of the accelerations without joints: less is none


def _scale(scene: Scene, duration: float) -> tuple[float, float]:
    """Return a length in m and a time in s that are not small in a scene."""
    moving = [i for i, body in enumerate(scene.bodies) if body.dynamic]
    shapes = [shape for i in moving if (shape := scene.bodies[i].shape) is not None]
    if shapes or not moving:
        return max((shape.bounding_radius for shape in shapes), default=0.0) or 1.0, duration
    states = start_states(scene)
    q, rate = coordinates([states[i] for i in moving])
    loads = Loads(scene)
    pull = loads.field(moving, [None] * len(moving))(0.0, q, rate)
    free = loads.free_field(moving)(0.0, q, rate)
    place, speed, push, loose = (np.hypot(rows[:, 0], rows[:, 1]) for rows in (q, rate, pull, free))
    ways = (speed * duration + push * duration**2).max()
    if ways <= _HELD * (unheld := (loose * duration**2).max()):
        ways = unheld  # what is left beside what joints exert is rounding
    far = place.max() if place.max() > EPSILON * ways else math.inf
    return float(min(far, ways)) or 1.0, duration
