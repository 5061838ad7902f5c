"""The substeps of all bodies with contacts, slab by slab.

Bodies carry what contacts have done to them, so that a substep visits each contact twice, and the
step once more as it begins. Source: Macklin et al. (2019), substeps; Catto (2024), soft step.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.direct.solve import prepare_trees, solve_trees
from tamias2d.engine.energy.angular_momentum import add_moments, add_moments_before, begin_moments
from tamias2d.engine.energy.step_energy import makes_energy, sum_step_energy
from tamias2d.engine.energy_bound import bound_energy, mark_bounced, note_before_restitution
from tamias2d.engine.islands import update_islands
from tamias2d.engine.joints.impacts import answer_impacts
from tamias2d.engine.joints.rebound import fit_rebound
from tamias2d.engine.joints.stages import (
    begin_joints,
    end_joints,
    fit_touched,
    relax_joints,
    solve_joints,
    store_joints,
)
from tamias2d.engine.joints.summed_energy import look_at_touched, past_untouched
from tamias2d.engine.pressed import note_pressed
from tamias2d.engine.solver.blocks import clear_lanes, fill_lanes
from tamias2d.engine.solver.impulses import store_impulses
from tamias2d.engine.solver.integration import apply_forces, begin_step, integrate_positions
from tamias2d.engine.solver.lanes import (
    apply_restitution,
    clear_restitution,
    relax,
    solve_soft,
    warm_start,
)
from tamias2d.engine.solver.prefetch import prefetch_blocks, prefetch_manifolds
from tamias2d.engine.solver.prepare import fill_blocks, prepare_blocks
from tamias2d.engine.solver.running_surfaces import run_surfaces
from tamias2d.engine.springs.substep import apply_springs, begin_springs, end_springs
from tamias2d.engine.tables import Constraints, Contacts, Control, Direct, World
from tamias2d.engine.turning import add_late_impulses, turn_contacts
from tamias2d.kernels.assembled import inlined

FEW_BLOCKS = 32  # up to which impacts get more sweeps: no impulses of before are known for them
MORE_SWEEPS = 8
MOST_BOUNCES, BOUNCES = 64, 8  # visits of restitution to each contact there, and elsewhere


def solve_contacts(world: World, contacts: Contacts) -> None:
    """Take the substeps of all bodies with contacts; then restitution, and the bound on energy."""
    control, constraints = world.control, world.constraints
    substep = control.progress[tb.PART_TIME] / control.counts[tb.PART_SUBSTEPS]
    before = control.settings[tb.SUBSTEP]
    control.progress[tb.IMPULSE_RATIO] = substep / before if before > 0.0 else 1.0
    control.settings[tb.SUBSTEP] = substep
    for k in range(len(constraints.energy)):
        constraints.energy[k] = 0.0
    sprung = world.springs.counts[tb.NETWORKS_TOUCHED] > 0
    if sprung:
        begin_springs(substep, world.bodies, world.springs)
    more = (
        world.touching.counts[tb.IMPULSES_UNKNOWN] > 0
        and constraints.counts[tb.BLOCKS] <= FEW_BLOCKS
    )
    constraints.counts[tb.SWEEPS] = MORE_SWEEPS if more else 1
    number, last = constraints.counts[tb.SLABS], 2 * control.counts[tb.PART_SUBSTEPS]
    for front in range(number + last):  # of two slabs the first is a stage ahead
        for stage in range(max(front - number + 1, 0), min(front, last) + 1):
            take_stage(stage, front - stage, substep, world, contacts)
    note_unsolved(control, world.direct)
    note_pressed(control, world.bodies, contacts, world.touching, constraints)
    constraints.counts[tb.LANES_FILLED] = 1
    looked_at = constraints.counts[tb.BOUNCING] + constraints.counts[tb.FREE_ISLANDS] > 0
    if looked_at or makes_energy(constraints.energy):
        finish_step(world)
    store_joints(world)
    if sprung:
        end_springs(world.bodies, world.springs)
    if constraints.counts[tb.BOUNCING] > 0:
        last = world.touching.counts[tb.TOUCHING]
        store_impulses(0, last, control, world.bodies, contacts, world.touching, constraints)
    if control.counts[tb.LOADS_VARY] == 1:
        turn_contacts(world, contacts)


def note_unsolved(control: Control, direct: Direct) -> None:
    """Note the first body of an island that was not solved, and whose masses are very different."""
    if direct.counts[tb.UNSOLVED] > 0 and control.counts[tb.OUTWEIGHED] == 0:
        control.counts[tb.OUTWEIGHED] = direct.counts[tb.UNSOLVED]
        control.counts[tb.LIMITS] += 1


def finish_step(world: World) -> None:
    """Apply restitution, and take back what makes energy."""
    bodies, touching, constraints = world.bodies, world.touching, world.constraints
    islands = world.islands
    if constraints.counts[tb.BOUNCING] > 0:
        note_before_restitution(bodies, touching, constraints, islands)
        clear_restitution(constraints)
        few = constraints.counts[tb.BLOCKS] <= FEW_BLOCKS
        over = False
        for visit in range(MOST_BOUNCES if few else BOUNCES):
            over = over or apply_restitution(visit > 0, bodies, constraints)
            if over:
                break
            over = fit_rebound(over, visit == 0, world)
        mark_bounced(bodies, touching, constraints, islands)
    update_islands(bodies, touching, islands, world.joints)
    bound_energy(world.control, bodies, touching, constraints, islands, world.joints)


@inlined
def take_stage(stage: int, slab: int, substep: float, world: World, contacts: Contacts) -> None:
    """Take a slab through one stage: first the begin of the step, then two for each substep.

    Its contacts are with bodies of its own and of the next slab, which the slab before it has
    taken to this stage already.
    """
    if stage == 0:
        begin_slab(slab, substep, world, contacts)
    elif stage % 2 == 1:
        solve_slab(stage > 1, slab, substep, world)
    else:
        relax_slab(slab, substep, world)
        if stage == 2 * world.control.counts[tb.PART_SUBSTEPS]:
            end_slab(slab, world, contacts)
    if world.control.counts[tb.LOADS_VARY] == 1:
        add_late_impulses(stage, slab, world)


def bodies_of_stage(slab: int, constraints: Constraints) -> tuple[int, int]:
    """Return the active bodies to take to a stage: the next slab's; of slab 0 its own, too."""
    slabs = constraints.slabs
    first = slabs[slab + 1, tb.S_BODY] if slab > 0 else 0
    return first, slabs[min(slab + 2, constraints.counts[tb.SLABS]), tb.S_BODY]


