"""What governs the freedom of a joint: limits, motors, brakes, springs and ropes (IM15)."""

import math

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.errors import StepWarning
from tamias2d.scene import Distance, JointSpring, Limits, Motor, Scene, Wheel, catalogue
from tests.engine.scenes import ground, plain
from tests.simulator.mechanisms import G, governed, pendulum


def test_limit_stops_and_bears_the_weight() -> None:
    sim = plain(governed(limits=Limits(lower=-0.5, upper=1.0, restitution=0.0)))
    sim.step(40)
    assert sim.orientation[0] == pytest.approx(-0.5, abs=1e-6)  # passed by less than a substep
    assert sim.angular_velocity[0] == pytest.approx(0.0, abs=1e-8)  # by how firm a row is
    assert sim.reactions.torque[0, 1] == pytest.approx(G * math.cos(0.5), rel=1e-6)


@pytest.mark.parametrize("side", [-1, 1])
def test_limit_that_pushed_in_the_step_is_told(side: int) -> None:
    """Only then: before it is reached, and after it was left, none is."""
    sim = plain(governed(limits=Limits(lower=-0.5, upper=0.5, restitution=0.0)))
    sim.angular_velocity[0], sim.velocity[0] = 6.0 * side, (0.0, 6.0 * side)
    sim.step(2)
    assert sim.reactions.limit.tolist() == [0]
    sim.step(4)
    assert sim.reactions.limit.tolist() == [side]
    sim.angular_velocity[0], sim.velocity[0] = -3.0 * side, (0.0, -3.0 * side)
    sim.step(2)
    assert sim.reactions.limit.tolist() == [0]


def test_limits_that_were_tried_and_let_go_are_not_told() -> None:
    """At rest each link of a chain leans on the limit to which it hangs down, and on no other."""
    scene = Scene(gravity=(0.0, -G))
    stops = Limits(lower=-0.1, upper=0.1, restitution=0.0)
    for k in range(6):
        scene.add_body(None, mass=1.0, inertia=0.1, position=(k + 0.5, 0.0))
        place, anchor = ((0.0, 0.0), (0.0, 0.0)) if k == 0 else (k - 1, (0.5, 0.0))
        scene.add_joint(
            t2.Revolute(limits=stops), place, k, anchor=anchor, other_anchor=(-0.5, 0.0)
        )
    sim = plain(scene)
    sim.step(240)
    assert sim.reactions.limit.tolist() == [-1] * 6
    assert np.diff(sim.orientation) == pytest.approx(-0.1, abs=1e-4)


def test_limit_never_pulls() -> None:
    scene = governed(limits=Limits(lower=0.0, restitution=0.0))
    sim = plain(scene)
    sim.step(3)
    sim.angular_velocity[0], sim.velocity[0] = 3.0, (0.0, 3.0)
    sim.step(6)
    free = plain(governed())
    free.angular_velocity[0], free.velocity[0] = 3.0, (0.0, 3.0)
    free.step(6)
    assert sim.orientation[0] == pytest.approx(free.orientation[0], abs=2e-3)  # of order one
    assert sim.reactions.force == pytest.approx(free.reactions.force, rel=2e-2)


def test_motor_keeps_its_speed_or_gives_the_most_that_it_can() -> None:
    sim = plain(governed(motor=Motor(speed=2.0)))
    sim.step(6)
    assert sim.angular_velocity[0] == pytest.approx(2.0, rel=1e-7)  # firm to 1e-8
    sim = plain(governed(motor=Motor(speed=2.0, maximum=4.0)))
    sim.step(1)
    assert sim.angular_velocity[0] * 60 == pytest.approx((4.0 - G) / 1.1, rel=1e-6)
    assert sim.reactions.torque[0, 1] == pytest.approx(4.0, rel=1e-5)  # arms at the end


def test_motor_that_gives_the_most_tears_no_mechanism() -> None:
    """Jansen's legs weigh thirty times their crank, which has to reach its speed with them."""
    sim = plain(catalogue.load("walker"))
    for _ in range(5):
        sim.step()
        assert sim.reactions.separation.max() < 1e-8
        assert abs(sim.reactions.torque[sim.joints.index("motor"), 1]) < 20.0 * (1 + 1e-6)
    assert sim.angular_velocity[0] == pytest.approx(-math.pi, rel=1e-6)


