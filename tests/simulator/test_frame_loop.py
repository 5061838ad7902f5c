"""Views are the state; forces and impulses do what mechanics says; bad values are named."""

import copy
import pickle
from typing import Any

import numpy as np
import pytest

import tamias2d as t2

ULPS = 1e-13  # relative: a handful of roundings


def flight(gravity: tuple[float, float] = (0.0, -9.81), **more: Any) -> t2.Simulator:
    """Two discs and a box that never meet."""
    scene = t2.Scene(gravity=gravity)
    for k in range(3):
        shape = t2.Box(width=2.0, height=1.0) if k == 2 else t2.Disc(radius=0.5)
        scene.add_body(
            shape, mass=k + 1.0, position=(10.0 * k, 0.0), restitution=0, name=f"body {k}", **more
        )
    return t2.Simulator(scene, time_step=0.01)


def test_what_is_written_counts_and_reading_copies_nothing() -> None:
    sim = flight(gravity=(0.0, 0.0))
    place, velocity = sim.position, sim.velocity
    assert np.shares_memory(place, sim.position)
    velocity[:] = (1.0, 0.0)
    sim.velocity[1] = 3.0, 4.0
    sim.angular_velocity += 2.0
    sim.step(100)
    np.testing.assert_allclose(place, [[1, 0], [13, 4], [21, 0]], rtol=ULPS)
    np.testing.assert_allclose(sim.orientation, 2.0, rtol=ULPS)
    sim.position = np.array([[0, 0], [5, 0], [9, 0]])
    assert place.tolist() == [[0, 0], [5, 0], [9, 0]]
    assert sim.time == pytest.approx(1.0, rel=ULPS)


def test_reading_positions_takes_nothing_until_bodies_are_added() -> None:
    sim = flight(gravity=(0.0, 0.0))
    place = sim.position
    sim.step()
    sim.remove(1)
    sim.step()
    assert sim.position is place  # a step of few bodies takes little longer than making a view
    for count in (1, 1, 100):
        row = np.atleast_1d(sim.add(None, mass=1.0, position=np.full((count, 2), 5.0)))
        np.testing.assert_array_equal(sim.position[row], 5.0)
        sim.position[row] = 7.0, 8.0
        sim.velocity[row] = 100.0, 0.0
        sim.step()
        np.testing.assert_allclose(sim.position[row], [[8.0, 8.0]] * count, rtol=ULPS)
    for other in (pickle.loads(pickle.dumps(sim)), copy.deepcopy(sim)):
        assert not np.shares_memory(other.position, sim.position)
        other.step()
        np.testing.assert_allclose(other.position[row], [[9.0, 8.0]] * 100, rtol=ULPS)


def test_a_force_lasts_until_it_is_changed_and_an_applied_one_for_a_step() -> None:
    sim = flight(gravity=(0.0, 0.0))
    sim.force[0] = 1.0, 0.0
    sim.torque[2] = 1.0
    sim.apply_force([1, 1], (0.0, 2.0))  # twice the same body: the sum acts
    sim.apply_force("body 2", (0.0, 3.0), at=(21.0, 0.0))
    sim.step()
    inertia = 3.0 * (2.0**2 + 1.0**2) / 12
    np.testing.assert_allclose(sim.velocity, [[0.01, 0], [0, 0.02], [0, 0.01]], rtol=ULPS)
    assert sim.angular_velocity[2] == pytest.approx(0.01 * (1.0 + 3.0) / inertia, rel=ULPS)
    assert sim.force.tolist() == [[1, 0], [0, 0], [0, 0]]
    sim.step(9)
    assert sim.velocity[0, 0] == pytest.approx(0.1, rel=ULPS)
    assert sim.velocity[1, 1] == pytest.approx(0.02, rel=ULPS)


def test_impulses_change_momentum_at_once() -> None:
    sim = flight()
    sim.apply_impulse([0, 2], [(2.0, 0.0), (0.0, 3.0)], at=[(0.0, 0.5), (21.0, 0.0)])
    assert sim.velocity.tolist() == [[2, 0], [0, 0], [0, 1]]
    assert sim.angular_velocity[0] == pytest.approx(-1.0 / (1.0 * 0.5**2 / 2), rel=ULPS)
    assert sim.angular_velocity[2] == pytest.approx(3.0 / (3.0 * 5 / 12), rel=ULPS)
    wall = sim.add_static(t2.Box(width=1.0, height=1.0), position=(50.0, 0.0), restitution=0.0)
    sim.apply_impulse(wall, (1e9, 0.0))
    assert sim.velocity[wall].tolist() == [0, 0]


