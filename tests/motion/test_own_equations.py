"""An equation of one's own beside what governs other joints of its mechanism, against scipy."""

from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import tamias2d as t2
from tamias2d.scene import Scene
from tamias2d.state import Array

G = 9.81


def bead(also: str) -> Scene:
    """Return a bead on a parabola, by an equation, and what else holds it."""
    scene = Scene(gravity=(0.0, -G))
    scene.add_body(None, mass=1.0, inertia=0.1, position=(1.0, 1.0), name="bead")
    bears = {"break_force": 1e6} if also == "break" else {}
    scene.add_joint(t2.Equation("y(position_a)*1[m] - x(position_a)**2"), "bead", **bears)
    if also == "spring":
        spring = t2.JointSpring(stiffness=5.0, rest=1.0)
        scene.add_joint(t2.Distance(spring=spring), "bead", (0.0, 2.0))
    if also == "rope":
        limits = t2.Limits(upper=20.0, restitution=0.5)
        scene.add_joint(t2.Distance(limits=limits), "bead", (0.0, 2.0))
    if also == "brake":
        scene.add_joint(t2.Rotary(motor=t2.Motor(speed=0.0)), (0.0, 0.0), "bead")
    return scene


@pytest.mark.parametrize("also", ["break", "spring", "rope", "brake"])
@pytest.mark.parametrize(
    "way", [{}, {"tolerance": 1e-8}, {"method": t2.RungeKutta4(), "time_step": 1e-3}]
)
def test_an_equation_of_ones_own_beside_what_is_governed(also: str, way: dict[str, Any]) -> None:
    """A rope that is not taut and a brake of what nothing turns exert nothing.

    Of the parabola x, x^2: (1 + 4 x^2) x'' + 4 x x'^2 = -2 g x, and a spring to (0, 2).
    """
    stiffness = 5.0 if also == "spring" else 0.0

    def rate(_: float, state: Array) -> list[float]:
        x, u = state
        away = np.array((x, x * x - 2.0))
        length = np.hypot(*away)
        pull = -stiffness * (length - 1.0) * away / length
        force = pull[0] + 2 * x * (pull[1] - G)
        return [u, (force - 4 * x * u * u) / (1 + 4 * x * x)]

    run = t2.simulate(bead(also), duration=2.0, **way)
    true = solve_ivp(
        rate, (0.0, 2.0), [1.0, 0.0], method="DOP853", rtol=1e-12, atol=1e-12, t_eval=run.times
    )
    error = np.abs(run.position[:, 0, 0] - true.y[0]).max()
    assert error <= (1e-9 if not way else 2e-8)


@pytest.mark.parametrize(
    ("way", "within"), [({}, 1e-9), ({"method": t2.Stepped(), "time_step": 1 / 960}, 1e-4)]
)
def test_the_norm_of_a_vector_that_is_put_together(way: dict[str, Any], within: float) -> None:
    """A bead on an ellipse, (2 cos u, sin u) in m, from u = 0."""

    def rate(_: float, state: Array) -> list[float]:
        turn, speed = state
        sine, cosine = np.sin(turn), np.cos(turn)
        bent = 3 * sine * cosine * speed**2
        return [speed, -(bent + G * cosine) / (4 * sine**2 + cosine**2)]

    scene = Scene(gravity=(0.0, -G))
    scene.add_body(None, mass=1.0, position=(2.0, 0.0), name="bead")
    wire = t2.Equation("norm(vector(x(position_a)/2, y(position_a))) - 1[m]")
    scene.add_joint(wire, "bead")
    run = t2.simulate(scene, duration=1.5, times=[0.0, 0.5, 1.0, 1.5], **way)
    kept = {"rtol": 1e-12, "atol": 1e-12, "t_eval": run.times}
    turn = solve_ivp(rate, (0.0, 1.5), [0.0, 0.0], method="DOP853", **kept).y[0]
    true = np.stack((2 * np.cos(turn), np.sin(turn)), axis=-1)
    assert np.abs(run.position[:, 0] - true).max() <= within


@pytest.mark.parametrize(
    "text",
    [
        "dot(position_a, position_a) - 1[m^2]",
        "norm(position_a) - 1[m]",
        "5*norm(position_a) - 5[m]",
        "log(norm(position_a)/1[m])",
    ],
)
def test_how_far_an_equation_is_apart_is_a_way_whatever_its_unit(text: str) -> None:
    scene = Scene(gravity=(0.0, -G))
    scene.add_body(None, mass=1.0, position=(1.0, 0.0), name="bead")
    scene.add_joint(t2.Equation(text), "bead")
    run = t2.simulate(scene, duration=1.0, method=t2.Stepped(), time_step=0.1)
    assert run.reactions is not None
    apart = np.abs(np.hypot(*run.position[:, 0].T) - 1)
    assert apart.max() > 1e-10
    assert run.reactions.separation[:, 0] == pytest.approx(apart, rel=1e-3, abs=1e-14)
    assert not run.reactions.angular_separation.any()


@pytest.mark.parametrize(
    ("text", "off"), [("x(position_a)/1[m] - 3", "off by 2"), ("orientation_a - 2", "off by 2 rad")]
)
def test_what_has_no_unit_is_an_angle_if_it_only_turns(text: str, off: str) -> None:
    scene = Scene(gravity=(0.0, -G))
    scene.add_body(None, mass=1.0, inertia=1.0, position=(1.0, 0.0), name="bead")
    with pytest.raises(t2.errors.InputError, match=off + r" \(TM7\)"):
        scene.add_joint(t2.Equation(text), "bead")


@pytest.mark.parametrize(
    ("way", "within"), [({}, 1e-9), ({"method": t2.Stepped(), "time_step": 1 / 960}, 1e-4)]
)
@pytest.mark.parametrize("factor", ["1", "-180", "0.5[m]"])
def test_a_direction_turns_on_through_half_a_turn(
    way: dict[str, Any], within: float, factor: str
) -> None:
    """A bead in a groove that turns at 1 rad/s from 3 rad flies out: r = cosh t, in m."""
    scene = Scene(gravity=(0.0, 0.0))
    along, across = np.array((np.cos(3), np.sin(3))), np.array((-np.sin(3), np.cos(3)))
    scene.add_body(None, mass=1.0, position=tuple(along), velocity=tuple(across), name="bead")
    turned = "atan2(y(position_a), x(position_a)) - 3[rad] - 1[rad/s]*time"
    scene.add_joint(t2.Equation(f"{factor}*({turned})"), "bead")
    run = t2.simulate(scene, duration=2.0, times=[0.0, 0.1, 0.2, 1.0, 2.0], **way)
    angle = 3.0 + run.times
    true = np.cosh(run.times) * np.stack((np.cos(angle), np.sin(angle)))
    assert np.abs(run.position[:, 0].T - true).max() <= within
    assert run.reactions is not None
    assert run.reactions.separation.max() <= 1e-9
