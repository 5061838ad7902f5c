"""Joints in scenes and scene files: what is refused, where, and what comes back."""

import re
from collections.abc import Callable

import pytest

import tamias2d as t2
from tamias2d.errors import InputError, SceneError
from tamias2d.scene import Scene


def scene() -> Scene:
    made = Scene(gravity=(0, -9.81))
    made.add_body(t2.Box(width=1, height=0.1), mass=1, position=(0.5, 0), name="rod")
    made.add_body(t2.Disc(radius=0.2), mass=1, position=(2, 0), name="wheel")
    made.add_body(None, mass=1, position=(0, 3), name="bob")
    made.add_static(t2.Disc(radius=0.1), position=(0, -5), name="post")
    made.add_static(t2.Disc(radius=0.1), position=(1, -5), name="stake")
    made.add_kinematic(t2.Disc(radius=0.1), position=(9, 0), name="lift")
    return made


BAD: dict[str, tuple[Callable[[Scene], object], str]] = {
    "anchors that do not fit": (
        lambda s: s.add_joint(t2.Revolute(), "rod", (0.1, 0), anchor=(-0.5, 0)),
        "does not hold at the start: it is off by 0.1 m",
    ),
    "a body with itself": (lambda s: s.add_joint(t2.Weld(), "rod", "rod"), "'rod' to itself"),
    "two statics": (
        lambda s: s.add_joint(t2.Distance(), "post", "stake"),
        "it holds no body that moves",
    ),
    "two points": (lambda s: s.add_joint(t2.Distance(), (0, 0), (1, 0)), "no body that moves"),
    "an equation with a kinematic body": (
        lambda s: s.add_joint(
            t2.Equation("phi1(orientation_a - y(position_b)/1[m])"), "rod", "lift"
        ),
        "is kinematic, which only steps know",
    ),
    "a length that is another": (
        lambda s: s.add_joint(t2.Distance(length=1), "rod", "wheel"),
        "off by 0.5 m",
    ),
    "a length of zero": (lambda _: t2.Distance(length=0), r"length 0 m of a distance joint: must"),
    "no distance at all": (
        lambda s: s.add_joint(t2.Distance(), "rod", (0.5, 0)),
        "no finite derivative at the start",
    ),
    "an axis of zero": (lambda _: t2.Groove(axis=(0, 0)), "has no direction"),
    "a ratio of zero": (lambda _: t2.Gear(ratio=0), "ratio 0 of a gear: must not be 0"),
    "one post": (lambda _: t2.Pulley(posts=[(0, 0)]), "posts of a pulley: found 1"),
    "an angle without inertia": (
        lambda s: s.add_joint(t2.Weld(), "bob", (0, 3)),
        "'bob' has no inertia, and the joint would turn it",
    ),
    "an anchor of the plane": (
        lambda s: s.add_joint(t2.Revolute(), "rod", (0, 0), anchor=(-0.5, 0), other_anchor=(1, 0)),
        "a point of the plane has none",
    ),
    "no kind": (lambda s: s.add_joint(t2.Revolute, "rod", "wheel"), "must be a kind of joint"),
    "no such body": (lambda s: s.add_joint(t2.Revolute(), "rod", "well"), "the scene has none"),
    "a name twice": (
        lambda s: [s.add_joint(t2.Distance(), "rod", "wheel", name="x") for _ in "ab"],
        "be no other joint's",
    ),
    "a wrong unit": (
        lambda s: s.add_joint(t2.Equation("x(position_a) - 1[s]"), "rod"),
        r"'1\[s\]' is a scalar in s.*column 1",
    ),
    "a name that is no place": (
        lambda s: s.add_joint(t2.Equation("x(velocity_a) - 1[m/s]"), "rod"),
        "'velocity_a' is no place of a body",
    ),
    "a name that is mistyped": (
        lambda s: s.add_joint(t2.Equation("x(positon_a) - 1[m]"), "rod"),
        "'positon_a' is no place of a body; did you mean 'position_a'",
    ),
    "an equation of nothing": (
        lambda s: s.add_joint(t2.Equation("time - 1[s]"), "rod"),
        "holds no body",
    ),
    "an equation of a third body that is not given": (
        lambda s: s.add_joint(
            t2.Equation("x(position_b) - x(position_c) - 1[m]"), (0, 0), "wheel", name="own"
        ),
        "joint 'own': its equation asks where body C is, and no third body is given",
    ),
    "an equation of an anchor of no third body": (
        lambda s: s.add_joint(t2.Equation("x(point_a - point_c) - 1[m]"), "wheel"),
        "asks where body C is, and no third body is given",
    ),
    "an equation without derivative": (
        lambda s: s.add_joint(t2.Equation("abs(x(position_a)) - 0.5[m]"), "rod"),
        "abs has no derivative",
    ),
    "an equation without finite derivative": (
        lambda s: s.add_joint(t2.Equation("sqrt(x(position_a) - 0.5[m])"), "rod"),
        "no finite derivative at the start",
    ),
    "an equation without slope": (
        lambda s: s.add_joint(t2.Equation("(x(position_a) - 0.5[m])**2"), "rod"),
        "does not change with any place",
    ),
    "a drive that starts with a jerk": (
        lambda s: s.add_joint(t2.Equation("orientation_a - 3[rad/s]*time"), "wheel"),
        "the velocities at the start tear it: it is left at -3 rad/s",
    ),
    "limits that are crossed": (
        lambda s: hinged(s, limits=t2.Limits(lower=1, upper=-1, restitution=0)),
        "limits of joint 'joint0': lower 1 is not below upper -1",
    ),
    "a start beyond the limits": (
        lambda s: hinged(s, limits=t2.Limits(lower=0.1, restitution=0)),
        r"its angle is 0 rad at the start, beyond them \(0.1 to any rad\)",
    ),
    "limits of nothing": (
        lambda s: hinged(s, limits=t2.Limits(restitution=0)),
        "limits of joint 'joint0': found none",
    ),
    "no limits": (lambda s: hinged(s, limits=(0, 1)), r"must be one .*Give Limits\(lower="),
    "a restitution above one": (
        lambda s: hinged(s, limits=t2.Limits(lower=-1, restitution=1.5)),
        "restitution 1.5 of limits of joint 'joint0': must be",
    ),
    "a rope of no length": (
        lambda s: s.add_joint(
            t2.Distance(limits=t2.Limits(upper=0, restitution=0)), "rod", "wheel"
        ),
        "upper 0 m: a distance is positive",
    ),
    "a rod with limits": (
        lambda _: t2.Distance(length=1.5, limits=t2.Limits(upper=2, restitution=0)),
        "length 1.5 m of a distance joint: what is kept has no limits",
    ),
    "a rope whose ends are at one place": (
        lambda s: s.add_joint(
            t2.Distance(limits=t2.Limits(upper=1, restitution=0)), "rod", (0.5, 0)
        ),
        "no finite derivative at the start",
    ),
    "a spring of no stiffness": (
        lambda s: hinged(s, spring=t2.JointSpring(stiffness=0)),
        "stiffness 0 N.m/rad of spring of joint 'joint0': must be > 0",
    ),
    "a spring of negative damping": (
        lambda s: hinged(s, spring=t2.JointSpring(stiffness=1, damping=-1)),
        "damping -1 N.m.s/rad of spring of joint 'joint0': must be >= 0",
    ),
    "a spring of no force": (
        lambda s: hinged(s, spring=t2.JointSpring(stiffness=1, maximum=0)),
        "maximum 0 N.m of spring of joint 'joint0': must be > 0",
    ),
    "a spring of a negative force": (
        lambda s: s.add_joint(
            t2.Target(spring=t2.JointSpring(stiffness=1, maximum=-2)), (0, 0), "rod"
        ),
        "maximum -2 N of spring of joint 'joint0': must be > 0",
    ),
    "a spring without a finite force": (
        lambda s: hinged(s, spring=t2.JointSpring(stiffness=1, maximum=float("nan"))),
        "maximum of spring of joint 'joint0': found nan: must be finite",
    ),
    "a target of neither stiffness nor damping": (
        lambda s: s.add_joint(
            t2.Target(spring=t2.JointSpring(stiffness=0, maximum=2)), (0, 0), "rod"
        ),
        "stiffness 0 N/m of spring of joint 'joint0': must be > 0, or its damping",
    ),
    "a motor of no torque": (
        lambda s: hinged(s, motor=t2.Motor(speed=1, maximum=0)),
        "maximum 0 N.m of motor of joint 'joint0': must be > 0",
    ),
    "a motor without a finite speed": (
        lambda s: hinged(s, motor=t2.Motor(speed=float("nan"), maximum=1)),
        "speed of motor of joint 'joint0': found nan: must be finite",
    ),
    "an angle of which nothing is said": (
        lambda s: s.add_joint(t2.Rotary(), "rod", "wheel"),
        "joint 'joint0': nothing is said of the angle",
    ),
    "a ratchet without teeth": (
        lambda s: s.add_joint(t2.Ratchet(pitch=0, restitution=0), "rod", "wheel"),
        "pitch 0 rad of joint 'joint0': must be > 0",
    ),
    "a joint that bears nothing": (
        lambda s: hinged(s, bears=0),
        "break force 0 N of joint 'joint0': must be > 0",
    ),
    "a torque that a hinge never exerts": (
        lambda s: s.add_joint(t2.Revolute(), (0, 0), "rod", other_anchor=(-0.5, 0), break_torque=1),
        "break_torque of joint 'joint0': one of kind revolute exerts no torque",
    ),
    "a torque that a rope never exerts": (
        lambda s: s.add_joint(
            t2.Distance(limits=t2.Limits(upper=9, restitution=0)), (0, 0), "bob", break_torque=1
        ),
        "one of kind distance exerts no torque",
    ),
    "a torque that a pulley never exerts": (
        lambda s: s.add_joint(
            *(t2.Pulley(posts=[(0, 3), (1, 3)]), "rod", "bob"), break_force=1, break_torque=1
        ),
        "one of kind pulley exerts no torque",
    ),
    "a force that a gear never exerts": (
        lambda s: s.add_joint(t2.Gear(ratio=2), "rod", (0, 0), break_force=1),
        "break_force of joint 'joint0': one of kind gear exerts no force.*break_torque in N m",
    ),
    "a force that a ratchet never exerts": (
        lambda s: s.add_joint(t2.Ratchet(pitch=1, restitution=0), (0, 0), "rod", break_force=1),
        "one of kind ratchet exerts no force",
    ),
    "a spring in what may break": (
        lambda s: hinged(s, bears=1, spring=t2.JointSpring(stiffness=1)),
        "has a spring and may break",
    ),
    "an angle of a body without inertia": (
        lambda s: s.add_joint(t2.Rotary(motor=t2.Motor(speed=1)), "bob", "rod"),
        "'bob' has no inertia",
    ),
}


