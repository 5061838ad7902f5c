"""Thin islands solved at once: all their contacts together, instead of one after the other.

Serves: a step. Hides: the active set and the elimination.

Every contact is asked for the push that it has and what its velocity, times a large mass, would
add. With the velocities unknown this is a linear system over the bodies of the island; which
contacts push, and which hold by friction, is tried, solved and corrected until it fits. Pushes that
come out are never negative and rubs never too large, and what does not fit is left as it was.

Source: Rockafellar (1976), proximal point; George and Liu (1981), elimination of sparse systems.
"""

from math import sqrt

from tamias2d.generated.soft_contact import (
    angular_velocity_a_kicked,
    angular_velocity_b_kicked,
    bias_velocity,
    row_velocity,
    separation_later,
    velocity_a_kicked,
    velocity_b_kicked,
)
from tamias2d.state import Array, Vector
from tamias2d.stepped.elimination import (
    ASKED,
    BIAS,
    CHANGE,
    FIRM,
    HEAVIEST,
    HELD,
    INERTIA,
    LEFT,
    LOOSE,
    MASS,
    RIGHT,
    SCALE,
    SHARE,
    SOFT,
    START,
    assemble,
    factor,
    share_of,
    substitute,
)
from tamias2d.stepped.layout import (
    DTURN,
    DX,
    DY,
    INVERSE_INERTIA,
    INVERSE_MASS,
    SPIN,
    THIN,
    VX,
    VY,
    Whole,
)
from tamias2d.stepped.rows import (
    BODY_A,
    BODY_B,
    P_ARM_A,
    P_ARM_B,
    P_GAP,
    P_NOW,
    P_PUSH,
    P_RUB,
    P_SIDE_A,
    P_SIDE_B,
    POINTS,
    R_BIAS,
    R_FRICTION,
    R_INERTIA_A,
    R_INERTIA_B,
    R_KEEP,
    R_LIMIT,
    R_MASS_A,
    R_MASS_B,
    R_NX,
    R_NY,
    R_ROUND_A,
    R_ROUND_B,
    R_SHARE,
    SHARED,
    SIZE,
)
from tamias2d.stepped.thin import (
    I_FRESH,
    I_JOINT,
    I_KNOT,
    J_BLOCK,
    J_BUILT,
    J_LANE,
    J_ONE,
    J_OTHER,
    J_STATE,
    K_BODY,
)

STIFF = 1e9  # of a contact, in masses between the heaviest and the lightest of its island
REMOVED = 0.2  # of an overlap, removed in a substep
CORRECTIONS = 12  # corrections of what pushes and what holds
NEARLY = 1e-3  # of the fastest point: what is slower to part may push
SLIGHT = 1e-7  # of the largest push: no reason to correct
CLOSE_ENOUGH = 1e-10  # what may be left of the equations, as a part of the pushes, both squared
STILL_GOOD = 1e-6  # more than this is not taken
WILD = 100.0  # nor pushes so many times what there is to stop, for each contact
LIVELY = 1.0 + 1e-9  # nor what gives the bodies more energy, but for rounding
LEFT_ALONE = -1


def ready(islands: int, body: Array, rows: Array, lanes: Whole, web: Whole, weave: Array) -> None:
    """Note the masses of the knots of all islands, and how soft their joints are."""
    for n in range(islands):
        heaviest = lightest = 0.0
        for knot in range(web[n, I_KNOT], web[n + 1, I_KNOT]):
            i = web[knot, K_BODY]
            mass, inertia = body[i, INVERSE_MASS], body[i, INVERSE_INERTIA]
            weave[knot, MASS] = 1.0 / mass if mass > 0.0 else 0.0
            weave[knot, INERTIA] = 1.0 / inertia if inertia > 0.0 else 0.0
            mass = weave[knot, MASS]
            heaviest = max(heaviest, mass)
            lightest = min(lightest, mass) if lightest > 0.0 else mass
        weave[n, HEAVIEST] = heaviest
        weave[n, FIRM] = STIFF * sqrt(heaviest * lightest)
        web[n, I_FRESH] = 0
        for joint in range(web[n, I_JOINT], web[n + 1, I_JOINT]):
            row, m = rows[web[joint, J_BLOCK]], web[joint, J_LANE]
            weave[joint, SOFT], weave[joint, SOFT + 1] = row[R_BIAS + m], row[R_SHARE + m]
            weave[joint, SOFT + 2] = row[R_KEEP + m]
            first, second = row[SHARED + P_PUSH + m], row[SHARED + SIZE + P_PUSH + m]
            both = lanes[web[joint, J_BLOCK], POINTS] == 2 and first + second > 0.0
            weave[joint, SHARE] = first / (first + second) if both else 0.5


