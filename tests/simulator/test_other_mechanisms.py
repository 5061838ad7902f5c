"""Where joints come and go, mechanisms that have none of them go on with the same bits."""

from collections.abc import Callable

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.scene import Distance, Revolute
from tamias2d.simulator import Simulator
from tamias2d.state import Array

LINKS = 4


def chains() -> Simulator:
    """Two chains of four links, far from each other, and two boxes beside them."""
    random = np.random.default_rng(0)
    scene = t2.Scene(gravity=(0.0, -9.81))
    for chain in range(2):
        above: int | tuple[float, float] = (50.0 * chain, 6.0)
        for k in range(LINKS):
            link = scene.add_body(
                t2.Box(width=0.9, height=0.1), mass=float(random.uniform(0.5, 2.0)),
                position=(50.0 * chain + 0.5 + k, 6.0), restitution=0.5, friction=0.3,
            )  # fmt: skip
            hinge = f"hinge {chain} {k}"
            scene.add_joint(Revolute(), above, link, at=(50.0 * chain + k, 6.0), name=hinge)
            above = link
    for x in (100.0, 103.0):
        scene.add_body(
            t2.Box(width=1.0, height=1.0), mass=1.0, position=(x, 9.0), restitution=0.5,
            friction=0.3,
        )  # fmt: skip
    return Simulator(scene)


def replaced(sim: Simulator) -> None:
    """Take a joint out, and put another one there under its name."""
    sim.remove_joint("hinge 0 3")
    sim.add_joint(Distance(), 2, 3, name="hinge 0 3")


CHANGES: dict[str, Callable[[Simulator], object]] = {
    "bodies that go": lambda sim: sim.remove([1, 2]),
    "a joint that goes": lambda sim: sim.remove_joint("hinge 0 2"),
    "a joint that comes": lambda sim: sim.add_joint(Distance(), 8, 9),
    "a joint in place of another": replaced,
    "a body that comes": lambda sim: sim.add(
        t2.Disc(radius=0.1), mass=1.0, position=(-50.0, 50.0), restitution=0.5, friction=0.3
    ),
    "a body that is larger": lambda sim: sim.set_shape(0, t2.Box(width=0.95, height=0.12)),
}


def motion(sim: Simulator) -> Array:
    """Return how the second chain moves."""
    other = slice(LINKS, 2 * LINKS)
    found: Array = np.column_stack((sim.position, sim.velocity, sim.angular_velocity))[other]
    return found


@pytest.mark.parametrize("change", CHANGES)
def test_a_chain_far_away_goes_on_with_the_same_bits(change: str) -> None:
    there, here = chains(), chains()
    for sim in (there, here):
        sim.step(60)
    CHANGES[change](here)
    assert np.array_equal(motion(here), motion(there))
    for _ in range(30):
        there.step()
        here.step()
        assert np.array_equal(motion(here), motion(there))


def test_what_joints_exerted_is_told_after_another_one_came() -> None:
    sim = chains()
    sim.step(60)
    before = sim.reactions.force[: 2 * LINKS]
    assert before.any()
    sim.add_joint(Distance(), 8, 9)
    assert np.array_equal(sim.reactions.force[: 2 * LINKS], before)
    assert not sim.reactions.force[2 * LINKS :].any()


def test_a_joint_that_came_under_the_name_of_another_has_exerted_nothing() -> None:
    sim = chains()
    sim.step(60)
    replaced(sim)
    assert not sim.reactions.force[-1].any()
