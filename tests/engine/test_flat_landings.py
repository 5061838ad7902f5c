"""What lands on several shapes at one instant meets them together (IM12, DD67), IM9 at each."""

import math

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.state import Array

GRAVITY = 9.81
ROUNDING = 1e-9  # of the speed: an impact is found by Newton's method, within that of its instant
GROUNDS = ("plane", "vertex", "tiles", "pillars", "legs")


def add_ground(scene: t2.Scene, ground: str, at: float, restitution: float) -> None:
    """Add a level ground at height 0 that a body a metre wide lands on."""
    law = {"restitution": restitution, "friction": 0.3}
    if ground in ("plane", "legs"):
        scene.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=0.0), **law)
    elif ground == "vertex":
        scene.add_static(t2.Chain(vertices=[(-4.0, 0.0), (at, 0.0), (4.0, 0.0)], loop=False), **law)
    elif ground == "tiles":
        for x in (at - 2.0, at + 2.0):
            scene.add_static(t2.Box(width=4.0, height=1.0), position=(x, -0.5), **law)
    else:
        for x in (-0.4, at, 0.45):
            scene.add_static(t2.Box(width=0.1, height=1.0), position=(x, -0.5), **law)


def body_on(ground: str) -> t2.Box | t2.Compound:
    """Return a body a metre wide, whose lowest points are 0.2 m below its centre."""
    if ground != "legs":
        return t2.Box(width=1.0, height=0.4)
    parts = [t2.Part(shape=t2.Box(width=0.1, height=0.4), position=(x, 0.0)) for x in (-0.45, 0.45)]
    return t2.Compound(parts=[*parts, t2.Part(shape=t2.Box(width=0.8, height=0.1))])


@pytest.mark.parametrize("time_step", [1 / 30, 1 / 240])
@pytest.mark.parametrize("restitution", [0.1, 0.6, 0.75, 1.0])
@pytest.mark.parametrize("ground", GROUNDS)
def test_a_flat_landing_rebounds_level(ground: str, restitution: float, time_step: float) -> None:
    """It leaves with the energy that its restitution leaves, and does not turn."""
    high, half = 1.3, 0.2
    scene = t2.Scene(gravity=(0.0, -GRAVITY))
    add_ground(scene, ground, 0.13, restitution)
    scene.add_body(
        body_on(ground), mass=1.0, position=(0.0, half + high), velocity=(0.0, 0.0),
        orientation=0.0, angular_velocity=0.0, restitution=restitution, friction=0.3,
    )  # fmt: skip
    sim = t2.Simulator(scene, time_step=time_step)
    while float(sim.velocity[-1, 1]) <= 0.0:
        sim.step()
    fast = math.sqrt(2 * GRAVITY * high)
    energy = float(sim.velocity[-1, 1]) ** 2 / 2 + GRAVITY * (float(sim.position[-1, 1]) - half)
    assert math.sqrt(2 * energy) == pytest.approx(restitution * fast, abs=ROUNDING * fast)
    assert abs(float(sim.angular_velocity[-1])) <= ROUNDING * fast / half
    assert abs(float(sim.velocity[-1, 0])) <= ROUNDING * fast


@pytest.mark.parametrize("steep", [0.3, 0.7, 1.1])
def test_a_disc_that_falls_into_a_groove_stays_there(steep: float) -> None:
    """Both sides stop it at once: nothing of its speed is left to go up one of them."""
    scene = t2.Scene(gravity=(0.0, -GRAVITY))
    for side in (-1.0, 1.0):
        normal = (side * math.sin(steep), math.cos(steep))
        scene.add_static(t2.HalfPlane(normal=normal, offset=0.0), restitution=0.0, friction=0.0)
    scene.add_body(
        t2.Disc(radius=0.3), mass=1.0, position=(0.0, 0.3 / math.cos(steep) + 1.0),
        velocity=(0.0, 0.0), orientation=0.0, angular_velocity=0.0, restitution=0.0, friction=0.0,
    )  # fmt: skip
    sim = t2.Simulator(scene, time_step=1 / 60)
    sim.step(30)
    soft = GRAVITY / 60  # what a contact may yield: gravity in a step
    assert np.abs(sim.velocity[-1]).max() < soft / 60