def hinged(made: Scene, *, bears: float | None = None, **said: object) -> None:
    made.add_joint(
        t2.Revolute(**said),  # type: ignore[arg-type]
        *((0, 0), "rod"),
        other_anchor=(-0.5, 0),
        break_force=bears,
    )


@pytest.mark.parametrize("what", BAD)
def test_a_bad_joint_is_refused_by_name(what: str) -> None:
    add, message = BAD[what]
    with pytest.raises(InputError, match=message):
        add(scene())


FILE = """gravity: [0 m/s^2, -9.81 m/s^2]
bodies:
  rod: {shape: box, width: 1 m, height: 10 cm, mass: 1 kg, position: [0.5 m, 0 m]}
joints:
  - kind: revolute
    between: [rod, [0 m, 0 m]]
    anchor: [-0.5 m, 0 m]
"""


@pytest.mark.parametrize(
    ("old", "new", "place", "message"),
    [
        ("kind: revolute", "kind: revolut", "5:11", "did you mean 'revolute'"),
        ("[0 m, 0 m]]", "[0 m, 0 s]]", "6:26", "must be in m"),
        ("[rod,", "[rot,", "6:15", "the scene has none such"),
        ("anchor: [-0.5 m", "anchor: [-0.4 m", "6:14", "off by 0.1 m"),
        ("anchor:", "ankor:", "7:5", "did you mean 'anchor'"),
        ("    anchor", "    length: 1 m\n    anchor", "7:5", "key 'length' of a joint of kind rev"),
        (", [0 m, 0 m]]", "]", "6:14", "found 1 ends"),
        (
            "kind: revolute",
            "kind: equation\n    equation: x(position_a) - 1[s]",
            "6:15",
            "'1[s]' is a scalar in s",
        ),
        (
            "kind: revolute",
            "kind: equation\n    equation: x(position_a) - x(position_c)",
            "6:15",
            "asks where body C is, and no third body is given",
        ),
        (
            "    anchor",
            "    limits: {lower: 1 rad, upper: 0 rad, restitution: 0}\n    anchor",
            "7:21",
            "lower 1 is not below upper 0",
        ),
        ("    anchor", "    motor: {speed: 1 m}\n    anchor", "7:20", "must be in s^-1"),
        (
            "    anchor",
            "    spring: {rest: 0 rad}\n    anchor",
            "7:5",
            "key 'stiffness' is missing",
        ),
        ("    anchor", "    break_torque: 0 N*m\n    anchor", "7:19", "must be > 0"),
        ("    anchor", "    break_torque: 1 N*m\n    anchor", "7:19", "exerts no torque"),
        ("    anchor", "    limits: {lowest: 0 rad}\n    anchor", "7:14", "lower"),
    ],
)
def test_a_bad_joint_in_a_file_has_its_place(old: str, new: str, place: str, message: str) -> None:
    with pytest.raises(SceneError) as caught:
        t2.load(FILE.replace(old, new))
    assert str(caught.value).startswith(f"scene:{place}: "), caught.value
    assert message in str(caught.value)


