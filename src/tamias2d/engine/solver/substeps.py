"""The substeps of all bodies with contacts.

Serves: a step. Hides: that what contacts did before is carried by bodies, so that each contact is
visited twice in a substep, and once more as the step begins.
"""

from tamias2d.engine.direct.solve import prepare_trees, solve_trees
from tamias2d.engine.islands import update_islands
from tamias2d.engine.solver.constraints import (
    clear_lanes,
    fill_blocks,
    fill_lanes,
    prefetch_blocks,
    prefetch_manifolds,
    prepare_blocks,
    store_impulses,
)
from tamias2d.engine.solver.energy import makes_energy, note_before_restitution, sum_step_energy
from tamias2d.engine.solver.energy_bound import bound_energy
from tamias2d.engine.solver.lanes import apply_restitution, relax, solve_soft, warm_start
from tamias2d.engine.tables import (
    ACTIVE,
    ANGULAR,
    BLOCKS,
    BOUNCING,
    CONTACT_CHANGE,
    DANGLE,
    DECAY,
    DRAG_FACTOR,
    DX,
    DY,
    DYNAMIC,
    ENERGY_FIRST,
    ENERGY_GIVEN,
    ENERGY_NOW,
    GAIN,
    GRAVITY_X,
    GRAVITY_Y,
    INCREMENT,
    INVERSE_INERTIA,
    INVERSE_MASS,
    LANES_FILLED,
    ONE_SUBSTEP,
    PREFETCHED,
    PROPAGATOR,
    S_BLOCK,
    S_BODY,
    S_CONTACT,
    S_TREE,
    SLABS,
    SPIN,
    STEP_START,
    SUBSTEP_START,
    SUBSTEPS,
    TIME_STEP,
    TOUCHING,
    VX,
    VY,
    Bodies,
    Constraints,
    Contacts,
    Control,
    Direct,
    Islands,
    Shapes,
    Touching,
)
from tamias2d.generated.definitions import (
    acceleration,
    angular_acceleration,
    pace_given,
    pace_later,
)
from tamias2d.generated.soft_contact import shift_later, turn_later
from tamias2d.kernels.assembled import inlined


def solve_contacts(
    control: Control,
    bodies: Bodies,
    shapes: Shapes,
    contacts: Contacts,
    touching: Touching,
    constraints: Constraints,
    islands: Islands,
    direct: Direct,
) -> None:
    """Take the substeps of all bodies with contacts, and let them bounce."""
    if constraints.counts[ACTIVE] == 0:
        return
    substeps = control.counts[SUBSTEPS]
    substep = control.settings[TIME_STEP] / substeps
    constraints.scratch[ENERGY_FIRST] = constraints.scratch[ENERGY_NOW] = constraints.scratch[
        ENERGY_GIVEN
    ] = 0.0
    number, last = constraints.counts[SLABS], 2 * substeps
    for front in range(number + last):  # of two slabs the first is a stage ahead
        for stage in range(max(front - number + 1, 0), min(front, last) + 1):
            take_stage(
                stage,
                front - stage,
                substep,
                control,
                bodies,
                shapes,
                contacts,
                touching,
                constraints,
                direct,
            )
    constraints.counts[LANES_FILLED] = 1
    bouncing = constraints.counts[BOUNCING]
    slowest = (
        2.0
        * control.settings[TIME_STEP]
        * (abs(control.settings[GRAVITY_X]) + abs(control.settings[GRAVITY_Y]))
    )
    if bouncing > 0 or makes_energy(constraints.scratch):
        if bouncing > 0:
            note_before_restitution(bodies, touching, constraints, islands)
            apply_restitution(0, constraints.counts[BLOCKS], bodies, constraints, slowest)
        update_islands(bodies, touching, islands)
        bound_energy(control, bodies, touching, constraints, islands, bouncing)
    if bouncing > 0:
        store_impulses(0, touching.counts[TOUCHING], bodies, contacts, touching, constraints)


