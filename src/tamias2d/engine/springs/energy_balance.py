"""The energy of networks that met something in flight is put right (DD91).

Springs are held as if nothing were met on the way. Cost: of a network of which a body was turned
back, some visits to each member and spring.
"""

from math import sqrt

from tamias2d.engine import tables as tb
from tamias2d.engine.energy.island_damping import (
    add_to_island,
    begin_motion,
    motion_of_all,
    place_from,
)
from tamias2d.engine.energy.step_energy import can_be_turned, mass_and_inertia
from tamias2d.engine.springs.held import turned
from tamias2d.engine.tables import Bodies, Islands, Springs, World
from tamias2d.generated.definitions import kinetic_energy, point_velocity
from tamias2d.generated.island_energy import (
    angular_velocity_damped,
    angular_velocity_seen,
    velocity_damped,
    velocity_seen,
    work,
)
from tamias2d.generated.spring_step import (
    balanced_share,
    energy_defect,
    spring_gain,
    tension_held,
)
from tamias2d.state import Array, Vector

MOST_RETURNED = sqrt(2.0)  # times a motion: springs give back no more energy than it has
VIOLENT = 0.5  # of the energy of a motion: what changes more of it is too much for one part


def balance_networks(world: World) -> bool:
    """Put the energy of networks right of which an impact in flight has turned a body back.

    Returns whether that changes none of them much; else a shorter part is better.
    """
    bodies, springs = world.bodies, world.springs
    slight = True
    for n in range(springs.counts[tb.NETWORKS]):
        alone = springs.networks[n, tb.N_STATUS] == tb.ALONE
        if alone and is_turned_back(n, bodies, springs):
            balanced = balance_network(n, bodies, springs, world.islands)
            slight = slight and balanced
    return slight


def is_turned_back(n: int, bodies: Bodies, springs: Springs) -> bool:
    """Return whether an impact in flight has turned back a body of a network in this part."""
    met = False
    for k in range(springs.networks[n, tb.N_MEMBER], springs.networks[n + 1, tb.N_MEMBER]):
        i = springs.slot[k]
        met = met or (bodies.kind[i] == tb.DYNAMIC and bodies.flight[i, tb.REDIRECTED] > 0.0)
    return bool(met)


def balance_network(n: int, bodies: Bodies, springs: Springs, islands: Islands) -> bool:
    """Scale what differs from the motion of a network as one by what it got too much or too little.

    Returns whether that is a small part of its energy. The row of energies of its first free body
    serves for the sums.
    """
    defect = defect_of_network(n, bodies, springs)
    first, last = springs.networks[n, tb.N_MEMBER], springs.networks[n + 1, tb.N_MEMBER]
    root = first_free(n, bodies, springs)
    row = islands.energy[root]
    find_reference(n, root, bodies, springs, row)
    energy = 0.0
    for k in range(first, last):
        energy += energy_of_member(k, root, bodies, springs, row)
    if energy > 0.0 and defect != 0.0:
        share = balanced_share(energy, 0.0, defect, MOST_RETURNED)
        for k in range(first, last):
            scale_member(k, root, share, bodies, springs, row)
    return bool(abs(defect) <= VIOLENT * energy)


def defect_of_network(n: int, bodies: Bodies, springs: Springs) -> float:
    """Return what held forces gave the bodies of a network beyond what its springs lost, J.

    With dampers it is less by what these take, so that nothing is given back there.
    """
    done = gained = 0.0
    damped = False
    for k in range(springs.networks[n, tb.N_MEMBER], springs.networks[n + 1, tb.N_MEMBER]):
        done += held_work_on(k, bodies, springs)
    for s in range(springs.networks[n, tb.N_SPRING], springs.networks[n + 1, tb.N_SPRING]):
        spring, later = springs.springs[s], length_later(s, bodies, springs)
        tension = tension_held(
            spring[tb.STIFFNESS], spring[tb.REST_LENGTH], spring[tb.LENGTH], later
        )
        gained += spring_gain(tension, spring[tb.LENGTH], later)
        damped = damped or spring[tb.DAMPER] > 0.0
    defect = energy_defect(done, gained)
    return float(max(defect, 0.0) if damped else defect)


def held_work_on(k: int, bodies: Bodies, springs: Springs) -> float:
    """Return the work of the forces that were held for the springs on a member, J."""
    row, (x, y, turn) = springs.members[k], way_of(k, bodies, springs)
    pull = (row[tb.HELD_LOAD] - row[tb.BASE_LOAD], row[tb.HELD_LOAD + 1] - row[tb.BASE_LOAD + 1])
    torque = row[tb.HELD_LOAD + 2] - row[tb.BASE_LOAD + 2]
    return float(work(0.0, (0.0, 0.0), pull, torque, (x, y), turn))


def way_of(k: int, bodies: Bodies, springs: Springs) -> tuple[float, float, float]:
    """Return how far a member has come in a part, m, m, rad; impacts may have moved its pose."""
    i, start = springs.slot[k], springs.members[k]
    pose, now = bodies.pose[i], bodies.motion[i]
    return (
        (pose[tb.X] - start[tb.START_POSE]) + now[tb.DX],
        (pose[tb.Y] - start[tb.START_POSE + 1]) + now[tb.DY],
        (pose[tb.ANGLE] - start[tb.START_POSE + 2]) + now[tb.DANGLE],
    )