def least_energy_after(
    arm: Array, inverse_inertia: float, before: Array, restitution: float, friction: float
) -> Array:
    """Return vx, vy and spin of a body of 1 kg after a floor has met it at a point.

    Of all impulses that give the point its normal velocity, and obey Coulomb's law, the one that
    leaves the least energy (IM9).
    """
    inverse = np.diag([1.0, 1.0, inverse_inertia])
    along, up = np.array([1.0, 0.0, -arm[1]]), np.array([0.0, 1.0, arm[0]])
    drags = []

    def after(drag: float) -> tuple[float, Array]:
        wanted = -restitution * (up @ before) - up @ (before + inverse @ along * drag)
        push = wanted / (up @ inverse @ up)
        return push, before + inverse @ (along * drag + up * push)

    pushes = np.array([after(0.0)[0], after(1.0)[0]])
    for sign in (-1.0, 1.0):  # where the drag is the coefficient times the push
        slope = sign - friction * (pushes[1] - pushes[0])
        drags.append(friction * pushes[0] / slope if slope * sign > 0 else sign * math.inf)
    energy = [state @ np.linalg.inv(inverse) @ state for state in (after(d)[1] for d in (0, 1, 2))]
    curve = np.polyfit([0.0, 1.0, 2.0], energy, 2)
    return after(float(np.clip(-curve[1] / (2 * curve[0]), *drags)))[1]


@pytest.mark.parametrize("friction", [0.1, 0.6, 2.0])
@pytest.mark.parametrize("restitution", [0.0, 0.5, 0.9])
@pytest.mark.parametrize("tilt", [0.3, 0.8, 1.3])
def test_a_corner_leaves_a_rough_floor_as_its_equation_says(
    tilt: float, restitution: float, friction: float
) -> None:
    """Friction at a corner beside the centre changes the normal impulse with it (IM9)."""
    law = {"restitution": restitution, "friction": friction}
    before = np.array([3.0, -4.0, 1.5])
    half = np.array([0.5, 0.2])
    corners = np.array([[x, y] for x in (-half[0], half[0]) for y in (-half[1], half[1])])
    turn = np.array([[math.cos(tilt), -math.sin(tilt)], [math.sin(tilt), math.cos(tilt)]])
    arm = min((turn @ corner for corner in corners), key=lambda corner: float(corner[1]))
    scene = t2.Scene(gravity=(0.0, 0.0))
    scene.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=0.0), **law)
    scene.add_body(
        t2.Box(width=1.0, height=0.4), mass=1.0, position=(0.0, 1e-5 - float(arm[1])),
        velocity=(3.0, -4.0), orientation=tilt, angular_velocity=1.5, **law,
    )  # fmt: skip
    sim = t2.Simulator(scene, time_step=1e-5)
    sim.step(2)
    inverse_inertia = 12 / (1.0 + 0.4**2)
    found = np.array([*sim.velocity[-1], sim.angular_velocity[-1]])
    wanted = least_energy_after(arm, inverse_inertia, before, restitution, friction)
    turned = 1e-5 * 1.5 * 4  # the body goes on by so much until it meets the floor
    assert np.abs(found - wanted).max() < 10 * turned


