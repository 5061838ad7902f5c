"""What joints exert while contacts last, located: closed forms, and Newton's law on each body."""

import math
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.record.difference import first_difference
from tests.contact.test_jointed_contacts import EXACT, G, cart, fallen_chain, floor

SIXTEEN = np.linspace(0, 0.5, 16)


def on_a_slope(friction: float) -> t2.Scene:
    """A box of 2 kg on a slope of .3 rad, which a rod holds at a place up the slope and above."""
    scene = t2.Scene(gravity=(G * math.sin(0.3), -G * math.cos(0.3)))
    floor(scene, friction)
    box = t2.Box(width=1.0, height=0.4)
    scene.add_body(box, mass=2.0, position=(0.0, 0.2), friction=friction, restitution=0.0)
    scene.add_joint(t2.Distance(), (-4.0, 3.2), 1)
    return scene


def test_a_rod_holds_a_box_on_a_smooth_slope() -> None:
    run = t2.simulate(on_a_slope(0.0), duration=0.5, times=SIXTEEN, method=EXACT)
    pull = 2 * G * math.sin(0.3) / 0.8  # the rod is 3, 4, 5
    np.testing.assert_allclose(run.reactions.force[:, 0, 1], [(-0.8 * pull, 0.6 * pull)] * 16)
    press = 2 * G * math.cos(0.3) - 0.6 * pull
    assert run.contact_force is not None
    np.testing.assert_allclose(run.contact_force[:, 1], [(0.0, press)] * 16, atol=1e-12)


@pytest.mark.parametrize("friction", [0.2, 0.5])
def test_of_a_rod_and_friction_that_hold_the_same_box_forces_are_in_balance(
    friction: float,
) -> None:
    """Friction of .5 would do alone; .2 not."""
    run = t2.simulate(on_a_slope(friction), duration=0.5, method=EXACT)
    assert run.contact_force is not None
    across, up = run.contact_force[-1, 1]
    assert abs(across) <= friction * up * (1 + 1e-12)
    total = run.contact_force[-1, 1] + run.reactions.force[-1, 0, 1]
    weight = (2 * G * math.sin(0.3), -2 * G * math.cos(0.3))
    np.testing.assert_allclose(total, np.negative(weight), rtol=1e-12)


def test_a_bob_that_lies_on_a_ledge_takes_its_weight_off_the_hinge() -> None:
    """A level rod of 1 m and 2 kg with a disc welded to its end: moments about the hinge."""
    scene = t2.Scene(gravity=(0.0, -G))
    scene.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=-0.1), friction=0.0, restitution=0.0)
    scene.add_body(None, mass=2.0, inertia=0.2, position=(0.5, 0.0), name="rod")
    scene.add_body(
        t2.Disc(radius=0.1), mass=3.0, position=(1.0, 0.0), friction=0.0, restitution=0.0
    )
    scene.add_joint(t2.Revolute(), (0.0, 0.0), "rod", at=(0.0, 0.0))
    scene.add_joint(t2.Weld(), "rod", 2, at=(1.0, 0.0))
    run = t2.simulate(scene, duration=0.5, method=EXACT)
    np.testing.assert_allclose(run.reactions.force[-1, 0, 1], (0.0, 2 * G / 2), atol=1e-12)
    np.testing.assert_allclose(run.reactions.force[-1, 1, 1], (0.0, -2 * G / 2), atol=1e-12)
    assert run.contact_force is not None
    np.testing.assert_allclose(run.contact_force[-1, 2], (0.0, 4 * G), atol=1e-12)


def test_hinges_of_a_cart_that_rolls_down_a_slope() -> None:
    """Newton's law of the frame, and the moments about its centre."""
    scene = cart(0.3)
    run = t2.simulate(scene, duration=0.5, times=SIXTEEN, method=EXACT)
    along = -4 * G * math.sin(0.3) / 7
    up, tilt = 4 * G * math.cos(0.3) / 2, -0.2 * along / 0.8 / 2
    wanted = [[(-along / 2, tilt - up)] * 16, [(-along / 2, -up - tilt)] * 16]
    np.testing.assert_allclose(run.reactions.force[:, :, 1].swapaxes(0, 1), wanted, rtol=1e-10)
    assert not any("reactions" in note for note in run.notes)


def test_two_rods_that_lean_on_each_other_press_their_hinge() -> None:
    """The floor pushes inwards by W L sin/2/(L cos + r)."""
    tilt, length, radius = 0.4, 1.0, 0.05
    push = G * length * math.sin(tilt) / 2 / (length * math.cos(tilt) + radius)
    scene = t2.Scene(gravity=(0.0, -G))
    floor(scene, 1.0)
    for side in (-1, 1):
        scene.add_body(
            t2.Capsule(length=length, radius=radius),
            mass=1.0,
            position=(side * length / 2 * math.sin(tilt), radius + length / 2 * math.cos(tilt)),
            orientation=math.pi / 2 + side * tilt,
            friction=1.0,
            restitution=0.0,
        )
    scene.add_joint(t2.Revolute(), 1, 2, at=(0.0, radius + length * math.cos(tilt)))
    run = t2.simulate(scene, duration=0.3, method=EXACT)
    np.testing.assert_allclose(run.reactions.force[-1, 0, :2], [(-push, 0), (push, 0)], atol=1e-9)
    assert run.contact_force is not None
    np.testing.assert_allclose(run.contact_force[-1, 1:], [(push, G), (-push, G)], atol=1e-9)


