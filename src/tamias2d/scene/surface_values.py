"""The checked values of a surface: of a body, of a part of one, or of a pair (R3, R4)."""

from tamias2d.scene.rules import number


def checked_restitution(value: object, of: str) -> float:
    """Return a restitution, 0 to 1."""
    return number(value, "restitution", of, "Give a number from 0 to 1.", at=("restitution",))


def optional_restitution(value: object, of: str) -> float | None:
    """Return a restitution, or None where none is stated."""
    return None if value is None else checked_restitution(value, of)


def checked_friction(value: object, of: str) -> float:
    """Return a coefficient of friction, which is not negative."""
    remedy = "Give a number such as 0.5, or 0 for a smooth surface."
    return number(value, "friction", of, remedy, at=("friction",))


def optional_friction(value: object, of: str) -> float | None:
    """Return a coefficient of friction, or None where none is stated."""
    return None if value is None else checked_friction(value, of)
