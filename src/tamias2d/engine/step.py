"""One step of all bodies: the stages in their order.

Which shapes are near; which touch, and where; blocks of contacts; then substeps, each of which
applies forces, applies the impulses of before, corrects them softly, moves bodies, and takes the
softness out of the velocities again; then restitution; and bodies that move far are stopped where
they meet something. Bodies that touch nothing follow their closed form instead (IM1, IM6).

Cost: a substep visits each contact three times. Source: Macklin et al. (2019), Catto (2024).
"""

from tamias2d.engine.broad_phase.comoving_frame import move_frame
from tamias2d.engine.broad_phase.contact_list import current_contacts
from tamias2d.engine.broad_phase.fat_bounds import left_by_frame, mark_out_of_bounds
from tamias2d.engine.broad_phase.pairs import (
    CLEAR,
    DONE,
    INVALID,
    OVERFLOWED,
    rebuild_pairs,
    update_pairs,
)
from tamias2d.engine.broad_phase.vertices import turn_vertices
from tamias2d.engine.continuous.bounds import mark_leaving_bounds
from tamias2d.engine.continuous.continuous import MOST_UPDATES, solve_continuous
from tamias2d.engine.motion.free import integrate_free
from tamias2d.engine.narrow_phase.touching import find_touching
from tamias2d.engine.sleep import (
    fall_asleep,
    hold_sleeping,
    keep_touching_flags,
    note_support_kinds,
    update_sleep,
    wake_touched,
)
from tamias2d.engine.solver.arrangement import arrange
from tamias2d.engine.solver.substeps import solve_contacts
from tamias2d.engine.state import gather_state, scatter_state
from tamias2d.engine.tables import (
    ARRIVING,
    AT_START,
    CHECKED,
    CONTACTS,
    FLOWN,
    IN_FLIGHT,
    KINEMATIC,
    LIST_HOLDS,
    MANIFOLDS_KNOWN,
    OUT_OF_BOUNDS,
    PAIRS_KNOWN,
    PAIRS_STALE,
    SLEEP_STEPS,
    SLEEPING,
    STAGE,
    STATIC,
    STEPS_LEFT,
    STEPS_SINCE,
    STEPS_TAKEN,
    UPDATES_LEFT,
    Contacts,
    World,
)
from tamias2d.kernels.assembled import inlined


def step(world: World) -> int:
    """Take the steps that are left of a call, or return why not all can be taken.

    Called again, it continues. It ends early where no pair is near: bodies may go ballistically
    then.
    """
    counts = world.control.counts
    if counts[STAGE] == AT_START:
        valid = gather_state(world.control, world.state, world.bodies)
        if not valid and counts[CHECKED] == 0:
            return INVALID
    alone = False
    while counts[STEPS_LEFT] > 0 and not alone:
        status = take_step(world)
        if status != DONE:
            return status
        counts[STEPS_LEFT] -= 1
        counts[STEPS_TAKEN] += 1
        if not scatter_state(world.state, world.bodies):
            return OVERFLOWED
        near = world.broad_phase.counts
        asleep = world.islands.counts[SLEEP_STEPS]
        alone = near[CONTACTS] == 0 and near[LIST_HOLDS] == 1 and asleep == 0
    return CLEAR if alone else DONE


@inlined
def take_step(world: World) -> int:
    """Take one step, or return which array is too short; called again, it continues."""
    counts = world.control.counts
    if counts[STAGE] == AT_START:
        counts[STAGE] = PAIRS_KNOWN if refresh_pairs(world) else PAIRS_STALE
    if counts[STAGE] == PAIRS_STALE:
        status = rebuild_pairs(
            world.control, world.bodies, world.shapes, world.tree, world.broad_phase,
            world.buffers, world.touching,
        )  # fmt: skip
        if status != DONE:
            return status
        counts[STAGE] = PAIRS_KNOWN
    if counts[STAGE] == PAIRS_KNOWN:
        contacts = current_contacts(world.broad_phase, world.buffers)
        find_contacts(world, contacts)
        counts[STAGE] = MANIFOLDS_KNOWN
    if counts[STAGE] == MANIFOLDS_KNOWN:
        contacts = current_contacts(world.broad_phase, world.buffers)
        status = arrange(
            world.control, world.bodies, contacts, world.touching, world.constraints, world.direct
        )
        if status != DONE:
            return status
        counts[STAGE] = solve_and_integrate(world, contacts)
    while counts[STAGE] != ARRIVING:
        if counts[STAGE] == OUT_OF_BOUNDS:
            status = find_pairs_in_flight(world)
            if status != DONE:
                return status
        counts[STAGE] = OUT_OF_BOUNDS if fly(world) else ARRIVING
    if world.islands.counts[SLEEP_STEPS] > 0:
        fall_asleep(world.control, world.bodies, world.islands)
    world.broad_phase.counts[STEPS_SINCE] += 1
    counts[STAGE] = AT_START
    return DONE


