"""Springs in the substeps of contacts, for networks with a body that a contact touches (DD52).

So are those for which no loads were found that can be held.

A stiff network is solved for the velocities at the end of the substep, all of its springs at once:
before the contacts are visited, and again with what they did, so that no body runs away from one
that a contact has stopped. A network that is slow for its substeps is given its impulses as they
are, which takes no energy from it.

Cost: of a soft network a visit to each spring in a substep; of a stiff one the solution of its
equations, twice.
"""

from math import sqrt

from tamias2d.engine import tables as tb
from tamias2d.engine.joined import or_joined
from tamias2d.engine.springs.held import turned
from tamias2d.engine.springs.network import (
    pull_ends,
    resist,
    solve_network,
    write_diagonal,
)
from tamias2d.engine.tables import Bodies, Constraints, Springs, Touching
from tamias2d.generated.spring_step import (
    end_pace,
    end_yield,
    leaning_resistance,
    resistance_across,
    resistance_along,
    spring_impulse,
    tension_held,
)
from tamias2d.state import Array

ACCURACY = 1e-10  # relative, with which a stiff network is solved
SLOW = 0.25  # (phase of the fastest oscillation of a network in a substep)^2: soft up to there


def activate_touched(
    bodies: Bodies, touching: Touching, constraints: Constraints, springs: Springs
) -> None:
    """Make the bodies of networks active that have a free body with a contact."""
    touched = 0
    for n in range(springs.counts[tb.NETWORKS]):
        first, last = springs.networks[n, tb.N_MEMBER], springs.networks[n + 1, tb.N_MEMBER]
        found = springs.networks[n, tb.N_UNSOLVED]
        for k in range(first, last):
            i = springs.slot[k]
            found += bodies.moved[i] == 1 and bodies.kind[i] == tb.DYNAMIC
        springs.networks[n, tb.N_STATUS] = tb.TOUCHED if found > 0 else tb.ALONE
        touched += found > 0
    springs.counts[tb.NETWORKS_TOUCHED] = touched
    for n in range(springs.counts[tb.NETWORKS]):
        if springs.networks[n, tb.N_STATUS] == tb.TOUCHED:
            for k in range(springs.networks[n, tb.N_MEMBER], springs.networks[n + 1, tb.N_MEMBER]):
                if bodies.kind[springs.slot[k]] == tb.DYNAMIC:
                    activate(springs.slot[k], bodies, touching, constraints)


def activate(i: int, bodies: Bodies, touching: Touching, constraints: Constraints) -> None:
    """Put a body that moves on the list of active bodies, unless it is there."""
    if bodies.moved[i] == 0:
        bodies.moved[i] = 1
        touching.active[constraints.counts[tb.ACTIVE]] = i
        constraints.counts[tb.ACTIVE] += 1


def begin_springs(substep: float, bodies: Bodies, springs: Springs) -> None:
    """Take the held loads off the bodies of touched networks, and see which of these are stiff."""
    for n in range(springs.counts[tb.NETWORKS]):
        if springs.networks[n, tb.N_STATUS] != tb.ALONE:
            for k in range(springs.networks[n, tb.N_MEMBER], springs.networks[n + 1, tb.N_MEMBER]):
                note_member(k, bodies, springs)
            stiff = springs.networks[n, tb.N_UNSOLVED] == 1
            stiff = stiff or fastest(n, substep, bodies, springs) > SLOW
            springs.networks[n, tb.N_STATUS] = tb.TOUCHED_STIFF if stiff else tb.TOUCHED_SOFT


def note_member(k: int, bodies: Bodies, springs: Springs) -> None:
    """Note the mass of a member, and let only what acts besides springs act on it."""
    row, i = springs.members[k], springs.slot[k]
    for c in range(3):
        bodies.load[i, c], row[tb.RESISTANCE + c] = row[tb.BASE_LOAD + c], 0.0
    if bodies.kind[i] == tb.DYNAMIC:
        inverse_inertia = bodies.properties[i, tb.INVERSE_INERTIA]
        row[tb.RESISTANCE] = row[tb.RESISTANCE + 1] = 1.0 / bodies.properties[i, tb.INVERSE_MASS]
        row[tb.RESISTANCE + 2] = 1.0 / inverse_inertia if inverse_inertia > 0.0 else 0.0


def fastest(n: int, substep: float, bodies: Bodies, springs: Springs) -> float:
    """Return a bound of what the springs of a network do in a substep, by Gershgorin's circles.

    It is of the square of the phase that an oscillation gains, or of the share that dampers take
    (DD114).
    """
    members = springs.members
    for k in range(springs.networks[n, tb.N_MEMBER], springs.networks[n + 1, tb.N_MEMBER]):
        members[k, tb.STIFFENING] = 0.0
    for s in range(springs.networks[n, tb.N_SPRING], springs.networks[n + 1, tb.N_SPRING]):
        spring = springs.springs[s]
        a, b = springs.ends[s, tb.MEMBER_A], springs.ends[s, tb.MEMBER_B]
        members[a, tb.STIFFENING] += phase(springs.slot[a], tb.ANCHOR_A, substep, spring, bodies)
        if b >= 0:
            members[b, tb.STIFFENING] += phase(
                springs.slot[b], tb.ANCHOR_B, substep, spring, bodies
            )
    most = 0.0
    for k in range(springs.networks[n, tb.N_MEMBER], springs.networks[n + 1, tb.N_MEMBER]):
        most = max(most, members[k, tb.STIFFENING])
    return most


