"""What an island on a support has too much is dissipated in the bodies that got it (DD88).

A body that got nothing loses nothing: one slides on the same plank, or flies on a slack rope. It
keeps what it had as the step began, and what forces gave it, unless joints have pushed it.
Cost: some visits to each body, where some island has too much.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.energy.step_energy import GRACE, mass_and_inertia
from tamias2d.engine.energy.support import (
    FREE,
    damp_to_support,
    energy_from_support,
    reference_at,
    share_left,
)
from tamias2d.engine.energy.velocity_change import product_with_motion, reduce_along
from tamias2d.engine.joints.acting import unless_tied
from tamias2d.engine.joints.joined_dissipation import reduce_motion_as_one, reduce_together
from tamias2d.engine.tables import Bodies, Constraints, Control, Islands, Joints, Touching
from tamias2d.generated.definitions import coordinate_velocity_later, kinetic_energy
from tamias2d.generated.island_energy import (
    energy_along_given,
    energy_along_given_left,
    lift_work,
)
from tamias2d.kernels.assembled import inlined


def dissipate_excess(
    control: Control,
    bodies: Bodies,
    touching: Touching,
    constraints: Constraints,
    islands: Islands,
    joints: Joints,
) -> None:
    """Take what chosen islands have too much from their bodies.

    Bodies at rest lose it first. Where they have not enough, those do that got energy: of what
    they got, then of all of their motion. What is left is taken from all that contacts push, as far
    as it goes.
    """
    for n in range(islands.counts[tb.ROOTS]):
        row = islands.energy[islands.roots[n]]
        chosen = row[tb.DAMPED_SHARE] != 1.0 and row[tb.SUPPORT] != FREE
        row[tb.ENERGY_SURPLUS] = row[tb.ENERGY_KEPT] - row[tb.ENERGY_BOUND] if chosen else 0.0
    damp_chosen(False, control, bodies, touching, constraints, islands)
    for k in range(constraints.counts[tb.ACTIVE]):
        i = touching.active[k]
        if has_excess(i, bodies, islands):
            note_given(i, control, bodies, islands)
    reduce_together(islands, joints)
    for k in range(constraints.counts[tb.ACTIVE]):
        i = touching.active[k]
        if has_excess(i, bodies, islands) and islands.given[i] > 0.0:
            reduce_change(i, bodies, islands)
    find_surplus(False, control, bodies, touching, constraints, islands)
    reduce_motion_as_one(bodies, islands, joints)
    for k in range(constraints.counts[tb.ACTIVE]):
        i = touching.active[k]
        if has_excess(i, bodies, islands) and islands.given[i] > 0.0:
            reduce_motion(i, bodies, islands)
    damp_chosen(True, control, bodies, touching, constraints, islands)


def has_excess(i: int, bodies: Bodies, islands: Islands) -> bool:
    """Return whether a body is of an island that has too much."""
    surplus = islands.energy[islands.links[i, tb.ROOT], tb.ENERGY_SURPLUS]
    return bool(bodies.kind[i] == tb.DYNAMIC and surplus > 0.0)


def note_given(i: int, control: Control, bodies: Bodies, islands: Islands) -> None:
    """Note what a body was given: the change of its velocities that forces alone do not make."""
    row, then, now = islands.energy[i], bodies.substep_state[i], bodies.motion[i]
    for n in range(3):
        free = then[tb.STEP_START + n]
        for _ in range(control.counts[tb.PART_SUBSTEPS]):
            free = coordinate_velocity_later(then[tb.DRAG_FACTOR + n], free, then[tb.INCREMENT + n])
        row[tb.VELOCITY_GIVEN + n] = now[n] - free
    mass, inertia = mass_and_inertia(i, bodies.properties)
    by, spin = reference_at(i, bodies, islands)
    given = (row[tb.VELOCITY_GIVEN], row[tb.VELOCITY_GIVEN + 1])
    turned = row[tb.ANGULAR_VELOCITY_GIVEN]
    row[tb.CHANGE_ENERGY] = kinetic_energy(mass, given, inertia, turned)
    row[tb.GIVEN_PRODUCT] = product_with_motion(
        i, given, turned, by, spin, bodies.motion, bodies.properties
    )


def reduce_change(i: int, bodies: Bodies, islands: Islands) -> None:
    """Take from a body, along what it was given, its part of the surplus."""
    row = islands.energy[i]
    product, change = row[tb.GIVEN_PRODUCT], row[tb.CHANGE_ENERGY]
    island = islands.energy[islands.links[i, tb.ROOT]]
    if not (product > 0.0 and change > 0.0):
        return
    energy = energy_along_given(product, change)
    left = energy_along_given_left(
        energy, island[tb.ENERGY_SURPLUS], islands.given[i], island[tb.ENERGY_GIVEN_ALL]
    )
    share = share_left(energy, max(left, least_left(energy, i, bodies, islands)))
    given = (row[tb.VELOCITY_GIVEN], row[tb.VELOCITY_GIVEN + 1])
    reduce_along(given, row[tb.ANGULAR_VELOCITY_GIVEN], share, product, change, bodies.motion[i])


def reduce_motion(i: int, bodies: Bodies, islands: Islands) -> None:
    """Take from all of the motion of a body its part of the surplus, unless it lost it with others.

    No body loses more than it got.
    """
    row, energy = islands.energy[islands.links[i, tb.ROOT]], energy_from_support(i, bodies, islands)
    alone = energy > 0.0
    alone = unless_tied(alone, i, islands)
    if alone:
        left = energy_along_given_left(
            energy, row[tb.ENERGY_SURPLUS], islands.given[i], row[tb.ENERGY_GIVEN_ALL]
        )
        share = share_left(energy, max(left, energy - dissipable(False, i, bodies, islands)))
        damp_to_support(i, share, bodies, islands)


def dissipable(whole: bool, i: int, bodies: Bodies, islands: Islands) -> float:
    """Return what a body can lose: the whole of its energy, or what is not its own, J."""
    own = 0.0 if whole else islands.energy[i, tb.ENERGY_OWN]
    return max(energy_from_support(i, bodies, islands) - own, 0.0)


@inlined
def least_left(energy: float, i: int, bodies: Bodies, islands: Islands) -> float:
    """Return what a body keeps at least of an energy, J: bodies that are tied lose it together."""
    alone = True
    alone = unless_tied(alone, i, islands)
    return energy - dissipable(False, i, bodies, islands) if alone else 0.0


def loses_all(last: bool, i: int, islands: Islands) -> bool:
    """Return whether a chosen body keeps nothing: one at rest, unless others there are tied."""
    row = islands.energy[islands.links[i, tb.ROOT]]
    return bool(not last and row[tb.ACTING] == 0.0)


def damp_chosen(
    last: bool,
    control: Control,
    bodies: Bodies,
    touching: Touching,
    constraints: Constraints,
    islands: Islands,
) -> None:
    """Damp chosen bodies by what they can lose, if that suffices, or nothing else is left.

    At first these are bodies at rest, in the end all that contacts push.
    """
    find_surplus(last, control, bodies, touching, constraints, islands)
    for n in range(islands.counts[tb.ROOTS]):
        row = islands.energy[islands.roots[n]]
        surplus, theirs = row[tb.ENERGY_SURPLUS], row[tb.DISSIPABLE_ENERGY]
        row[tb.DISSIPATED_SHARE] = 0.0
        if surplus > 0.0 and theirs > 0.0 and (theirs >= surplus or last):
            row[tb.DISSIPATED_SHARE] = min(surplus / theirs, 1.0)
            row[tb.ENERGY_SURPLUS] = 0.0
    for k in range(constraints.counts[tb.ACTIVE]):
        i = touching.active[k]
        share = islands.energy[islands.links[i, tb.ROOT], tb.DISSIPATED_SHARE]
        chosen = is_chosen(last, i, control, bodies, islands)
        if bodies.kind[i] == tb.DYNAMIC and share > 0.0 and chosen:
            energy = energy_from_support(i, bodies, islands)
            lost = dissipable(loses_all(last, i, islands), i, bodies, islands)
            damp_to_support(i, share_left(energy, energy - share * lost), bodies, islands)


def find_surplus(
    last: bool,
    control: Control,
    bodies: Bodies,
    touching: Touching,
    constraints: Constraints,
    islands: Islands,
) -> None:
    """Find what islands still have too much, and what their chosen bodies can lose, J."""
    for n in range(islands.counts[tb.ROOTS]):
        row = islands.energy[islands.roots[n]]
        row[tb.ENERGY_AFTER] = row[tb.DISSIPABLE_ENERGY] = 0.0
    for k in range(constraints.counts[tb.ACTIVE]):
        i = touching.active[k]
        if has_excess(i, bodies, islands):
            row, energy = (
                islands.energy[islands.links[i, tb.ROOT]],
                energy_from_support(i, bodies, islands),
            )
            row[tb.ENERGY_AFTER] += energy
            if is_chosen(last, i, control, bodies, islands):
                whole = loses_all(last, i, islands)
                row[tb.DISSIPABLE_ENERGY] += dissipable(whole, i, bodies, islands)
    for n in range(islands.counts[tb.ROOTS]):
        row = islands.energy[islands.roots[n]]
        if row[tb.ENERGY_SURPLUS] > 0.0:
            surplus = row[tb.ENERGY_AFTER] - row[tb.ENERGY_BOUND]
            row[tb.ENERGY_SURPLUS] = surplus if surplus > GRACE * row[tb.ENERGY_AFTER] else 0.0


def is_chosen(last: bool, i: int, control: Control, bodies: Bodies, islands: Islands) -> bool:
    """Return whether a body that contacts push is at rest, or all are chosen as the last."""
    rests = is_at_rest(i, control, bodies, islands)
    rests = unless_tied(rests, i, islands)
    return bool(bodies.moved[i] == tb.MOVED and (rests or last))


def is_at_rest(i: int, control: Control, bodies: Bodies, islands: Islands) -> bool:
    """Return whether a body moves less than forces would move it in a substep."""
    gravity = (control.settings[tb.GRAVITY_X], control.settings[tb.GRAVITY_Y])
    mass, load = 1.0 / bodies.properties[i, tb.INVERSE_MASS], bodies.load[i]
    most = lift_work(mass, gravity, (load[0], load[1]), control.settings[tb.SUBSTEP])
    return energy_from_support(i, bodies, islands) < most
