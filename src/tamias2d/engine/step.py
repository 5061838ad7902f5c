"""One step of all bodies: the stages in their order.

The broad phase finds pairs of shapes that may touch, the narrow phase their manifolds; contacts
that touch are arranged in blocks, slabs and trees. Each substep applies forces and the impulses of
before, solves soft constraints, integrates positions, and relaxes the constraints; then restitution
acts. Bodies without contacts follow their closed form instead (IM1, IM6). Continuous collision
stops bodies that move far where they meet others, and islands at rest fall asleep. Springs pull
through the whole step, or in its substeps where their bodies have contacts (IM14, DD52).

Cost: a substep visits each contact twice. Source: Macklin et al. (2019), Catto (2024).
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.all_asleep import note_all_asleep, skip_steps, still_asleep
from tamias2d.engine.arrangement import arrange
from tamias2d.engine.broad_phase.all_pairs import few_shapes
from tamias2d.engine.broad_phase.comoving_frame import move_frame
from tamias2d.engine.broad_phase.contact_list import current_contacts
from tamias2d.engine.broad_phase.fat_bounds import left_by_frame, mark_out_of_bounds
from tamias2d.engine.broad_phase.pairs import list_stays, rebuild_pairs, update_pairs
from tamias2d.engine.broad_phase.vertices import turn_vertices
from tamias2d.engine.continuous.bounds import mark_leaving_bounds
from tamias2d.engine.continuous.event_loop import MOST_UPDATES, TOO_LONG, solve_continuous
from tamias2d.engine.continuous.prediction import foresee
from tamias2d.engine.continuous.sensing import tell_passed
from tamias2d.engine.early import add_early
from tamias2d.engine.joined import mark_joined
from tamias2d.engine.joints.activity import clear_of_joints, note_mechanisms
from tamias2d.engine.joints.placement import note_places
from tamias2d.engine.joints.step_impulses import keep_joint_impulses
from tamias2d.engine.motion.free import integrate_free
from tamias2d.engine.motion.hard_discs import may_be_hard, take_hard_steps
from tamias2d.engine.motion.quiet import may_be_quiet, nothing_touches, take_quiet_steps
from tamias2d.engine.narrow_phase.touching import find_touching
from tamias2d.engine.overshoot import overshoots
from tamias2d.engine.parts import (
    begin_part,
    end_part,
    is_last_part,
    note_start,
    retake_part,
    set_level,
    shorten_part,
)
from tamias2d.engine.pulled import wake_pulled
from tamias2d.engine.reports.contact_log import log_events
from tamias2d.engine.sleep import (
    fall_asleep,
    hold_sleeping,
    keep_touching_flags,
    note_support_kinds,
    update_sleep,
    wake_touched,
)
from tamias2d.engine.springs.energy_balance import balance_networks
from tamias2d.engine.springs.held import hold_springs, release_springs
from tamias2d.engine.state import gather_state, scatter_state
from tamias2d.engine.substeps import solve_contacts
from tamias2d.engine.tables import Control, World
from tamias2d.kernels.assembled import for_each

SHORTEST_FOR_SPRINGS = 6  # level; networks for which that is too long go through the substeps


@for_each
def step(world: World, steps: int) -> int:
    """Take some steps, or return why not all of them can be taken.

    Called again with those that are left, it continues. It ends early, with CLEAR, where no contact
    is on the list: bodies may go ballistically then; and where the contact log has no room for what
    began and ceased to touch. Each step judges what it begins with, as if it had been asked for
    alone.
    """
    counts = world.control.counts
    counts[tb.STEPS_LEFT] = steps
    if still_asleep(world):
        skip_steps(world)
        return tb.DONE
    note_places(world)
    mark_joined(world)
    clear, logged = False, True
    while counts[tb.STEPS_LEFT] > 0 and logged and not clear:
        if counts[tb.STAGE] == tb.AT_START:
            if not gather_state(world.control, world.state, world.bodies):
                return tb.INVALID
            status = list_few(world)
            if status != tb.DONE:
                return status
            if may_be_quiet(world):
                valid = True
                if may_be_hard(world):
                    take_hard_steps(world)
                elif nothing_touches(world):
                    valid = take_quiet_steps(world)
                if counts[tb.STEPS_LEFT] == 0 or world.log.counts[tb.LOG_FULL] == 1:
                    return tb.DONE
                if not valid:
                    continue  # to be told of it
        status = take_step(world)
        if status != tb.DONE:
            return status
        counts[tb.STEPS_LEFT] -= 1
        counts[tb.STEPS_TAKEN] += 1
        if not scatter_state(world.state, world.bodies):
            return tb.OVERFLOWED
        if note_all_asleep(world):
            skip_steps(world)
            return tb.DONE
        pairs, sleep_steps = world.broad_phase.counts, world.islands.counts[tb.SLEEP_STEPS]
        sprung = world.springs.counts[tb.SPRINGS] > 0
        clear = (
            pairs[tb.CONTACTS] == 0
            and pairs[tb.LIST_HOLDS] == 1
            and sleep_steps == 0
            and not sprung
        )
        clear = clear_of_joints(clear, world)
        logged = log_events(world)
    return tb.CLEAR if clear else tb.DONE


def list_few(world: World) -> int:
    """List all pairs of a few discs before their first step; return which array is too short.

    So that step, too, may be one of hard discs.
    """
    if world.broad_phase.counts[tb.LIST_HOLDS] == 1 or not (
        may_be_hard(world) and few_shapes(world.bodies, world.shapes)
    ):
        return tb.DONE
    turn_vertices(world.bodies, world.shapes, tb.STATIC)
    return rebuild_pairs(world)


def take_step(world: World) -> int:
    """Take one step by its parts, or return which array is too short."""
    ended = False
    while not ended:
        status = take_part(world)
        if status == tb.DONE:
            keep_joint_impulses(world)
            if world.control.counts[tb.LOADS_VARY] == 1:
                add_early(world)
            ended = end_part(world)
        elif status != tb.AGAIN:
            return status
    return tb.DONE


def take_part(world: World) -> int:
    """Take a part of a step, or return which array is too short; called again, it continues."""
    control, bodies, shapes, islands = world.control, world.bodies, world.shapes, world.islands
    broad_phase, buffers, touching = world.broad_phase, world.buffers, world.touching
    counts, sprung = control.counts, len(world.springs.members) > 0
    if counts[tb.STAGE] == tb.AT_START:  # what has nothing to do is not called: calls take longest
        begin_part(world)
        wake_changed(sprung, world)
        left = find_moved(world)
        known = list_stays(left, broad_phase) or update_pairs(left, world)
        counts[tb.STAGE] = tb.PAIRS_KNOWN if known else tb.PAIRS_STALE
    if counts[tb.STAGE] == tb.PAIRS_STALE:
        status = rebuild_pairs(world)
        if status != tb.DONE:
            return status
        counts[tb.STAGE] = tb.PAIRS_KNOWN
    contacts = current_contacts(broad_phase, buffers)
    if counts[tb.STAGE] == tb.PAIRS_KNOWN:
        length = control.progress[tb.PART_TIME]
        shorten_part(world, contacts)
        if sprung and control.progress[tb.PART_TIME] != length:
            release_springs(bodies, world.springs)
            hold_springs_of_part(world)
        again = counts[tb.TICK] + counts[tb.RETAKEN] > 0
        find_touching(again, control, bodies, shapes, broad_phase, contacts, touching, islands)
        while islands.counts[tb.SLEEPING] > 0 and wake_touched(contacts, touching, islands):
            find_touching(True, control, bodies, shapes, broad_phase, contacts, touching, islands)
        foresee(world, contacts)
        counts[tb.STAGE] = tb.MANIFOLDS_KNOWN
    if counts[tb.STAGE] == tb.MANIFOLDS_KNOWN:
        note_mechanisms(world)
        constraints = world.constraints
        if touching.counts[tb.ARRANGED] == 0 or constraints.counts[tb.ACTIVE] > 0:
            status = arrange(world, contacts)
            if status != tb.DONE:
                return status
        note_start(world)
        if constraints.counts[tb.ACTIVE] > 0:
            solve_contacts(world, contacts)
        if counts[tb.START_NOTED] == 1 and overshoots(world, contacts):
            release_springs(bodies, world.springs)
            retake_part(world, contacts)
            return tb.AGAIN
        counts[tb.STAGE] = integrate(world)
    while counts[tb.STAGE] != tb.ARRIVING:
        status = fly(world)
        if status != tb.DONE:
            return status
    if sprung:
        balanced = control.progress[tb.FLOWN] <= 1.0 or balance_networks(world)
        release_springs(bodies, world.springs)
        if not balanced and may_shorten(control):
            retake_part(world, contacts)
            return tb.AGAIN
    if islands.counts[tb.SLEEP_STEPS] > 0 and is_last_part(control):
        fall_asleep(control, bodies, islands)
    broad_phase.counts[tb.STEPS_SINCE] += 1
    counts[tb.STAGE] = tb.AT_START
    return tb.DONE


def wake_changed(sprung: bool, world: World) -> None:
    """Wake islands that were changed, and hold the loads of springs; wake what these pull."""
    islands = world.islands
    if islands.counts[tb.SLEEP_STEPS] > 0:
        contacts = current_contacts(world.broad_phase, world.buffers)
        update_sleep(
            world.control, world.bodies, world.broad_phase, contacts, islands, world.joints
        )
    if sprung:
        hold_springs_of_part(world)
        if islands.counts[tb.SLEEPING] > 0:
            wake_pulled(world)


def may_shorten(control: Control) -> bool:
    """Return whether a part may be taken again as a shorter one for its springs."""
    counts = control.counts
    return bool(counts[tb.START_NOTED] == 1 and counts[tb.LEVEL] < SHORTEST_FOR_SPRINGS)


def fly(world: World) -> int:
    """Let bodies go on until they arrive or one leaves its bounds; return whether they could."""
    control, bodies, shapes, broad_phase = (
        world.control, world.bodies, world.shapes, world.broad_phase,
    )  # fmt: skip
    if control.counts[tb.STAGE] == tb.OUT_OF_BOUNDS:
        left = find_leaving(world)
        if not update_pairs(left, world):
            status = rebuild_pairs(world)
            if status != tb.DONE:
                return status
        control.progress[tb.UPDATES_LEFT] -= 1.0
    near = current_contacts(broad_phase, world.buffers)
    updates, flown = int(control.progress[tb.UPDATES_LEFT]), control.progress[tb.FLOWN]
    flown = solve_continuous(
        control, bodies, shapes, broad_phase, near, world.events, updates, flown
    )
    if flown == TOO_LONG:
        release_springs(bodies, world.springs)
        retake_part(world, near)
        return tb.AGAIN
    if flown > 1.0:
        tell_passed(bodies, shapes, broad_phase, near, world.events)
    control.progress[tb.FLOWN] = flown
    control.counts[tb.STAGE] = tb.OUT_OF_BOUNDS if flown <= 1.0 else tb.ARRIVING
    return tb.DONE


def hold_springs_of_part(world: World) -> None:
    """Hold the loads of springs for a part, which is made so short that these can be found."""
    solved = hold_springs(world)
    while not solved and world.control.counts[tb.LEVEL] < SHORTEST_FOR_SPRINGS:
        release_springs(world.bodies, world.springs)
        set_level(world.control.counts[tb.LEVEL] + 1, world)
        solved = hold_springs(world)
    networks = world.springs.networks
    for n in range(0 if solved else world.springs.counts[tb.NETWORKS]):
        networks[n, tb.N_LOSES] = max(networks[n, tb.N_LOSES], networks[n, tb.N_UNSOLVED])


def find_moved(world: World) -> int:
    """Return how many bodies have left their bounds."""
    bodies, broad_phase = world.bodies, world.broad_phase
    left = mark_out_of_bounds(world.control, bodies, broad_phase)
    all_needed = left > 0 or broad_phase.counts[tb.LIST_HOLDS] == 0
    if all_needed or broad_phase.counts[tb.CONTACTS] > 0:
        turn_vertices(bodies, world.shapes, tb.STATIC if all_needed else tb.KINEMATIC)
    return left


def integrate(world: World) -> int:
    """Find the displacements of all bodies; return the next stage."""
    bodies, broad_phase, islands = world.bodies, world.broad_phase, world.islands
    contacts = current_contacts(broad_phase, world.buffers)
    if islands.counts[tb.SLEEP_STEPS] > 0:
        touching, joints, shapes = world.touching, world.joints, world.shapes
        note_support_kinds(world.control, bodies, contacts, touching, islands, joints, shapes)
    if islands.counts[tb.SLEEPING] > 0:
        hold_sleeping(bodies, islands)
        keep_touching_flags(broad_phase, contacts, islands)
    far = integrate_free(world.control, bodies)
    move_frame(broad_phase)
    progress, counts = world.control.progress, world.touching.counts
    progress[tb.FLOWN], progress[tb.UPDATES_LEFT] = 0.0, MOST_UPDATES
    if not far and counts[tb.LOCATED_PAIRS] + counts[tb.PRESSED_DEEP] == 0:
        return tb.ARRIVING
    leaving = mark_leaving_bounds(bodies, broad_phase)
    return tb.OUT_OF_BOUNDS if leaving > 0 or left_by_frame(bodies, broad_phase) else tb.IN_FLIGHT


def find_leaving(world: World) -> int:
    """Return how many bodies leave their bounds in flight."""
    unturned = world.broad_phase.counts[tb.CONTACTS] == 0
    if unturned or world.control.progress[tb.FLOWN] > 0.0:  # they were turned along the flight
        turn_vertices(world.bodies, world.shapes, tb.STATIC)
    return mark_leaving_bounds(world.bodies, world.broad_phase)
