"""Which energies are summed and looked at where there are mechanisms."""

from tamias2d.engine import tables as tb
from tamias2d.engine.energy.step_energy import UNLIMITED
from tamias2d.engine.tables import World


def past_untouched(first: int, last: int, world: World) -> int:
    """Return from which of some active bodies on energies are summed: none where nothing touches.

    Mechanisms have bounded their own then.
    """
    alone = world.touching.counts[tb.TOUCHING] + world.springs.counts[tb.NETWORKS_TOUCHED] == 0
    if not alone or world.joints.counts[tb.MECHANISMS_TOUCHED] > 0:
        return first
    for k in range(first, last):
        flight = world.bodies.flight[world.touching.active_by_slab[k]]
        flight[tb.FORCE_GAIN] = flight[tb.FORCE_GAIN + 1] = flight[tb.FORCE_GAIN + 2] = 0.0
    return last


def look_at_touched(world: World) -> None:
    """Let the energy of each island be looked at if contacts touch mechanisms, not their sum."""
    energy = world.constraints.energy
    if (
        world.joints.counts[tb.MECHANISMS_AWAKE] > 0
        and world.joints.counts[tb.MECHANISMS_TOUCHED] > 0
    ):
        energy[tb.TOTAL_ENERGY_NOW] = 2.0 * UNLIMITED
