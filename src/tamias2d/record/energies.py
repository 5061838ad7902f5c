"""The lines of a run's energy over time, for who draws them."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tamias2d.balance import kinetic_energy

if TYPE_CHECKING:
    from tamias2d.run_data import RunData
    from tamias2d.state import Array


def energies(run: RunData) -> dict[str, Array]:
    """Return energies (k,), J, by their names.

    Where nothing that is counted has a potential, as fields and laws of forces have none, the
    kinetic energy is all that is known: it would be wrong to call it the energy.
    """
    kinetic = kinetic_energy(run.scene, run.velocity, run.angular_velocity)
    potential = run.energy - kinetic
    if not potential.any():
        return {"kinetic energy": kinetic}
    return {"energy": run.energy, "kinetic": kinetic, "potential": potential}
