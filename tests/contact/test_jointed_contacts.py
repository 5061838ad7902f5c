"""Mechanisms that rub, roll and rest on what they meet, located: answers known from outside."""

import math
import random

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import tamias2d as t2

G = 9.81
EXACT = t2.Dop853(rtol=1e-11, atol=1e-13)


def floor(scene: t2.Scene, friction: float, restitution: float = 0.0) -> None:
    normal = (0.0, 1.0)
    scene.add_static(
        t2.HalfPlane(normal=normal, offset=0.0), friction=friction, restitution=restitution
    )


def cart(slope: float, **motor: float) -> t2.Scene:
    """A frame of 4 kg on two discs of 1 kg and .3 m, which may be driven."""
    scene = t2.Scene(gravity=(G * math.sin(slope), -G * math.cos(slope)))
    floor(scene, 1.0)
    scene.add_body(None, mass=4.0, inertia=1.0, position=(0.0, 0.5), name="frame")
    for k, x in enumerate((-0.8, 0.8)):
        disc = t2.Disc(radius=0.3)
        scene.add_body(disc, mass=1.0, position=(x, 0.3), friction=1.0, restitution=0.0)
        drive = t2.Motor(speed=motor["speed"]) if motor and k == 0 else None
        scene.add_joint(t2.Revolute(motor=drive), "frame", 2 + k, at=(x, 0.3))
    return scene


def test_a_cart_rolls_down_a_slope_as_its_wheels_say() -> None:
    """Energy: each wheel counts as one and a half of its mass."""
    run = t2.simulate(cart(0.3), duration=2.0, method=EXACT)
    assert len(run.impacts) == 0
    pull = G * math.sin(0.3) * 6 / 7
    np.testing.assert_allclose(run.position[-1, 1], (pull * 2, 0.5), rtol=0, atol=1e-12)
    np.testing.assert_allclose(run.angular_velocity[-1, 2:], -pull * 2 / 0.3, rtol=1e-12)
    np.testing.assert_allclose(run.energy, run.energy[0], rtol=1e-12)


def test_a_driven_cart_goes_as_fast_as_its_wheel_turns() -> None:
    scene = cart(0.0, speed=-5.0)
    run = t2.simulate(scene, duration=1.0, method=EXACT)
    np.testing.assert_allclose(run.velocity[-1, 1], (0.3 * 5.0, 0.0), rtol=0, atol=1e-9)


@pytest.mark.parametrize("friction", [0.0, 0.9])
def test_a_ladder_slides_down_as_lagrange_says(friction: float) -> None:
    """A rod of 2 kg and 1 m along a wall above, and on a disc of 1 kg on the floor below."""
    scene = t2.Scene(gravity=(0.0, -G))
    floor(scene, friction)
    tilt = 0.5  # from upright
    foot, top = (math.sin(tilt), 0.1), (0.0, math.cos(tilt) + 0.1)
    middle = ((foot[0] + top[0]) / 2, (foot[1] + top[1]) / 2)
    turned = math.atan2(top[1] - foot[1], top[0] - foot[0])
    scene.add_body(None, mass=2.0, inertia=2 / 12, position=middle, orientation=turned, name="rod")
    scene.add_body(t2.Disc(radius=0.1), mass=1.0, position=foot, friction=friction, restitution=0.0)
    scene.add_joint(t2.Groove(axis=(0, 1)), (0, 0), "rod", other_anchor=(0.5, 0.0))
    scene.add_joint(t2.Revolute(), "rod", 2, at=foot)
    rolling = 1.0 if friction == 0 else 1.5  # kg

    def rates(_: float, y: np.ndarray) -> list[float]:
        angle, rate = y
        c, s = math.cos(angle), math.sin(angle)
        inertia = 2 / 3 + rolling * c * c
        return [rate, (2 * G / 2 * s + rolling * c * s * rate**2) / inertia]

    wanted = solve_ivp(rates, (0, 0.4), [tilt, 0.0], rtol=1e-13, atol=1e-14).y[0, -1]
    run = t2.simulate(scene, duration=0.4, method=EXACT)
    np.testing.assert_allclose(run.position[-1, 2], (math.sin(wanted), 0.1), rtol=0, atol=1e-11)


def test_a_box_that_is_pulled_by_a_rod_rubs() -> None:
    """F - mu (m + m') g = (m + m') a, on the level."""
    scene = t2.Scene(gravity=(0.0, -G))
    floor(scene, 0.2)
    box = t2.Box(width=1.0, height=0.2)
    for x, mass, force in ((0.0, 2.0, 0.0), (3.0, 3.0, 20.0)):
        scene.add_body(
            box, mass=mass, position=(x, 0.1), force=(force, 0.0), friction=0.2, restitution=0.0
        )
    scene.add_joint(t2.Distance(), 1, 2)
    run = t2.simulate(scene, duration=1.0, method=EXACT)
    way = (20.0 - 0.2 * 5 * G) / 5 / 2
    np.testing.assert_allclose(run.position[-1, 1:], [(way, 0.1), (3 + way, 0.1)], atol=1e-12)