def test_brake_holds_what_it_can() -> None:
    sim = plain(governed(motor=Motor(speed=0.0, maximum=1.2 * G)))
    sim.step(20)
    assert abs(sim.orientation[0]) < 1e-7


def test_spring_of_a_joint_rests_where_its_torque_is_that_of_the_weight() -> None:
    spring = JointSpring(stiffness=100.0, damping=20.0, rest=0.0)
    sim = plain(governed(spring=spring))
    sim.step(180)
    angle = sim.orientation[0]
    assert 100.0 * angle == pytest.approx(-G * math.cos(angle), rel=1e-4)


def test_stiff_spring_gains_no_energy() -> None:
    scene = governed(spring=JointSpring(stiffness=1e6, rest=0.1))
    sim, most = plain(scene), 0.5 * 1e6 * 0.1**2
    for _ in range(30):
        sim.step()
        moving = 0.5 * ((sim.velocity**2).sum() + 0.1 * sim.angular_velocity[0] ** 2)
        stored = 0.5e6 * (sim.orientation[0] - 0.1) ** 2
        assert moving + stored + G * sim.position[0, 1] <= most * (1 + 1e-9)


def test_rope_holds_a_weight_at_its_length_and_lets_it_come_nearer() -> None:
    scene = Scene(gravity=(0.0, -G))
    scene.add_body(None, mass=2.0, inertia=0.1, position=(0.0, -0.5))
    scene.add_joint(Distance(limits=Limits(upper=1.0, restitution=0.0)), (0.0, 0.0), 0)
    sim = plain(scene)
    sim.step(10)
    assert sim.velocity[0, 1] == pytest.approx(-G * 10 / 60)
    sim.step(30)
    assert sim.position[0, 1] == pytest.approx(-1.0, abs=1e-6)
    assert sim.reactions.force[0, 1, 1] == pytest.approx(2.0 * G, rel=1e-6)


def test_car_stands_on_its_springs() -> None:
    scene = Scene(gravity=(0.0, -G))
    ground(scene, 0.5)
    stuff = {"friction": 0.5, "restitution": 0.0}
    hull = scene.add_body(t2.Box(width=2.0, height=0.4), mass=100.0, position=(0.0, 1.0), **stuff)
    spring = JointSpring(stiffness=20e3, damping=3e3, rest=0.0)
    for x in (-0.7, 0.7):
        wheel = scene.add_body(t2.Disc(radius=0.3), mass=10.0, position=(x, 0.3), **stuff)
        kind = Wheel(axis=(0.0, 1.0), spring=spring, limits=Limits(lower=-0.2, restitution=0.0))
        scene.add_joint(kind, hull, wheel, anchor=(x, -0.7))
    sim = plain(scene)
    sim.step(60)
    sunk = float(1.0 - sim.position[hull, 1])
    assert sunk == pytest.approx(100.0 * G / 2 / 20e3, abs=2e-3)  # contacts yield by as much
    assert np.abs(sim.velocity).max() < 0.05


def test_joints_that_are_apart_are_told_by_name() -> None:
    sim = plain(pendulum())
    sim.position[0] = (1.5, 0.0)
    with pytest.warns(StepWarning, match=r"joint 'joint0' \(revolute\).*apart.*R13"):
        sim.step()


@pytest.mark.parametrize(("speed", "maximum"), [(2.0, None), (3.0, 8.0), (1.0, 1.0), (0.0, 3.0)])
def test_motors_of_hinges_are_of_order_two(speed: float, maximum: float | None) -> None:
    """One that holds its speed, and others that give the most; they were of order one."""
    scene = t2.Scene(gravity=(0.0, -9.81))
    for x in (1.0, 2.0):
        scene.add_body(None, mass=1.0, inertia=0.1, position=(x, 0.0))
    motor = Motor(speed=speed, maximum=maximum)
    scene.add_joint(t2.Revolute(motor=motor), (0.0, 0.0), 0, other_anchor=(-1.0, 0.0))
    scene.add_joint(t2.Revolute(), 0, 1, anchor=(0.5, 0.0), other_anchor=(-0.5, 0.0))
    exact = t2.simulate(scene, duration=0.25, tolerance=1e-9).position[-1]
    errors = []
    for steps in (60, 240):
        sim = plain(scene, time_step=1 / steps)
        sim.step(steps // 4)
        errors.append(float(np.abs(sim.position - exact).max()))
    assert errors[0] < 1e-4
    assert errors[1] < errors[0] / 8  # 16 of order two, but for when it begins to hold