def phase(i: int, at: int, substep: float, spring: Array, bodies: Bodies) -> float:
    """Return what one end of a spring adds to the bound of its body: its yielding and its leaning.

    It yields by its mass and turns with its arm, and leans on its arm with its tension.
    """
    if bodies.kind[i] != tb.DYNAMIC:
        return 0.0
    arm = (spring[at], spring[at + 1])
    inverse_inertia = bodies.properties[i, tb.INVERSE_INERTIA]
    firm = resistance_along(spring[tb.STIFFNESS], spring[tb.DAMPER], substep)
    pull = tension_held(
        spring[tb.STIFFNESS], spring[tb.REST_LENGTH], spring[tb.LENGTH], spring[tb.LENGTH]
    )
    yielding = end_yield(arm, bodies.properties[i, tb.INVERSE_MASS], inverse_inertia)
    return float(end_pace(firm, yielding, pull, arm, inverse_inertia, substep))


def apply_springs(
    again: bool, substep: float, share: float, bodies: Bodies, springs: Springs
) -> None:
    """Let the springs of touched networks act for a substep, a share of the step.

    Again, after contacts have changed velocities, only those of stiff networks.
    """
    for n in range(springs.counts[tb.NETWORKS]):
        status = springs.networks[n, tb.N_STATUS]
        if status == tb.TOUCHED_STIFF or (status == tb.TOUCHED_SOFT and not again):
            take_velocities(n, again, bodies, springs)
            if not again:
                for s in range(
                    springs.networks[n, tb.N_SPRING], springs.networks[n + 1, tb.N_SPRING]
                ):
                    aim(s, substep, status == tb.TOUCHED_STIFF, bodies, springs)
            find_pulls(n, springs)
            give_pulls(n, share, bodies, springs)


def take_velocities(n: int, again: bool, bodies: Bodies, springs: Springs) -> None:
    """Note the velocities of the bodies of a network as they are without its springs."""
    for k in range(springs.networks[n, tb.N_MEMBER], springs.networks[n + 1, tb.N_MEMBER]):
        row, i = springs.members[k], springs.slot[k]
        for c in range(3):
            if not again:
                row[tb.GIVEN + c] = 0.0
            row[tb.SHIFT + c] = bodies.motion[i, c]
            if row[tb.RESISTANCE + c] > 0.0:
                row[tb.SHIFT + c] -= row[tb.GIVEN + c] / row[tb.RESISTANCE + c]
        if not again:
            row[tb.STIFFENING] = 0.0


def aim(s: int, substep: float, stiff: bool, bodies: Bodies, springs: Springs) -> None:
    """Note the axis of a spring, its impulse at rest, and what it resists in this substep."""
    spring = springs.springs[s]
    a, b = springs.ends[s, tb.MEMBER_A], springs.ends[s, tb.MEMBER_B]
    x, y = end_place(springs.slot[a], tb.ANCHOR_A, tb.ARM_A, bodies, spring)
    x, y = -x, -y
    if b >= 0:
        to_x, to_y = end_place(springs.slot[b], tb.ANCHOR_B, tb.ARM_B, bodies, spring)
        x, y = to_x + x, to_y + y
    else:
        x, y = spring[tb.ANCHOR_B] + x, spring[tb.ANCHOR_B + 1] + y
    length = sqrt(x * x + y * y)
    axis = (x / max(length, 1e-150), y / max(length, 1e-150))
    spring[tb.AXIS_X], spring[tb.AXIS_Y] = axis
    stiffness, rest_length = spring[tb.STIFFNESS], spring[tb.REST_LENGTH]
    given = spring_impulse(stiffness, rest_length, length, axis, substep)
    spring[tb.FORCE_X], spring[tb.FORCE_Y] = given
    spring[tb.ALONG] = resistance_along(stiffness if stiff else 0.0, spring[tb.DAMPER], substep)
    spring[tb.ACROSS] = 0.0
    if stiff:
        spring[tb.ACROSS] = resistance_across(stiffness, rest_length, length, substep)
        arm = (spring[tb.ARM_A], spring[tb.ARM_A + 1])
        springs.members[a, tb.STIFFENING] += leaning_resistance(arm, given, substep)
        if b >= 0:
            arm, against = (spring[tb.ARM_B], spring[tb.ARM_B + 1]), (-given[0], -given[1])
            springs.members[b, tb.STIFFENING] += leaning_resistance(arm, against, substep)


