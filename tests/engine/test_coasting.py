"""Bodies near nothing coast: one step, many at once, and without it, with the same bits."""

from collections.abc import Callable
from types import SimpleNamespace

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.simulator import Simulator

LEG = 12
Change = Callable[[Simulator], None]


def crowd(*, linear_drag=(0.0,), force=((0.0, 0.0),), gravity=(0.3, -9.81), others=False):
    """Make 53 bodies, 3 m from each other: three full crews, and one that is not."""
    scene = t2.Scene(gravity=gravity)
    for k in range(53):
        place = (3.0 * (k % 9), 3.0 * (k // 9))
        shape = t2.Disc(radius=0.5) if k % 3 else t2.Box(width=1.0, height=0.5)
        if others and k % 20 == 2:
            scene.add_static(shape, position=place)
        elif others and k % 20 == 3:
            scene.add_kinematic(shape, position=place, velocity=(0.1, 0.0), angular_velocity=0.2)
        else:
            scene.add_body(
                shape, mass=1.0 + k % 2, position=place, angular_velocity=0.1 * (k % 4),
                velocity=(0.01 * k, 0.0), linear_drag=linear_drag[k % len(linear_drag)],
                angular_drag=linear_drag[k % len(linear_drag)], force=force[k % len(force)],
                restitution=0.5, friction=0.0,
            )  # fmt: skip
    return scene


SCENES = {
    "fall": crowd(),
    "drag": crowd(linear_drag=(0.7,)),
    "drags": crowd(linear_drag=(0.0, 0.7, 2.0)),
    "loads": crowd(force=((0.1, 0.2), (0.0, 0.0))),
    "one load": crowd(force=(*[(0.0, 0.0)] * 30, (0.3, 0.0), *[(0.0, 0.0)] * 22)),
    "others": crowd(gravity=(0.0, -0.2), others=True),
    "zeros": crowd(gravity=(-0.0, 0.0)),
}


def negative_zeros(sim: Simulator) -> None:
    sim.torque[::2] = sim.force[::3] = -0.0
    sim.angular_velocity[:] = sim.velocity[5:20] = -0.0
    sim.position[0] = -0.0


def send(sim: Simulator) -> None:
    sim.velocity[7], sim.angular_velocity[30] = (40.0, 3.0), 20.0


def move(sim: Simulator) -> None:
    sim.position[12] += (0.9, 0.4)
    sim.orientation[33] += 1.0


def push(sim: Simulator) -> None:
    sim.force[21], sim.torque[22] = (0.5, 0.1), 0.3


def remove(sim: Simulator) -> None:
    sim.force[:], sim.torque[:] = 0.0, 0.0
    sim.remove([4, 50])


def turn_gravity(sim: Simulator) -> None:
    sim.gravity[:] = 0.7, 0.2


def settle(sim: Simulator) -> None:
    sim.add(t2.Disc(radius=0.2), mass=1.0, position=(-4.0, -4.0), restitution=0.5, friction=0.0)


CHANGES: tuple[Change, ...] = (turn_gravity, negative_zeros, push, move, remove, settle, send)


class Watched:
    """A simulator that counts the steps that bodies coast, or lets none be."""

    def __init__(self, scene: t2.Scene, coasts: bool = True) -> None:
        self.sim, self.coasted = Simulator(scene), 0
        engine = self.sim._world._engine

        def coast(*given: object) -> int:
            taken = engine.coast(*given) if coasts else 0
            self.coasted += taken
            return taken

        self.sim._world._engine = SimpleNamespace(
            step=engine.step, coast=coast, know_course=engine.know_course
        )

    def state(self) -> bytes:
        world = self.sim._world
        return world.pose.tobytes() + world.velocity.tobytes()


@pytest.mark.parametrize("scene", SCENES.values(), ids=SCENES)
def test_one_by_one_many_at_once_and_kept_from_it_have_the_same_bits(scene: t2.Scene) -> None:
    single, many, kept = Watched(scene), Watched(scene), Watched(scene, coasts=False)
    taken = 0
    for change in (None, *CHANGES):
        for one in (single, many, kept):
            if change is not None:
                change(one.sim)
        for _ in range(LEG):
            single.sim.step()
            kept.sim.step()
            taken += 1
        many.sim.step(LEG)
        assert single.state() == kept.state(), change
        assert many.state() == kept.state(), change
    assert single.coasted == many.coasted > 0.5 * taken
    assert kept.coasted == 0


@pytest.mark.parametrize("row", [3, 40, 52])
@pytest.mark.parametrize("view", ["position", "velocity", "force", "orientation"])
@pytest.mark.parametrize("bad", [np.nan, np.inf])
def test_what_is_not_a_number_moves_nothing(row: int, view: str, bad: float) -> None:
    one = Watched(SCENES["fall"])
    one.sim.step(10)
    for _ in range(3):
        one.sim.step()
    assert one.coasted > 0
    held = getattr(one.sim, view)
    good = held[row].copy()
    held[row] = bad
    before = one.state()
    with pytest.raises(t2.InputError, match=rf"{view}\[{row}\]"):
        one.sim.step()
    assert one.state() == before
    held[row] = good
    one.sim.step()
    other = Watched(SCENES["fall"], coasts=False)
    other.sim.step(14)
    assert one.state() == other.state()


@pytest.mark.parametrize(("row", "view"), [(2, "force"), (3, "force"), (50, "velocity")])
def test_nor_does_what_is_not_a_number_of_a_body_that_nothing_pushes(row: int, view: str) -> None:
    """A static body, a kinematic one, and the row of one that was removed."""
    one = Watched(SCENES["others"])
    one.sim.remove(50)
    one.sim.step(10)
    getattr(one.sim, view)[row] = np.nan
    before, coasted = one.state(), one.coasted
    assert coasted > 0
    with pytest.raises(t2.InputError, match=rf"{view}\[{row}\]"):
        one.sim.step()
    assert (one.state(), one.coasted) == (before, coasted)


def test_an_infinite_spin_is_told_of_a_disc_that_has_turned_far() -> None:
    one = Watched(SCENES["fall"])
    one.sim.orientation[1] = 1e300  # and so far that what is added to the largest number counts
    one.sim.step(10)
    one.sim.angular_velocity[1] = np.inf
    assert one.coasted > 0
    with pytest.raises(t2.InputError, match=r"angular_velocity\[1\]"):
        one.sim.step()


@pytest.mark.parametrize("row", [2, 53])
def test_a_static_body_that_moves_is_told_while_others_coast(row: int) -> None:
    one = Watched(SCENES["others"])
    one.sim.add_static(t2.Disc(radius=0.5), position=(-5.0, -5.0))  # the last one
    one.sim.step(10)
    one.sim.velocity[row] = 0.0, 1e-9
    before, coasted = one.state(), one.coasted
    assert coasted > 0
    with pytest.raises(t2.InputError, match=rf"velocity\[{row}\]"):
        one.sim.step()
    assert (one.state(), one.coasted) == (before, coasted)


@pytest.mark.parametrize("row", [0, 50])
def test_one_that_is_put_beyond_another_meets_it_on_the_way_back(row: int) -> None:
    """It is at home after the step, and was not before it."""
    one, other = Watched(SCENES["fall"]), Watched(SCENES["fall"], coasts=False)
    for each in (one, other):
        each.sim.step(10)
        each.sim.position[row, 0] += 4.5
        each.sim.velocity[row, 0] = -4.5 / each.sim.time_step
        each.sim.step()
        assert len(each.sim.contacts) == 1
    assert one.state() == other.state()
    assert one.coasted > 0


def test_coasting_goes_on_after_it_is_restored(tmp_path) -> None:
    one = Watched(SCENES["others"])
    one.sim.step(10)
    one.sim.save(tmp_path / "flight.npz")
    other = Simulator.restore(tmp_path / "flight.npz")
    for _ in range(10):
        one.sim.step()
        other.step()
    assert one.sim.digest() == other.digest()


def test_views_are_of_now_after_each_step() -> None:
    sim = Simulator(SCENES["fall"])
    sim.step(5)
    place, velocity = sim.position, sim.velocity
    last = place.copy()
    for _ in range(5):
        sim.step()
        assert (place[:, 1] < last[:, 1]).all()
        way = place[:, 1] - last[:, 1]
        np.testing.assert_allclose(velocity[:, 1] * sim.time_step, way, rtol=0.1)
        assert np.shares_memory(place, sim.position)
        last = place.copy()
