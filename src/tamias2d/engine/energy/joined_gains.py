"""Energy that joints and contacts make where they are solved in turns, and disagree (IM11, IM15).

What a free island has too much is taken from all that differs from its motion as one. Where that is
nearly all that it has, the part is taken again in shorter ones, in which they agree. Where the
motion as one has more than may be, too, for bodies came together on a way that was too fast, energy
has risen: that is told.

Cost: where the motion of an island is damped, a visit to each mechanism.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.energy.support import FREE
from tamias2d.engine.tables import Control, Islands, Joints, World
from tamias2d.generated.definitions import kinetic_energy
from tamias2d.state import Array

VIOLENT = 0.5  # share of its motion that an island keeps, below which joints and contacts disagree
SLIGHT_GAIN = 1e-3  # of the energy of an island: less is not told
ROUNDING_OF_MOTION = 1e-12  # of the energy of motion, of which a gain is none


def noted_if_free(noted: bool, world: World) -> bool:
    """Return whether the start of a part is noted: also where contacts touch free mechanisms."""
    free = world.constraints.counts[tb.FREE_ISLANDS] > 0
    return bool(noted | (free & (world.joints.counts[tb.MECHANISMS_TOUCHED] > 0)))


def joints_disagree(again: bool, world: World) -> bool:
    """Return whether a part is taken again: also where joints and contacts disagree in it."""
    return bool(again | (world.control.counts[tb.DISAGREE] == 1))


def note_gains(control: Control, islands: Islands, joints: Joints) -> None:
    """Note which mechanisms are in free islands that got energy, and whether joints disagree."""
    for n in range(joints.counts[tb.MECHANISMS]):
        if joints.mechanisms[n, tb.M_STATUS] == tb.IN_CONTACT:
            i = joints.sparse[joints.sparse[n, tb.I_NODE], tb.N_BODY]
            row = islands.energy[islands.links[i, tb.ROOT]]
            if row[tb.SUPPORT] == FREE and row[tb.DAMPED_SHARE] < VIOLENT:
                control.counts[tb.DISAGREE] = 1
                gain = 1.0 if has_gained(row) else 0.0
                joints.numbers[joints.mechanisms[n, tb.M_JOINT], tb.J_GAIN] = gain


def has_gained(row: Array) -> bool:
    """Return whether the motion of an island as one has more energy than may be, J."""
    mass, velocity = row[tb.ISLAND_MASS], (row[tb.REFERENCE], row[tb.REFERENCE + 1])
    of_motion = row[tb.ENERGY_KEPT] + kinetic_energy(mass, velocity, 0.0, 0.0)
    most = row[tb.ENERGY_BOUND] * (1.0 + SLIGHT_GAIN) + ROUNDING_OF_MOTION * of_motion
    return bool(row[tb.ENERGY_LEAST] > most)