def settle_islands(
    relaxing: bool,
    substep: float,
    counts: Whole,
    rows: Array,
    lanes: Whole,
    motion: Array,
    web: Whole,
    weave: Array,
) -> None:
    """Solve all thin islands, with the speed that removes overlap, or to take that out again."""
    rate = REMOVED / substep
    for n in range(counts[THIN]):
        if web[n, I_FRESH] == LEFT_ALONE:
            continue
        first, last = web[n, I_JOINT], web[n + 1, I_JOINT]
        fastest = apart = largest = 0.0
        for joint in range(first, last):
            speed, bias = open_joint(
                joint, relaxing, substep, rate, rows, lanes, motion, web, weave
            )
            fastest, apart = max(fastest, speed), apart - bias
        for joint in range(first, last):
            largest = max(
                largest, guess(joint, relaxing, NEARLY * fastest, rows, lanes, web, weave)
            )
        weave[n, SCALE] = largest + weave[n, HEAVIEST] * fastest
        before = set_out(n, rows, lanes, motion, web, weave)
        left = solve_island(n, rows, lanes, motion, web, weave)
        good = left <= STILL_GOOD
        go_back(n, motion, web, weave)
        if good:
            most = 0.0
            for joint in range(first, last):
                most = max(most, apply_joint(joint, rows, lanes, motion, web, weave))
            good = most <= WILD * (last - first) * weave[n, SCALE]
            good = good and not_livelier(n, before, apart, motion, web, weave)
            if not good:
                go_back(n, motion, web, weave)
        for joint in range(first, last):
            if good:
                keep_joint(joint, rows, lanes, web, weave)
            harden(joint, good, rate, rows, web, weave)
        if not good:
            web[n, I_FRESH] = LEFT_ALONE
        elif relaxing:
            for joint in range(first, last):
                leave_room(joint, substep, rows, lanes, motion, web, weave)


def go_back(n: int, motion: Array, web: Whole, weave: Array) -> None:
    """Give the bodies of an island the velocities that were noted."""
    for knot in range(web[n, I_KNOT], web[n + 1, I_KNOT]):
        for k in range(3):
            motion[web[knot, K_BODY], k] = weave[knot, START + k]


def set_out(n: int, rows: Array, lanes: Whole, motion: Array, web: Whole, weave: Array) -> float:
    """Note the velocities of an island; return twice its energy without its contacts, J."""
    for knot in range(web[n, I_KNOT], web[n + 1, I_KNOT]):
        for k in range(3):
            weave[knot, START + k] = motion[web[knot, K_BODY], k]
            weave[knot, CHANGE + k] = 0.0
    for joint in range(web[n, I_JOINT], web[n + 1, I_JOINT]):
        b, m = web[joint, J_BLOCK], web[joint, J_LANE]
        row = rows[b]
        line, tangent = (row[R_NX + m], row[R_NY + m]), (-row[R_NY + m], row[R_NX + m])
        for k in range(lanes[b, POINTS]):
            at = SHARED + k * SIZE
            push, rub = row[at + P_PUSH + m], row[at + P_RUB + m]
            load_knots(joint, m, at, P_ARM_A, P_ARM_B, -push, line, row, web, weave)
            load_knots(joint, m, at, P_SIDE_A, P_SIDE_B, -rub, tangent, row, web, weave)
    energy = 0.0
    for knot in range(web[n, I_KNOT], web[n + 1, I_KNOT]):
        mass, inertia = weave[knot, MASS], weave[knot, INERTIA]
        x = mass * weave[knot, START] + weave[knot, CHANGE]
        y = mass * weave[knot, START + 1] + weave[knot, CHANGE + 1]
        turn = inertia * weave[knot, START + 2] + weave[knot, CHANGE + 2]
        energy += (x * x + y * y) / mass if mass > 0.0 else 0.0
        energy += turn * turn / inertia if inertia > 0.0 else 0.0
    return energy


def not_livelier(
    n: int, before: float, apart: float, motion: Array, web: Whole, weave: Array
) -> bool:
    """Return whether contacts have taken energy, but for what removes overlap at a speed, m/s."""
    energy = mass = 0.0
    for knot in range(web[n, I_KNOT], web[n + 1, I_KNOT]):
        now = motion[web[knot, K_BODY]]
        energy += weave[knot, MASS] * (now[VX] * now[VX] + now[VY] * now[VY])
        energy += weave[knot, INERTIA] * now[SPIN] * now[SPIN]
        mass += weave[knot, MASS]
    return energy <= before * LIVELY + mass * apart * apart


