"""What a scene needs: never too little, and a reason for all that is left out."""

import math

import numpy as np
import pytest
from hypothesis import assume, given, settings, strategies as st

from tamias2d.errors import InputError
from tamias2d.scene import Box, Disc, HalfPlane, Needs, Polygon, Scene, catalogue, needs
from tamias2d.scene.acting import varying_loads
from tamias2d.scene.reach import pairs_that_can_meet

small = st.floats(-10, 10)
discs = st.tuples(st.tuples(small, small), st.tuples(small, small), st.tuples(small, small))


def needed(name: str) -> set[str]:
    return {entry.what for entry in needs(catalogue.load(name)).entries if entry.needed}


def reason(found: Needs, what: str) -> str:
    return next(entry.reason for entry in found.entries if entry.what == what)


def test_a_projectile_needs_translation_and_gravity_only() -> None:
    assert needed("tc6") == {
        "position, velocity",
        "gravity (GD2)",
        "translation (IM1)",
        "closed form",
    }


def test_bouncing_discs_need_no_rotation() -> None:
    found = needed("bouncing-disc")
    assert {"impact (IM3)", "resting contact (GD3)", "location of impacts"} <= found
    assert not {"rotation (IM2)", "orientation, angular velocity"} & found


def test_boxes_that_can_be_hit_need_rotation() -> None:
    assert "rotation (IM2)" in needed("tc11-corner")
    assert "rotation (IM2)" not in needed("tc10")


def test_a_force_of_time_is_integrated() -> None:
    found = needed("driven")
    assert "integration of the equations of motion" in found
    assert "closed form" not in found
    assert "rotation (IM2)" in found


TERMS = {
    "drag-fall": "linear drag (IM6)",
    "quadratic-drag": "quadratic drag (IM6)",
    "oscillator": "springs and dampers (IM7)",
    "two-body": "attraction between bodies (IM5)",
    "own-law": "force fields (IM8)",
    "pendulum-a01": "joints (TM7, GD17)",
}


@pytest.mark.parametrize("name", TERMS)
def test_a_scene_needs_the_term_that_it_states_and_no_other(name: str) -> None:
    assert needed(name) & set(TERMS.values()) == {TERMS[name]}
    assert not needed("showcase") & set(TERMS.values())


def test_a_closed_form_is_used_where_there_is_one() -> None:
    for name in ("drag-fall", "oscillator"):
        assert "closed form" in needed(name)
        assert "integration of the equations of motion" not in needed(name)
    found = needs(catalogue.load("quadratic-drag"))
    assert "closed form" not in found
    assert "'dropped' is under quadratic drag" in reason(found, "closed form")


def test_bodies_that_act_on_each_other_go_together() -> None:
    together = "integration of bodies together"
    found = needs(catalogue.load("spring-chain"))
    assert "'ball01' and 'ball02'" in reason(found, together)
    assert "in a group of 12" in reason(found, together)
    assert together in needed("two-body")
    assert together not in needed("kepler")


def test_a_spring_beside_the_centre_turns_its_body() -> None:
    for anchor, turned in (((0.0, 0.0), False), ((0.5, 0.0), True)):
        scene = Scene(gravity=(0, 0), duration=1)
        scene.add_body(Box(width=1, height=1), mass=1, position=(0, 0))
        scene.add_spring(0, (3, 0), stiffness=1, rest_length=0, anchor=anchor)
        assert ("rotation (IM2)" in needs(scene)) is turned


def test_a_field_that_twists_turns_what_has_inertia() -> None:
    scene = Scene(gravity=(0, 0), duration=1)
    scene.add_body(None, mass=1, position=(0, 0))
    scene.add_field(torque="1[N*m]*cos(1[rad/s]*time)")
    assert "rotation (IM2)" not in needs(scene)
    scene.add_body(None, mass=1, inertia=1, position=(0, 0))
    assert "rotation (IM2)" in needs(scene)


def test_a_law_that_asks_how_a_body_is_turned_needs_the_orientation() -> None:
    """A thrust along the body's axis: the body does not turn, but has to be turned."""
    scene = Scene(gravity=(0, 0), duration=1)
    scene.add_body(
        Box(width=1, height=1),
        mass=1,
        position=(0, 0),
        orientation=1,
        force=("3[N]*cos(orientation)", 0),
    )
    assert "orientation, angular velocity" in needs(scene)