@inlined
def begin_slab(slab: int, substep: float, world: World, contacts: Contacts) -> None:
    """Prepare the constraints of a slab, and apply the impulses of before."""
    bodies, touching, constraints = world.bodies, world.touching, world.constraints
    slabs, blocks, lanes = constraints.slabs, constraints.blocks, constraints.lanes
    contact, contact_end = slabs[slab, tb.S_CONTACT], slabs[slab + 1, tb.S_CONTACT]
    block, block_end = slabs[slab, tb.S_BLOCK], slabs[slab + 1, tb.S_BLOCK]
    if constraints.counts[tb.SLABS] > 1:
        total = prefetch_manifolds(contact, contact_end, contacts, touching)
        total += prefetch_blocks(block, block_end, blocks, lanes)
        constraints.scratch[tb.PREFETCHED] = total
    first, last = bodies_of_stage(slab, constraints)
    begin_step(first, last, world.control, bodies, touching)
    if constraints.counts[tb.FREE_ISLANDS] > 0:
        begin_moments(first, last, touching, world.islands)
    if constraints.counts[tb.LANES_FILLED] == 0:
        clear_lanes(block, block_end, len(bodies.kind) - 1, blocks, lanes)
        fill_lanes(contact, contact_end, bodies, world.shapes, contacts, touching, constraints)
    if constraints.counts[tb.RUNNING] > 0:
        run_surfaces(block, block_end, contacts, world.shapes, constraints)
    fill_blocks(block, block_end, world.control, bodies, contacts, constraints)
    prepare_blocks(block, block_end, substep, blocks, lanes)
    prepare_trees(
        slabs[slab, tb.S_TREE], slabs[slab + 1, tb.S_TREE], bodies, constraints, world.direct
    )
    warm_start(block, block_end, bodies, constraints)
    begin_joints(substep, world)