def solve_island(
    n: int, rows: Array, lanes: Whole, motion: Array, web: Whole, weave: Array
) -> float:
    """Find the velocities and pushes of an island; return what is left, as a part of the pushes."""
    changed, left = balance(n, True, rows, lanes, motion, web, weave)
    for _ in range(CORRECTIONS):
        if changed > 0 or web[n, I_FRESH] == 0:
            assemble(n, rows, lanes, web, weave)
            web[n, I_FRESH] = 0
            if not factor(n, web, weave):
                return 1.0
            web[n, I_FRESH] = 1
        substitute(n, web, weave)
        for knot in range(web[n, I_KNOT], web[n + 1, I_KNOT]):
            for k in range(3):
                motion[web[knot, K_BODY], k] += weave[knot, CHANGE + k]
        changed, left = balance(n, False, rows, lanes, motion, web, weave)
        if left <= CLOSE_ENOUGH:
            return left
    return left


def speed_of(
    m: int, at: int, row: Array, a: Array, b: Array, arm_a: int, arm_b: int, line: Vector
) -> float:
    """Return the velocity of a row of a lane, m/s."""
    return row_velocity(
        (a[VX], a[VY]),
        a[SPIN],
        row[at + arm_a + m],
        (b[VX], b[VY]),
        b[SPIN],
        row[at + arm_b + m],
        line,
    )


def open_joint(
    joint: int,
    relaxing: bool,
    substep: float,
    rate: float,
    rows: Array,
    lanes: Whole,
    motion: Array,
    web: Whole,
    weave: Array,
) -> tuple[float, float]:
    """Find the velocity that a joint is to have; return how far it is off that, and least bias."""
    b, m = web[joint, J_BLOCK], web[joint, J_LANE]
    row = rows[b]
    one, other = motion[lanes[b, BODY_A + m]], motion[lanes[b, BODY_B + m]]
    line = (row[R_NX + m], row[R_NY + m])
    fastest = least = 0.0
    for k in range(lanes[b, POINTS]):
        at = SHARED + k * SIZE
        speed = speed_of(m, at, row, one, other, P_ARM_A, P_ARM_B, line)
        if relaxing:
            bias = max(row[at + P_NOW + m] / substep + speed, 0.0)
        else:
            gap = separation_later(
                row[at + P_GAP + m],
                (one[DX], one[DY]),
                one[DTURN],
                row[at + P_ARM_A + m],
                row[at + P_SIDE_A + m] - row[R_ROUND_A + m],
                (other[DX], other[DY]),
                other[DTURN],
                row[at + P_ARM_B + m],
                row[at + P_SIDE_B + m] + row[R_ROUND_B + m],
                line,
            )
            bias = max(bias_velocity(gap, rate, substep), row[R_LIMIT + m])
        weave[joint, BIAS + k] = bias
        weave[joint, ASKED + k] = speed + bias
        fastest, least = max(fastest, abs(speed + bias)), min(least, bias)
    return fastest, least


def guess(
    joint: int,
    relaxing: bool,
    slow: float,
    rows: Array,
    lanes: Whole,
    web: Whole,
    weave: Array,
) -> float:
    """Say what the points of a joint may do, unless that is known; return its larger push."""
    b, m = web[joint, J_BLOCK], web[joint, J_LANE]
    row = rows[b]
    pushes = rubs = 0.0
    state = 0
    for k in range(lanes[b, POINTS]):
        at = SHARED + k * SIZE + m
        if row[at + P_PUSH] > 0.0 or weave[joint, ASKED + k] <= slow:
            state += 1 << k
        pushes, rubs = pushes + row[at + P_PUSH], rubs + row[at + P_RUB]
    limit = row[R_FRICTION + m] * pushes
    if state > 0 and row[R_FRICTION + m] > 0.0:
        slides = pushes > 0.0 and abs(rubs) >= limit
        state += HELD if not slides else LEFT if rubs < 0.0 else RIGHT
    if not relaxing:
        web[joint, J_STATE] = state
    return pushes