def test_a_constant_field_is_swept_like_gravity() -> None:
    """Pushed by 2 m/s^2 for 3 s it moves by 9 m."""
    for wall, pairs in ((9.4, [(0, 1)]), (9.6, [])):
        scene = Scene(gravity=(0, 0))
        scene.add_body(Disc(radius=0.5), mass=3, position=(0, 0))
        scene.add_static(HalfPlane(normal=(-1, 0), offset=-wall))
        scene.add_field(force=("2[m/s^2]*mass", 0))
        assert pairs_that_can_meet(scene, 3.0) == pairs
        assert not varying_loads(scene)


def test_each_thing_left_out_has_its_reason() -> None:
    found = needs(catalogue.load("tc10"))
    assert reason(found, "gravity (GD2)") == "the scene has no gravity"
    assert reason(found, "impact (IM3)") == "no two bounds meet within 4 s"
    assert "(IM3)" not in found
    assert "translation (IM1)" in found
    for name in catalogue.names():
        assert all(entry.reason for entry in needs(catalogue.load(name)).entries)


def table(scene: Scene, duration: float) -> list[str]:
    entries = needs(scene, duration).entries
    return [f"{'needs' if e.needed else 'omits'} {e.what}: {e.reason}" for e in entries]


NOTHING_ELSE_ACTS = [
    "omits attraction between bodies (IM5): the scene states no attraction",
    "omits linear drag (IM6): no body has a linear drag",
    "omits quadratic drag (IM6): no body has a quadratic drag",
    "omits angular drag (IM6): no body has an angular drag",
    "omits springs and dampers (IM7): the scene has no spring",
    "omits joints (TM7, GD17): the scene has no joint",
    "omits force fields (IM8): the scene has no field",
]
APART = "omits integration of bodies together: nothing but contact acts between bodies"


def test_an_empty_scene_needs_nothing() -> None:
    assert table(Scene(gravity=(0, -1)), 2.0) == [
        "omits position, velocity: 0 of 0 bodies can move",
        "omits orientation, angular velocity: no body has a torque or a spin, and none can be hit",
        "omits gravity (GD2): no body moves",
        "omits applied force: no force is applied to any body",
        "omits applied torque: no torque is applied to any body",
        *NOTHING_ELSE_ACTS,
        "omits translation (IM1): 0 of 0 bodies can move",
        "omits rotation (IM2): no body has a torque or a spin, and none can be hit",
        "omits detection (IM4): no body has a shape",
        "omits impact (IM3): no two bounds meet within 2 s",
        "omits impacts that act together (A18): no two bounds meet within 2 s",
        "omits resting contact (GD3): no two bounds meet within 2 s",
        "omits friction (IM9, GD8): no two bounds meet within 2 s",
        "omits closed form: no body moves",
        "omits integration of the equations of motion: no body moves",
        APART,
        "omits location of impacts: no two bounds meet within 2 s",
    ]


def test_one_disc_alone_pushed_and_twisted() -> None:
    scene = Scene(gravity=(0, 0))
    scene.add_body(
        Disc(radius=1), mass=1, position=(0, 0), force=(1, 0), torque="time*1[N*m/s]", name="a"
    )
    varies = "under a force or torque that varies with time or state"
    assert table(scene, 0.5) == [
        "needs position, velocity: 1 of 1 bodies can move",
        "needs orientation, angular velocity: 'a' is spun or twisted from the start",
        "omits gravity (GD2): the scene has no gravity",
        "needs applied force: 'a' is pushed",
        "needs applied torque: 'a' is twisted",
        *NOTHING_ELSE_ACTS,
        "needs translation (IM1): 1 of 1 bodies can move",
        "needs rotation (IM2): 'a' is spun or twisted from the start",
        "omits detection (IM4): 1 body has a shape: there is no pair",
        "omits impact (IM3): no two bounds meet within 0.5 s",
        "omits impacts that act together (A18): no two bounds meet within 0.5 s",
        "omits resting contact (GD3): no two bounds meet within 0.5 s",
        "omits friction (IM9, GD8): no two bounds meet within 0.5 s",
        f"omits closed form: 'a' is {varies}",
        f"needs integration of the equations of motion: 'a' is {varies}",
        APART,
        "omits location of impacts: no two bounds meet within 0.5 s",
    ]


