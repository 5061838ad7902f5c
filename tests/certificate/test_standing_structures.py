"""What joints hold still stays where it is under loads that vary, by any method and tolerance.

What joints leave of the accelerations is rounding, which no step may be chosen by.
"""

import math

import numpy as np
import pytest

import tamias2d as t2

TOLERANCES = (1e-3, 1e-6, 1e-9)


def truss() -> t2.Scene:
    """Return a point that two rods hold."""
    scene = t2.Scene(gravity=(0.0, -9.81))
    push = ("3[N]*sin(2[rad/s]*time)", 0.0)
    scene.add_body(None, mass=2.0, position=(0.37, 0.91), force=push, name="apex")
    scene.add_joint(t2.Distance(), (0.0, 0.0), "apex")
    scene.add_joint(t2.Distance(), (1.1, 0.2), "apex")
    return scene


def braked() -> t2.Scene:
    """Return an arm in air that a motor without speed holds."""
    scene = t2.Scene(gravity=(0.0, -9.81))
    scene.add_body(
        None, mass=2.7, inertia=0.84, position=(0.49, -0.06), orientation=-0.72,
        linear_drag=0.26, force=("0.43[N]*sin(3.2[rad/s]*time)", 0.0), name="arm",
    )  # fmt: skip
    cos, sin = math.cos(0.72), math.sin(0.72)
    held = cos * -0.79 - sin * -0.1, sin * -0.79 + cos * -0.1
    brake = t2.Revolute(motor=t2.Motor(speed=0.0))
    scene.add_joint(brake, (0.49 - 0.79, -0.06 - 0.1), "arm", other_anchor=held)
    return scene


def welded(force: str = "3[N]*sin(2[rad/s]*time)", drag: float = 0.25) -> t2.Scene:
    """Return two bodies that are welded to each other and to the plane."""
    scene = t2.Scene(gravity=(0.0, -9.81))
    for name, place in (("near", (0.1, 0.6)), ("far", (0.83, 0.41))):
        scene.add_body(
            None, mass=2.8, inertia=0.2, position=place, linear_drag=drag,
            force=(force, 0.0) if force else (0.0, 0.0), name=name,
        )  # fmt: skip
    scene.add_joint(t2.Weld(), (0.4, 0.2), "near", other_anchor=(0.3, -0.4))
    scene.add_joint(t2.Weld(), "near", "far", anchor=(0.31, 0.17), other_anchor=(-0.42, 0.36))
    return scene


SCENES = {"truss": truss, "braked": braked, "welded": welded, "weight": lambda: welded("", 0.0)}


@pytest.mark.parametrize("name", SCENES)
def test_it_stays_by_the_reference(name: str) -> None:
    """Steps follow the load, which changes in tenths of a second."""
    run = t2.simulate(SCENES[name](), duration=1.0)
    assert np.abs(run.position - run.position[0]).max() <= 1e-14
    assert run.cost is not None
    assert run.cost.steps <= 100


@pytest.mark.parametrize("name", SCENES)
@pytest.mark.parametrize("tolerance", TOLERANCES)
def test_it_stays_within_a_tolerance(name: str, tolerance: float) -> None:
    """Nothing is the scale of what does not move but 1 m."""
    run = t2.simulate(SCENES[name](), duration=1.0, tolerance=tolerance)
    assert np.abs(run.position - run.position[0]).max() <= 1e-14
    assert run.certificate is not None
    assert run.certificate.bound is not None
    assert run.certificate.bound <= tolerance
    assert "taken where nothing moves" in run.certificate.measure


def test_a_scheme_that_knows_no_joints_is_not_weighed() -> None:
    plan = t2.recommend(braked(), duration=1.0, tolerance=1e-6)
    assert not any(isinstance(one.method, t2.ExponentialDrag) for one in plan.estimates)