def end_place(i: int, at: int, to: int, bodies: Bodies, spring: Array) -> tuple[float, float]:
    """Return where an end of a spring is in this substep, and note its arm."""
    pose, now = bodies.pose[i], bodies.motion[i]
    arm = (spring[at], spring[at + 1])
    if abs(arm[0]) + abs(arm[1]) > 0.0:
        arm = turned(arm, pose[tb.ANGLE] + now[tb.DANGLE])
    spring[to], spring[to + 1] = arm
    return pose[tb.X] + now[tb.DX] + arm[0], pose[tb.Y] + now[tb.DY] + arm[1]


def find_pulls(n: int, springs: Springs) -> None:
    """Find the impulses of the springs of a network, from velocities without them."""
    first, last = springs.networks[n, tb.N_MEMBER], springs.networks[n + 1, tb.N_MEMBER]
    members = springs.members
    impulses_at(n, springs)
    for k in range(first, last):
        row = members[k]
        for c in range(3):
            row[tb.RESIDUAL + c] = row[tb.PULL + c]
        row[tb.RESIDUAL + 2] -= row[tb.STIFFENING] * row[tb.SHIFT + 2]
    write_diagonal(n, springs)
    solve_network(n, ACCURACY, springs)
    for k in range(first, last):
        row = members[k]
        for c in range(3):
            row[tb.SHIFT + c] += row[tb.SOLUTION + c]
    impulses_at(n, springs)
    for k in range(first, last):
        members[k, tb.PULL + 2] -= members[k, tb.STIFFENING] * members[k, tb.SHIFT + 2]


def impulses_at(n: int, springs: Springs) -> None:
    """Write the impulses of the springs of a network at the velocities in SHIFT."""
    members = springs.members
    for k in range(springs.networks[n, tb.N_MEMBER], springs.networks[n + 1, tb.N_MEMBER]):
        members[k, tb.PULL], members[k, tb.PULL + 1], members[k, tb.PULL + 2] = 0.0, 0.0, 0.0
    for s in range(springs.networks[n, tb.N_SPRING], springs.networks[n + 1, tb.N_SPRING]):
        spring = springs.springs[s]
        pull_ends(s, (spring[tb.FORCE_X], spring[tb.FORCE_Y]), tb.PULL, springs)
        resist(s, tb.SHIFT, tb.PULL, 1.0, springs)


def give_pulls(n: int, share: float, bodies: Bodies, springs: Springs) -> None:
    """Change the velocities of a network by its springs, which is not what contacts do.

    The loads of the bodies become the mean over the step, by which the energy is judged.
    """
    for k in range(springs.networks[n, tb.N_MEMBER], springs.networks[n + 1, tb.N_MEMBER]):
        row, i = springs.members[k], springs.slot[k]
        state = bodies.substep_state[i]
        for c in range(3):
            if row[tb.RESISTANCE + c] > 0.0:
                change = row[tb.PULL + c] - row[tb.GIVEN + c]
                bodies.motion[i, c] += change / row[tb.RESISTANCE + c]
                state[tb.SUBSTEP_START + c] += change / row[tb.RESISTANCE + c]
                bodies.load[i, c] += share * change
                row[tb.GIVEN + c] = row[tb.PULL + c]


def end_springs(bodies: Bodies, springs: Springs) -> None:
    """Put the held loads back on the bodies of touched networks.

    Of a network that no contact has changed they are held for this part after all.
    """
    for n in range(springs.counts[tb.NETWORKS]):
        if springs.networks[n, tb.N_STATUS] != tb.ALONE:
            first, last = springs.networks[n, tb.N_MEMBER], springs.networks[n + 1, tb.N_MEMBER]
            for k in range(first, last):
                for c in range(3):
                    bodies.load[springs.slot[k], c] = springs.members[k, tb.HELD_LOAD + c]
            if springs.networks[n, tb.N_UNSOLVED] == 0 and is_unchanged(n, bodies, springs):
                springs.networks[n, tb.N_STATUS] = tb.ALONE
                for k in range(first, last):
                    begin_again(springs.slot[k], bodies)


def is_unchanged(n: int, bodies: Bodies, springs: Springs) -> bool:
    """Return whether nothing but its springs changed a velocity in a network in the substeps."""
    changed = False
    for k in range(springs.networks[n, tb.N_MEMBER], springs.networks[n + 1, tb.N_MEMBER]):
        i = springs.slot[k]
        state, now = bodies.substep_state[i], bodies.motion[i]
        for c in range(3 if bodies.kind[i] == tb.DYNAMIC else 0):
            changed = changed or state[tb.CONTACT_CHANGE + c] != 0.0
            changed = changed or now[c] != state[tb.SUBSTEP_START + c]
        changed = or_joined(changed, i, bodies)
    return not changed


def begin_again(i: int, bodies: Bodies) -> None:
    """Take a body back to the begin of its substeps, to fly instead."""
    if bodies.kind[i] == tb.DYNAMIC:
        for c in range(3):
            bodies.motion[i, c] = bodies.substep_state[i, tb.STEP_START + c]
            bodies.motion[i, tb.DX + c] = 0.0
        bodies.moved[i] = tb.UNMOVED