def test_three_bodies_that_meet() -> None:
    scene = Scene(gravity=(0, 0))
    for name, x, push in (("a", 0, 1), ("b", 2, 0), ("c", 4, 1)):
        scene.add_body(Box(width=1, height=1), mass=1, position=(x, 0), name=name, force=(push, 0))
    found = table(scene, 3.0)
    assert "needs applied force: 'a' and 1 more are pushed" in found
    met = "the bounds of 'a' and 'b', and of 1 more pair, meet within 3 s"
    assert needs(scene, 3.0).pairs == ((0, 1), (0, 2))
    turned = "'a' and 2 more are turned when hit beside the centre of mass"
    assert found[1] == f"needs orientation, angular velocity: {turned}"
    assert found[13:] == [
        f"needs rotation (IM2): {turned}",
        "needs detection (IM4): 3 bodies have shapes",
        f"needs impact (IM3): {met}",
        "needs impacts that act together (A18): 'a' may be struck while it touches another: "
        "then a rule decides",
        "needs resting contact (GD3): bodies that can meet are pressed together by gravity "
        "or a force",
        "omits friction (IM9, GD8): no body states friction (A6)",
        "needs closed form: every force and torque is constant",
        "omits integration of the equations of motion: every force and torque is constant",
        APART,
        f"needs location of impacts: {met}",
    ]


def test_free_discs_that_meet_do_not_come_to_rest_on_each_other() -> None:
    found = table(catalogue.load("oblique-discs"), 3.0)
    met = "the bounds of 'moving' and 'struck' meet within 3 s"
    assert f"needs impact (IM3): {met}" in found
    why = "nothing presses bodies together: those that touch exert no force"
    assert f"omits resting contact (GD3): {why}" in found
    assert "omits impacts that act together (A18): no body can meet two others" in found
    why = "no body has a torque or a spin, and a disc is hit through its centre (no friction, A6)"
    assert f"omits rotation (IM2): {why}" in found
    assert "needs gravity (GD2): (0, -9.81) m/s^2 acts" in table(catalogue.load("resting"), 1.0)


def test_the_plan_s_collision_case_needs_no_impact_until_it_is_long_enough() -> None:
    """The gap of 100 m closes after sqrt(20) s = 4.47 s."""
    scene = catalogue.load("tc10")
    assert not needs(scene, 4.47).pairs
    assert needs(scene, 4.48).pairs == ((0, 1),)


def test_a_scene_without_a_duration_asks_for_one() -> None:
    with pytest.raises(InputError, match="duration"):
        needs(Scene(gravity=(0, 0)))


def test_a_throw_reaches_the_ceiling_that_it_turns_back_below() -> None:
    """Thrown with 10 m/s under 10 m/s^2 it rises by 5 m, and is back after 2 s."""
    for ceiling, pairs in ((5.49, [(0, 1)]), (5.51, [])):
        scene = Scene(gravity=(0, -10))
        scene.add_body(Disc(radius=0.5), mass=1, position=(0, 0), velocity=(0, 10))
        scene.add_static(HalfPlane(normal=(0, -1), offset=-ceiling))
        assert pairs_that_can_meet(scene, 2.0) == pairs


def test_a_touching_body_can_meet_what_it_touches() -> None:
    scene = Scene(gravity=(0, 0))
    for turn in (0.0, 0.3, 1.0):
        reach = 0.5 * (math.sin(turn) + math.cos(turn))
        scene.add_body(Box(width=1, height=1), mass=1, position=(9 * turn, reach), orientation=turn)
    scene.add_static(HalfPlane(normal=(0, 1), offset=0))
    assert pairs_that_can_meet(scene, 1.0) == [(0, 3), (1, 3), (2, 3)]


