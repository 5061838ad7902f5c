"""Rows of joints that a step leaves to the next stand only where nobody has moved what they hold.

A simulator that is restored has no rows: it finds all of them anew, and has to get the same bits.
"""

from pathlib import Path

import numpy as np
import pytest

from tamias2d.scene import Box, Distance, Revolute, Scene
from tamias2d.simulator import Simulator

_ROD = Box(width=1.0, height=0.1)


def _pendulums(count: int, hinge: bool) -> Scene:
    """Return double pendulums side by side: eight or more trees of hinges share a block."""
    scene = Scene(gravity=(0.0, -10.0))
    for n in range(count):
        x = 5.0 * n
        for k in range(2):
            body = scene.add_body(_ROD, mass=1.0 + n, position=(x + 0.5 + k, 0.0), restitution=0.0)
            above, at = ((x, 0.0), (0.0, 0.0)) if k == 0 else (body - 1, (0.5, 0.0))
            scene.add_joint(Revolute(), above, body, anchor=at, other_anchor=(-0.5, 0.0))
        if not hinge:
            scene.add_joint(Distance(), body, (x + 4.0, 1.0))
    return scene


def _numbers(sim: Simulator) -> bytes:
    state = np.column_stack((sim.position, sim.orientation, sim.velocity, sim.angular_velocity))
    return state.tobytes()


@pytest.mark.parametrize("count", [1, 8])
@pytest.mark.parametrize("hinge", [True, False])
@pytest.mark.parametrize("moved", ["nothing", "by a hair", "turned", "elsewhere"])
def test_steps_after_a_change_are_those_of_new_rows(
    count: int, hinge: bool, moved: str, tmp_path: Path
) -> None:
    """What users move between steps is solved by the rows of where it is."""
    sim = Simulator(_pendulums(count, hinge), compiled=False)
    sim.step(3)
    if moved == "by a hair":
        sim.position[1] += 1e-9
    elif moved == "turned":
        sim.orientation[0] += 1e-6
    elif moved == "elsewhere":
        sim.position[:2] += (0.25, 0.0)
    sim.save(tmp_path / "state.npz")
    anew = Simulator.restore(tmp_path / "state.npz", compiled=False)
    for _ in range(2):
        sim.step()
        anew.step()
        assert _numbers(sim) == _numbers(anew)