def test_joints_of_all_kinds_come_back_from_their_text_to_the_last_bit() -> None:
    made = Scene(gravity=(0, -9.81), name="all")
    for k in range(4):
        made.add_body(
            t2.Disc(radius=0.1), mass=1, position=(k / 3, 0.1), orientation=k / 7, name=f"b {k}"
        )
    made.add_joint(t2.Revolute(), "b 0", (0, 0.1))
    made.add_joint(t2.Distance(), "b 0", "b 1", anchor=(0.01, 0.02), other_anchor=(-0.1, 0))
    made.add_joint(t2.Gear(ratio=-1 / 3), "b 0", "b 1", third="b 2", collide=True)
    made.add_joint(t2.Prismatic(axis=(1, 3)), (2 / 3, 0.1), "b 2")
    made.add_joint(t2.Groove(axis=(0.3, 0.1)), (1, 0.1), "b 3", name="slot")
    made.add_joint(
        t2.Pulley(posts=[(0, 3), (1, 3)], ratio=1.5), "b 1", "b 3", third="b 2", third_anchor=(0, 1)
    )
    made.add_joint(t2.Weld(), "b 3", (1, 0.1))
    made.add_joint(t2.Target(spring=t2.JointSpring(stiffness=1 / 3)), (2, 1), "b 3")
    limits = t2.Limits(lower=-1 / 3, upper=2 / 3, restitution=0.1)
    motor = t2.Motor(speed=1 / 3, maximum=1 / 7)
    made.add_joint(t2.Target(spring=t2.JointSpring(stiffness=0, damping=9, maximum=1)), (1, 1), 2)
    spring = t2.JointSpring(stiffness=1 / 3, damping=1 / 7, maximum=2 / 3)
    made.add_joint(t2.Rotary(limits=limits, motor=motor, spring=spring), "b 0", "b 1")
    made.add_joint(t2.Distance(limits=t2.Limits(upper=7 / 3, restitution=0)), "b 0", "b 2")
    made.add_joint(t2.Ratchet(pitch=1 / 3, restitution=0.5), "b 1", "b 2")
    made.add_joint(
        t2.Wheel(axis=(0, 1), spring=spring, limits=limits, motor=motor), (2 / 3, 0.1), "b 2"
    )
    made.add_joint(
        t2.Revolute(motor=t2.Motor(speed=0.5, maximum=1)), (0, 0.1), "b 0", break_force=1 / 3,
        break_torque=1 / 7,
    )  # fmt: skip
    made.add_joint(t2.Prismatic(axis=(1, 0), limits=limits), (1, 0.1), "b 3")
    made.add_joint(t2.Equation(["x(point_a - point_b) + 1/3*1[m]"]), "b 0", "b 1", anchor=(0, 0))
    again = t2.load(t2.scene_text(made))
    assert again == made
    assert again.digest() == made.digest()
    assert not re.search(r"joints", t2.scene_text(scene()))