@inlined
def solve_slab(again: bool, slab: int, substep: float, world: World) -> None:
    """Apply forces to bodies, and solve the soft constraints of a slab and touched springs."""
    bodies, constraints = world.bodies, world.constraints
    slabs = constraints.slabs
    first, last = bodies_of_stage(slab, constraints)
    if again and constraints.counts[tb.FREE_ISLANDS] > 0:
        add_moments(first, last, bodies, world.touching, world.islands)
    apply_forces(again, first, last, bodies, world.touching)
    sprung = world.springs.counts[tb.NETWORKS_TOUCHED] > 0
    share = 1.0 / world.control.progress[tb.PART_TIME]
    if sprung:
        apply_springs(False, substep, share, bodies, world.springs)
    answer_impacts(substep, world)
    solve_joints(False, substep, world)
    tree, tree_end = slabs[slab, tb.S_TREE], slabs[slab + 1, tb.S_TREE]
    solve_trees(False, tree, tree_end, substep, bodies, constraints, world.direct)
    for _ in range(constraints.counts[tb.SWEEPS]):
        solve_soft(
            slabs[slab, tb.S_BLOCK], slabs[slab + 1, tb.S_BLOCK], bodies, constraints, substep
        )
    if sprung:
        apply_springs(True, substep, share, bodies, world.springs)
    solve_joints(True, substep, world)


@inlined
def relax_slab(slab: int, substep: float, world: World) -> None:
    """Integrate positions, and relax the constraints of a slab."""
    bodies, constraints = world.bodies, world.constraints
    slabs = constraints.slabs
    first, last = bodies_of_stage(slab, constraints)
    if constraints.counts[tb.FREE_ISLANDS] > 0:
        add_moments_before(substep, first, last, bodies, world.touching, world.islands)
    integrate_positions(substep, first, last, bodies, world.touching)
    relax_joints(world)
    tree, tree_end = slabs[slab, tb.S_TREE], slabs[slab + 1, tb.S_TREE]
    solve_trees(True, tree, tree_end, substep, bodies, constraints, world.direct)
    block, block_end = slabs[slab, tb.S_BLOCK], slabs[slab + 1, tb.S_BLOCK]
    for left in range(constraints.counts[tb.SWEEPS] - 1, -1, -1):
        relax(block, block_end, bodies, constraints, substep, left == 0)


@inlined
def end_slab(slab: int, world: World, contacts: Contacts) -> None:
    """Add up the energy of a slab, and store its impulses unless restitution changes them."""
    bodies, touching, constraints = world.bodies, world.touching, world.constraints
    slabs = constraints.slabs
    first, last = slabs[slab, tb.S_BODY], slabs[slab + 1, tb.S_BODY]
    fit_touched(world)
    end_joints(world)
    first = past_untouched(first, last, world)
    sum_step_energy(first, last, world.control, bodies, touching, constraints.energy)
    look_at_touched(world)
    if constraints.counts[tb.BOUNCING] == 0:
        first, last = slabs[slab, tb.S_CONTACT], slabs[slab + 1, tb.S_CONTACT]
        store_impulses(first, last, world.control, bodies, contacts, touching, constraints)
