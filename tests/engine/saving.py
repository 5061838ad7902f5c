"""Simulators that are saved and restored."""

from pathlib import Path

from tamias2d.simulator import Simulator


def goes_on_alike(sim: Simulator, folder: Path, steps: int) -> bool:
    """Save a simulator, let it and the restored one take some steps; whether they end alike."""
    sim.save(folder / "state.npz")
    twin = Simulator.restore(folder / "state.npz")
    sim.step(steps)
    twin.step(steps)
    return sim.digest() == twin.digest()