def test_a_push_that_float64_cannot_hold_is_refused_whole() -> None:
    sim = flight()
    for push in (sim.apply_impulse, sim.apply_force):
        for _ in range(2):
            with pytest.raises(t2.InputError, match=r"\[1\] of the bodies: .*beyond what float64"):
                push([1, 0, 0], (1.7e308, 0.0))
    sim.apply_force(0, (1.0, 0.0))
    assert not sim.velocity.any()
    sim.step()
    assert sim.velocity[0, 0] == pytest.approx(0.01, rel=ULPS)


def test_selections() -> None:
    sim = flight(gravity=(0.0, 0.0))
    sim.apply_impulse(np.array([True, False, True]), (1.0, 0.0))
    sim.apply_impulse(["body 1", "body 0"], [(0.0, 2.0), (0.0, 1.0)])
    sim.apply_impulse([], (1.0, 1.0))
    np.testing.assert_allclose(sim.velocity, [[1, 1], [0, 1], [1 / 3, 0]], rtol=ULPS)
    assert sim.index("body 2") == 2


def test_drag_in_closed_form() -> None:
    sim = flight(gravity=(0.0, 0.0), linear_drag=0.5, angular_drag=0.2)
    sim.velocity[:] = (1.0, 0.0)
    sim.angular_velocity[:] = 1.0
    sim.step(200)
    np.testing.assert_allclose(sim.velocity[:, 0], np.exp(-0.5 * 2.0 / sim.mass), rtol=1e-12)
    inertia = np.array([0.125, 0.25, 1.25])
    np.testing.assert_allclose(sim.angular_velocity, np.exp(-0.2 * 2.0 / inertia), rtol=1e-12)


def test_loads_that_vary_are_followed_to_second_order() -> None:
    """An oscillator of period 2 pi: halving the step quarters the error."""
    errors = []
    for steps in (200, 400, 800):
        scene = t2.Scene(gravity=(0.0, 0.0))
        ball = scene.add_body(t2.Disc(radius=0.1), mass=1.0, position=(1.0, 0.0))
        scene.add_spring(ball, (0.0, 0.0), stiffness=1.0, rest_length=0.0)
        sim = t2.Simulator(scene, time_step=1 / steps)
        sim.step(steps)
        errors.append(abs(float(sim.position[ball, 0]) - np.cos(1.0)))
        assert sim.force[ball].tolist() == [0, 0]
    assert errors[0] / errors[1] == pytest.approx(4.0, abs=0.1)
    assert errors[1] / errors[2] == pytest.approx(4.0, abs=0.1)


def test_a_spring_goes_with_its_body() -> None:
    scene = t2.Scene(gravity=(0.0, 0.0))
    ball = scene.add_body(t2.Disc(radius=0.1), mass=1.0, position=(1.0, 0.0), restitution=0)
    other = scene.add_body(t2.Disc(radius=0.1), mass=1.0, position=(-1.0, 0.0))
    scene.add_spring(ball, other, stiffness=1.0, rest_length=0.0)
    sim = t2.Simulator(scene)
    sim.step()
    assert sim.velocity[ball, 0] < 0
    sim.remove(other)
    before = sim.velocity[ball].copy()
    sim.step()
    again = sim.add(t2.Disc(radius=0.1), mass=1.0, position=(-1.0, 0.0))
    assert again == other
    sim.step()
    assert sim.velocity[ball].tolist() == before.tolist()


