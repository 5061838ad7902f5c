"""Trees of hinges that are solved side by side move as they do by themselves, to the bit (IM15)."""

import random
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.engine.joints import equal_trees
from tamias2d.engine.tables import M_IN_BLOCK, TREE_BLOCKS
from tamias2d.scene import Revolute, Scene
from tamias2d.simulator import Simulator
from tests.engine.scenes import ground

G = 10.0
SHAPE = t2.Capsule(length=0.8, radius=0.1)


def hung_chain(scene: Scene, x: float, links: int, spin: float, upper: int | None = None) -> None:
    """Add links that lie level, hung at the left end from a place, or from a body."""
    for k in range(links):
        own = scene.add_body(
            SHAPE,
            mass=1.0 + 0.1 * k,
            position=(x + 0.5 + k, 5.0),
            velocity=(0.0, (0.5 + k) * spin),
            angular_velocity=spin,
            restitution=0.0,
        )
        above = own - 1 if k else (x, 5.0) if upper is None else upper
        anchor = (0.5, 0.0) if k else (0.0, 0.0)
        scene.add_joint(Revolute(), above, own, anchor=anchor, other_anchor=(-0.5, 0.0))


def star(scene: Scene, x: float, y: float, spin: float) -> None:
    """Add four arms on a hub that nothing holds."""
    hub = scene.add_body(
        t2.Disc(radius=0.2), mass=2.0, position=(x, y), angular_velocity=spin, restitution=0.0
    )
    for k in range(4):
        turn = k * np.pi / 2
        out = np.array([np.cos(turn), np.sin(turn)])
        arm = scene.add_body(
            SHAPE,
            mass=1.0,
            position=tuple(np.array([x, y]) + 0.7 * out),
            orientation=turn,
            velocity=(-0.7 * spin * out[1], 0.7 * spin * out[0]),
            angular_velocity=spin,
            restitution=0.0,
        )
        anchor = tuple(0.2 * out)
        scene.add_joint(Revolute(), hub, arm, anchor=anchor, other_anchor=(-0.5, 0.0))


def many_trees(fastest: float) -> Scene:
    """Chains that swing slowly or fast, two longer ones, and stars that fall to the ground."""
    scene, rng = Scene(gravity=(0.0, -G)), random.Random(3)
    ground(scene, 0.5)
    peg = scene.add_static(t2.Disc(radius=0.01), position=(0.0, 5.0))
    for n in range(18):
        hung_chain(scene, 8.0 * n, 3, fastest * rng.random() ** 2, None if n else peg)
    for n in range(2):
        hung_chain(scene, 8.0 * (18 + n), 5, 1.0)
    for n in range(9):
        star(scene, 3.0 * n - 30.0, rng.uniform(0.95, 3.0), fastest * rng.random() ** 2 * (n > 2))
    return scene


def course(scene: Scene, steps: int, **options: Any) -> tuple[Any, Simulator]:
    sim = Simulator(scene, **options)
    found = []
    for _ in range(steps):
        sim.step()
        told = sim.reactions
        now = (sim.position, sim.orientation, sim.velocity, sim.angular_velocity)
        found.append(np.concatenate([x.ravel() for x in (*now, told.force, told.separation)]))
    return np.array(found), sim


@pytest.mark.filterwarnings("ignore::tamias2d.errors.StepWarning")
@pytest.mark.parametrize(
    ("fastest", "compiled", "steps"),
    [(30.0, False, 4), (1.0, True, 240), (300.0, True, 240), (30000.0, True, 20)],
)
def test_side_by_side_they_have_the_same_bits(
    fastest: float, compiled: bool, steps: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    options: Any = {"compiled": compiled, "sleeping": True}
    together, sim = course(many_trees(fastest), steps, **options)
    joints = sim._engine.world.joints
    assert joints.counts[TREE_BLOCKS] == 2
    assert joints.mechanisms[:, M_IN_BLOCK].sum() == 16 + 9
    monkeypatch.setattr(equal_trees, "FEWEST_TREES", 100)
    alone, sim = course(many_trees(fastest), steps, **options)
    assert sim._engine.world.joints.counts[TREE_BLOCKS] == 0
    assert together.tobytes() == alone.tobytes()


def blocks(scene: Scene) -> int:
    sim = Simulator(scene, compiled=False)
    sim.step()
    return int(sim._engine.world.joints.counts[TREE_BLOCKS])


@pytest.mark.parametrize(("count", "found"), [(7, 0), (8, 1), (16, 1), (23, 1), (24, 2)])
def test_eight_equal_trees_are_a_block_and_sixteen_fill_it(count: int, found: int) -> None:
    scene = Scene(gravity=(0.0, -G))
    for n in range(count):
        hung_chain(scene, 5.0 * n, 2, 0.0)
    assert blocks(scene) == found


def test_trees_on_the_plane_and_on_a_static_body_are_equal() -> None:
    scene = Scene(gravity=(0.0, -G))
    for n in range(7):
        hung_chain(scene, 5.0 * n, 2, 0.0)
    assert blocks(scene) == 0
    hung_chain(scene, 50.0, 2, 0.0, scene.add_static(t2.Disc(radius=0.01), position=(50.0, 5.0)))
    assert blocks(scene) == 1


def test_a_tree_that_comes_to_eight_or_goes_again_moves_on() -> None:
    rng, scene = random.Random(1), Scene(gravity=(0.0, -G))
    for n in range(8):
        hung_chain(scene, 5.0 * n, 2, rng.uniform(-2.0, 2.0))
    sim = Simulator(scene, compiled=False)
    sim.step(3)
    sim.remove_joint(sim.joints[-1])
    sim.step(3)
    assert sim._engine.world.joints.counts[TREE_BLOCKS] == 0
    assert sim.reactions.separation.max() < 1e-3


def test_saved_and_restored_they_go_on_alike(tmp_path: Path) -> None:
    sim = Simulator(many_trees(30.0))
    sim.step(20)
    sim.remove_joint(sim.joints[4])  # of the second chain
    sim.step(20)
    sim.save(tmp_path / "trees.npz")
    twin = Simulator.restore(tmp_path / "trees.npz")
    sim.step(40)
    twin.step(40)
    assert sim.digest() == twin.digest()
    assert sim._engine.world.joints.counts[TREE_BLOCKS] == 2