def meeting_at_once(seed: int) -> t2.Scene:
    """Return bodies in a row that a long one meets at one instant."""
    rng = np.random.default_rng(seed)
    scene = t2.Scene(gravity=(0.0, 0.0))

    def law() -> dict[str, float]:
        mass = float(np.exp(rng.uniform(-2.5, 2.5)))
        return {"mass": mass, "restitution": float(rng.choice([0.0, 0.3, 0.6, 0.9, 1.0]))}

    friction, count = float(rng.choice([0.0, 0.1, 0.5, 1.5])), int(rng.integers(2, 5))
    across = float(rng.uniform(-3.0, 3.0))
    scene.add_body(
        t2.Box(width=4.0, height=0.2), position=(0.0, 1.0), velocity=(across, -4.0),
        orientation=0.0, angular_velocity=0.0, friction=friction, **law(),
    )  # fmt: skip
    for x in np.linspace(-1.6, 1.6, count).tolist():
        shape = t2.Box(width=0.3, height=0.4) if rng.random() < 0.6 else t2.Disc(radius=0.2)
        scene.add_body(
            shape, position=(x, 0.0), velocity=(0.0, 0.0), orientation=0.0,
            angular_velocity=0.0, friction=friction, **law(),
        )  # fmt: skip
    return scene


@pytest.mark.parametrize("seed", range(12))
def test_bodies_that_meet_at_once_keep_what_bodies_keep(seed: int) -> None:
    """Their momentum and angular momentum are those before, and they gain no energy."""
    scene = meeting_at_once(seed)
    sim = t2.Simulator(scene, time_step=1 / 60)
    mass = np.array([body.mass for body in scene.bodies])
    inertia = np.array([body.inertia for body in scene.bodies])

    def kept() -> tuple[Array, float]:
        place, velocity, spin = sim.position, sim.velocity, sim.angular_velocity
        about = place[:, 0] * velocity[:, 1] - place[:, 1] * velocity[:, 0]
        moments = [*(mass @ velocity), mass @ about + inertia @ spin]
        energy = mass @ (velocity**2).sum(axis=1) + inertia @ spin**2
        return np.array(moments), float(energy) / 2

    before, energy = kept()
    size = float(np.abs(before).max()) + mass[0] * 4.0
    for _ in range(16):
        sim.step()
        after, left = kept()
        assert np.abs(after - before).max() <= 1e-13 * size
        assert left <= energy * (1 + 1e-13)
        energy = left
    assert np.abs(sim.velocity[1:]).max() > 1e-3  # they did meet


@pytest.mark.parametrize("restitution", [0.1, 0.3, 0.6, 0.9])
def test_a_plank_flies_on_from_two_free_boxes_as_rigid_bodies_do(restitution: float) -> None:
    """All three are free: the step finds what the event-driven solution has (DD67)."""
    scene = t2.Scene(gravity=(0.0, 0.0))
    for width, high, mass, x, y, v in (
        (2.0, 0.2, 1.7, 0.0, 1.0, -5.0),
        (0.2, 0.4, 0.6, -0.7, 0.0, 0.0),
        (0.2, 0.4, 2.3, 0.4, 0.0, 0.0),
    ):
        scene.add_body(
            t2.Box(width=width, height=high), mass=mass, position=(x, y), velocity=(0.0, v),
            orientation=0.0, angular_velocity=0.0, restitution=restitution, friction=0.0,
        )  # fmt: skip
    sim = t2.Simulator(scene, time_step=1 / 60)
    sim.step(10)
    run = t2.simulate(scene, duration=10 / 60)
    assert np.abs(sim.velocity - run.velocity[-1]).max() < 1e-9 * 5
    assert np.abs(sim.angular_velocity - run.angular_velocity[-1]).max() < 1e-9 * 5


def test_a_box_that_is_struck_centrally_does_not_turn() -> None:
    """It stands on two corners, and both give back what restitution says."""
    law = {"restitution": 0.75, "friction": 0.3}
    scene = t2.Scene(gravity=(0.0, -GRAVITY))
    scene.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=0.0), **law)
    for width, mass, y in ((1.2, 1.0, 0.2), (2.0, 0.7, 1.3)):
        scene.add_body(
            t2.Box(width=width, height=0.4), mass=mass, position=(0.0, y), velocity=(0.0, 0.0),
            orientation=0.0, angular_velocity=0.0, **law,
        )  # fmt: skip
    sim = t2.Simulator(scene, time_step=1 / 240)
    sim.step(120)
    assert np.abs(sim.velocity[-1]).max() > 0.1
    assert np.abs(sim.angular_velocity).max() < 1e-5  # the solver visits each corner in turn
