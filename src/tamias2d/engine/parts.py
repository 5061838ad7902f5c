"""The parts of a step: where a crowd outruns it, it is taken in shorter ones.

A crowd that comes far in a step has unboundedly many impacts in it, one after the other. In parts
so short that no body of it goes farther than it can be held back from, the solver treats them
together. Fast bodies that are few are left to continuous collision. Each part begins at a tick and
is a power of a half of the step; one that is longer than the last begins at a multiple of its
length. Cost of choosing: a pass over contacts, and the gap of those that are fast.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.broad_phase.contact_list import current_contacts
from tamias2d.engine.broad_phase.pairs import TOO_CROWDED
from tamias2d.engine.continuous.events import THIN, allowed_depth, manifold_at
from tamias2d.engine.continuous.passing import smaller_radius
from tamias2d.engine.energy.joined_gains import noted_if_free
from tamias2d.engine.narrow_phase.polygon import held_normal
from tamias2d.engine.part_impulses import add_up_impulses, forget_impulses, forget_impulses_of_part
from tamias2d.engine.tables import Bodies, Contacts, Control, Shapes, World
from tamias2d.generated.continuous_collision import motion_bound

FEW, OF_ALL = 3, 64  # pairs that are left to continuous collision: so many, or one of so many
CHEAP = 5  # a level beyond which twice as many are left for each: their impacts cost less
LIMIT = 1.5  # depths from which bodies are pushed back: how far a pair may go in a part


def begin_part(world: World) -> None:
    """Give the part that begins its length, which `shorten_part` may reduce."""
    control, broad_phase = world.control, world.broad_phase
    counts = control.counts
    if counts[tb.TICK] + counts[tb.RETAKEN] == 0:
        counts[tb.FINEST] = 0
    set_level(broad_phase.counts[tb.NEXT_LEVEL], world)


def end_part(world: World) -> bool:
    """Put the bodies where they are after a part; return whether the step has ended.

    The next part is twice as long where it begins at a multiple of that, if nothing forbids it.
    """
    control, bodies, broad_phase = world.control, world.bodies, world.broad_phase
    counts = control.counts
    level = counts[tb.LEVEL]
    counts[tb.TICK] += 1 << (tb.MOST_LEVEL - level)
    longer = (
        level > counts[tb.LEAST_LEVEL] and counts[tb.TICK] % (1 << (tb.MOST_LEVEL - level + 1)) == 0
    )
    broad_phase.counts[tb.NEXT_LEVEL] = level - 1 if longer else level
    counts[tb.RETAKEN], counts[tb.FINEST] = 0, max(counts[tb.FINEST], level)
    contacts = current_contacts(broad_phase, world.buffers)
    add_up_impulses(broad_phase.counts[tb.CONTACTS] if counts[tb.FINEST] > 0 else 0, contacts)
    if counts[tb.TICK] == 1 << tb.MOST_LEVEL:
        counts[tb.TICK] = counts[tb.LEAST_LEVEL] = 0
        set_level(0, world)
        return True
    for i in range(len(bodies.pose)):
        for n in range(3):
            bodies.pose[i, n] += bodies.motion[i, tb.DX + n]
            bodies.motion[i, tb.DX + n] = 0.0
    return False


def is_last_part(control: Control) -> bool:
    """Return whether the step ends with this part."""
    counts = control.counts
    return counts[tb.TICK] + (1 << (tb.MOST_LEVEL - counts[tb.LEVEL])) == 1 << tb.MOST_LEVEL


def note_start(world: World) -> None:
    """Note poses and velocities as a part begins, if it may have to be taken again.

    A body that stands may go far, too, once another one has met it.
    """
    control, bodies, touching = world.control, world.bodies, world.touching
    counts = control.counts
    noted = counts[tb.GOES_FAR] == 1 or touching.counts[tb.MEETING] > 0
    noted = noted_if_free(noted, world)
    counts[tb.START_NOTED], counts[tb.DISAGREE] = 1 if noted else 0, 0
    for i in range(len(bodies.pose) if noted else 0):
        for n in range(3):
            bodies.start[i, n], bodies.start[i, 3 + n] = bodies.pose[i, n], bodies.motion[i, n]


def retake_part(world: World, contacts: Contacts) -> None:
    """Put all bodies back to where a part began, which is to be taken again as a shorter one."""
    control, bodies, broad_phase = world.control, world.bodies, world.broad_phase
    counts = control.counts
    for i in range(len(bodies.pose)):
        bodies.moved[i] = tb.UNMOVED
        for n in range(3):
            bodies.pose[i, n], bodies.motion[i, n] = bodies.start[i, n], bodies.start[i, 3 + n]
            bodies.motion[i, tb.DX + n] = 0.0
    listed = broad_phase.counts[tb.CONTACTS]
    forget_impulses_of_part(counts[tb.TICK] == 0, listed, contacts, world.islands)
    broad_phase.counts[tb.NEXT_LEVEL] = counts[tb.LEAST_LEVEL] = counts[tb.LEVEL] + 1
    counts[tb.RETAKEN], counts[tb.STAGE] = 1, tb.AT_START


def set_level(level: int, world: World) -> None:
    """Let the part that begins be a power of a half of the step."""
    control, bodies, broad_phase = world.control, world.bodies, world.broad_phase
    counts = control.counts
    control.progress[tb.PART_TIME] = control.settings[tb.TIME_STEP] / (1 << level)
    counts[tb.PART_SUBSTEPS] = part_substeps(counts[tb.SUBSTEPS], level)
    if counts[tb.LEVEL] == level:
        return
    counts[tb.LEVEL] = level
    for k in range(len(bodies.propagators)):
        for n in range(bodies.propagators.shape[1]):
            bodies.propagators[k, n] = bodies.propagators_of_level[level, k, n]
    crowded = broad_phase.counts[tb.CONTACTS] > TOO_CROWDED * len(world.shapes.slot)
    if broad_phase.frame[tb.FRAME_MOVES] != 0.0 or crowded:
        broad_phase.counts[tb.LIST_HOLDS] = 0


def part_substeps(substeps: int, level: int) -> int:
    """Return in how many substeps a part is taken, where a whole step takes some."""
    return (substeps - 1) // (1 << level) + 1


def shorten_part(world: World, contacts: Contacts) -> None:
    """Make a part so short that only few pairs go farther in it than they are held back from."""
    control, broad_phase = world.control, world.broad_phase
    counts, wanted = control.counts, control.wanted
    level = counts[tb.LEVEL]
    if counts[tb.GOES_FAR] == 0 and level == 0:
        return
    find_wanted_levels(world, contacts)
    longer, highest = 0, tb.MOST_LEVEL
    few = max(FEW, broad_phase.counts[tb.CONTACTS] // OF_ALL)
    while highest > level and longer + wanted[highest] <= few << max(highest - CHEAP, 0):
        longer += wanted[highest]
        highest -= 1
    set_level(highest, world)
    if highest > 0 and counts[tb.TICK] == 0:
        forget_impulses(broad_phase.counts[tb.CONTACTS], contacts, world.islands)


def find_wanted_levels(world: World, contacts: Contacts) -> None:
    """Count the pairs that want a part of each level, where that is shorter than this one.

    Pairs for which the shortest part is too long want none.
    """
    control, bodies, shapes = world.control, world.bodies, world.shapes
    wanted, level = control.wanted, control.counts[tb.LEVEL]
    for k in range(len(wanted)):
        wanted[k] = 0
    for p in range(world.broad_phase.counts[tb.CONTACTS]):
        s, t = contacts.pairs[p, 0], contacts.pairs[p, 1]
        i, j = contacts.pairs[p, tb.SLOT_A], contacts.pairs[p, tb.SLOT_B]
        far = motion_of_pair(i, j, control.progress[tb.PART_TIME], bodies)
        reach = smaller_radius(s, t, shapes.material)
        deep = max(LIMIT * allowed_depth(i, j, reach, bodies.properties), THIN * reach)
        near = far > deep and not stay_apart(p, far, bodies, shapes, contacts)
        if near and contacts.flags[p, tb.SENSES] == 0:
            held = held_normal(contacts.manifolds[p], contacts.flags[p])
            gap = manifold_at(s, t, 0.0, held, bodies, shapes, world.events)
            k = level
            while k < tb.MOST_LEVEL and far > deep and far > gap:
                k += 1
                far *= 0.5
            wanted[k] += 1 if far <= max(deep, gap) else 0


def stay_apart(p: int, far: float, bodies: Bodies, shapes: Shapes, contacts: Contacts) -> bool:
    """Return whether the circles around a pair are farther apart than it comes together, m.

    Such a pair wants no shorter part.
    """
    a, b = bodies.pose[contacts.pairs[p, tb.SLOT_A]], bodies.pose[contacts.pairs[p, tb.SLOT_B]]
    material, pair = shapes.material, contacts.pairs[p]
    reach = material[pair[0], tb.SHAPE_RADIUS] + material[pair[1], tb.SHAPE_RADIUS] + far
    dx, dy = b[tb.X] - a[tb.X], b[tb.Y] - a[tb.Y]
    return bool(dx * dx + dy * dy > reach * reach)


def motion_of_pair(i: int, j: int, time: float, bodies: Bodies) -> float:
    """Return how far two bodies may come together in a time, m."""
    motion, properties = bodies.motion, bodies.properties
    by_x, by_y = (
        time * (motion[j, tb.VX] - motion[i, tb.VX]),
        time * (motion[j, tb.VY] - motion[i, tb.VY]),
    )
    of_i = motion_bound((0.0, 0.0), time * motion[i, tb.SPIN], properties[i, tb.CORE_RADIUS])
    return of_i + motion_bound(
        (by_x, by_y), time * motion[j, tb.SPIN], properties[j, tb.CORE_RADIUS]
    )
