"""Loads of springs that are held through a step, so that energy is neither gained nor lost (IM14).

Where bodies get to and which forces take them there is found together, network by network, by
Newton's method with a matrix that is made symmetric. In steps without contacts these loads are all
that is needed; networks with contacts are solved in the substeps instead.
"""

from math import sqrt

from tamias2d.engine import tables as tb
from tamias2d.engine.rotation import cosine_sine
from tamias2d.engine.springs.network import pull_ends, solve_network, write_diagonal
from tamias2d.engine.tables import Bodies, BodyState, Control, Springs, World
from tamias2d.generated.definitions import (
    acceleration,
    angular_acceleration,
    coordinate_displacement,
)
from tamias2d.generated.soft_contact import row_mass, turning_arm
from tamias2d.generated.spring_step import (
    arm_held,
    change_across,
    change_along,
    change_leaning,
    coordinate_missing,
    damping_held,
    spring_force_held,
    tension_held,
    turning_resistance,
    way_resistance,
)
from tamias2d.kernels.assembled import inlined
from tamias2d.state import Array, Vector

MOST_ROUNDS = 40
SOLVED = 1e-12  # of the largest displacement: that by which the last round may change one
INNER = 1e-3  # accuracy of each round, relative
ENOUGH = 1e-11  # the same, where rounds end without that
ROUNDED = 1e-15  # of a position: what float64 does not tell apart


def hold_springs(world: World) -> bool:
    """Add the loads of all springs to those of the bodies, for a part of a step.

    A network for which none are found is marked, and taken through the substeps. Returns whether
    there is none.
    """
    springs, bodies = world.springs, world.bodies
    solved = True
    for n in range(springs.counts[tb.NETWORKS]):
        gather_network(n, world.control, world.state, bodies, springs)
        found = solve_held(n, world.control.progress[tb.PART_TIME], bodies, springs)
        solved = solved and found
        unsolved = 0 if found else 1
        if springs.networks[n, tb.N_UNSOLVED] != unsolved:
            springs.networks[n, tb.N_UNSOLVED] = unsolved
            world.touching.counts[tb.ARRANGED] = 0
    for k in range(len(springs.members)):
        row, load = springs.members[k], bodies.load[springs.slot[k]]
        for c in range(3):
            row[tb.HELD_LOAD + c] = row[tb.BASE_LOAD + c] + row[tb.PULL + c]
            load[c] = row[tb.HELD_LOAD + c]
    return solved


def release_springs(bodies: Bodies, springs: Springs) -> None:
    """Take the loads of springs off the bodies again."""
    for k in range(len(springs.members)):
        for c in range(3):
            bodies.load[springs.slot[k], c] = springs.members[k, tb.BASE_LOAD + c]


def gather_network(
    n: int, control: Control, state: BodyState, bodies: Bodies, springs: Springs
) -> None:
    """Note where the bodies of a network are, and where they would get to without springs."""
    for k in range(springs.networks[n, tb.N_MEMBER], springs.networks[n + 1, tb.N_MEMBER]):
        i = state.slot_of_body[springs.body[k]]
        springs.slot[k] = i
        row, properties = springs.members[k], bodies.properties[i]
        for c in range(3):
            row[tb.BASE_LOAD + c] = bodies.load[i, c]
            row[tb.START_POSE + c] = bodies.pose[i, c]
        propagator = bodies.propagators[int(properties[tb.PROPAGATOR])]
        by_x = by_y = turning = 0.0
        mass = inertia = 0.0
        if bodies.kind[i] == tb.DYNAMIC:
            gravity = (control.settings[tb.GRAVITY_X], control.settings[tb.GRAVITY_Y])
            load, inverse_mass = bodies.load[i], properties[tb.INVERSE_MASS]
            by_x, by_y = acceleration(gravity, (load[0], load[1]), inverse_mass)
            turning = angular_acceleration(load[2], properties[tb.INVERSE_INERTIA])
            mass = 1.0 / inverse_mass
            inertia = (
                1.0 / properties[tb.INVERSE_INERTIA] if properties[tb.INVERSE_INERTIA] > 0 else 0.0
            )
        moves = bodies.kind[i] >= tb.KINEMATIC
        for c in range(3):
            at = tb.WHOLE_STEP + tb.ANGULAR if c == 2 else tb.WHOLE_STEP
            by = by_x if c == 0 else by_y if c == 1 else turning
            gain, lift = propagator[at + tb.GAIN], propagator[at + tb.LIFT]
            free = coordinate_displacement(gain, lift, bodies.motion[i, c], by) if moves else 0.0
            row[tb.FREE_SHIFT + c] = row[tb.SHIFT + c] = free
            row[tb.RESISTANCE + c] = (
                turning_resistance(inertia, lift) if c == 2 else way_resistance(mass, lift)
            )
    for s in range(springs.networks[n, tb.N_SPRING], springs.networks[n + 1, tb.N_SPRING]):
        note_spring(s, control.progress[tb.PART_TIME], bodies, springs)


