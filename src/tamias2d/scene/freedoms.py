"""What a joint leaves free: an angle, a travel or a distance, with limits, a motor, a spring.

Each is measured by a constraint of srs/models/joints.md (GD21, GD22, DD64, DD65, DD103).
"""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, fields, replace
from typing import Literal, TypeAlias, TypeVar

from tamias2d.scene.forms import within
from tamias2d.scene.rules import RuleError, number, shown
from tamias2d.suggestions import suggests

_T = TypeVar("_T")
_ON_TOOTH = 1e-9  # of the pitch: as near to a tooth as that is on it
Measure: TypeAlias = Literal["angle", "travel", "distance"]
VALUE_OF = {"angle": "joint_angle", "travel": "joint_travel", "distance": "joint_length"}
"""The parameter at which each measure, as a constraint, is kept."""


def limit_symbols(measure: Measure) -> dict[str, str]:
    """Return the symbol of each value of the limits of a measure."""
    place = "joint_angle" if measure == "angle" else "joint_travel"
    return {"lower": place, "upper": place, "restitution": "restitution"}


def motor_symbols(measure: Measure) -> dict[str, str]:
    """Return the symbol of each value of a motor."""
    if measure == "angle":
        return {"speed": "motor_spin", "maximum": "joint_torque_most"}
    return {"speed": "motor_speed", "maximum": "joint_force_most"}


def spring_symbols(measure: Measure) -> dict[str, str]:
    """Return the symbol of each value of a spring."""
    if measure == "angle":
        return {
            "stiffness": "rotary_stiffness",
            "damping": "rotary_damping",
            "rest": "joint_angle",
            "maximum": "joint_torque_most",
        }
    return {
        "stiffness": "joint_stiffness",
        "damping": "damping",
        "rest": "joint_travel",
        "maximum": "joint_force_most",
    }


@suggests
@dataclass(frozen=True, kw_only=True)
class Limits:
    """How far a joint may turn, rad, or reach, m; at least one end (GD21).

    At an end it keeps `restitution` of its speed, turned around.
    """

    restitution: float
    lower: float | None = None
    upper: float | None = None


@suggests
@dataclass(frozen=True, kw_only=True)
class Motor:
    """What keeps a joint at a `speed`, rad/s or m/s (GD22).

    It does so with a torque, N m, or a force, N, of at most `maximum`; None for what it takes. At
    speed 0 it is a brake, or dry friction.
    """

    speed: float
    maximum: float | None = None


@suggests
@dataclass(frozen=True, kw_only=True)
class JointSpring:
    """What pulls a joint to `rest`, rad or m, as at the start unless given (DD64, DD65).

    With `stiffness`, N m/rad or N/m, and `damping`, N m s/rad or kg/s. Both together exert a
    torque, N m, or a force, N, of at most `maximum`; None for what they do (DD103).
    """

    stiffness: float
    damping: float = 0.0
    rest: float | None = None
    maximum: float | None = None


_OFF = Motor(speed=0.0, maximum=0.0)  # it gives nothing
_SLACK = JointSpring(stiffness=0.0)  # likewise
_FAR = 1e15  # m or rad: a limit there is never reached


@dataclass(frozen=True, kw_only=True)
class Freedom:
    """One number that a joint leaves free, checked."""

    measure: Measure
    limits: Limits | None = None
    motor: Motor | None = None
    spring: JointSpring | None = None
    pitch: float | None = None
    """From one tooth to the next, rad, of a ratchet."""
    across: bool = False
    """Whether a travel is that across the line, a quarter turn on."""


def freedom(
    measure: Measure,
    of: str,
    *,
    limits: object = None,
    motor: object = None,
    spring: object = None,
) -> tuple[Freedom, ...]:
    """Return what a joint leaves free, checked, if anything is said of it."""
    if limits is None and motor is None and spring is None:
        return ()
    found = Freedom(
        measure=measure,
        limits=_limits(limits, measure, of),
        motor=_motor(motor, measure, of),
        spring=_spring(spring, measure, of),
    )
    return (found,)


def with_motor(freedom: Freedom, motor: object, of: str) -> Freedom:
    """Return a freedom with another motor, checked, in place of its own; None turns it off."""
    return replace(freedom, motor=_motor(motor, freedom.measure, of) or _OFF)


def with_limits(freedom: Freedom, limits: object, of: str) -> Freedom:
    """Return a freedom with other limits, checked; what they leave out, or None, limits nothing."""
    new, own = _limits(limits, freedom.measure, of), freedom.limits or Limits(restitution=0.0)
    if freedom.pitch is not None:
        raise RuleError(
            f"limits of {of}: its teeth limit a ratchet (GD21). Add one of another pitch.", "limits"
        )
    kept = own.restitution if new is None else new.restitution
    lower, upper = (None, None) if new is None else (new.lower, new.upper)
    for end, had, value in (("lower", own.lower, lower), ("upper", own.upper, upper)):
        if had is None and value is not None:
            raise RuleError(
                f"{end} {value:g} of limits of {of}: it has no such limit that could be set "
                "(GD21). Leave it out, or give the joint both as you add it.",
                *("limits", end),
            )
    return replace(
        freedom,
        limits=Limits(
            restitution=kept,
            lower=_or_far(lower, own.lower, -_FAR),
            upper=_or_far(upper, own.upper, _FAR),
        ),
    )


def _or_far(value: float | None, had: float | None, far: float) -> float | None:
    """Return a limit; one that is left out, where there was one, is far away."""
    return far if value is None and had is not None else value