def test_bodies_attract_each_other_whatever_else_there_is() -> None:
    scene = t2.Scene(gravity=(0.0, 0.0))
    scene.add_static(t2.Box(width=1.0, height=1.0), position=(0.0, 50.0), restitution=0.0)
    for x, mass in ((0.0, 2.0), (4.0, 3.0)):
        shape = t2.Disc(radius=0.1)
        scene.add_body(shape, mass=mass, position=(x, 0.0), restitution=0.0)
    scene.add_attraction(gravitational_constant=8.0)
    sim = t2.Simulator(scene, time_step=0.01)
    sim.step()
    later = 4.0 - 0.5 * 0.01**2 * 8.0 * (3.0 + 2.0) / 16.0  # m, apart at the end of the step
    pulls = 0.01 * 8.0 * (1 / 16.0 + 1 / later**2) / 2  # per mass of the other one
    np.testing.assert_allclose(sim.velocity[1:, 0], [3.0 * pulls, -2.0 * pulls], rtol=1e-12)


def test_a_spring_follows_the_kinematic_body_that_holds_it() -> None:
    """It pulls a body too heavy to move with what it is longer by in the middle of each step."""
    scene = t2.Scene(gravity=(0.0, 0.0))
    shape = t2.Disc(radius=0.1)
    lift = scene.add_kinematic(shape, position=(0.0, 0.0), velocity=(2.0, 0.0))
    load = scene.add_body(None, mass=1e9, position=(0.0, 0.0))
    scene.add_spring(load, lift, stiffness=3.0, rest_length=0.0)
    sim = t2.Simulator(scene, time_step=0.01)
    sim.step(100)
    lengths = 2.0 * 0.01 * (np.arange(100) + 0.5)
    assert sim.velocity[load, 0] == pytest.approx(3.0 * lengths.sum() * 0.01 / 1e9, rel=1e-6)


def test_a_kinematic_body_moves_as_it_is_told() -> None:
    sim = flight()
    lift = sim.add_kinematic(
        t2.Box(width=1.0, height=0.1), position=(0.0, 50.0), velocity=(0.0, 1.0), friction=1.0
    )
    sim.velocity[lift] = 1.0, 2.0
    sim.step(100)
    np.testing.assert_allclose(sim.position[lift], [1.0, 52.0], rtol=ULPS)


@pytest.mark.parametrize(
    ("view", "value", "says"),
    [
        ("position", np.nan, r"position\[1\] of body 'body 1': found \[nan, nan\]: must be finite"),
        ("orientation", np.inf, r"orientation\[1\] of body 'body 1': found inf: must be finite"),
        ("velocity", -np.inf, r"velocity\[1\] of body 'body 1': found \[-inf, -inf\]"),
        ("angular_velocity", np.nan, r"angular_velocity\[1\] of body 'body 1': found nan"),
        ("force", np.nan, r"force\[1\] of body 'body 1': found \[nan, nan\]"),
        ("torque", np.nan, r"torque\[1\] of body 'body 1': found nan"),
    ],
)
def test_what_is_no_number_is_named_and_no_step_is_taken(
    view: str, value: float, says: str
) -> None:
    sim = flight()
    sim.step(3)
    before = sim.position.copy()
    good = getattr(sim, view)[1].copy()
    getattr(sim, view)[1] = value
    with pytest.raises(t2.InputError, match=says):
        sim.step()
    getattr(sim, view)[1] = good
    assert (sim.position == before).all()
    assert sim.time == pytest.approx(0.03, rel=ULPS)
    twin = flight()
    twin.step(4)
    sim.step()
    assert sim.digest() == twin.digest()


EMPTY = t2.Scene(gravity=(0.0, 0.0))


def test_gravity_and_static_bodies() -> None:
    sim = flight()
    wall = sim.add_static(t2.Box(width=1.0, height=1.0), position=(50.0, 0.0), restitution=0.0)
    sim.velocity[wall] = 1.0, 0.0
    with pytest.raises(
        t2.InputError, match=r"velocity\[3\] of body 3: .*of a static body: must be 0"
    ):
        sim.step()
    sim.velocity[wall] = 0.0
    sim.gravity = 0.0, np.nan
    with pytest.raises(t2.InputError, match=r"gravity: .*must be finite"):
        sim.step()
    sim.gravity = 0.0, 10.0
    sim.step()
    assert sim.velocity[0].tolist() == pytest.approx([0.0, 0.1], rel=ULPS)