def note_spring(s: int, time_step: float, bodies: Bodies, springs: Springs) -> None:
    """Note the span of a spring as the step begins, and the damping that is held."""
    spring = springs.springs[s]
    a, b = springs.slot[springs.ends[s, tb.MEMBER_A]], springs.ends[s, tb.MEMBER_B]
    arm_a = turned((spring[tb.ANCHOR_A], spring[tb.ANCHOR_A + 1]), bodies.pose[a, tb.ANGLE])
    x, y = -bodies.pose[a, tb.X] - arm_a[0], -bodies.pose[a, tb.Y] - arm_a[1]
    arm_b = (spring[tb.ANCHOR_B], spring[tb.ANCHOR_B + 1])
    inverse_mass = inverse_inertia = 0.0
    if b >= 0:
        b = springs.slot[b]
        arm_b = turned(arm_b, bodies.pose[b, tb.ANGLE])
        x, y = bodies.pose[b, tb.X] + x, bodies.pose[b, tb.Y] + y
        if bodies.kind[b] == tb.DYNAMIC:
            inverse_mass = bodies.properties[b, tb.INVERSE_MASS]
            inverse_inertia = bodies.properties[b, tb.INVERSE_INERTIA]
    x, y = x + arm_b[0], y + arm_b[1]
    length = sqrt(x * x + y * y)
    spring[tb.SPAN_X], spring[tb.SPAN_Y], spring[tb.LENGTH] = x, y, length
    axis = (x / max(length, 1e-150), y / max(length, 1e-150))
    own_mass = own_inertia = 0.0
    if bodies.kind[a] == tb.DYNAMIC:
        own_mass = bodies.properties[a, tb.INVERSE_MASS]
        own_inertia = bodies.properties[a, tb.INVERSE_INERTIA]
    mass = row_mass(
        own_mass,
        own_inertia,
        turning_arm(arm_a, axis),
        inverse_mass,
        inverse_inertia,
        turning_arm(arm_b, axis),
    )
    spring[tb.DAMPER_HELD] = damping_held(spring[tb.DAMPER], spring[tb.STIFFNESS], mass, time_step)


def solve_held(n: int, time_step: float, bodies: Bodies, springs: Springs) -> bool:
    """Find where the bodies of a network get to, and what its springs pull through the step.

    Returns whether that was found: not where arms turn very far in the step.
    """
    change = far = 0.0
    for _ in range(MOST_ROUNDS):
        pull_all(n, time_step, bodies, springs)
        solve_network(n, INNER, springs)
        change, far = move(n, bodies, springs)
        if change <= SOLVED * far:
            break
    pull_all(n, time_step, bodies, springs)
    return change <= ENOUGH * far


def move(n: int, bodies: Bodies, springs: Springs) -> tuple[float, float]:
    """Change the displacements of a network by the solution.

    Returns the largest change, and the largest displacement or what float64 can tell of a position,
    m. What turns is measured where springs hold it, so that no unit of length decides.
    """
    change = far = 0.0
    for k in range(springs.networks[n, tb.N_MEMBER], springs.networks[n + 1, tb.N_MEMBER]):
        row, pose = springs.members[k], bodies.pose[springs.slot[k]]
        far = max(far, ROUNDED / SOLVED * (abs(pose[tb.X]) + abs(pose[tb.Y])))
        for c in range(3):
            row[tb.SHIFT + c] += row[tb.SOLUTION + c]
        for c in range(2):
            far = max(far, abs(row[tb.SHIFT + c]))
            change = max(change, abs(row[tb.SOLUTION + c]))
    for s in range(springs.networks[n, tb.N_SPRING], springs.networks[n + 1, tb.N_SPRING]):
        spring = springs.springs[s]
        for end in range(2):
            k, at = springs.ends[s, end], tb.ANCHOR_A if end == tb.MEMBER_A else tb.ANCHOR_B
            if k >= 0:
                row, arm = springs.members[k], abs(spring[at]) + abs(spring[at + 1])
                far = max(far, arm * abs(row[tb.SHIFT + 2]))
                change = max(change, arm * abs(row[tb.SOLUTION + 2]))
    return change, far