def length_later(s: int, bodies: Bodies, springs: Springs) -> float:
    """Return the length of a spring as a part ends, m."""
    spring, b = springs.springs[s], springs.ends[s, tb.MEMBER_B]
    by_x, by_y = end_moved(springs.ends[s, tb.MEMBER_A], tb.ANCHOR_A, spring, bodies, springs)
    x, y = spring[tb.SPAN_X] - by_x, spring[tb.SPAN_Y] - by_y
    if b >= 0:
        by_x, by_y = end_moved(b, tb.ANCHOR_B, spring, bodies, springs)
        x, y = x + by_x, y + by_y
    return sqrt(x * x + y * y)


def end_moved(k: int, at: int, spring: Array, bodies: Bodies, springs: Springs) -> Vector:
    """Return how far an end of a spring has come in a part, m."""
    anchor, (x, y, turn) = (spring[at], spring[at + 1]), way_of(k, bodies, springs)
    before = turned(anchor, springs.members[k, tb.START_POSE + 2])
    after = turned(anchor, springs.members[k, tb.START_POSE + 2] + turn)
    return x + (after[0] - before[0]), y + (after[1] - before[1])


def first_free(n: int, bodies: Bodies, springs: Springs) -> int:
    """Return the first body of a network that moves freely."""
    k = springs.networks[n, tb.N_MEMBER]
    while bodies.kind[springs.slot[k]] != tb.DYNAMIC:
        k += 1
    return int(springs.slot[k])


def find_reference(n: int, root: int, bodies: Bodies, springs: Springs, row: Array) -> None:
    """Write the motion of a network as one, at its root, or that of what it is tied to.

    Of the latter it is the velocity alone. A spin that no spring changes is apart from it.
    """
    begin_motion(0.0, row)
    for c in range(3):
        row[tb.REFERENCE + c] = 0.0
    for k in range(springs.networks[n, tb.N_MEMBER], springs.networks[n + 1, tb.N_MEMBER]):
        i = springs.slot[k]
        now = bodies.motion[i]
        if bodies.kind[i] != tb.DYNAMIC:
            row[tb.REFERENCE], row[tb.REFERENCE + 1] = now[tb.VX], now[tb.VY]
            return
        mass, inertia = mass_and_inertia(i, bodies.properties)
        inertia = inertia if springs.members[k, tb.TURNED] > 0.0 else 0.0
        place, velocity = place_from(root, i, bodies), (now[tb.VX], now[tb.VY])
        add_to_island(mass, inertia, place, velocity, now[tb.SPIN], row)
    if not is_tied_to_plane(n, springs):
        place, velocity, spin = motion_of_all(row)
        x, y = point_velocity(velocity, spin, (-place[0], -place[1]))
        row[tb.REFERENCE], row[tb.REFERENCE + 1], row[tb.REFERENCE + 2] = x, y, spin


def is_tied_to_plane(n: int, springs: Springs) -> bool:
    """Return whether a spring of a network holds a point of the plane."""
    tied = False
    for s in range(springs.networks[n, tb.N_SPRING], springs.networks[n + 1, tb.N_SPRING]):
        tied = tied or springs.ends[s, tb.MEMBER_B] < 0
    return bool(tied)


def energy_of_member(k: int, root: int, bodies: Bodies, springs: Springs, row: Array) -> float:
    """Return the kinetic energy of a member as seen from the motion in a row, J."""
    i = springs.slot[k]
    if bodies.kind[i] != tb.DYNAMIC:
        return 0.0
    now, (mass, inertia) = bodies.motion[i], mass_and_inertia(i, bodies.properties)
    inertia = inertia if springs.members[k, tb.TURNED] > 0.0 else 0.0
    seen = velocity_seen((now[tb.VX], now[tb.VY]), reference_of(i, root, bodies, row))
    spin = angular_velocity_seen(now[tb.SPIN], row[tb.REFERENCE + 2])
    return float(kinetic_energy(mass, seen, inertia, spin))


def reference_of(i: int, root: int, bodies: Bodies, row: Array) -> Vector:
    """Return the velocity that a body has in the motion in a row, m/s."""
    velocity = (row[tb.REFERENCE], row[tb.REFERENCE + 1])
    x, y = point_velocity(velocity, row[tb.REFERENCE + 2], place_from(root, i, bodies))
    return x, y


def scale_member(
    k: int, root: int, share: float, bodies: Bodies, springs: Springs, row: Array
) -> None:
    """Scale what differs in the motion of a member from that in a row."""
    i = springs.slot[k]
    if bodies.kind[i] == tb.DYNAMIC:
        now, by = bodies.motion[i], reference_of(i, root, bodies, row)
        now[tb.VX], now[tb.VY] = velocity_damped((now[tb.VX], now[tb.VY]), by, share)
        if springs.members[k, tb.TURNED] > 0.0 and can_be_turned(i, bodies.properties):
            now[tb.SPIN] = angular_velocity_damped(now[tb.SPIN], row[tb.REFERENCE + 2], share)
