"""The loads of all bodies at once are those of each body alone, to the bit; nothing is idle."""

import math
from typing import Any

import numpy as np
import pytest

from tamias2d.errors import InputError, SimulationError
from tamias2d.generated import definitions, drag, gravitation, rotation, spring, translation
from tamias2d.motion.loads import Loads, coordinates, start_states
from tamias2d.motion.terms import terms
from tamias2d.scene import Box, Scene, Spring, catalogue
from tamias2d.scene.acting import groups, steady_load, varying_laws
from tamias2d.scene.springs import arm

WIND = ("0.3[kg/s]*(2[1/s]*y(position) - x(velocity))", "sin(orientation)*1[N]*time/1[s]")
TWIST = "-2[N*m]*sin(orientation) - 0.1[N*m*s]*angular_velocity"


def crowd(count: int, seed: int) -> Scene:
    """Bodies under everything that a scene can state."""
    draw = np.random.default_rng(seed).uniform
    scene = Scene(gravity=(0.1, -9.81))
    for k in range(count):
        scene.add_body(
            Box(width=1, height=draw(0.5, 2)),
            mass=draw(0.5, 3),
            position=draw(-5, 5, 2),
            velocity=draw(-2, 2, 2),
            orientation=draw(-3, 3),
            angular_velocity=draw(-2, 2),
            force=(draw(-1, 1), "-1[N/m]*x(position)") if k % 3 else (draw(-1, 1), 0.5),
            torque=TWIST if k % 2 else 0.3,
            linear_drag=draw(0, 1) if k % 2 else 0.0,
            quadratic_drag=draw(0, 1) if k % 3 else 0.0,
        )
    nail = scene.add_static(Box(width=1, height=1), position=(1, 2), orientation=0.3)
    for k in range(count):
        scene.add_spring(
            k,
            (k + 1) % count,
            stiffness=draw(1, 50),
            rest_length=draw(0, 1),
            damping=draw(0, 1),
            anchor=draw(-1, 1, 2),
            other_anchor=draw(-1, 1, 2),
        )
    scene.add_spring(0, (3, 4), stiffness=2, rest_length=0, anchor=(0.5, 0))
    scene.add_spring(nail, 1, stiffness=2, rest_length=0.1, anchor=(0.5, 0.5))
    scene.add_attraction(gravitational_constant=0.7)
    scene.add_field(force=WIND)
    scene.add_field(force=("-0.2[m/s^2]*mass", 0), torque=TWIST, bodies=[1, 0])
    return scene


def alone(scene: Scene, k: int, time: float) -> tuple[float, float, float]:
    """The acceleration of one body, term by term in floats; sums in the order of the terms."""
    body, moving = scene.bodies[k], [i for i, body in enumerate(scene.bodies) if body.dynamic]
    load = list(steady_load(scene, k))
    for (component, law), rows in varying_laws(scene, moving).items():
        for _ in range(rows.count(k)):
            load[component] += law({**body.start, "time": time})
    for force in (
        drag.linear_drag_force(body.linear_drag, body.velocity),
        drag.quadratic_drag_force(body.quadratic_drag, body.velocity),
        *(pull(scene, each, back=each.second == k) for each in scene.springs if k in each.bodies),
        *(attracted(scene, k, other) for other in moving if other != k),
    ):
        for component, part in enumerate(force):
            load[component] += part
    x, y = translation.acceleration(scene.gravity, (load[0], load[1]), body.mass)
    return x, y, rotation.angular_acceleration(load[2], body.inertia)


def pull(scene: Scene, each: Spring, *, back: bool = False) -> tuple[float, float, float]:
    arms, points, speeds = [], [], []
    for i, anchor in each.ends:
        body = scene.bodies[i]
        reach = arm(anchor, body.orientation)
        arms.append(reach)
        points.append((body.position[0] + reach[0], body.position[1] + reach[1]))
        speeds.append(definitions.point_velocity(body.velocity, body.angular_velocity, reach))
    points, speeds = [*points, each.point], [*speeds, (0.0, 0.0)]
    law = (each.stiffness, each.rest_length, each.damping)
    x, y = spring.spring_force(*law, points[0], speeds[0], points[1], speeds[1])
    force = (-x, -y) if back else (x, y)
    return (*force, definitions.torque(arms[back], force))


def attracted(scene: Scene, k: int, other: int) -> tuple[float, float]:
    """Pairs are computed for the earlier body; the later one feels exactly the opposite."""
    a, b = (scene.bodies[i] for i in sorted((k, other)))
    force = gravitation.attraction(scene.attraction, a.mass, b.mass, a.position, b.position)
    x, y = force
    return (x, y) if k < other else (-x, -y)


def rows_of(scene: Scene, time: float) -> np.ndarray[Any, Any]:
    moving = [k for k, body in enumerate(scene.bodies) if body.dynamic]
    states = start_states(scene)
    now = coordinates([states[k] for k in moving])
    return Loads(scene).field(moving, [None] * len(moving))(time, *now)


@pytest.mark.parametrize("seed", range(5))
def test_all_at_once_are_each_alone_to_the_bit(seed: int) -> None:
    scene = crowd(7, seed)
    rows = rows_of(scene, 0.7)
    assert rows.tolist() == [list(alone(scene, k, 0.7)) for k in range(7)]