def harden(joint: int, good: bool, rate: float, rows: Array, web: Whole, weave: Array) -> None:
    """Let the next sweep take a joint as hard, where it was solved, otherwise as soft."""
    row, m = rows[web[joint, J_BLOCK]], web[joint, J_LANE]
    row[R_BIAS + m] = rate if good else weave[joint, SOFT]
    row[R_SHARE + m] = 1.0 if good else weave[joint, SOFT + 1]
    row[R_KEEP + m] = 0.0 if good else weave[joint, SOFT + 2]


def balance(
    n: int,
    first: bool,
    rows: Array,
    lanes: Whole,
    motion: Array,
    web: Whole,
    weave: Array,
) -> tuple[int, float]:
    """Find what is left of the equations of an island, and what its points do now.

    Returns how many joints differ from what was eliminated, and what is left as a part of the
    pushes, both squared.
    """
    for knot in range(web[n, I_KNOT], web[n + 1, I_KNOT]):
        i = web[knot, K_BODY]
        mass, inertia = weave[knot, MASS], weave[knot, INERTIA]
        weave[knot, CHANGE] = mass * (weave[knot, START] - motion[i, VX])
        weave[knot, CHANGE + 1] = mass * (weave[knot, START + 1] - motion[i, VY])
        weave[knot, CHANGE + 2] = inertia * (weave[knot, START + 2] - motion[i, SPIN])
    slight = SLIGHT * weave[n, SCALE]
    changed = 0
    for joint in range(web[n, I_JOINT], web[n + 1, I_JOINT]):
        ask(joint, first, weave[n, FIRM], slight, rows, lanes, motion, web, weave)
        changed += 1 if web[joint, J_STATE] != web[joint, J_BUILT] else 0
    left = 0.0
    for knot in range(web[n, I_KNOT], web[n + 1, I_KNOT]):
        x, y, turn = weave[knot, CHANGE], weave[knot, CHANGE + 1], weave[knot, CHANGE + 2]
        mass, inertia = weave[knot, MASS], weave[knot, INERTIA]
        lever = inertia / mass if mass > 0.0 else 0.0
        left = max(left, x * x + y * y + (turn * turn / lever if lever > 0.0 else 0.0))
    scale = weave[n, SCALE] * weave[n, SCALE]
    return changed, left / scale if scale > 0.0 else left


def ask(
    joint: int,
    first: bool,
    firm: float,
    slight: float,
    rows: Array,
    lanes: Whole,
    motion: Array,
    web: Whole,
    weave: Array,
) -> float:
    """Ask a joint for its impulses, and add to its knots what is new in them; return the push."""
    b, m = web[joint, J_BLOCK], web[joint, J_LANE]
    row = rows[b]
    one, other = motion[lanes[b, BODY_A + m]], motion[lanes[b, BODY_B + m]]
    line, tangent = (row[R_NX + m], row[R_NY + m]), (-row[R_NY + m], row[R_NX + m])
    friction = row[R_FRICTION + m]
    state = web[joint, J_STATE]
    now = 0
    pushes = rubs = side = 0.0
    for k in range(lanes[b, POINTS]):
        at = SHARED + k * SIZE
        before = row[at + P_PUSH + m]
        speed = speed_of(m, at, row, one, other, P_ARM_A, P_ARM_B, line)
        push = before - firm * (speed + weave[joint, BIAS + k])
        pushing = (state >> k) & 1
        if not first:
            pushing = 1 if push > (-slight if pushing == 1 else slight) else 0
        push = push if pushing == 1 else 0.0
        now += pushing << k
        weave[joint, ASKED + k] = push
        pushes += max(push, 0.0)
        rubs += row[at + P_RUB + m]
        load_knots(joint, m, at, P_ARM_A, P_ARM_B, push - before, line, row, web, weave)
    for k in range(lanes[b, POINTS]):
        part, at = share_of(k, now, joint, weave), SHARED + k * SIZE
        side += part * speed_of(m, at, row, one, other, P_SIDE_A, P_SIDE_B, tangent)
    wanted = rubs - firm * side
    does = state & RIGHT
    limit = friction * pushes
    if not first:
        does = LOOSE
        if now > 0 and friction > 0.0:
            held = abs(wanted) < limit + (slight if state & RIGHT == HELD else -slight)
            turned = state & RIGHT == (RIGHT if wanted < 0.0 else LEFT)
            does = HELD if held or turned else LEFT if wanted < 0.0 else RIGHT
    rub = 0.0
    if does == HELD:
        rub = wanted
    elif does == LEFT:
        rub = -limit
    elif does == RIGHT:
        rub = limit
    for k in range(lanes[b, POINTS]):
        at = SHARED + k * SIZE
        part = share_of(k, now, joint, weave)
        if does > HELD:
            part = max(weave[joint, ASKED + k], 0.0) / pushes if pushes > 0.0 else 0.0
        weave[joint, ASKED + 2 + k] = rub * part
        more = rub * part - row[at + P_RUB + m]
        load_knots(joint, m, at, P_SIDE_A, P_SIDE_B, more, tangent, row, web, weave)
    web[joint, J_STATE] = now + does
    return pushes