@inlined
def refresh_pairs(world: World) -> bool:
    """Wake what was changed, and look for pairs of bodies that left their bounds.

    Returns whether the list of pairs holds.
    """
    bodies, broad_phase = world.bodies, world.broad_phase
    if world.islands.counts[SLEEP_STEPS] > 0:
        contacts = current_contacts(broad_phase, world.buffers)
        update_sleep(world.control, bodies, broad_phase, contacts, world.islands)
    left = mark_out_of_bounds(bodies, broad_phase)
    everything = left > 0 or broad_phase.counts[LIST_HOLDS] == 0
    turn_vertices(bodies, world.shapes, STATIC if everything else KINEMATIC)
    return update_pairs(
        left, world.control, bodies, world.shapes, world.tree, broad_phase, world.buffers,
        world.touching,
    )  # fmt: skip


@inlined
def find_contacts(world: World, contacts: Contacts) -> None:
    """Find the contacts that touch; once more where they wake something."""
    again = False
    while not again or (
        world.islands.counts[SLEEPING] > 0 and wake_touched(contacts, world.touching, world.islands)
    ):
        find_touching(
            again, world.control, world.bodies, world.shapes, world.broad_phase, contacts,
            world.touching, world.islands,
        )  # fmt: skip
        again = True


@inlined
def solve_and_integrate(world: World, contacts: Contacts) -> int:
    """Solve the contacts, and move all bodies; return the next stage."""
    bodies, broad_phase, islands = world.bodies, world.broad_phase, world.islands
    solve_contacts(
        world.control, bodies, world.shapes, contacts, world.touching, world.constraints, islands,
        world.direct,
    )  # fmt: skip
    if islands.counts[SLEEP_STEPS] > 0:
        note_support_kinds(bodies, contacts, world.touching, islands)
    if islands.counts[SLEEPING] > 0:
        hold_sleeping(bodies, islands)
        keep_touching_flags(broad_phase, contacts, islands)
    far = integrate_free(world.control, bodies)
    move_frame(broad_phase)
    world.control.progress[FLOWN], world.control.progress[UPDATES_LEFT] = 0.0, MOST_UPDATES
    if not far:
        return ARRIVING
    leaving = mark_leaving_bounds(bodies, broad_phase)
    return OUT_OF_BOUNDS if leaving > 0 or left_by_frame(bodies, broad_phase) else IN_FLIGHT


@inlined
def find_pairs_in_flight(world: World) -> int:
    """Look for pairs of bodies that leave their bounds on their way; return how that ended."""
    control, bodies, broad_phase = world.control, world.bodies, world.broad_phase
    if control.progress[FLOWN] > 0.0:  # vertices were turned along the flight
        turn_vertices(bodies, world.shapes, STATIC)
    leaving = mark_leaving_bounds(bodies, broad_phase)
    status = DONE
    if not update_pairs(
        leaving, control, bodies, world.shapes, world.tree, broad_phase, world.buffers,
        world.touching,
    ):  # fmt: skip
        status = rebuild_pairs(
            control, bodies, world.shapes, world.tree, broad_phase, world.buffers, world.touching
        )
    if status == DONE:
        control.progress[UPDATES_LEFT] -= 1.0
    return status


@inlined
def fly(world: World) -> bool:
    """Let bodies that move far meet others; return whether one leaves its bounds before that."""
    progress = world.control.progress
    contacts = current_contacts(world.broad_phase, world.buffers)
    progress[FLOWN] = solve_continuous(
        world.control, world.bodies, world.shapes, world.broad_phase, contacts, world.events,
        int(progress[UPDATES_LEFT]), progress[FLOWN],
    )  # fmt: skip
    return bool(progress[FLOWN] <= 1.0)
