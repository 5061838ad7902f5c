"""Bodies for which a step has no more impacts: they wait for the next, where nothing is.

Serves: flight. Hides: what goes along with what cannot wait, and that nobody gains by waiting.

A step has given a velocity what forces give on all of its way. What is not gone of this way is
taken back from the kinetic energy, as it is seen from where the body waits: in the world, or on
something that moves on.
"""

from tamias2d.generated.definitions import kinetic_energy
from tamias2d.generated.island_energy import (
    angular_velocity_calmed,
    angular_velocity_seen,
    calm_share,
    velocity_calmed,
    velocity_seen,
    work,
)
from tamias2d.state import Array, Vector
from tamias2d.stepped.energy import mass_and_inertia
from tamias2d.stepped.flight_impact import BENT
from tamias2d.stepped.layout import (
    DTURN,
    DX,
    DY,
    DYNAMIC,
    GRAVITY_X,
    GRAVITY_Y,
    SPIN,
    TIME_STEP,
    VX,
    VY,
    Whole,
    X,
    Y,
)
from tamias2d.stepped.trajectory import bend_line

PUSHED_ON = 2.0  # instead of 1 where a line is bent: as that of something that does not wait


def stand_by(
    i: int,
    j: int,
    now: float,
    again: bool,
    settings: Array,
    pose: Array,
    motion: Array,
    load: Array,
    body: Array,
    gained: Array,
    kind: Whole,
) -> bool:
    """Let two bodies that meet wait for the next step; return whether this changes their lines.

    What has met something that cannot wait, or something that goes along with that, goes along,
    too; `again` says that this may happen to a body more than once.
    """
    held_i, held_j = cannot_wait(i, gained, kind), cannot_wait(j, gained, kind)
    if not held_i and not held_j:
        wait(i, now, settings, pose, motion, load, body, kind)
        wait(j, now, settings, pose, motion, load, body, kind)
        return True
    if held_i and held_j and not again:
        return False
    if kind[j] != DYNAMIC or (held_j and kind[i] == DYNAMIC):
        i, j = j, i
    way, turn = way_along(i, j, now, pose, motion)
    lead(j, now, way, turn, settings, pose, motion, load, body)
    gained[j, BENT] = PUSHED_ON
    return True


def cannot_wait(i: int, gained: Array, kind: Whole) -> bool:
    """Return whether a body stays on its line whatever it meets, or goes along with such a one."""
    return bool(kind[i] != DYNAMIC or gained[i, BENT] == PUSHED_ON)


def wait(
    i: int,
    now: float,
    settings: Array,
    pose: Array,
    motion: Array,
    load: Array,
    body: Array,
    kind: Whole,
) -> None:
    """Let a body stay where it is for the rest of the step."""
    if kind[i] == DYNAMIC:
        lead(i, now, (0.0, 0.0), 0.0, settings, pose, motion, load, body)


def way_along(i: int, j: int, now: float, pose: Array, motion: Array) -> tuple[Vector, float]:
    """Return the way of a body j, m and rad, as if it were a part of i, as far as a line can be.

    The line leads on the inside of the arc on which it would go.
    """
    x = pose[j, X] - pose[i, X] + now * (motion[j, DX] - motion[i, DX])
    y = pose[j, Y] - pose[i, Y] + now * (motion[j, DY] - motion[i, DY])
    turn = motion[i, DTURN]
    inwards = turn * turn * (1.0 - now)
    way = (
        motion[i, DX] - turn * y - inwards * x,
        motion[i, DY] + turn * x - inwards * y,
    )
    return way, turn


def lead(
    i: int,
    now: float,
    way: Vector,
    turn: float,
    settings: Array,
    pose: Array,
    motion: Array,
    load: Array,
    body: Array,
) -> None:
    """Lead a body another way, over a whole step, without an impulse: its velocity stays.

    But what forces have given it for the way that it does not go any more is taken back.
    """
    undone = velocity_seen((motion[i, DX], motion[i, DY]), way)
    unturned = angular_velocity_seen(motion[i, DTURN], turn)
    bend_line(i, now, (-undone[0], -undone[1]), -unturned, pose, motion)
    mass, inertia = mass_and_inertia(i, body)
    left = 1.0 - now
    surplus = work(
        mass,
        (settings[GRAVITY_X], settings[GRAVITY_Y]),
        (load[i, 0], load[i, 1]),
        load[i, 2],
        (left * undone[0], left * undone[1]),
        left * unturned,
    )
    if surplus <= 0.0:
        return
    time_step = settings[TIME_STEP]
    support, spin = (way[0] / time_step, way[1] / time_step), turn / time_step
    seen = velocity_seen((motion[i, VX], motion[i, VY]), support)
    energy = kinetic_energy(mass, seen, inertia, angular_velocity_seen(motion[i, SPIN], spin))
    if energy > 0.0:
        share = calm_share(energy, max(energy - surplus, 0.0), 0.0)
        motion[i, VX], motion[i, VY] = velocity_calmed(
            (motion[i, VX], motion[i, VY]), support, share
        )
        motion[i, SPIN] = angular_velocity_calmed(motion[i, SPIN], spin, share)
