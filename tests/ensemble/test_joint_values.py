"""The numbers of joints can vary, each by its name, and only that one."""

import math
from operator import attrgetter

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.ensemble.outline import outline_of, scene_of
from tamias2d.ensemble.places import place_at


def machine() -> t2.Scene:
    """Bodies in a row, each on a joint of another kind."""
    scene = t2.Scene(gravity=(0.0, -10.0))
    for k in range(7):
        scene.add_body(None, mass=1.0, inertia=1.0, position=(2.0 * k, 0.0), name=f"body{k}")
    limits = t2.Limits(lower=-1.0, upper=1.0, restitution=0.5)
    motor, spring = t2.Motor(speed=1.0), t2.JointSpring(stiffness=5.0, damping=0.1)
    hinge = t2.Revolute(limits=limits, motor=motor, spring=spring)
    scene.add_joint(hinge, (0.0, 0.0), "body0", name="hip.left")
    slide = t2.Prismatic(axis=(1.0, 0.0), motor=t2.Motor(speed=2.0, maximum=3.0))
    scene.add_joint(slide, (2.0, 0.0), "body1", name="slide", break_torque=50.0)
    scene.add_joint(t2.Distance(), (4.0, 1.0), "body2", name="rod", break_force=90.0)
    wheel = t2.Wheel(axis=(0.0, 1.0), spring=spring, motor=motor)
    scene.add_joint(wheel, (6.0, 0.0), "body3", name="wheel")
    scene.add_joint(t2.Target(spring=spring), (8.0, 0.0), "body4", name="hand")
    ratchet = t2.Ratchet(pitch=0.1, restitution=0.0)
    scene.add_joint(ratchet, (10.0, 0.0), "body5", name="ratchet")
    scene.add_joint(t2.Weld(), (12.0, 0.0), "body6", name="weld")
    return scene


def number(scene: t2.Scene, name: str, key: str, freedom: int | None) -> float | None:
    """Return a number of a joint, or of one of its freedoms."""
    (joint,) = (each for each in scene.joints if each.name == name)
    found: float | None = attrgetter(key)(joint if freedom is None else joint.freedoms[freedom])
    return found


@pytest.mark.parametrize(
    ("name", "key", "freedom", "value", "unit"),
    [
        ("hip.left", "limits.lower", 0, -2.0, "rad"),
        ("hip.left", "limits.upper", 0, 2.0, "rad"),
        ("hip.left", "limits.restitution", 0, 0.0, "1"),
        ("hip.left", "motor.speed", 0, 3.0, "rad/s"),
        ("hip.left", "motor.maximum", 0, 4.0, "N*m"),
        ("hip.left", "spring.stiffness", 0, 4.0, "N*m/rad"),
        ("hip.left", "spring.rest", 0, 0.4, "rad"),
        ("slide", "motor.speed", 0, 4.0, "m/s"),
        ("slide", "motor.maximum", 0, 4.0, "N"),
        ("slide", "break_torque", None, 4.0, "N*m"),
        ("rod", "break_force", None, 4.0, "N"),
        ("wheel", "spring.damping", 0, 4.0, "kg/s"),
        ("wheel", "motor.speed", 1, 4.0, "rad/s"),
        ("hand", "spring.stiffness", 0, 4.0, "N/m"),
        ("hand", "spring.stiffness", 1, 4.0, "N/m"),
    ],
)
def test_a_number_of_a_joint_is_found_and_changes_alone(
    name: str, key: str, freedom: int | None, value: float, unit: str
) -> None:
    scene = machine()
    outline = outline_of(scene)
    place = place_at(f"joints.{name}.{key}", outline)
    changed = scene_of(place.put(outline, value), scene)
    before = number(scene, name, key, freedom)
    assert number(changed, name, key, freedom) == value != before
    assert scene_of(place.put(outline_of(changed), before), scene) == scene
    assert place.symbol.unit == unit


def test_a_rod_is_longer_where_its_body_is_farther() -> None:
    vary = {"joints.rod.length": [1.0, 2.0], "bodies.body2.position.y": [0.0, -1.0]}
    sims = t2.Simulators(machine(), vary=vary)
    sims.step(10)
    rod = sims.joints.index("rod")
    assert np.abs(sims.reactions.separation[:, rod]).max() < 1e-9
    with pytest.raises(t2.InputError, match=r"world 1 .*'rod': it does not hold at the start"):
        t2.Simulators(machine(), vary={"joints.rod.length": [1.0, 2.0]})


def test_motors_drive_each_world_with_its_own_maximum() -> None:
    scene = t2.Scene(gravity=(0.0, 0.0))
    scene.add_body(None, mass=1.0, inertia=2.0, position=(0.0, 0.0), name="wheel")
    motor = t2.Motor(speed=100.0, maximum=1.0)
    scene.add_joint(t2.Revolute(motor=motor), (0.0, 0.0), "wheel", name="hip")
    sims = t2.Simulators(scene, vary={"joints.hip.motor.maximum": [1.0, "5 N*m", 10.0]})
    sims.step(60)
    np.testing.assert_allclose(sims.angular_velocity[:, 0], [0.5, 2.5, 5.0], rtol=1e-12)
    drawn = t2.ensemble(scene, duration=1.0, vary={"joints.hip.motor.speed": [0.1, 0.2]}, workers=1)
    assert drawn["joints.hip.motor.speed"].attrs["units"] == "rad/s"
    np.testing.assert_allclose(drawn.angular_velocity[:, -1, 0], [0.1, 0.2], atol=1e-6)


@pytest.mark.parametrize(
    ("path", "values", "message"),
    [
        ("joints.hip.left.motor.maximun", [1.0], "Did you mean 'joints.hip.left.motor.maximum'"),
        ("joints.hip.motor.maximum", [1.0], "Did you mean 'joints.hip.left.motor.maximum'"),
        ("joints.0.motor.maximum", [1.0], "the scene has no such place"),
        ("joints.hip.left.motor", [1.0], "the scene has no such place"),
        ("joints.hip.left.motor.measure", [1.0], "the scene has no such place"),
        ("joints.hand.spring.rest", [1.0], "the scene has no such place"),
        ("joints.ratchet.limits.restitution", [1.0], "the scene has no such place"),
        ("joints.hip.left.motor.maximum", [-1.0], r"found -1.0 N\*m for world 0: must be > 0"),
        ("joints.hip.left.limits.restitution", [2.0], r"must be in \[0, 1\]"),
        ("joints.hip.left.limits.lower", [1.5], "world 0 .* lower 1.5 is not below upper 1"),
        ("joints.hip.left.limits.lower", [math.nan], "must be finite"),
        ("joints.hip.left.limits.lower", [0.5], "world 0 .* its angle is 0 rad at the start"),
    ],
)
def test_what_no_joint_has_or_may_have_is_refused(
    path: str, values: list[float], message: str
) -> None:
    with pytest.raises(t2.InputError, match=message):
        t2.Simulators(machine(), vary={path: values})
