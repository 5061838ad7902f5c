"""Surfaces that run along themselves: belts, and rollers that stand (DD97)."""

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.scene.reading import read_scene
from tamias2d.scene.writing import scene_text

SPEED, GRAVITY, FRICTION = 2.0, 10.0, 0.5
ROUGH: Any = {"friction": FRICTION, "restitution": 0.0}
GROUNDS: Any = {
    "half-plane": (t2.HalfPlane(normal=(0.0, 1.0), offset=0.0), {}),
    "box": (t2.Box(width=40.0, height=2.0), {"position": (0.0, -1.0)}),
    "chain": (t2.Chain(vertices=[(20.0, 0.0), (-20.0, 0.0)], one_sided=True), {}),
}


def belt(ground: str, surface: Any = ROUGH, *, sleeping: bool = False) -> t2.Simulator:
    """A ground whose surface goes to the right."""
    sim = t2.Simulator(t2.Scene(gravity=(0.0, -GRAVITY)), sleeping=sleeping)
    shape, place = GROUNDS[ground]
    sim.add_static(shape, surface_speed=-SPEED, **place, **surface)
    return sim


@pytest.mark.parametrize("ground", GROUNDS)
def test_a_box_gains_speed_by_friction_until_it_goes_with_its_belt(ground: str) -> None:
    sim = belt(ground)
    box = sim.add(t2.Box(width=0.8, height=0.4), mass=3.0, position=(0.0, 0.2), **ROUGH)
    sim.step(12)
    assert sim.velocity[box, 0] == pytest.approx(FRICTION * GRAVITY * sim.time, rel=0.01)
    sim.step(60)
    assert sim.velocity[box] == pytest.approx((SPEED, 0.0), abs=1e-6)


@pytest.mark.parametrize("ground", GROUNDS)
@pytest.mark.parametrize("height", [0.3, 2.0])
def test_a_disc_rolls_on_a_belt_at_a_third_of_its_speed(ground: str, height: float) -> None:
    """Put on it, or met in flight; friction gives its rim what turns it (Hibbeler)."""
    surface: Any = {"friction": FRICTION, "restitution": 0.8 if height > 1.0 else 0.0}
    sim = belt(ground, surface)
    disc = sim.add(t2.Disc(radius=0.3), mass=2.0, position=(0.0, height), **surface)
    sim.step(60)
    assert sim.velocity[disc, 0] == pytest.approx(SPEED / 3.0, rel=1e-3)
    assert sim.angular_velocity[disc] * 0.3 == pytest.approx(2.0 * SPEED / 3.0, rel=1e-3)


def test_a_surface_runs_around_its_body_counter_clockwise() -> None:
    """Without gravity: discs that are thrown on all four sides of a square."""
    sim = t2.Simulator(t2.Scene(gravity=(0.0, 0.0)))
    sim.add_static(t2.Box(width=2.0, height=2.0), surface_speed=SPEED, **ROUGH)
    out = np.array([(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0)])
    discs = sim.add(t2.Disc(radius=0.2), mass=1.0, position=1.5 * out, velocity=-8.0 * out, **ROUGH)
    sim.step(5)
    around = np.column_stack((-out[:, 1], out[:, 0]))
    assert (sim.velocity[discs] * around).sum(axis=1) == pytest.approx(SPEED / 3.0, rel=1e-6)


@pytest.mark.parametrize("way", ["steps", "simulate"])
@pytest.mark.parametrize("above", [True, False])
@pytest.mark.parametrize("rightwards", [True, False])
def test_a_chain_runs_from_its_first_vertex_to_its_last_on_both_sides(
    way: str, above: bool, rightwards: bool
) -> None:
    """So carries what lies on it, and what bounces on it."""
    up = 1.0 if above else -1.0
    scene = t2.Scene(gravity=(0.0, -GRAVITY * up))
    ends = [(-20.0, 0.0), (20.0, 0.0)]
    chain = t2.Chain(vertices=ends if rightwards else ends[::-1])
    surface: Any = {"friction": FRICTION, "restitution": 0.5}
    scene.add_static(chain, surface_speed=SPEED, **surface)
    scene.add_body(t2.Box(width=0.8, height=0.4), mass=3.0, position=(0.0, 0.2 * up), **ROUGH)
    scene.add_body(t2.Disc(radius=0.3), mass=2.0, position=(5.0, 2.0 * up), **surface)
    if way == "steps":
        sim = t2.Simulator(scene)
        sim.step(60)
        going = sim.velocity[1:, 0]
    else:
        going = t2.simulate(scene, duration=1.0).velocity[-1, 1:, 0]
    along = SPEED if rightwards else -SPEED
    assert going == pytest.approx([along, along / 3.0], rel=1e-3)