def load_knots(
    joint: int,
    m: int,
    at: int,
    arm_a: int,
    arm_b: int,
    amount: float,
    line: Vector,
    row: Array,
    web: Whole,
    weave: Array,
) -> None:
    """Add an impulse, N s, to what its two knots take."""
    one, other = web[joint, J_ONE], web[joint, J_OTHER]
    if one >= 0:
        weave[one, CHANGE] -= amount * line[0]
        weave[one, CHANGE + 1] -= amount * line[1]
        weave[one, CHANGE + 2] -= amount * row[at + arm_a + m]
    if other >= 0:
        weave[other, CHANGE] += amount * line[0]
        weave[other, CHANGE + 1] += amount * line[1]
        weave[other, CHANGE + 2] += amount * row[at + arm_b + m]


def apply_joint(
    joint: int, rows: Array, lanes: Whole, motion: Array, web: Whole, weave: Array
) -> float:
    """Let the impulses that were found act, as contacts can give them; return the larger push."""
    b, m = web[joint, J_BLOCK], web[joint, J_LANE]
    row = rows[b]
    one, other = motion[lanes[b, BODY_A + m]], motion[lanes[b, BODY_B + m]]
    line, tangent = (row[R_NX + m], row[R_NY + m]), (-row[R_NY + m], row[R_NX + m])
    most = 0.0
    for k in range(lanes[b, POINTS]):
        at = SHARED + k * SIZE + m
        push = max(weave[joint, ASKED + k], 0.0)
        limit = row[R_FRICTION + m] * push
        rub = max(min(weave[joint, ASKED + 2 + k], limit), -limit)
        weave[joint, ASKED + k], weave[joint, ASKED + 2 + k] = push, rub
        more = push - row[at + P_PUSH]
        jolt(m, more, line, row[at + P_ARM_A], row[at + P_ARM_B], row, one, other)
        more = rub - row[at + P_RUB]
        jolt(m, more, tangent, row[at + P_SIDE_A], row[at + P_SIDE_B], row, one, other)
        most = max(most, push)
    return most


def keep_joint(joint: int, rows: Array, lanes: Whole, web: Whole, weave: Array) -> None:
    """Write the impulses that were found where sweeps go on from."""
    b, m = web[joint, J_BLOCK], web[joint, J_LANE]
    for k in range(lanes[b, POINTS]):
        at = SHARED + k * SIZE + m
        rows[b, at + P_PUSH] = weave[joint, ASKED + k]
        rows[b, at + P_RUB] = weave[joint, ASKED + 2 + k]


def jolt(
    m: int,
    amount: float,
    line: Vector,
    arm_a: float,
    arm_b: float,
    row: Array,
    one: Array,
    other: Array,
) -> None:
    """Let an impulse, N s, act on two bodies."""
    one[VX], one[VY] = velocity_a_kicked((one[VX], one[VY]), amount, line, row[R_MASS_A + m])
    one[SPIN] = angular_velocity_a_kicked(one[SPIN], amount, arm_a, row[R_INERTIA_A + m])
    other[VX], other[VY] = velocity_b_kicked(
        (other[VX], other[VY]), amount, line, row[R_MASS_B + m]
    )
    other[SPIN] = angular_velocity_b_kicked(other[SPIN], amount, arm_b, row[R_INERTIA_B + m])


def leave_room(
    joint: int, substep: float, rows: Array, lanes: Whole, motion: Array, web: Whole, weave: Array
) -> None:
    """Tell the next visit of a joint how far it is open, from its velocity now."""
    b, m = web[joint, J_BLOCK], web[joint, J_LANE]
    row = rows[b]
    one, other = motion[lanes[b, BODY_A + m]], motion[lanes[b, BODY_B + m]]
    line = (row[R_NX + m], row[R_NY + m])
    for k in range(lanes[b, POINTS]):
        at = SHARED + k * SIZE
        speed = speed_of(m, at, row, one, other, P_ARM_A, P_ARM_B, line)
        row[at + P_NOW + m] = substep * (weave[joint, BIAS + k] - speed)
