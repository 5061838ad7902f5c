"""Bodies that are named as they are added, and found and told of by their names (R1)."""

from typing import Any

import numpy as np
import pytest

import tamias2d as t2

BALL: dict[str, Any] = {"mass": 1.0, "restitution": 0.0}
DISC = t2.Disc(radius=0.1)


def started() -> t2.Simulator:
    scene = t2.Scene(gravity=(0.0, -10.0))
    floor = t2.HalfPlane(normal=(0.0, 1.0), offset=0.0)
    scene.add_static(floor, restitution=0.0, name="floor")
    scene.add_body(DISC, position=(0.0, 0.1), name="old", **BALL)
    return t2.Simulator(scene)


def test_one_and_many_are_named() -> None:
    sim = started()
    hero = sim.add(DISC, position=(1.0, 0.1), name="hero", **BALL)
    places: Any = [(k, 0.1) for k in range(2, 5)]
    coins = sim.add(DISC, position=places, name=[f"coin {k}" for k in range(3)], **BALL)
    sim.add_static(DISC, position=(9.0, 0.0), name="peg")
    sim.add_kinematic(DISC, position=[(9.0, 5.0)], name=np.array(["lift"]))
    nameless = sim.add(DISC, position=(7.0, 0.1), **BALL)
    assert sim.index("hero") == hero == 2
    assert sim.index("coin 1") == coins[1] == 4
    assert [sim.name(k) for k in (0, hero, coins[2], 6, 7)] == [
        *("floor", "hero", "coin 2", "peg", "lift"),
    ]
    assert sim.name(nameless) is None
    sim.apply_impulse(["hero", "coin 0"], (1.0, 0.0))
    assert sim.velocity[[hero, coins[0]], 0].tolist() == [1.0, 1.0]
    sim.step()
    told = {sim.name(k) for pair in sim.contacts.bodies.tolist() for k in pair}
    assert told == {"floor", "old", "hero", "coin 0", "coin 1", "coin 2", None}


def test_errors_tell_the_names_of_bodies_that_were_added() -> None:
    sim = started()
    hero = sim.add(DISC, position=(1.0, 0.1), name="hero", **BALL)
    sim.velocity[hero, 0] = np.nan
    with pytest.raises(t2.InputError, match=r"velocity\[2\] of body 'hero'"):
        sim.step()
    sim.velocity[hero] = 0.0
    sim.add_joint(t2.Distance(length=1.0), "old", "hero", name="rod")
    with pytest.raises(t2.InputError, match="body 'heroine': the simulator has none such"):
        sim.remove("heroine")
    with pytest.raises(t2.InputError, match="'hero'"):
        sim.add_joint(t2.Revolute(), "hero", "hero")


def test_a_name_is_free_once_its_body_is_removed() -> None:
    sim = started()
    sim.add(DISC, position=[(1.0, 0.1), (2.0, 0.1)], name=["a", "b"], **BALL)
    sim.remove(["a", "old"])
    sim.step()
    again = sim.add(DISC, position=[(3.0, 0.1), (4.0, 0.1)], name=["old", "c"], **BALL)
    assert again.tolist() == [1, 2]  # rows of removed ones
    assert (sim.index("old"), sim.index("c"), sim.name(3)) == (1, 2, "b")
    with pytest.raises(t2.InputError, match="body 'a': the simulator has none such"):
        sim.index("a")


@pytest.mark.parametrize("scene", ["alone", "drawn"])
def test_names_are_saved_and_loads_of_the_scene_stay_with_its_bodies(
    scene: str, tmp_path: Any
) -> None:
    made = t2.Scene(gravity=(0.0, 0.0))
    made.add_body(DISC, position=(0.0, 0.0), name="bob", **BALL)
    if scene == "drawn":
        made.add_spring("bob", (1.0, 0.0), stiffness=9.0, rest_length=0.0)
    sim = t2.Simulator(made)
    sim.add(DISC, position=(5.0, 0.0), name="hero", **BALL)
    if scene == "alone":
        sim.remove("bob")
    sim.step(5)
    sim.save(tmp_path / "named.npz")
    other = t2.Simulator.restore(tmp_path / "named.npz")
    assert (other.index("hero"), other.name(1)) == (1, "hero")
    with pytest.raises(t2.InputError, match="another body has it"):
        other.add(DISC, position=(9.0, 0.0), name="hero", **BALL)
    for one in (sim, other):
        one.add(DISC, position=(9.0, 0.0), name="late", **BALL)
        one.step(5)
    assert sim.digest() == other.digest()
    assert (other.velocity[0, 0] > 0.1) == (scene == "drawn")


WRONG: list[tuple[Any, Any, str]] = [
    ("old", (1.0, 1.0), "name 'old': another body has it"),
    (["a", "a"], [(1.0, 1.0), (2.0, 1.0)], "name 'a': another body has it"),
    ("a", [(1.0, 1.0), (2.0, 1.0)], "name of the bodies added: found 1 for 2 bodies"),
    (["a", "b"], (1.0, 1.0), "name of the bodies added: found 2 for 1 body"),
    (7, (1.0, 1.0), "name of the bodies added: found 7"),
    ([7], (1.0, 1.0), "name: found 7: must be text"),
    (" ", (1.0, 1.0), "must have 1 to 100 characters"),
    ("a\n", (1.0, 1.0), "must be text of printable characters"),
]


@pytest.mark.parametrize(("name", "position", "says"), WRONG, ids=str)
def test_a_name_that_cannot_be_given_is_refused_and_nothing_is_added(
    name: Any, position: Any, says: str
) -> None:
    sim = started()
    with pytest.raises(t2.InputError, match=says):
        sim.add(DISC, position=position, name=name, **BALL)
    with pytest.raises(t2.SceneError, match="not stated"):
        sim.add(DISC, mass=1.0, position=[(1.0, 1.0), (2.0, 1.0)], name=["x", "y"])
    assert len(sim) == 2
    sim.add(DISC, position=(1.0, 1.0), name="x", **BALL)
