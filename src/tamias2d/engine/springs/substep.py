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

from tamias2d.engine.springs.held import turned
from tamias2d.engine.springs.network import (
    pull_ends,
    resist,
    solve_network,
    write_diagonal,
)
from tamias2d.engine.tables import (
    ACROSS,
    ACTIVE,
    ALONE,
    ALONG,
    ANCHOR_A,
    ANCHOR_B,
    ANGLE,
    ARM_A,
    ARM_B,
    AXIS_X,
    AXIS_Y,
    BASE_LOAD,
    DAMPER,
    DANGLE,
    DX,
    DY,
    DYNAMIC,
    FORCE_X,
    FORCE_Y,
    GIVEN,
    HELD_LOAD,
    INVERSE_INERTIA,
    INVERSE_MASS,
    LENGTH,
    MEMBER_A,
    MEMBER_B,
    N_MEMBER,
    N_SPRING,
    N_STATUS,
    N_UNSOLVED,
    NETWORKS,
    NETWORKS_TOUCHED,
    PULL,
    RESIDUAL,
    RESISTANCE,
    REST_LENGTH,
    SHIFT,
    SOLUTION,
    STIFFENING,
    STIFFNESS,
    SUBSTEP_START,
    TOUCHED,
    TOUCHED_SOFT,
    TOUCHED_STIFF,
    Bodies,
    Constraints,
    Springs,
    Touching,
    X,
    Y,
)
from tamias2d.generated.spring_step import (
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
    for n in range(springs.counts[NETWORKS]):
        first, last = springs.networks[n, N_MEMBER], springs.networks[n + 1, N_MEMBER]
        found = springs.networks[n, N_UNSOLVED]
        for k in range(first, last):
            i = springs.slot[k]
            found += bodies.moved[i] == 1 and bodies.kind[i] == DYNAMIC
        springs.networks[n, N_STATUS] = TOUCHED if found > 0 else ALONE
        touched += found > 0
    springs.counts[NETWORKS_TOUCHED] = touched
    for n in range(springs.counts[NETWORKS]):
        if springs.networks[n, N_STATUS] == TOUCHED:
            for k in range(springs.networks[n, N_MEMBER], springs.networks[n + 1, N_MEMBER]):
                activate(springs.slot[k], bodies, touching, constraints)


def activate(i: int, bodies: Bodies, touching: Touching, constraints: Constraints) -> None:
    """Put a free body on the list of active bodies, unless it is there."""
    if bodies.moved[i] == 0 and bodies.kind[i] == DYNAMIC:
        bodies.moved[i] = 1
        touching.active[constraints.counts[ACTIVE]] = i
        constraints.counts[ACTIVE] += 1


def begin_springs(substep: float, bodies: Bodies, springs: Springs) -> None:
    """Take the held loads off the bodies of touched networks, and see which of these are stiff."""
    for n in range(springs.counts[NETWORKS]):
        if springs.networks[n, N_STATUS] != ALONE:
            for k in range(springs.networks[n, N_MEMBER], springs.networks[n + 1, N_MEMBER]):
                note_member(k, bodies, springs)
            stiff = springs.networks[n, N_UNSOLVED] == 1
            stiff = stiff or fastest(n, substep, bodies, springs) > SLOW
            springs.networks[n, N_STATUS] = TOUCHED_STIFF if stiff else TOUCHED_SOFT


def note_member(k: int, bodies: Bodies, springs: Springs) -> None:
    """Note the mass of a member, and let only what acts besides springs act on it."""
    row, i = springs.members[k], springs.slot[k]
    for c in range(3):
        bodies.load[i, c], row[RESISTANCE + c] = row[BASE_LOAD + c], 0.0
    if bodies.kind[i] == DYNAMIC:
        inverse_inertia = bodies.properties[i, INVERSE_INERTIA]
        row[RESISTANCE] = row[RESISTANCE + 1] = 1.0 / bodies.properties[i, INVERSE_MASS]
        row[RESISTANCE + 2] = 1.0 / inverse_inertia if inverse_inertia > 0.0 else 0.0


def fastest(n: int, substep: float, bodies: Bodies, springs: Springs) -> float:
    """Return a bound of what the springs of a network do in a substep, by Gershgorin's circles.

    It is of the square of the phase that an oscillation gains, or of the share that dampers take.
    """
    members = springs.members
    for k in range(springs.networks[n, N_MEMBER], springs.networks[n + 1, N_MEMBER]):
        members[k, STIFFENING] = 0.0
    for s in range(springs.networks[n, N_SPRING], springs.networks[n + 1, N_SPRING]):
        spring = springs.springs[s]
        a, b = springs.ends[s, MEMBER_A], springs.ends[s, MEMBER_B]
        members[a, STIFFENING] += phase(springs.slot[a], ANCHOR_A, substep, spring, bodies)
        if b >= 0:
            members[b, STIFFENING] += phase(springs.slot[b], ANCHOR_B, substep, spring, bodies)
    most = 0.0
    for k in range(springs.networks[n, N_MEMBER], springs.networks[n + 1, N_MEMBER]):
        most = max(most, members[k, STIFFENING])
    return most


def phase(i: int, at: int, substep: float, spring: Array, bodies: Bodies) -> float:
    """Return what one end of a spring adds to the bound of its body: its yielding and its leaning.

    It yields by its mass and turns with its arm, and leans on its arm with its tension.
    """
    if bodies.kind[i] != DYNAMIC:
        return 0.0
    square = spring[at] * spring[at] + spring[at + 1] * spring[at + 1]
    inverse_inertia = bodies.properties[i, INVERSE_INERTIA]
    firm = resistance_along(spring[STIFFNESS], spring[DAMPER], substep)
    pull = abs(tension_held(spring[STIFFNESS], spring[REST_LENGTH], spring[LENGTH], spring[LENGTH]))
    yielding = bodies.properties[i, INVERSE_MASS] + square * inverse_inertia
    leaning = substep * substep * pull * sqrt(square) * inverse_inertia
    return float(2.0 * firm * yielding + leaning)


def apply_springs(
    again: bool, substep: float, share: float, bodies: Bodies, springs: Springs
) -> None:
    """Let the springs of touched networks act for a substep, a share of the step.

    Again, after contacts have changed velocities, only those of stiff networks.
    """
    for n in range(springs.counts[NETWORKS]):
        status = springs.networks[n, N_STATUS]
        if status == TOUCHED_STIFF or (status == TOUCHED_SOFT and not again):
            take_velocities(n, again, bodies, springs)
            if not again:
                for s in range(springs.networks[n, N_SPRING], springs.networks[n + 1, N_SPRING]):
                    aim(s, substep, status == TOUCHED_STIFF, bodies, springs)
            find_pulls(n, springs)
            give_pulls(n, share, bodies, springs)


def take_velocities(n: int, again: bool, bodies: Bodies, springs: Springs) -> None:
    """Note the velocities of the bodies of a network as they are without its springs."""
    for k in range(springs.networks[n, N_MEMBER], springs.networks[n + 1, N_MEMBER]):
        row, i = springs.members[k], springs.slot[k]
        for c in range(3):
            if not again:
                row[GIVEN + c] = 0.0
            row[SHIFT + c] = bodies.motion[i, c]
            if row[RESISTANCE + c] > 0.0:
                row[SHIFT + c] -= row[GIVEN + c] / row[RESISTANCE + c]
        if not again:
            row[STIFFENING] = 0.0


def aim(s: int, substep: float, stiff: bool, bodies: Bodies, springs: Springs) -> None:
    """Note the axis of a spring, its impulse at rest, and what it resists in this substep."""
    spring = springs.springs[s]
    a, b = springs.ends[s, MEMBER_A], springs.ends[s, MEMBER_B]
    x, y = end_place(springs.slot[a], ANCHOR_A, ARM_A, bodies, spring)
    x, y = -x, -y
    if b >= 0:
        to_x, to_y = end_place(springs.slot[b], ANCHOR_B, ARM_B, bodies, spring)
        x, y = to_x + x, to_y + y
    else:
        x, y = spring[ANCHOR_B] + x, spring[ANCHOR_B + 1] + y
    length = sqrt(x * x + y * y)
    axis = (x / max(length, 1e-150), y / max(length, 1e-150))
    spring[AXIS_X], spring[AXIS_Y] = axis
    stiffness, rest_length = spring[STIFFNESS], spring[REST_LENGTH]
    x, y = spring_impulse(stiffness, rest_length, length, axis, substep)
    spring[FORCE_X], spring[FORCE_Y] = x, y
    spring[ALONG] = resistance_along(stiffness if stiff else 0.0, spring[DAMPER], substep)
    spring[ACROSS] = 0.0
    if stiff:
        spring[ACROSS] = resistance_across(stiffness, rest_length, length, substep)
        leaning = substep * max(spring[ARM_A] * x + spring[ARM_A + 1] * y, 0.0)
        springs.members[a, STIFFENING] += leaning
        if b >= 0:
            leaning = substep * max(-spring[ARM_B] * x - spring[ARM_B + 1] * y, 0.0)
            springs.members[b, STIFFENING] += leaning


def end_place(i: int, at: int, to: int, bodies: Bodies, spring: Array) -> tuple[float, float]:
    """Return where an end of a spring is in this substep, and note its arm."""
    pose, now = bodies.pose[i], bodies.motion[i]
    arm = (spring[at], spring[at + 1])
    if abs(arm[0]) + abs(arm[1]) > 0.0:
        arm = turned(arm, pose[ANGLE] + now[DANGLE])
    spring[to], spring[to + 1] = arm
    return pose[X] + now[DX] + arm[0], pose[Y] + now[DY] + arm[1]


def find_pulls(n: int, springs: Springs) -> None:
    """Find the impulses of the springs of a network, from velocities without them."""
    first, last = springs.networks[n, N_MEMBER], springs.networks[n + 1, N_MEMBER]
    members = springs.members
    impulses_at(n, springs)
    for k in range(first, last):
        row = members[k]
        for c in range(3):
            row[RESIDUAL + c] = row[PULL + c]
        row[RESIDUAL + 2] -= row[STIFFENING] * row[SHIFT + 2]
    write_diagonal(n, springs)
    solve_network(n, ACCURACY, springs)
    for k in range(first, last):
        row = members[k]
        for c in range(3):
            row[SHIFT + c] += row[SOLUTION + c]
    impulses_at(n, springs)
    for k in range(first, last):
        members[k, PULL + 2] -= members[k, STIFFENING] * members[k, SHIFT + 2]


def impulses_at(n: int, springs: Springs) -> None:
    """Write the impulses of the springs of a network at the velocities in SHIFT."""
    members = springs.members
    for k in range(springs.networks[n, N_MEMBER], springs.networks[n + 1, N_MEMBER]):
        members[k, PULL], members[k, PULL + 1], members[k, PULL + 2] = 0.0, 0.0, 0.0
    for s in range(springs.networks[n, N_SPRING], springs.networks[n + 1, N_SPRING]):
        spring = springs.springs[s]
        pull_ends(s, (spring[FORCE_X], spring[FORCE_Y]), PULL, springs)
        resist(s, SHIFT, PULL, 1.0, springs)


def give_pulls(n: int, share: float, bodies: Bodies, springs: Springs) -> None:
    """Change the velocities of a network by its springs, which is not what contacts do.

    The loads of the bodies become the mean over the step, by which the energy is judged.
    """
    for k in range(springs.networks[n, N_MEMBER], springs.networks[n + 1, N_MEMBER]):
        row, i = springs.members[k], springs.slot[k]
        state = bodies.substep_state[i]
        for c in range(3):
            if row[RESISTANCE + c] > 0.0:
                change = row[PULL + c] - row[GIVEN + c]
                bodies.motion[i, c] += change / row[RESISTANCE + c]
                state[SUBSTEP_START + c] += change / row[RESISTANCE + c]
                bodies.load[i, c] += share * change
                row[GIVEN + c] = row[PULL + c]


def end_springs(bodies: Bodies, springs: Springs) -> None:
    """Put the held loads back on the bodies of touched networks."""
    for n in range(springs.counts[NETWORKS]):
        if springs.networks[n, N_STATUS] != ALONE:
            for k in range(springs.networks[n, N_MEMBER], springs.networks[n + 1, N_MEMBER]):
                for c in range(3):
                    bodies.load[springs.slot[k], c] = springs.members[k, HELD_LOAD + c]
