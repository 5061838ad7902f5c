"""What counts on the surface of each part of a body: its own values, or those of the body (R3)."""

from collections.abc import Sequence
from numbers import Integral
from typing import Literal, TypeAlias

from tamias2d.scene.bodies import Body
from tamias2d.scene.chain import Chain
from tamias2d.scene.compound import Compound
from tamias2d.scene.rules import RuleError, shown

SurfaceKey: TypeAlias = Literal["restitution", "friction"]


def surface_values(body: Body, key: SurfaceKey) -> tuple[float | None, ...]:
    """Return the value that counts for each part of a body, None where nothing states any.

    A shape of one piece is a single part, each piece of a chain is one, and a particle has none.
    """
    whole: float | None = getattr(body, key)
    if body.shape is None:
        return ()
    if isinstance(body.shape, Compound):
        own = (getattr(part, key) for part in body.shape.parts)
        return tuple(whole if value is None else value for value in own)
    return (whole,) * (len(body.shape.segments) if isinstance(body.shape, Chain) else 1)


def part_numbers(body: Body) -> Sequence[int | None]:
    """Return the numbers of the parts of a compound; None alone for what is none."""
    return range(len(body.shape.parts)) if isinstance(body.shape, Compound) else (None,)


def surface_value(body: Body, part: int | None, key: SurfaceKey) -> float | None:
    """Return the value that counts for one part of a body, or, for None, what the body states.

    Raises:
        RuleError: the body has no such part.
    """
    if part is None:
        value: float | None = getattr(body, key)
        return value
    values = surface_values(body, key) if isinstance(body.shape, Compound) else ()
    whole = isinstance(part, Integral) and not isinstance(part, bool)
    if not (whole and part in range(len(values))):
        raise RuleError(fault_of_part(f"'{body.name}'", part, len(values)), "parts")
    return values[part]


def fault_of_part(body: str, part: object, count: int) -> str:
    """Return what is wrong with the number of a part of a body that has so many, and what helps."""
    if not count:
        return f"part of {body}: found {shown(part)}: the body is no compound (R3). Leave it out."
    return (
        f"part of {body}: found {shown(part)}: it has {count} parts, from 0 on (R3). Give the "
        "number of one of them."
    )