def test_what_has_no_bound_can_meet_everything() -> None:
    scene = Scene(gravity=(0, 0))
    scene.add_body(Disc(radius=1), mass=1, position=(0, 0), force=("1[N/s]*time", 0))
    scene.add_body(Disc(radius=1), mass=1, position=(1e9, 0))
    scene.add_body(Disc(radius=1), mass=1, position=(5, 9), velocity=(0, 1e300))
    scene.add_body(None, mass=1, position=(0, 0))
    assert pairs_that_can_meet(scene, 1.0) == [(0, 1), (0, 2)]
    assert pairs_that_can_meet(scene, 1e9) == [(0, 1), (0, 2), (1, 2)]  # 1e309 is no number


def test_a_bound_that_overflows_is_no_bound() -> None:
    """The end of the path is infinity less infinity."""
    scene = Scene(gravity=(0, -1e300))
    scene.add_body(Disc(radius=1), mass=1, position=(0, 0), velocity=(0, 1e300))
    scene.add_static(Disc(radius=1), position=(0, 9))
    assert pairs_that_can_meet(scene, 1e200) == [(0, 1)]


def test_a_static_body_does_not_fall() -> None:
    scene = Scene(gravity=(0, -10))
    scene.add_body(Disc(radius=1), mass=1, position=(0, -30))
    scene.add_static(Box(width=9, height=1), position=(0, 10))
    assert pairs_that_can_meet(scene, 9.0) == []


@given(st.lists(discs, min_size=2, max_size=5), st.floats(0.1, 5))
@settings(max_examples=300, deadline=None)
def test_no_pair_that_meets_is_missed(
    bodies: list[tuple[tuple[float, float], ...]], duration: float
) -> None:
    """Positions at 200 times, computed here, against the pairs that are said to be able to meet."""
    scene = Scene(gravity=(1, -2))
    for position, velocity, force in bodies:
        scene.add_body(Disc(radius=1), mass=0.5, position=position, velocity=velocity, force=force)
    scene.add_static(HalfPlane(normal=(0.6, 0.8), offset=-3))
    t = np.linspace(0, duration, 200)[:, None, None]
    start, velocity, force = (np.array([body[k] for body in bodies]) for k in range(3))
    path = start + velocity * t + (force / 0.5 + (1, -2)) * t**2 / 2
    wall = len(bodies)
    met = {(k, wall) for k in range(wall) if (path[:, k] @ (0.6, 0.8) - 1 <= -3).any()}
    for i in range(wall):
        for j in range(i + 1, wall):
            if (np.linalg.norm(path[:, i] - path[:, j], axis=-1) <= 2).any():
                met.add((i, j))
    assert met <= set(pairs_that_can_meet(scene, duration))


@given(st.floats(-7, 7), st.floats(-3, 3), st.floats(0.1, 3), small, small)
@settings(max_examples=300, deadline=None)
def test_no_corner_that_reaches_a_wall_is_missed(
    turn: float, spin: float, duration: float, x: float, y: float
) -> None:
    triangle = Polygon(vertices=[(0, 0), (3, 0), (0, 1)])
    scene = Scene(gravity=(0, -3))
    scene.add_body(
        triangle, mass=1, position=(0, 4), velocity=(x, y), orientation=turn, angular_velocity=spin
    )
    scene.add_static(HalfPlane(normal=(0, 1), offset=0))
    t = np.linspace(0, duration, 200)[:, None]
    angle, (px, py) = turn + spin * t, np.array(triangle.vertices).T
    corner = 4 + y * t - 1.5 * t**2 + np.sin(angle) * px + np.cos(angle) * py
    assume((corner <= 0).any())
    assert pairs_that_can_meet(scene, duration) == [(0, 1)]


def test_friction_turns_discs() -> None:
    scene = Scene(gravity=(0, -9.81))
    scene.add_static(HalfPlane(normal=(0, 1), offset=0), name="floor", friction=0.5)
    scene.add_body(Disc(radius=1), mass=1, position=(0, 1), name="ball")
    found = table(scene, 1.0)
    assert "needs friction (IM9, GD8): 'floor' is rough" in found
    assert "needs rotation (IM2): 'floor' is rough, and friction turns what touches" in found
    scene.set_friction("floor", "ball", 0.0)
    assert "friction (IM9, GD8)" in needs(scene, 1.0)  # another body may come
