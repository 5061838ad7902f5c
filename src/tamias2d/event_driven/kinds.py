"""What kinds of bodies there are: with corners or without, pushed or fixed."""

from tamias2d.event_driven import tables as tb
from tamias2d.event_driven.tables import World
from tamias2d.kernels.assembled import inlined


@inlined
def is_pushed(k: int, world: World) -> bool:
    """Return whether impacts change how a body moves."""
    return bool(world.kinds[k] >= tb.DISC)


@inlined
def has_hull(i: int, j: int, world: World) -> bool:
    """Return whether one of two bodies has corners."""
    corners = tb.HULL, tb.FIXED_HULL
    return bool(world.kinds[i] in corners or world.kinds[j] in corners)