@inlined
def take_stage(
    stage: int,
    slab: int,
    substep: float,
    control: Control,
    bodies: Bodies,
    shapes: Shapes,
    contacts: Contacts,
    touching: Touching,
    constraints: Constraints,
    direct: Direct,
) -> None:
    """Take a slab through one stage: first the begin of the step, then two for each substep.

    Its contacts are with bodies of its own and of the next slab, which the slab before it has
    taken to this stage already.
    """
    first = constraints.slabs[slab + 1, S_BODY] if slab > 0 else 0
    last = constraints.slabs[min(slab + 2, constraints.counts[SLABS]), S_BODY]
    block, end = constraints.slabs[slab, S_BLOCK], constraints.slabs[slab + 1, S_BLOCK]
    hit, hit_end = constraints.slabs[slab, S_CONTACT], constraints.slabs[slab + 1, S_CONTACT]
    isle, isle_end = constraints.slabs[slab, S_TREE], constraints.slabs[slab + 1, S_TREE]
    if stage == 0:
        if constraints.counts[SLABS] > 1:
            constraints.scratch[PREFETCHED] = prefetch_manifolds(hit, hit_end, contacts, touching)
            constraints.scratch[PREFETCHED] += prefetch_blocks(
                block, end, constraints.blocks, constraints.lanes
            )
        begin_step(first, last, control, bodies, touching)
        if constraints.counts[LANES_FILLED] == 0:
            clear_lanes(block, end, len(bodies.kind) - 1, constraints.blocks, constraints.lanes)
            fill_lanes(hit, hit_end, bodies, shapes, contacts, touching, constraints)
        fill_blocks(hit, hit_end, bodies, contacts, touching, constraints)
        prepare_blocks(block, end, substep, constraints.blocks, constraints.lanes)
        prepare_trees(isle, isle_end, bodies, constraints, direct)
        warm_start(block, end, bodies, constraints)
    elif stage % 2 == 1:
        apply_forces(stage > 1, first, last, bodies, touching)
        solve_trees(False, isle, isle_end, substep, bodies, constraints, direct)
        solve_soft(block, end, bodies, constraints, substep)
    else:
        integrate_positions(substep, first, last, bodies, touching)
        solve_trees(True, isle, isle_end, substep, bodies, constraints, direct)
        relax(block, end, bodies, constraints, substep)
        if stage == 2 * control.counts[SUBSTEPS]:
            own, own_end = constraints.slabs[slab, S_BODY], constraints.slabs[slab + 1, S_BODY]
            sum_step_energy(own, own_end, control, bodies, touching, constraints)
            if constraints.counts[BOUNCING] == 0:
                store_impulses(hit, hit_end, bodies, contacts, touching, constraints)


def begin_step(first: int, last: int, control: Control, bodies: Bodies, touching: Touching) -> None:
    """Note the velocities before the impulses of the last step are applied again.

    Noted, too, is what gravity, forces and drag do to them in a substep.
    """
    gravity = (control.settings[GRAVITY_X], control.settings[GRAVITY_Y])
    for k in range(first, last):
        i = touching.active_by_slab[k]
        note = bodies.substep_state[i]
        for n in range(3):
            note[CONTACT_CHANGE + n], note[SUBSTEP_START + n] = 0.0, bodies.motion[i, n]
            note[STEP_START + n] = bodies.motion[i, n]
            note[DRAG_FACTOR + n], note[INCREMENT + n] = 1.0, 0.0
        if bodies.kind[i] == DYNAMIC:
            by_x, by_y = acceleration(
                gravity, (bodies.load[i, 0], bodies.load[i, 1]), bodies.properties[i, INVERSE_MASS]
            )
            turn = angular_acceleration(bodies.load[i, 2], bodies.properties[i, INVERSE_INERTIA])
            so = bodies.propagators[int(bodies.properties[i, PROPAGATOR])]
            decay, gain = so[ONE_SUBSTEP + DECAY], so[ONE_SUBSTEP + GAIN]
            note[DRAG_FACTOR] = note[DRAG_FACTOR + 1] = decay
            note[INCREMENT], note[INCREMENT + 1] = pace_given(gain, by_x), pace_given(gain, by_y)
            decay, gain = so[ONE_SUBSTEP + ANGULAR + DECAY], so[ONE_SUBSTEP + ANGULAR + GAIN]
            note[DRAG_FACTOR + 2], note[INCREMENT + 2] = decay, pace_given(gain, turn)


def apply_forces(again: bool, first: int, last: int, bodies: Bodies, touching: Touching) -> None:
    """Let forces change velocities for a substep, and contacts as they have before.

    What contacts have changed so far is carried: impulses add up, so this is what applying each of
    them again would do. In the first substep that is what the last step did, and bodies begin with
    the velocities that were noted.
    """
    for k in range(first, last):
        i = touching.active_by_slab[k]
        note = bodies.substep_state[i]
        for n in range(3):
            note[CONTACT_CHANGE + n] += bodies.motion[i, n] - note[SUBSTEP_START + n]
            before = bodies.motion[i, n] if again else note[SUBSTEP_START + n]
            flown = pace_later(note[DRAG_FACTOR + n], before, note[INCREMENT + n])
            bodies.motion[i, n] = flown + note[CONTACT_CHANGE + n]
            note[SUBSTEP_START + n] = bodies.motion[i, n]


def integrate_positions(
    substep: float, first: int, last: int, bodies: Bodies, touching: Touching
) -> None:
    """Move bodies along for a substep, s."""
    for k in range(first, last):
        i = touching.active_by_slab[k]
        now = bodies.motion[i]
        now[DX], now[DY] = shift_later((now[DX], now[DY]), (now[VX], now[VY]), substep)
        now[DANGLE] = turn_later(now[DANGLE], now[SPIN], substep)