@pytest.mark.parametrize("share", [0.98, 1.02])
def test_two_rods_that_lean_on_each_other_stand_if_friction_suffices(share: float) -> None:
    """Moments about the hinge at the top: the floor pushes inwards by W L sin/2/(L cos + r)."""
    tilt, length, radius = 0.4, 1.0, 0.05
    least = length * math.sin(tilt) / 2 / (length * math.cos(tilt) + radius)
    scene = t2.Scene(gravity=(0.0, -G))
    floor(scene, share * least)
    apex = (0.0, radius + length * math.cos(tilt))
    for side in (-1, 1):
        place = (side * length / 2 * math.sin(tilt), radius + length / 2 * math.cos(tilt))
        scene.add_body(
            t2.Capsule(length=length, radius=radius),
            mass=1.0,
            position=place,
            orientation=math.pi / 2 + side * tilt,
            friction=share * least,
            restitution=0.0,
        )
    scene.add_joint(t2.Revolute(), 1, 2, at=apex)
    run = t2.simulate(scene, duration=0.3, method=EXACT)
    fallen = apex[1] - radius - length * math.cos(tilt) + run.position[0, 1, 1]
    moved = np.abs(run.position[-1] - run.position[0]).max()
    assert fallen > 0
    assert moved < 1e-14 if share > 1 else moved > 1e-4


def free_rods(seed: int) -> t2.Scene:
    """Two to four rods on hinges that are thrown at a rough floor, without gravity."""
    rng = random.Random(seed)
    scene = t2.Scene(gravity=(0.0, 0.0))
    floor(scene, rng.choice((0.1, 0.4, 1.5)), rng.choice((0.0, 0.5, 1.0)))
    count, turned, velocity = rng.randint(2, 4), rng.uniform(0.2, 1.3), (rng.uniform(-2, 2), -1.0)
    c, s = math.cos(turned), math.sin(turned)
    for k in range(count):
        scene.add_body(
            t2.Capsule(length=0.8, radius=0.05),
            mass=rng.uniform(0.5, 3.0),
            position=(k * c, 0.7 + k * s),
            orientation=turned,
            velocity=velocity,
            friction=scene.bodies[0].friction,
            restitution=scene.bodies[0].restitution,
        )
        if k:
            scene.add_joint(t2.Revolute(), k, k + 1, at=((k - 0.5) * c, 0.7 + (k - 0.5) * s))
    return scene


@pytest.mark.parametrize("seed", range(20))
def test_what_strikes_a_rough_floor_keeps_its_moment_about_the_point(seed: int) -> None:
    """The impulse passes through it, within the cone of friction, and makes no energy."""
    scene = free_rods(seed)
    met = t2.simulate(scene, duration=1.0, method=EXACT).impacts
    time, (x, y) = float(met.time[0]), met.point[0]
    near = [time - 1e-7, time]
    run = t2.simulate(scene, duration=1.0, times=near, method=EXACT)
    mass = np.array([body.mass for body in scene.bodies[1:]])
    inertia = np.array([body.inertia for body in scene.bodies[1:]])
    arms = run.position[:, 1:] - (x, y)
    cross = arms[..., 0] * run.velocity[:, 1:, 1] - arms[..., 1] * run.velocity[:, 1:, 0]
    moment = cross @ mass + run.angular_velocity[:, 1:] @ inertia
    assert moment[1] == pytest.approx(moment[0], abs=1e-6)  # of 1e-7 s before it
    change = mass @ (run.velocity[1, 1:] - run.velocity[0, 1:])
    friction = scene.friction(0, 1)
    assert change[1] == pytest.approx(met.impulse[np.isclose(met.time, time)].sum(), abs=1e-6)
    assert abs(change[0]) <= friction * change[1] + 1e-6
    assert run.energy[1] <= run.energy[0] * (1 + 1e-12)


def test_a_hinged_rod_that_strikes_a_rough_wall_turns_back_by_the_restitution() -> None:
    """It has one freedom: what friction takes, the hinge gives back (IM9)."""
    scene = t2.Scene(gravity=(0.0, 0.0))
    scene.add_static(t2.HalfPlane(normal=(-1.0, 0.0), offset=-0.5), friction=0.5, restitution=0.6)
    scene.add_body(
        t2.Capsule(length=1.0, radius=0.05),
        mass=2.0,
        position=(0.0, -0.5),
        orientation=-math.pi / 2,
        velocity=(0.5, 0.0),
        angular_velocity=1.0,
        friction=0.5,
        restitution=0.6,
    )
    scene.add_joint(t2.Revolute(), (0.0, 0.0), 1, at=(0.0, 0.0))
    run = t2.simulate(scene, duration=1.0, method=EXACT)
    assert len(run.impacts) == 1
    assert run.angular_velocity[-1, 1] == pytest.approx(-0.6, rel=1e-12)


