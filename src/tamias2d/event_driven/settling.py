"""A disc that stays on a half-plane without friction, and slides along it (GD3)."""

from tamias2d.contact.constrained_acceleration import along_surface
from tamias2d.event_driven import tables as tb
from tamias2d.event_driven.approach import MARGIN
from tamias2d.event_driven.laws import friction_of
from tamias2d.event_driven.tables import Pair, World


def settle(i: int, j: int, normal: Pair, world: World) -> bool:
    """Let a disc stay on the half-plane that it is pressed on; return whether it is so."""
    planes = world.kinds[i] == tb.PLANE, world.kinds[j] == tb.PLANE
    if not (planes[0] or planes[1]):
        return False
    k, plane = (j, i) if planes[0] else (i, j)
    path, body = world.paths[k], world.bodies[k]
    sign = 1.0 if planes[0] else -1.0
    pressing = -sign * (body[tb.AX] * normal[0] + body[tb.AY] * normal[1])
    rough = friction_of(i, j, world) > 0.0
    if rough or pressing <= MARGIN * (abs(body[tb.AX]) + abs(body[tb.AY])):
        return False
    path[tb.VX], path[tb.VY] = along_surface((path[tb.VX], path[tb.VY]), normal)
    path[tb.AX], path[tb.AY] = along_surface((body[tb.AX], body[tb.AY]), normal)
    world.notes[k, tb.HELD_BY] = plane + 1
    return True
