"""Clusters: bodies that meet when a part of a step may have no more impacts go on together in it.

Their centre of mass goes its way, and they keep their angular momentum. A body that meets something
that is driven or stands, such as a wall, is carried along. Those that go together are linked in
circles. Cost: linear in their number, for each that joins them.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.continuous.cluster_as_one import (
    cluster_turning,
    return_cluster_turning,
    take_energy_of_cluster_back,
)
from tamias2d.engine.continuous.trajectory import redirect_path, relative_place
from tamias2d.engine.continuous.work import take_energy_back, work_ahead
from tamias2d.engine.energy.step_energy import can_be_turned
from tamias2d.engine.tables import Bodies, Control, Integers
from tamias2d.generated.continuous_collision import inward_share, shift_carried, shift_shared
from tamias2d.state import Array, Vector

MOST_ARC = 0.5  # rad: how far a wall turns at most while a body that it carries goes straight
# ranks: those of carried bodies stand in flight[REDIRECTED]
CARRIED_BY_BODY, CARRIED_BY_WALL, IMMOVABLE = 2.0, 3.0, 4.0
RISE, RISE_BY_WALL = 1.0 / 8.0, 1.0 / 64.0  # of a rank, each time that a body is carried


def join_or_carry(
    i: int, j: int, now: float, control: Control, bodies: Bodies, together: Integers
) -> bool:
    """Let two bodies that meet go on together; return whether this changes their paths.

    A body that meets one that is driven, or carried, is carried along. One that is carried by walls
    is carried by nothing else, and by these not for ever: it may be jammed.
    """
    rank_i = carrier_rank(i, bodies.flight, bodies.kind)
    rank_j = carrier_rank(j, bodies.flight, bodies.kind)
    if max(rank_i, rank_j) < CARRIED_BY_BODY:
        return join(i, j, now, control, bodies, together)
    if rank_i < rank_j:
        i, j = j, i
    rank, wall = min(rank_i, rank_j), bodies.kind[i] != tb.DYNAMIC
    if rank >= (IMMOVABLE if wall else CARRIED_BY_WALL):
        return False
    by, turn = displacement_along(i, j, now, bodies)
    leave(j, together)
    redirect(j, now, by, turn, control, bodies)
    if wall:
        bodies.flight[j, tb.REDIRECTED] = max(rank + RISE_BY_WALL, CARRIED_BY_WALL)
    else:
        bodies.flight[j, tb.REDIRECTED] = max(rank + RISE, CARRIED_BY_BODY)
    return True


def carrier_rank(i: int, flight: Array, kind: Integers) -> float:
    """Return how near a body is to something immovable that carries it."""
    return float(flight[i, tb.REDIRECTED]) if kind[i] == tb.DYNAMIC else IMMOVABLE


def is_carried(i: int, flight: Array, kind: Integers) -> bool:
    """Return whether a body is immovable, or carried by something that is."""
    return carrier_rank(i, flight, kind) >= CARRIED_BY_BODY


def hold(i: int, now: float, control: Control, bodies: Bodies, together: Integers) -> None:
    """Let a body stay where it is for the rest of the step."""
    if bodies.kind[i] == tb.DYNAMIC:
        leave(i, together)
        redirect(i, now, (0.0, 0.0), 0.0, control, bodies)


def join(i: int, j: int, now: float, control: Control, bodies: Bodies, together: Integers) -> bool:
    """Let two bodies and those that go with them go the way of their centre of mass, and not turn.

    Returns whether they did not go together yet.
    """
    motion = bodies.motion
    mass_i = mass_j = 0.0
    k = i
    while k != i or mass_i == 0.0:
        mass_i += 1.0 / bodies.properties[k, tb.INVERSE_MASS]
        k = together[k]
        if k == j:
            return False
    k = j
    while k != j or mass_j == 0.0:
        mass_j += 1.0 / bodies.properties[k, tb.INVERSE_MASS]
        k = together[k]
    way_i, way_j = (motion[i, tb.DX], motion[i, tb.DY]), (motion[j, tb.DX], motion[j, tb.DY])
    by = shift_shared(mass_i, way_i, mass_j, way_j)
    together[i], together[j] = together[j], together[i]
    origin = (bodies.pose[i, tb.X], bodies.pose[i, tb.Y])
    before = cluster_turning(i, origin, bodies, together)
    undone = take_along(i, now, by, control, bodies)
    k = together[i]
    while k != i:
        undone += take_along(k, now, by, control, bodies)
        k = together[k]
    take_energy_of_cluster_back(i, undone, bodies, together)
    return_cluster_turning(i, origin, before, bodies, together)
    return True


def take_along(i: int, now: float, by: Vector, control: Control, bodies: Bodies) -> float:
    """Let a body go the way that it shares, and not turn; return by how much forces do less, J."""
    bodies.flight[i, tb.REDIRECTED] = 1.0
    return change_way(i, now, by, 0.0, control, bodies)


def leave(i: int, together: Integers) -> None:
    """Let a body go alone."""
    k = i
    while together[k] != i:
        k = together[k]
    together[k], together[i] = together[i], i


def displacement_along(i: int, j: int, now: float, bodies: Bodies) -> tuple[Vector, float]:
    """Return the displacement of body j as a part of i, m and rad, as far as a line can be.

    What cannot be turned only goes along.

    Along with a wall that turns it begins on the inside of its arc, and cuts that before the wall
    has turned by `MOST_ARC`: there both meet again.
    """
    shift, turn = (bodies.motion[i, tb.DX], bodies.motion[i, tb.DY]), bodies.motion[i, tb.DANGLE]
    offset = relative_place(i, j, now, bodies.pose, bodies.motion)
    inwards = inward_share(turn, now, MOST_ARC) if bodies.kind[i] != tb.DYNAMIC else 0.0
    by = shift_carried(shift, turn, offset, inwards)
    return by, turn if can_be_turned(j, bodies.properties) else 0.0


def redirect(i: int, now: float, to: Vector, turn: float, control: Control, bodies: Bodies) -> None:
    """Give a body another displacement over a whole step, without an impulse: its velocity stays.

    But what forces have given it for the part of its path that it does not go is taken back.
    """
    time_step = control.progress[tb.PART_TIME]
    undone = change_way(i, now, to, turn, control, bodies)
    support = (to[0] / time_step, to[1] / time_step)
    take_energy_back(i, undone, support, turn / time_step, bodies.motion, bodies.properties)


def change_way(
    i: int, now: float, to: Vector, turn: float, control: Control, bodies: Bodies
) -> float:
    """Give a body another displacement over a whole step; return by how much forces do less, J."""
    left = 1.0 - now
    before = work_ahead(i, left, control, bodies)
    by = (to[0] - bodies.motion[i, tb.DX], to[1] - bodies.motion[i, tb.DY])
    redirect_path(i, now, by, turn - bodies.motion[i, tb.DANGLE], bodies.pose, bodies.motion)
    return before - work_ahead(i, left, control, bodies)
