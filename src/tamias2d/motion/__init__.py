"""Smooth motion: how bodies move in free flight, or while a contact lasts.

Serves: the path of a body from a state and a time on, as a function of time with bounds on its
derivatives. Hides: how that path is found (closed form, a scheme, scipy).
"""

from tamias2d.motion.adaptive import StepSizeError
from tamias2d.motion.joint_events import JointEvent, JointEvents, joint_events
from tamias2d.motion.legacy import Legacy2018
from tamias2d.motion.limited_mechanism import LimitHeldError
from tamias2d.motion.mechanism import JointError
from tamias2d.motion.method import Method
from tamias2d.motion.methods import (
    ClosedForm,
    Dop853,
    DormandPrince5,
    ExplicitEuler,
    ExponentialDrag,
    PathMethod,
    Reference,
    RungeKutta4,
    SemiImplicitEuler,
    Solvable,
    Stepped,
    VelocityVerlet,
    Yoshida4,
)
from tamias2d.motion.motion import Motion, Tally
from tamias2d.motion.reactions import Reactions, reactions_of
from tamias2d.motion.stability import StabilityError
from tamias2d.path import Bounds, PathPiece

__all__ = [
    "Bounds",
    "ClosedForm",
    "Dop853",
    "DormandPrince5",
    "ExplicitEuler",
    "ExponentialDrag",
    "JointError",
    "JointEvent",
    "JointEvents",
    "Legacy2018",
    "LimitHeldError",
    "Method",
    "Motion",
    "PathMethod",
    "PathPiece",
    "Reactions",
    "Reference",
    "RungeKutta4",
    "SemiImplicitEuler",
    "Solvable",
    "StabilityError",
    "StepSizeError",
    "Stepped",
    "Tally",
    "VelocityVerlet",
    "Yoshida4",
    "joint_events",
    "reactions_of",
]
