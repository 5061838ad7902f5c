"""Fields and attraction that are for all bodies that move act on those that are added, too."""

from pathlib import Path

import numpy as np
import pytest

import tamias2d as t2

DISC = t2.Disc(radius=0.1)
SURFACE = {"friction": 0.3, "restitution": 0.0}


def windy() -> t2.Scene:
    """A scene with fields of all kinds, and attraction, for all; and a field for one body."""
    scene = t2.Scene(gravity=(0.0, 0.0))
    for x in (0.0, 3.0):
        scene.add_body(DISC, mass=1.7, position=(x, 0.0), force=(0.1, 0.0), **SURFACE)
    scene.add_field(force=("1[N]", "2[m/s^2]*mass"), torque="1e-3[N*m]")
    scene.add_field(force=("-1[kg/s]*y(velocity)", "-0.3[N/m]*y(position)"))
    scene.add_field(force=("5[N]", "-1[N/m]*x(position)"), bodies=[1])
    scene.add_attraction(gravitational_constant=1.0)
    return scene


def test_a_body_that_is_added_feels_what_one_of_the_scene_does() -> None:
    """To the bit: stated in the scene, or added before the first step."""
    late = {"mass": 1.5, "position": (0.0, 9.0), "velocity": (1.0, 0.0), "force": (0.2, 0.3)}
    whole = windy()
    whole.add_body(DISC, **late, **SURFACE)
    one, other = t2.Simulator(whole), t2.Simulator(windy())
    row = other.add(DISC, **late, **SURFACE)
    np.testing.assert_array_equal(one.force, other.force)
    for _ in range(60):
        one.step()
        other.step()
    assert one.digest() == other.digest()
    assert np.abs(other.velocity[row]).min() > 0.1


def test_attraction_of_one_body_of_the_scene_pulls_one_that_is_added() -> None:
    """1000 kg at 10 m pull with 10 m/s^2 (IM5)."""
    scene = t2.Scene(gravity=(0.0, 0.0))
    scene.add_body(DISC, mass=1000.0, position=(0.0, 0.0), restitution=0.0)
    scene.add_attraction(gravitational_constant=1.0)
    sim = t2.Simulator(scene)
    row = sim.add(DISC, mass=1.0, position=(0.0, 10.0), restitution=0.0)
    sim.step(6)
    assert sim.velocity[row, 1] == pytest.approx(-1.0, rel=0.01)


def test_a_field_that_names_bodies_acts_on_no_other_one_even_in_a_row_of_theirs() -> None:
    scene = t2.Scene(gravity=(0.0, 0.0))
    scene.add_body(DISC, mass=1.0, position=(0.0, 0.0), restitution=0.0)
    scene.add_field(force=("1[N]", "-1[N/m]*y(position)"), bodies=[0])
    scene.add_field(force=("0", "-1[kg/s]*y(velocity)"))
    sim = t2.Simulator(scene)
    sim.step()
    sim.remove(0)
    sim.step()
    assert sim.add(DISC, mass=1.0, position=(0.0, 5.0), restitution=0.0) == 0
    sim.step(10)
    np.testing.assert_array_equal(sim.velocity[0], (0.0, 0.0))


def test_what_was_added_goes_on_with_the_same_bits_when_restored(tmp_path: Path) -> None:
    sim = t2.Simulator(windy())
    sim.add([DISC, DISC], mass=[1.0, 0.3], position=[(5.0, 5.0), (-5.0, 5.0)], **SURFACE)
    sim.step(20)
    sim.remove(0)
    sim.step(20)
    sim.add(DISC, mass=0.7, position=(1.0, -4.0), **SURFACE)
    sim.step(3)
    sim.save(tmp_path / "sim.npz")
    other = t2.Simulator.restore(tmp_path / "sim.npz")
    for _ in range(30):
        sim.step()
        other.step()
    assert other.digest() == sim.digest()


def test_a_field_without_a_value_where_a_body_is_added_refuses_it() -> None:
    scene = t2.Scene(gravity=(0.0, 0.0))
    scene.add_field(force=("1[N*m]/x(position)", "0"))
    sim = t2.Simulator(scene)
    with pytest.raises(t2.InputError, match=r"force\[0\] of field 0.*no finite value.*0\.0 m"):
        sim.add(DISC, mass=1.0, position=[(1.0, 0.0), (0.0, 0.0)], restitution=0.0)
    assert len(sim) == 0


def test_a_law_that_is_too_fast_for_the_step_names_the_body_that_was_added() -> None:
    scene = t2.Scene(gravity=(0.0, 0.0))
    scene.add_field(force=("-20000[N/m]*x(position)", "0"))
    sim = t2.Simulator(scene)
    sim.add(DISC, mass=1.0, position=(0.1, 0.0), restitution=0.0)
    with pytest.warns(t2.StepWarning, match="motion of body 0 gains energy"):
        sim.step(2)


@pytest.mark.parametrize("steps", range(3, 11))
def test_a_law_of_the_velocity_goes_on_with_the_same_bits_when_restored(
    steps: int, tmp_path: Path
) -> None:
    """It is found in rounds, together with the velocity, and known for the last but one."""
    scene = t2.Scene(gravity=(0.0, 0.0))
    scene.add_body(DISC, mass=1.3, position=(1.0, 2.0), velocity=(1.0, 0.3), **SURFACE)
    turning = "5[kg/s]*y(velocity) - 0.3[N/m]*x(position)"
    slowing = "-5[kg/s]*x(velocity) - 0.1[kg/m]*y(velocity)*norm(velocity)"
    scene.add_field(force=(turning, slowing))
    sim = t2.Simulator(scene)
    sim.step(steps)
    sim.save(tmp_path / "sim.npz")
    other = t2.Simulator.restore(tmp_path / "sim.npz")
    sim.step(20)
    other.step(20)
    assert other.digest() == sim.digest()