def test_one_body_asked_for_is_the_same_row() -> None:
    scene = crowd(5, 9)
    loads, states = Loads(scene), start_states(scene)
    rows = rows_of(scene, 0.2)
    for k in range(5):
        assert loads.acceleration(k, 0.2, states.__getitem__) == tuple(rows[k])
    assert loads.acceleration(5, 0.2, states.__getitem__) == (0, 0, 0)  # the static one


def test_a_dozen_terms_by_hand() -> None:
    """Worked out here from Newton's, Hooke's and Stokes's laws, without the generated code."""
    scene = Scene(gravity=(0, -10))
    scene.add_body(None, mass=2, position=(3, 4), velocity=(3, 4), linear_drag=1, quadratic_drag=2)
    scene.add_body(None, mass=4, position=(3, 0), force=("1[N/m]*y(position) + 3[N]", 0))
    scene.add_spring(0, 1, stiffness=10, rest_length=1, damping=0.5)
    scene.add_attraction(gravitational_constant=8)
    spring_pull = 10 * (4 - 1) + 0.5 * 4  # the ends part at 4 m/s
    gravitation_pull = 8 * 2 * 4 / 4**2
    drag_x, drag_y = -(1 + 2 * 5) * 3, -(1 + 2 * 5) * 4
    first = (drag_x / 2, (drag_y - spring_pull - gravitation_pull) / 2 - 10, 0)
    second = (3 / 4, (spring_pull + gravitation_pull) / 4 - 10, 0)
    np.testing.assert_allclose(rows_of(scene, 0.0), [first, second], rtol=1e-15)


def test_a_spring_turns_a_body_by_its_arm() -> None:
    """A pull of 6 N upwards, 2 m beside the centre, on a body turned by 90 degrees."""
    scene = Scene(gravity=(0, 0))
    scene.add_body(
        Box(width=1, height=1), mass=1, inertia=3, position=(1, 1), orientation=math.pi / 2
    )
    scene.add_spring(0, (3, 4), stiffness=2, rest_length=0, anchor=(0, -2))
    np.testing.assert_allclose(rows_of(scene, 0.0), [(0, 6, 2 * 6 / 3)], atol=1e-15)


@pytest.mark.parametrize("name", ["tc6", "tc9", "showcase", "billiard"])
def test_a_scene_without_laws_pays_for_no_term(name: str) -> None:
    scene = catalogue.load(name)
    moving = [k for k, body in enumerate(scene.bodies) if body.dynamic]
    assert terms(scene, moving) == []
    field = Loads(scene).field(moving, [None] * len(moving))
    q = np.zeros((len(moving), 3))
    assert field(0.0, q, q) is field(1.0, q, q)


def test_each_term_is_there_when_it_is_stated_and_only_then() -> None:
    kinds = {
        "quadratic-drag": ["quadratic_drag"],
        "drag-fall": ["linear_drag"],
        "oscillator": ["springs"],
        "solar": ["attraction between bodies"],
        "pendulum": ["torque of body 'bar'"],
    }
    for name, says in kinds.items():
        scene = catalogue.load(name)
        assert [term.says for term in terms(scene, range(len(scene)))] == says


def test_bodies_that_share_a_law_share_its_evaluation() -> None:
    scene = catalogue.load("own-law")
    assert len(terms(scene, range(3))) == 2  # one for each component, not one for each body


def test_groups_are_what_acts_on_each_other() -> None:
    scene = Scene(gravity=(0, 0))
    for k in range(6):
        scene.add_body(None, mass=1, position=(k, 0))
    for pair in ((4, 5), (0, 3), (5, 0)):
        scene.add_spring(*pair, stiffness=1, rest_length=0)
    scene.add_spring(1, (0, 1), stiffness=1, rest_length=0)
    assert groups(scene) == [[0, 3, 4, 5], [1], [2]]
    scene.add_attraction(gravitational_constant=1)
    assert groups(scene) == [[0, 1, 2, 3, 4, 5]]


def test_forces_between_bodies_are_opposite_to_the_bit() -> None:
    scene = catalogue.load("two-body")
    (ax, ay, _), (bx, by, _) = rows_of(scene, 0.0).tolist()
    assert (3 * ax, 3 * ay) == pytest.approx((-bx, -by), rel=1e-15)


def test_bodies_at_one_place_are_one_error() -> None:
    scene = Scene(gravity=(0, 0))
    scene.add_body(None, mass=1, position=(1, 0), name="one")
    scene.add_body(None, mass=1, position=(1, 0), name="other")
    scene.add_attraction(gravitational_constant=1)
    with pytest.raises(SimulationError, match=r"attraction .* 0\.0 s: no finite force on 'one'"):
        rows_of(scene, 0.0)


def test_a_law_without_a_value_is_one_error() -> None:
    scene = Scene(gravity=(0, 0))
    scene.add_body(None, mass=1, position=(1, 0), force=("1[N]*sqrt(1 - time/1[s])", 0))
    with pytest.raises(InputError, match=r"force\[0\] of body 'body0': .* at time 1\.5 s"):
        rows_of(scene, 1.5)