def pull_all(n: int, time_step: float, bodies: Bodies, springs: Springs) -> None:
    """Write what springs pull at the displacements as they are, what is missing, and the matrix."""
    members = springs.members
    for k in range(springs.networks[n, tb.N_MEMBER], springs.networks[n + 1, tb.N_MEMBER]):
        row = members[k]
        row[tb.PULL], row[tb.PULL + 1], row[tb.PULL + 2], row[tb.STIFFENING] = 0.0, 0.0, 0.0, 0.0
    for s in range(springs.networks[n, tb.N_SPRING], springs.networks[n + 1, tb.N_SPRING]):
        pull(s, time_step, bodies, springs)
    for k in range(springs.networks[n, tb.N_MEMBER], springs.networks[n + 1, tb.N_MEMBER]):
        row = members[k]
        for c in range(3):
            row[tb.RESIDUAL + c] = coordinate_missing(
                row[tb.RESISTANCE + c],
                row[tb.FREE_SHIFT + c],
                row[tb.SHIFT + c],
                row[tb.PULL + c],
            )
    write_diagonal(n, springs)


def pull(s: int, time_step: float, bodies: Bodies, springs: Springs) -> None:
    """Add the pull of a spring to its members, and note what it resists."""
    spring, members = springs.springs[s], springs.members
    a, b = springs.ends[s, tb.MEMBER_A], springs.ends[s, tb.MEMBER_B]
    x, y = end_shift(tb.ANCHOR_A, tb.ARM_A, members[a], bodies.pose[springs.slot[a]], spring)
    later_x, later_y = spring[tb.SPAN_X] - x, spring[tb.SPAN_Y] - y
    if b >= 0:
        x, y = end_shift(tb.ANCHOR_B, tb.ARM_B, members[b], bodies.pose[springs.slot[b]], spring)
        later_x, later_y = later_x + x, later_y + y
    length, later = spring[tb.LENGTH], sqrt(later_x * later_x + later_y * later_y)
    stiffness, damping = spring[tb.STIFFNESS], spring[tb.DAMPER_HELD]
    tension = tension_held(stiffness, spring[tb.REST_LENGTH], length, later)
    span = (spring[tb.SPAN_X], spring[tb.SPAN_Y])
    x, y = span[0] + later_x, span[1] + later_y
    both = max(sqrt(x * x + y * y), 1e-150)
    axis = (x / both, y / both)
    force = spring_force_held(
        tension, damping, span, (later_x, later_y), length, later, axis, time_step
    )
    spring[tb.AXIS_X], spring[tb.AXIS_Y] = axis
    spring[tb.ALONG] = change_along(stiffness, damping, time_step)
    spring[tb.ACROSS] = change_across(tension, length, later)
    pull_ends(s, force, tb.PULL, springs)
    arm = (spring[tb.ARM_A], spring[tb.ARM_A + 1])
    members[a, tb.STIFFENING] += change_leaning(arm, force)
    if b >= 0:
        arm = (spring[tb.ARM_B], spring[tb.ARM_B + 1])
        members[b, tb.STIFFENING] += change_leaning(arm, (-force[0], -force[1]))


@inlined
def end_shift(at: int, to: int, row: Array, pose: Array, spring: Array) -> Vector:
    """Return how far an end of a spring is shifted with its body, and note its arm."""
    anchor, turn = (spring[at], spring[at + 1]), row[tb.SHIFT + 2]
    arm = anchor
    if abs(anchor[0]) + abs(anchor[1]) > 0.0:
        arm = turned(anchor, pose[tb.ANGLE] + 0.5 * turn)
        if turn != 0.0:
            arm = arm_held(arm, 0.5 * turn, cosine_sine(0.5 * turn)[1])
    spring[to], spring[to + 1] = arm
    return row[tb.SHIFT] - turn * arm[1], row[tb.SHIFT + 1] + turn * arm[0]


@inlined
def turned(anchor: Vector, angle: float) -> Vector:
    """Return an anchor in the axes of the world."""
    cosine, sine = cosine_sine(angle)
    return cosine * anchor[0] - sine * anchor[1], sine * anchor[0] + cosine * anchor[1]
