"""The checks of a scene's and a body's values, one function a value (R2, R3, R4)."""

import math
from collections.abc import Container
from typing import get_args

from tamias2d.generated.symbols import SYMBOLS
from tamias2d.scene.bodies import Body
from tamias2d.scene.chain import Chain
from tamias2d.scene.compound import Shape
from tamias2d.scene.law import first_value
from tamias2d.scene.rules import RuleError, Vector, number, shown, vector
from tamias2d.scene.shapes import HalfPlane

MAX_NAME = 100  # characters
REMEDY_OF_SURFACE_SPEED = "Give it in m/s, 0 for a surface that does not run."
SHAPES: tuple[type, ...] = get_args(Shape)


def checked_text(value: object, key: str) -> str:
    """Return printable text, or raise `RuleError`."""
    if not isinstance(value, str) or not value.isprintable():
        raise RuleError(
            f"{key}: found {shown(value)}: must be text of printable characters (R1). Rewrite it.",
            key,
        )
    return value


def checked_duration(value: object) -> float:
    """Return a positive duration, s."""
    return number(
        value, "duration", "the scene", "Give a positive duration in s.", at=("duration",)
    )


def checked_angle(value: object, of: str) -> float:
    """Return an orientation, rad."""
    return number(value, "orientation", of, "Give it in rad.", at=("orientation",))


def checked_velocity(value: object, of: str) -> Vector:
    """Return a velocity, m/s."""
    return vector(value, "velocity", of, "Give (x, y) in m/s.", at=("velocity",))


def checked_spin(value: object, of: str) -> float:
    """Return an angular velocity, rad/s."""
    return number(value, "angular_velocity", of, "Give it in rad/s.", at=("angular_velocity",))


def checked_surface_speed(value: object, of: str) -> float:
    """Return a speed of a surface, m/s."""
    return number(value, "surface_speed", of, REMEDY_OF_SURFACE_SPEED, at=("surface_speed",))


def checked_drag(value: object, symbol: str, of: str) -> float:
    """Return the coefficient of linear, quadratic or angular drag, which is not negative."""
    unit = SYMBOLS[symbol].unit
    return number(value, symbol, of, f"Give it in {unit}, 0 for none.", at=(symbol,))


def checked_mass(value: object, of: str) -> float:
    """Return a mass, kg, whose inverse is a number too."""
    remedy = "Give a positive mass, or make the body static."
    mass = number(value, "mass", of, remedy, at=("mass",))
    return _invertible(mass, "mass", "kg", of)


def checked_name(name: object, taken: Container[str]) -> str:
    """Return the name of a body, which no other one has, or raise `RuleError`."""
    text = checked_text(name, "name")
    if not text.strip() or len(text) > MAX_NAME:
        raise RuleError(
            f"name {shown(text)} of a body: must have 1 to {MAX_NAME} characters (R1). "
            "Give a word.",
            "name",
        )
    if text in taken:
        raise RuleError(
            f"name '{text}': another body has it (R1). Give each body a name of its own.",
            "name",
        )
    return text


REMEDY_OF_INERTIA = (
    "Give a positive inertia in kg m^2, or math.inf for a body that nothing turns, or leave it out."
)


def checked_inertia(value: object, mass: float, shape: Shape | None, of: str) -> float:
    """Return the inertia that is stated or that follows from mass and shape, kg m^2.

    It is infinite for what nothing turns.
    """
    if isinstance(value, float) and value == math.inf:
        return math.inf
    if value is not None:
        inertia = number(value, "inertia", of, REMEDY_OF_INERTIA, at=("inertia",))
    elif shape is None or isinstance(shape, HalfPlane | Chain):
        return math.inf
    else:
        inertia = shape.inertia(mass)
    return _invertible(inertia, "inertia", "kg m^2", of)


def _invertible(value: float, key: str, unit: str, of: str) -> float:
    """Refuse a value whose inverse float64 cannot hold."""
    if not 1 / math.inf < value < math.inf or not math.isfinite(1 / value):
        raise RuleError(
            f"{key} {value:g} {unit} of {of}: float64 cannot hold its inverse (R4). "
            "Choose units in which it is nearer to 1.",
            key,
        )
    return value


def refuse_shape(
    shape: object, of: str, *, static: bool = False, told: bool = False, none: bool = False
) -> None:
    """Refuse what is no shape unless it is `none`, and ground that may not move like its body.

    A body is `static`, or moves as it is `told`, or freely.
    """
    if isinstance(shape, HalfPlane) and not static:
        raise RuleError(
            f"shape of {of}: found a half-plane: it cannot move (R4). Add it as a static body.",
            "shape",
        )
    if isinstance(shape, Chain) and not (static or told):
        raise RuleError(
            f"shape of {of}: found a chain: it cannot move freely (R4). Add it as a static or a "
            "kinematic body.",
            "shape",
        )
    if not (isinstance(shape, SHAPES) or (shape is None and none)):
        raise RuleError(
            f"shape of {of}: found {shown(shape)}: must be a shape (R4). Give a Disc, Box, "
            "Polygon, Capsule, Segment, Compound or, for a static body, a HalfPlane or Chain; a "
            "kinematic body may have a Chain.",
            "shape",
        )


def refuse_undefined_law(body: Body) -> None:
    """Refuse a law that has no value where its body starts."""
    for k, law in enumerate(body.force):
        first_value(law, body.start, at=("force", k))
    first_value(body.torque, body.start, at=("torque",))


def refuse_turned(body: Body) -> None:
    """Refuse torque or spin where nothing says the inertia, or where that is infinite."""
    for key in ("torque", "angular_velocity"):
        if getattr(body, key) != 0.0 and body.inertia == math.inf:
            raise RuleError(
                f"inertia of body '{body.name}': {fault_of_turning(key, body.inertia_stated)}",
                "inertia",
            )


def fault_of_turning(key: str, stated: bool) -> str:
    """Return what is wrong where something turns a body without an inertia, and what helps."""
    if stated:
        return (
            f"found inf, though its {key} is not 0: nothing turns such a body (R2, IM2). State a "
            f"finite one in kg m^2, or leave the {key} out."
        )
    return (
        f"found none, though its {key} is not 0 (R2, IM2). State the inertia in kg m^2, or give "
        "the body a shape."
    )


def refuse_placed_half_plane(body: Body) -> None:
    """Refuse a half-plane with a position or an orientation: its normal and offset place it."""
    placed = {"position": body.position != (0, 0), "orientation": body.orientation != 0}
    for key, given in placed.items():
        if isinstance(body.shape, HalfPlane) and given:
            raise RuleError(
                f"{key} of static body '{body.name}': a half-plane has none (R4). "
                "Say where it is by its normal and offset.",
                key,
            )