def test_a_rod_that_pulls_a_box_that_rubs() -> None:
    """It bears what its box takes of the force."""
    scene = t2.Scene(gravity=(0.0, -G))
    floor(scene, 0.2)
    box = t2.Box(width=1.0, height=0.2)
    for x, mass, force in ((0.0, 2.0, 0.0), (3.0, 3.0, 20.0)):
        scene.add_body(
            box, mass=mass, position=(x, 0.1), force=(force, 0.0), friction=0.2, restitution=0.0
        )
    scene.add_joint(t2.Distance(), 1, 2)
    run = t2.simulate(scene, duration=0.5, times=SIXTEEN, method=EXACT)
    np.testing.assert_allclose(run.reactions.force[:, 0, 0], [(8.0, 0.0)] * 16, atol=1e-11)


def missing(run: t2.Run) -> np.ndarray:
    """Return mass times acceleration less all forces (k, n, 3), in the middle of three samples."""
    scene, told = run.scene, run.reactions
    assert run.contact_force is not None
    assert run.contact_torque is not None
    forces = np.dstack((run.contact_force, run.contact_torque))
    for j, joint in enumerate(scene.joints):
        for end, (body, anchor) in enumerate(zip(joint.ends, joint.anchors, strict=True)):
            if body is not None:
                c, s = np.cos(run.orientation[:, body]), np.sin(run.orientation[:, body])
                x, y = c * anchor[0] - s * anchor[1], s * anchor[0] + c * anchor[1]
                across, up = told.force[:, j, end].T
                forces[:, body, :2] += told.force[:, j, end]
                forces[:, body, 2] += told.torque[:, j, end] + x * up - y * across
    masses = np.array([(b.mass, b.mass, b.inertia) for b in scene.bodies[1:]])
    rates = np.dstack((run.velocity, run.angular_velocity))[:, 1:]
    gained = (rates[2::3] - rates[::3]) / (run.times[2::3] - run.times[::3])[:, None, None]
    weight = np.array([(*np.multiply(b.mass, scene.gravity), 0.0) for b in scene.bodies[1:]])
    found: np.ndarray = masses * gained - weight - forces[1::3, 1:]
    return found


@pytest.mark.parametrize("seed", range(20, 28))
def test_forces_on_each_body_of_a_fallen_chain_obey_newton_and_coulomb(seed: int) -> None:
    scene = fallen_chain(seed)
    middles = np.linspace(0.5, 1.4, 19)
    times = np.sort(np.concatenate([middles - 1e-5, middles, middles + 1e-5]))
    try:
        run = t2.simulate(scene, duration=1.5, times=times, method=EXACT, work_limit=3000)
    except t2.SimulationError as refusal:  # the laws of rigid bodies leave it open
        run = refusal.run  # type: ignore[attr-defined]
        whole = len(run.times) // 3 * 3
        rows = ("times", "position", "orientation", "velocity", "angular_velocity")
        rows += ("contact_force", "contact_torque")
        run = replace(run, **{name: getattr(run, name)[:whole] for name in rows})
    met = np.abs(np.subtract.outer(run.times[1::3], run.impacts.time)).min(axis=1) < 2e-5
    assert run.contact_force is not None
    assert np.abs(run.contact_force).max() > 1.0
    assert np.abs(missing(run)[~met]).max() < 1e-4
    across, up = np.moveaxis(run.contact_force, -1, 0)
    assert (up >= -1e-12).all()
    assert (np.abs(across) <= scene.friction(0, 1) * up + 1e-9).all()


@pytest.mark.parametrize("kind", ["npz", "rrd"])
def test_a_recording_keeps_what_contacts_exert(kind: str, tmp_path: Path) -> None:
    if kind == "rrd":
        pytest.importorskip("rerun")
    run = t2.simulate(cart(0.3), duration=0.5, method=EXACT)
    run.save(tmp_path / f"cart.{kind}")
    read = t2.Run.load(tmp_path / f"cart.{kind}")
    np.testing.assert_array_equal(read.reactions.force, run.reactions.force)
    assert run.contact_force is not None
    other = replace(run, contact_force=run.contact_force + 1e-9)
    found = first_difference(read, other)
    assert found is not None
    assert found.quantity == "contact_force x"
    assert found.unit == "N"


def test_runs_whose_contacts_press_no_joints_tell_no_contact_forces() -> None:
    scene = t2.Scene(gravity=(0.0, -G))
    floor(scene, 0.5)
    scene.add_body(t2.Disc(radius=0.5), mass=1, position=(0, 0.5), friction=0.5, restitution=0.0)
    assert t2.simulate(scene, duration=0.1).contact_force is None