def test_what_is_not_given_is_as_at_the_start() -> None:
    made = scene()
    made.add_joint(t2.Distance(), "rod", "wheel")
    made.add_joint(t2.Gear(ratio=2), "rod", "wheel", name="gear")
    assert dict(made.joints[0].parameters) == {"joint_length": 1.5}
    assert dict(made.joints[1].parameters)["joint_angle"] == 0
    assert made.joints[1].name == "gear"
    assert not made.collides(0, 1)
    assert made.collides(0, 3)


@pytest.mark.parametrize("speed", [1e-300, 6.5e-45, 1e-14])
def test_what_rounding_leaves_of_rest_tears_no_joint(speed: float) -> None:
    made = Scene(gravity=(0, -9.81))
    made.add_body(t2.Disc(radius=0.1), mass=1, position=(2, 0), velocity=(speed, 0))
    made.add_joint(t2.Weld(), (0, 0), 0, at=(0, 0))
    assert t2.simulate(made, duration=0.1, times=[0.1]).velocity[0, 0].tolist() == [0.0, 0.0]


def test_more_than_rounding_tears_a_joint() -> None:
    made = Scene(gravity=(0, -9.81))
    made.add_body(t2.Disc(radius=0.1), mass=1, position=(2, 0), velocity=(1e-13, 0))
    with pytest.raises(InputError, match=r"tear it: it is left at 1e-13 m/s"):
        made.add_joint(t2.Weld(), (0, 0), 0, at=(0, 0))