@pytest.mark.parametrize("turned", [0.0, 0.4])
@pytest.mark.parametrize("counter_clockwise", [True, False])
def test_a_loop_carries_what_is_in_it_the_same_way_as_what_is_around_it(
    counter_clockwise: bool, turned: float
) -> None:
    """Discs that are thrown at all four sides of a square, from within and from outside."""
    sim = t2.Simulator(t2.Scene(gravity=(0.0, 0.0)))
    corners = [(-3.0, -3.0), (3.0, -3.0), (3.0, 3.0), (-3.0, 3.0)]
    loop = t2.Chain(vertices=corners if counter_clockwise else corners[::-1], loop=True)
    sim.add_kinematic(loop, position=(0.0, 0.0), orientation=turned, surface_speed=SPEED, **ROUGH)
    turn = np.array([(math.cos(turned), math.sin(turned)), (-math.sin(turned), math.cos(turned))])
    out = np.array([(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0)]) @ turn
    for start, heading in ((2.5, 1.0), (3.5, -1.0)):
        place, velocity = start * out, 8.0 * heading * out
        discs = sim.add(t2.Disc(radius=0.2), mass=1.0, position=place, velocity=velocity, **ROUGH)
    sim.step(5)
    around = np.column_stack((-out[:, 1], out[:, 0])) * (1.0 if counter_clockwise else -1.0)
    for group in (discs - 4, discs):
        along = (sim.velocity[group] * around).sum(axis=1)
        assert along == pytest.approx(SPEED / 3.0, rel=1e-6)


@pytest.mark.parametrize("restitution", [0.0, 0.5])
def test_a_roller_that_stands_carries_as_one_that_turns(restitution: float) -> None:
    """A plank over two rollers goes as over two wheels that turn as fast."""
    surface: Any = {"friction": FRICTION, "restitution": restitution}

    def plank_over(how: Any) -> t2.Simulator:
        sim = t2.Simulator(t2.Scene(gravity=(0.0, -GRAVITY)))
        for x in (-1.0, 1.0):
            sim.add_kinematic(t2.Disc(radius=0.5), position=(x, 0.0), **how, **surface)
        sim.add(t2.Box(width=4.0, height=0.2), mass=5.0, position=(0.0, 0.7), **surface)
        sim.step(40)
        return sim

    one, other = plank_over({"surface_speed": -1.0}), plank_over({"angular_velocity": -2.0})
    yields = 1e-4  # of the radius: where contacts yield, a wheel goes slower than at its rim
    assert one.velocity[2] == pytest.approx(other.velocity[2], abs=yields)
    assert one.position[2] == pytest.approx(other.position[2], abs=yields)
    assert one.velocity[2, 0] == pytest.approx(1.0, abs=1e-2)


def test_what_a_belt_presses_on_a_wall_stays_and_heaps_gain_no_speed_from_it() -> None:
    """A belt under forty boxes between walls: nothing goes faster than it, or leaves."""
    sim = belt("box")
    for x in (-4.0, 4.0):
        sim.add_static(t2.Box(width=1.0, height=20.0), position=(x, 10.0), **ROUGH)
    place = [(-3.0 + 0.75 * (k % 8), 0.3 + 0.6 * (k // 8)) for k in range(40)]
    boxes = sim.add(t2.Box(width=0.5, height=0.5), mass=1.0, position=place, **ROUGH)
    sim.step(300)
    fastest = 0.0
    for _ in range(120):
        sim.step()
        fastest = max(fastest, np.hypot(*sim.velocity[boxes].T).max())
    assert fastest < SPEED
    assert (np.abs(sim.position[boxes, 0]) < 3.5).all()
    assert sim.position[boxes, 1].max() < 4.0


def test_a_speed_is_changed_saved_and_told(tmp_path: Path) -> None:
    sim = belt("box", sleeping=True)
    box = sim.add(t2.Box(width=0.8, height=0.4), mass=3.0, position=(0.0, 0.2), **ROUGH)
    sim.set_surface(0, surface_speed=0.0)
    sim.step(120)
    assert sim.asleep[box]
    sim.set_surface(0, surface_speed=1.0)
    sim.step(60)
    assert sim.velocity[box, 0] == pytest.approx(-1.0, abs=1e-6)
    assert sim.body(0).surface_speed == 1.0
    sim.save(tmp_path / "belt.npz")
    other = t2.Simulator.restore(tmp_path / "belt.npz")
    for one in (sim, other):
        one.set_shape(0, t2.Box(width=30.0, height=2.0))
        one.step(10)
    assert other.digest() == sim.digest()
    assert other.body(0).surface_speed == 1.0


def test_scenes_say_it_and_their_impacts_are_stepped() -> None:
    scene = t2.Scene(gravity=(0.0, -GRAVITY))
    scene.add_static(GROUNDS["half-plane"][0], surface_speed=-SPEED, name="belt", **ROUGH)
    scene.add_body(t2.Box(width=0.8, height=0.4), mass=3.0, position=(0.0, 0.2), **ROUGH)
    text = scene_text(scene)
    assert "surface_speed: -2.0 m/s" in text
    assert scene_text(read_scene(text, file="belt.yaml")) == text
    assert "surfaces that run (DD97)" in str(t2.needs(scene, duration=1.0))
    run = t2.simulate(scene, duration=1.0)
    assert "'belt': its surface runs" in run.notes[0]
    assert run.velocity[-1, 1] == pytest.approx((SPEED, 0.0), abs=1e-6)


def test_what_moves_freely_has_no_such_surface() -> None:
    sim = belt("box")
    box = sim.add(t2.Box(width=0.8, height=0.4), mass=3.0, position=(0.0, 0.2), **ROUGH)
    with pytest.raises(t2.InputError, match=r"only static and kinematic .* \(DD97\)"):
        sim.set_surface(box, surface_speed=1.0)
    with pytest.raises(t2.InputError, match=r"surface speed\[0\] .* must be finite \(R4\)"):
        sim.set_surface(0, surface_speed=np.nan)