def with_spring(freedom: Freedom, spring: object, of: str) -> Freedom:
    """Return a freedom with another spring, checked; None turns it off.

    It is at rest where the one before was unless said.
    """
    new, own = _spring(spring, freedom.measure, of) or _SLACK, freedom.spring
    rest = own.rest if own and new.rest is None else new.rest
    return replace(freedom, spring=replace(new, rest=rest))


def ratchet(of: str, *, pitch: object, restitution: object) -> tuple[Freedom, ...]:
    """Return an angle that falls back no further than to its last tooth, checked."""
    remedy = "Give the angle from one tooth to the next, rad."
    step = number(pitch, "tooth_pitch", of, remedy, at=("pitch",))
    remedy = "Give the share of the speed that is left, from 0 to 1."
    kept = number(restitution, "restitution", of, remedy, at=("restitution",))
    return (Freedom(measure="angle", limits=Limits(restitution=kept), pitch=step),)


def last_tooth(angle: float, pitch: float) -> float:
    """Return the last tooth, rad, of a ratchet at an angle, rad, but for rounding."""
    return math.floor(angle / pitch + _ON_TOOTH) * pitch


def target(of: str, *, spring: object) -> tuple[Freedom, Freedom]:
    """Return both travels of a point that springs alike pull to another one, checked."""
    pull = _pulling(spring, "travel", of)
    refuse_rest(pull, of)
    along = Freedom(measure="travel", spring=replace(pull, rest=0.0))
    return along, replace(along, across=True)


def refuse_rest(spring: JointSpring, of: str) -> None:
    """Refuse a spring of a target that is at rest elsewhere than at the point."""
    if spring.rest:
        raise RuleError(
            f"spring of {of}: rest {spring.rest:g} m: it pulls to the point itself (DD64). "
            "Leave rest out, and move the point.",
            *("spring", "rest"),
        )


def at_rest(freedoms: Sequence[Freedom], start: Sequence[float]) -> tuple[Freedom, ...]:
    """Return the freedoms, with springs that are at rest where nothing else is said."""
    return tuple(
        replace(each, spring=replace(each.spring, rest=value))
        if each.spring and each.spring.rest is None
        else each
        for each, value in zip(freedoms, start, strict=True)
    )


def refuse_crossed(freedoms: Sequence[Freedom], start: Sequence[float], of: str) -> None:
    """Refuse a joint that is beyond its limits at the start."""
    for each, value in zip(freedoms, start, strict=True):
        limits = each.limits or Limits(restitution=0)
        lower = -math.inf if limits.lower is None else limits.lower
        upper = math.inf if limits.upper is None else limits.upper
        unit = "rad" if each.measure == "angle" else "m"
        slight = 1e-9 * (abs(value) + 1e-3)
        if not lower - slight <= value <= upper + slight:
            raise RuleError(
                f"limits of {of}: its {each.measure} is {value:g} {unit} at the start, beyond them "
                f"({_shown(limits.lower)} to {_shown(limits.upper)} {unit}) (GD21). Move the "
                "bodies, or the limits.",
                "limits",
            )


def _shown(value: float | None) -> str:
    return "any" if value is None else f"{value:g}"


def _limits(value: object, measure: Measure, of: str) -> Limits | None:
    if value is None:
        return None
    what = f"limits of {of}"
    limits = _checked(value, Limits, limit_symbols(measure), what, "limits")
    lower, upper = limits.lower, limits.upper
    if lower is None and upper is None:
        raise RuleError(f"{what}: found none (GD21). Give lower, upper or both.", "limits")
    if lower is not None and upper is not None and lower >= upper:
        raise RuleError(
            f"{what}: lower {lower:g} is not below upper {upper:g} (GD21). Exchange them; a joint "
            "that does not move is another kind.",
            *("limits", "lower"),
        )
    if measure == "distance" and upper is not None and upper <= 0:
        raise RuleError(
            f"{what}: upper {upper:g} m: a distance is positive (GD21). Give a longer one; two "
            "points at one place are held by a Revolute().",
            *("limits", "upper"),
        )
    return limits


def _motor(value: object, measure: Measure, of: str) -> Motor | None:
    if value is None:
        return None
    return _checked(value, Motor, motor_symbols(measure), f"motor of {of}", "motor")


def _spring(value: object, measure: Measure, of: str) -> JointSpring | None:
    if value is None:
        return None
    return _pulling(value, measure, of)


def _pulling(value: object, measure: Measure, of: str) -> JointSpring:
    """Return a spring, checked: it has a stiffness, or is a damper by itself."""
    what = f"spring of {of}"
    spring = _checked(value, JointSpring, spring_symbols(measure), what, "spring")
    if spring.stiffness == 0 and spring.damping == 0:
        unit = "N*m/rad" if measure == "angle" else "N/m"
        raise RuleError(
            f"stiffness 0 {unit} of {what}: must be > 0, or its damping (DD64). Give one of them.",
            *("spring", "stiffness"),
        )
    return spring


def _checked(value: object, kind: type[_T], symbols: Mapping[str, str], what: str, key: str) -> _T:
    """Return a value of a kind with numbers within the ranges of their symbols."""
    remedy = f"Give {kind.__name__}({', '.join(f'{name}=' for name in symbols)})."
    if not isinstance(value, kind):
        raise RuleError(f"{what}: found {shown(value)}: must be one (GD21). {remedy}", key)
    given = {name: getattr(value, name) for name in symbols}
    optional = {field.name for field in fields(kind) if field.default is None}  # type: ignore[arg-type]
    with within(key):
        numbers = {
            name: number(at, symbols[name], what, remedy, at=(name,))
            for name, at in given.items()
            if at is not None or name not in optional
        }
    return kind(**{**given, **numbers})
