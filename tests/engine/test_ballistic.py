"""Ballistic motion has the bits of ordinary steps, one by one and many at once."""

from collections.abc import Callable
from types import SimpleNamespace

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.simulator import Simulator

LEG = 12
Change = Callable[[Simulator], None]


def crowd(*, linear_drag=(0.0,), force=((0.0, 0.0),), gravity=(0.3, -9.81), others=False):
    """Make 53 bodies, 3 m from each other: three full chunks, and one that is not."""
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
    sim.force[21], sim.torque[24] = (0.5, 0.1), 0.3


def remove(sim: Simulator) -> None:
    sim.force[:], sim.torque[:] = 0.0, 0.0
    sim.remove([4, 50])


def turn_gravity(sim: Simulator) -> None:
    sim.gravity[:] = 0.7, 0.2


def settle(sim: Simulator) -> None:
    sim.add(t2.Disc(radius=0.2), mass=1.0, position=(-4.0, -4.0), restitution=0.5, friction=0.0)


CHANGES: tuple[Change, ...] = (turn_gravity, negative_zeros, push, move, remove, settle, send)


class Counted:
    """A simulator that counts its ballistic steps, or takes none."""

    def __init__(self, scene: t2.Scene, ballistic: bool = True) -> None:
        self.sim, self.ballistic_steps = Simulator(scene), 0
        library = self.sim._engine._entries

        def integrate_ballistic(*given: object) -> int:
            taken: int = library.integrate_ballistic(*given) if ballistic else 0
            self.ballistic_steps += taken
            return taken

        self.sim._engine._library = SimpleNamespace(
            step=library.step,
            integrate_ballistic=integrate_ballistic,
            note_course=library.note_course,
        )

    def state(self) -> bytes:
        state = self.sim._engine.world.state
        return state.pose.tobytes() + state.velocity.tobytes()


@pytest.mark.parametrize("scene", SCENES.values(), ids=SCENES)
def test_one_by_one_many_at_once_and_ordinary_steps_have_the_same_bits(scene: t2.Scene) -> None:
    single, many, kept = Counted(scene), Counted(scene), Counted(scene, ballistic=False)
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
    assert single.ballistic_steps == many.ballistic_steps > 0.5 * taken
    assert kept.ballistic_steps == 0


@pytest.mark.parametrize("row", [3, 40, 52])
@pytest.mark.parametrize("view", ["position", "velocity", "force", "orientation"])
@pytest.mark.parametrize("bad", [np.nan, np.inf])
def test_nan_and_infinity_are_named_and_move_nothing(row: int, view: str, bad: float) -> None:
    one = Counted(SCENES["fall"])
    one.sim.step(10)
    for _ in range(3):
        one.sim.step()
    assert one.ballistic_steps > 0
    held = getattr(one.sim, view)
    good = held[row].copy()
    held[row] = bad
    before = one.state()
    with pytest.raises(t2.InputError, match=rf"{view}\[{row}\]"):
        one.sim.step()
    assert one.state() == before
    held[row] = good
    one.sim.step()
    other = Counted(SCENES["fall"], ballistic=False)
    other.sim.step(14)
    assert one.state() == other.state()


@pytest.mark.parametrize(("row", "view"), [(2, "force"), (3, "force"), (50, "velocity")])
def test_nan_of_bodies_that_are_not_dynamic_is_named_too(row: int, view: str) -> None:
    """A static body, a kinematic one, and the row of one that was removed."""
    one = Counted(SCENES["others"])
    one.sim.remove(50)
    one.sim.step(10)
    getattr(one.sim, view)[row] = np.nan
    before, taken = one.state(), one.ballistic_steps
    assert taken > 0
    with pytest.raises(t2.InputError, match=rf"{view}\[{row}\]"):
        one.sim.step()
    assert (one.state(), one.ballistic_steps) == (before, taken)


def test_an_infinite_spin_is_named_of_a_disc_that_has_turned_far() -> None:
    one = Counted(SCENES["fall"])
    one.sim.orientation[1] = 1e300  # and so far that what is added to the largest number counts
    one.sim.step(10)
    one.sim.angular_velocity[1] = np.inf
    assert one.ballistic_steps > 0
    with pytest.raises(t2.InputError, match=r"angular_velocity\[1\]"):
        one.sim.step()


@pytest.mark.parametrize("row", [2, 53])
def test_a_static_body_with_a_velocity_is_named_in_ballistic_motion(row: int) -> None:
    one = Counted(SCENES["others"])
    one.sim.add_static(t2.Disc(radius=0.5), position=(-5.0, -5.0))  # the last one
    one.sim.step(10)
    one.sim.velocity[row] = 0.0, 1e-9
    before, taken = one.state(), one.ballistic_steps
    assert taken > 0
    with pytest.raises(t2.InputError, match=rf"velocity\[{row}\]"):
        one.sim.step()
    assert (one.state(), one.ballistic_steps) == (before, taken)


@pytest.mark.parametrize("row", [0, 50])
def test_a_body_put_beyond_another_meets_it_on_the_way_back(row: int) -> None:
    """It is within its bounds after the step, and was not before it."""
    one, other = Counted(SCENES["fall"]), Counted(SCENES["fall"], ballistic=False)
    for each in (one, other):
        each.sim.step(10)
        each.sim.position[row, 0] += 4.5
        each.sim.velocity[row, 0] = -4.5 / each.sim.time_step
        each.sim.step()
        assert len(each.sim.contacts) == 1
    assert one.state() == other.state()
    assert one.ballistic_steps > 0


def test_ballistic_motion_continues_after_restoring(tmp_path) -> None:
    one = Counted(SCENES["others"])
    one.sim.step(10)
    one.sim.save(tmp_path / "flight.npz")
    other = Simulator.restore(tmp_path / "flight.npz")
    for _ in range(10):
        one.sim.step()
        other.step()
    assert one.sim.digest() == other.digest()


def test_views_show_the_state_after_each_step() -> None:
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
