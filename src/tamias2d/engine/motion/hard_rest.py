"""Hard discs that rest on a half-plane that stands: they slide, or roll, in closed form (DD85).

A disc comes to rest where its rebound would be slow, and leaves only when another disc strikes it.
What was at rest as a step begins is seen from where the disc is and how it moves, so that a
restored world goes on alike.
"""

from tamias2d.contact.constrained_acceleration import along_surface
from tamias2d.contact.rolling_disc import (
    held,
    is_pressed,
    load_on,
    rate_of,
    sense_of,
    settled,
    sliding_end,
    slip_change,
)
from tamias2d.engine import tables as tb
from tamias2d.engine.motion.hard_paths import advance_to, closing_of, disc_and_other, place_at
from tamias2d.engine.narrow_phase.material import mixed_material
from tamias2d.engine.tables import Bodies, Contacts, Control, Shapes
from tamias2d.generated import rolling
from tamias2d.kernels.assembled import inlined
from tamias2d.state import Array, Vector

ON_TOP = 2.0**-24  # of the radius: a larger gap is one
DEEPEST = 2.0**-8  # of the radius: ordinary contacts yield by less, as a rule
AT_REST = 2.0**-40  # of the speeds that a velocity is the sum of: what is less is none


def begin_rest(
    p: int, control: Control, bodies: Bodies, shapes: Shapes, contacts: Contacts
) -> bool:
    """Let a disc stay on a half-plane, if a step begins with it at rest there; return whether."""
    s, t = disc_and_other(p, shapes, contacts)
    i, radius = shapes.slot[s], shapes.material[s, tb.SHAPE_RADIUS]
    if shapes.kind[t] != tb.HALF_PLANE or bodies.path[i, tb.RESTS_ON] != 0.0:
        return False
    at, going = place_at(i, 0.0, bodies)
    gap, rate, _ = closing_of(s, t, at, going, 0.0, 0.0, bodies, shapes)
    if (
        gap > ON_TOP * radius
        or gap < -DEEPEST * radius
        or abs(rate) > noise_of(i, radius, control, bodies)
    ):
        return False
    return stay_on(p, 0.0, control, bodies, shapes, contacts)


@inlined
def noise_of(i: int, radius: float, control: Control, bodies: Bodies) -> float:
    """Return which velocity of the contact of a disc counts as none, m/s."""
    motion, settings = bodies.motion[i], control.settings
    pull = abs(settings[tb.GRAVITY_X]) + abs(settings[tb.GRAVITY_Y])
    speed = abs(motion[tb.VX]) + abs(motion[tb.VY]) + radius * abs(motion[tb.SPIN])
    return AT_REST * (speed + settings[tb.TIME_STEP] * pull)


@inlined
def footing(s: int, t: int, shapes: Shapes) -> tuple[Vector, Vector]:
    """Return the arm of a disc to the half-plane below it, m, and the normal of that."""
    side, radius = shapes.world_vertices[shapes.first[t]], shapes.material[s, tb.SHAPE_RADIUS]
    return (0.0 - radius * side[2], 0.0 - radius * side[3]), (side[2], side[3])


def stay_on(
    p: int, now: float, control: Control, bodies: Bodies, shapes: Shapes, contacts: Contacts
) -> bool:
    """Let a disc slide or roll on a half-plane from a time on, s; return whether it is pressed."""
    s, t = disc_and_other(p, shapes, contacts)
    i, (arm, normal) = shapes.slot[s], footing(s, t, shapes)
    motion, path, mass = bodies.motion[i], bodies.path[i], bodies.properties[i]
    loads = (control.settings[tb.GRAVITY_X], control.settings[tb.GRAVITY_Y], 0.0)
    if not is_pressed(loads, arm, normal):
        return False
    friction, _ = mixed_material(s, t, shapes.material, shapes.pair_overrides)
    x, y = along_surface((loads[0], loads[1]), normal)
    add_rest(now, path)
    turning, sense = 0.0, 0
    if friction > 0.0:
        inverses = (mass[tb.INVERSE_MASS], mass[tb.INVERSE_INERTIA])
        going = (motion[tb.VX], motion[tb.VY], motion[tb.SPIN])
        noise = noise_of(i, shapes.material[s, tb.SHAPE_RADIUS], control, bodies)
        sense = sense_of(going, loads, arm, normal, inverses, friction, noise, 0.0)
        x, y, turning, sense = held(loads, arm, normal, inverses, friction, sense)
    path[tb.PATH_BY], path[tb.PATH_BY + 1], path[tb.PATH_BY + 2] = x, y, turning
    path[tb.SLIDES] = sense
    path[tb.REST_FORCE] = rolling.disc_force(load_on(loads, arm, normal), mass[tb.INVERSE_MASS])
    by_friction = slip_change((x - loads[0], y - loads[1], 0.0), arm, normal)
    # the force that ends a tangential acceleration is against the one that makes it
    path[tb.REST_FRICTION] = -rolling.rolling_friction(by_friction, mass[tb.INVERSE_MASS])
    if path[tb.RESTS_ON] != p + 1:
        path[tb.RESTS_ON], path[tb.REST_START] = p + 1, now
        bodies.flight[i, tb.RESTED_ON] = p + 1
    return True


