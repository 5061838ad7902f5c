"""Scenes of hard discs: nothing but gravity and impacts moves them, and only half-planes stand."""

from tamias2d.engine import tables as tb
from tamias2d.engine.tables import Bodies, Shapes
from tamias2d.kernels.assembled import inlined


def are_hard_discs(bodies: Bodies, shapes: Shapes) -> bool:
    """Return whether all that moves are hard discs.

    A sensor tells what is in it, and a surface may run: these need the ordinary way.
    """
    hard = True
    for i in range(len(bodies.kind)):
        hard = hard and bodies.kind[i] != tb.KINEMATIC
        if bodies.kind[i] == tb.DYNAMIC:
            hard = hard and falls_freely(i, bodies)
    for s in range(len(shapes.slot)):
        kind = bodies.kind[shapes.slot[s]]
        disc = shapes.kind[s] == tb.DISC and kind == tb.DYNAMIC
        plane = shapes.kind[s] == tb.HALF_PLANE and kind == tb.STATIC
        plain = shapes.filters[s, tb.SENSOR] == 0 and shapes.material[s, tb.SURFACE_SPEED] == 0.0
        hard = hard and (disc or plane or kind == tb.ABSENT) and plain
    return hard


@inlined
def falls_freely(i: int, bodies: Bodies) -> bool:
    """Return whether no drag and no load acts on a body, and its shapes are around its centre."""
    load, propagator = bodies.load[i], bodies.propagators[int(bodies.properties[i, tb.PROPAGATOR])]
    loaded = abs(load[0]) + abs(load[1]) + abs(load[2]) > 0.0
    going = propagator[tb.WHOLE_STEP + tb.DECAY] == 1.0
    turning = propagator[tb.WHOLE_STEP + tb.ANGULAR + tb.DECAY] == 1.0
    return bool(not loaded and going and turning and bodies.properties[i, tb.CORE_RADIUS] == 0.0)
