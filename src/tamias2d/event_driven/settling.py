"""A disc that stays on a half-plane without friction, and slides along it (GD3)."""

from tamias2d.contact.constrained_acceleration import along_surface
from tamias2d.event_driven.approach import MARGIN
from tamias2d.event_driven.laws import friction_of
from tamias2d.event_driven.tables import (
    AX,
    AY,
    HELD_BY,
    PLANE,
    VX,
    VY,
    Pair,
    World,
)


def settle(i: int, j: int, normal: Pair, world: World) -> bool:
    """Let a disc stay on the half-plane that it is pressed on; return whether it is so."""
    planes = world.kinds[i] == PLANE, world.kinds[j] == PLANE
    if not (planes[0] or planes[1]):
        return False
    k, plane = (j, i) if planes[0] else (i, j)
    path, body = world.paths[k], world.bodies[k]
    sign = 1.0 if planes[0] else -1.0
    pressing = -sign * (body[AX] * normal[0] + body[AY] * normal[1])
    rough = friction_of(i, j, world) > 0.0
    if rough or pressing <= MARGIN * (abs(body[AX]) + abs(body[AY])):
        return False
    path[VX], path[VY] = along_surface((path[VX], path[VY]), normal)
    path[AX], path[AY] = along_surface((body[AX], body[AY]), normal)
    world.notes[k, HELD_BY] = plane + 1
    return True