def fallen_chain(seed: int) -> t2.Scene:
    """Two to four boxes on hinges that fall on a rough floor."""
    rng = np.random.default_rng(seed)
    scene = t2.Scene(gravity=(0.0, -G))
    count, friction = int(rng.integers(2, 5)), float(rng.choice([0.0, 0.3, 0.8]))
    floor(scene, friction)
    length, width, turned = rng.uniform(0.3, 1), rng.uniform(0.1, 0.25), rng.uniform(-1, 1)
    high, c, s = rng.uniform(0.2, 0.5) + count * length, math.cos(turned), math.sin(turned)
    box = t2.Box(width=length, height=width)
    for k in range(count):
        place = (k * length * c, high + k * length * s)
        scene.add_body(
            box,
            mass=rng.uniform(0.5, 2),
            position=place,
            orientation=turned,
            friction=friction,
            restitution=0.0,
        )
        if k:
            at = ((k - 0.5) * length * c, high + (k - 0.5) * length * s)
            scene.add_joint(t2.Revolute(), k, k + 1, at=at)
    return scene


@pytest.mark.parametrize("seed", range(8))
def test_a_chain_that_falls_on_a_rough_floor_comes_to_rest_on_it(seed: int) -> None:
    scene = fallen_chain(seed)
    try:
        run = t2.simulate(scene, duration=1.5, method=EXACT, work_limit=3000)
    except t2.SimulationError as refusal:  # the laws of rigid bodies leave it open
        run = refusal.run  # type: ignore[attr-defined]
    assert len(run.times) > 20
    energy = run.energy
    assert np.diff(energy).max() <= 1e-10 * energy[0]
    assert run.reactions.separation.max() < 1e-12
    for k, body in enumerate(scene.bodies[1:], 1):
        box = body.shape
        assert isinstance(box, t2.Box)
        turned = run.orientation[:, k]
        reach = (np.abs(np.sin(turned)) * box.width + np.abs(np.cos(turned)) * box.height) / 2
        assert (run.position[:, k, 1] - reach).min() > -1e-9


def balls_on_a_rod_at_its_limit() -> t2.Scene:
    """Two balls that meet a rod at one instant, beside its hinge; it leans on a stop."""
    scene = t2.Scene(gravity=(0.0, -G))
    scene.add_body(
        t2.Box(width=2.0, height=0.1), mass=1.0, position=(0.5, 0.0), friction=0.0, restitution=0.5
    )
    stop = t2.Limits(lower=0.0, upper=1.0, restitution=0.0)
    scene.add_joint(t2.Revolute(limits=stop), (0.0, 0.0), 0, at=(0.0, 0.0), name="hinge")
    for x in (0.5, 1.0):
        scene.add_body(
            t2.Disc(radius=0.1), mass=1.0, position=(x, 0.5), friction=0.0, restitution=0.5
        )
    return scene


def test_balls_that_meet_a_rod_at_its_limit_together_are_stepped_where_nothing_else_is_asked() -> (
    None
):
    scene = balls_on_a_rod_at_its_limit()
    with pytest.raises(t2.JointError, match=r"joint 'hinge' at .* at its limit .*R13"):
        t2.simulate(scene, duration=0.5, method=EXACT)
    run = t2.simulate(scene, duration=0.5)
    assert run.method == t2.Stepped()
    assert "joint 'hinge'" in run.notes[0]


def test_one_that_touches_nothing_goes_on_beside_those_that_do_and_act_on_it() -> None:
    """Its path, too, ends where contacts of a mechanism change that attracts it."""
    scene = t2.Scene(gravity=(0, -G))
    scene.add_body(None, mass=0.7, inertia=0.03, position=(-2.4, 2.3), velocity=(-0.06, -0.58))
    corners = [(0.26, 0.139), (0.084, 0.283), (-0.295, -0.0047), (-0.0736, -0.286), (0.147, -0.256)]
    scene.add_body(
        t2.Polygon(vertices=corners), mass=0.915, position=(-0.673, 0.811), orientation=0.852,
        velocity=(0.972, 0.474), angular_velocity=0.875, restitution=0.8, friction=0, name="flung",
    )  # fmt: skip
    hung = t2.Capsule(length=0.498, radius=0.192)
    scene.add_body(
        hung, mass=1.129, position=(0.908, 2.3), orientation=-0.384, restitution=0.3, friction=0,
        name="hung",
    )  # fmt: skip
    scene.add_spring(
        "flung", "hung", stiffness=25.8, rest_length=0.496, damping=0, anchor=(-0.0439, 0.0562),
        other_anchor=(0.0742, -0.183),
    )  # fmt: skip
    scene.add_joint(t2.Distance(), "hung", (0.965, 3.3))
    scene.add_attraction(gravitational_constant=0.1225)
    run = t2.simulate(scene, duration=0.8, times=np.linspace(0, 0.8, 81))
    assert "'flung' and 'hung' stay in contact" in run.notes[-1]
    last = run.energy[run.times > run.impacts.time[-1]]
    assert len(last) > 10
    assert np.ptp(last) < 1e-9 * np.ptp(run.energy)  # nothing rubs