@inlined
def add_rest(now: float, path: Array) -> None:
    """Add what the half-plane on which a disc rests has given it until a time, s, if it does."""
    if path[tb.RESTS_ON] != 0.0:
        path[tb.REST_PUSH] += path[tb.REST_FORCE] * (now - path[tb.REST_START])
        path[tb.REST_DRAG] += path[tb.REST_FRICTION] * (now - path[tb.REST_START])
        path[tb.REST_START] = now


def rests_still(
    i: int, control: Control, bodies: Bodies, shapes: Shapes, contacts: Contacts
) -> bool:
    """Return whether a disc that rests on a half-plane neither leaves it nor is pressed into it."""
    s, t = disc_and_other(int(bodies.path[i, tb.RESTS_ON]) - 1, shapes, contacts)
    arm, normal = footing(s, t, shapes)
    going = (bodies.motion[i, tb.VX], bodies.motion[i, tb.VY], bodies.motion[i, tb.SPIN])
    noise = noise_of(i, shapes.material[s, tb.SHAPE_RADIUS], control, bodies)
    return bool(abs(rate_of(going, arm, normal)) <= noise)


def land(
    p: int, now: float, control: Control, bodies: Bodies, shapes: Shapes, contacts: Contacts
) -> bool:
    """Let a disc whose impact has left it on a half-plane stay there; return whether it does.

    It has not rested on another one in this step.
    """
    s, t = disc_and_other(p, shapes, contacts)
    i, (_, normal) = shapes.slot[s], footing(s, t, shapes)
    if bodies.flight[i, tb.RESTED_ON] != 0.0 and bodies.flight[i, tb.RESTED_ON] != p + 1:
        return False
    motion = bodies.motion[i]
    motion[tb.VX], motion[tb.VY] = along_surface((motion[tb.VX], motion[tb.VY]), normal)
    return stay_on(p, now, control, bodies, shapes, contacts)


def roll_on(
    p: int, now: float, control: Control, bodies: Bodies, shapes: Shapes, contacts: Contacts
) -> None:
    """Let a disc whose sliding ends at a time, s, roll, or slide the other way."""
    s, t = disc_and_other(p, shapes, contacts)
    i, (arm, normal) = shapes.slot[s], footing(s, t, shapes)
    advance_to(i, now, bodies)
    motion, mass = bodies.motion[i], bodies.properties[i]
    going = (motion[tb.VX], motion[tb.VY], motion[tb.SPIN])
    inverses = (mass[tb.INVERSE_MASS], mass[tb.INVERSE_INERTIA])
    friction, _ = mixed_material(s, t, shapes.material, shapes.pair_overrides)
    motion[tb.VX], motion[tb.VY], motion[tb.SPIN] = settled(
        going, arm, normal, inverses, friction, 0
    )
    stay_on(p, now, control, bodies, shapes, contacts)
    bodies.flight[i, tb.REDIRECTED] = 1.0


def leave_plane(i: int, now: float, control: Control, bodies: Bodies) -> None:
    """Let a disc leave the half-plane on which it has rested until a time, s."""
    path = bodies.path[i]
    add_rest(now, path)
    path[tb.RESTS_ON] = 0.0
    path[tb.PATH_BY] = control.settings[tb.GRAVITY_X]
    path[tb.PATH_BY + 1] = control.settings[tb.GRAVITY_Y]
    path[tb.PATH_BY + 2] = 0.0


@inlined
def end_of_sliding(p: int, bodies: Bodies, shapes: Shapes, contacts: Contacts) -> float:
    """Return until when a disc slides on its path on a half-plane, s in the step."""
    s, t = disc_and_other(p, shapes, contacts)
    i, (arm, normal) = shapes.slot[s], footing(s, t, shapes)
    motion, path = bodies.motion[i], bodies.path[i]
    return sliding_end(
        bodies.flight[i, tb.PATH_START],
        (motion[tb.VX], motion[tb.VY], motion[tb.SPIN]),
        (path[tb.PATH_BY], path[tb.PATH_BY + 1], path[tb.PATH_BY + 2]),
        arm,
        normal,
        int(path[tb.SLIDES]),
    )


@inlined
def push_of_rest(i: int, step: float, bodies: Bodies) -> Vector:
    """Return what a half-plane has given a disc by its rest in a step, and begin anew, N s.

    It is what the normal force gave, and what friction gave along the tangent.
    """
    path = bodies.path[i]
    add_rest(step, path)
    push, drag = float(path[tb.REST_PUSH]), float(path[tb.REST_DRAG])
    path[tb.REST_PUSH] = path[tb.REST_DRAG] = path[tb.REST_START] = 0.0
    bodies.flight[i, tb.RESTED_ON] = path[tb.RESTS_ON]
    return push, drag