BAD = {
    "time step 0": (lambda _: t2.Simulator(EMPTY, time_step=0.0), "time step 0 s of the sim"),
    "negative": (lambda _: t2.Simulator(EMPTY, time_step=-1.0), "must be > 0"),
    "no time step": (lambda _: t2.Simulator(EMPTY, time_step=np.nan), "must be finite"),
    "no substeps": (lambda _: t2.Simulator(EMPTY, substeps=0), "substeps 0: must be a whole"),
    "half a substep": (lambda _: t2.Simulator(EMPTY, substeps=1.5), "substeps 1.5"),
    "no scene": (lambda _: t2.Simulator("pile"), "scene: found 'pile'"),
    "back": (lambda sim: sim.step(-1), "count -1: must be a whole number"),
    "half a step": (lambda sim: sim.step(0.5), "count 0.5: .*time_step=1/60"),
    "shape": (lambda sim: setattr(sim, "velocity", np.zeros(7)), "found .7,.: must be numbers"),
    "text": (lambda sim: setattr(sim, "torque", "much"), "found str: must be numbers"),
    "unknown": (lambda sim: sim.apply_impulse(7, (0, 1)), "body 7: the simulator has none such"),
    "negative index": (lambda sim: sim.remove(-1), "body -1: the simulator has none such"),
    "name": (lambda sim: sim.remove("ball"), "body 'ball': the simulator has none such"),
    "names": (lambda sim: sim.remove(["body 0", "x"]), "body 'x': the simulator has none"),
    "fraction": (lambda sim: sim.remove([0.5]), "must be whole numbers or names"),
    "mask": (
        lambda sim: sim.remove([True]),
        "found 1 truth values: must be 3, one for each row, .* as many as len.sim.position.",
    ),
    "impulse": (lambda sim: sim.apply_impulse(0, np.nan), "must be two components"),
    "no impulse": (
        lambda sim: sim.apply_impulse([0, 1], [(0, 1), (np.nan, 0)]),
        r"impulse\[1\]\[0\] of the bodies: found nan",
    ),
    "endless step": (lambda _: t2.Simulator(EMPTY, time_step=1e300), "must be from 8.6e-78 to"),
    "no step": (lambda _: t2.Simulator(EMPTY, time_step=1e-320), "must be from 8.6e-78 to"),
    "endless substeps": (lambda _: t2.Simulator(EMPTY, substeps=10**9), "must be at most 1000"),
    "substeps": (lambda _: t2.Simulator(EMPTY, substeps=2**63), "must be less than 2..63"),
    "steps": (lambda sim: sim.step(2**63), "count 9223372036854775808: must be less than 2..63"),
    "huge": (lambda sim: setattr(sim, "torque", 10**400), "torque of the simulator: found int"),
    "huge index": (lambda sim: sim.remove(2**63), "body 9223372036854775808: the simulator"),
    "no name": (lambda sim: sim.index([]), "name: found .*: must be a name"),
    "not compiled": (lambda _: t2.Simulator(EMPTY, compiled=None), "compiled: found None"),
    "no shape": (lambda sim: sim.add([{}], mass=1.0, position=[(0, 0)]), "must be a shape"),
    "endless ray": (
        lambda sim: sim.ray_cast((0, 9), (0, -1.7e308)),
        r"end\[0\] .* within 1.2e.77 m",
    ),
    "far point": (lambda sim: sim.at_point((1e200, 0)), "must be within 1.2e.77 m"),
    "three": (lambda sim: sim.apply_force([0, 1], np.zeros((3, 2))), "for 2 bodies"),
}


@pytest.mark.parametrize("name", BAD)
def test_bad_calls_are_refused(name: str) -> None:
    call, says = BAD[name]
    sim = flight()
    before = sim.digest()
    with pytest.raises(t2.InputError, match=says):
        call(sim)
    assert sim.digest() == before


def test_a_misspelt_attribute_is_an_error() -> None:
    sim = flight()
    with pytest.raises(AttributeError):
        sim.velocty = np.zeros((3, 2))  # type: ignore[attr-defined]


def test_an_empty_simulator_steps() -> None:
    sim = t2.Simulator(t2.Scene(gravity=(0.0, -9.81)))
    sim.step(5)
    assert (len(sim), sim.position.shape, len(sim.contacts)) == (0, (0, 2), 0)
    assert repr(sim) == "<Simulator of 0 bodies at 0.0833333 s>"
