"""Meshes, nets and trees of hinges: each is solved its own way, and all agree (IM15)."""

import math
from typing import Any

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.engine.joints import grouping, hinge_net, net_gradients, rows
from tamias2d.engine.joints.yielding import REMOVED_BY_JOINTS
from tamias2d.scene import JointSpring, Limits, Motor, Revolute, Scene
from tamias2d.simulator import Simulator
from tests.engine.scenes import plain
from tests.simulator.mechanisms import G, energy
from tools.measurements.mechanisms.random_mechanism import random_mechanism
from tools.measurements.mechanisms.scenes import net


def test_meshes_hold() -> None:
    """A net of hinges whose factors would fill is solved by iteration."""
    scene = Scene(gravity=(0.0, -G))
    for k in range(16):
        x, y = divmod(k, 4)
        scene.add_body(None, mass=1.0, inertia=0.08, position=(float(x), float(-y)))
        if k in (0, 12):
            scene.add_joint(Revolute(), (float(x), float(-y)), k)
        if y:
            scene.add_joint(Revolute(), k - 1, k, anchor=(0.0, -0.5), other_anchor=(0.0, 0.5))
        if x:
            scene.add_joint(Revolute(), k - 4, k, anchor=(0.5, 0.0), other_anchor=(-0.5, 0.0))
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(grouping, "LOOPED", 0)
        patch.setattr(grouping, "FEW", 0)
        sim = plain(scene)
        sim.step(20)
    assert sim.reactions.separation.max() < 1e-3


@pytest.mark.parametrize("seed", [7, 12, 46])
def test_mechanisms_that_whirl_hold(seed: int) -> None:
    """Grooves whip light bodies by a tenth of a radian in a substep: rows turn meanwhile.

    With the rows of a substep's begin alone they come apart by 1 to 12 cm.
    """
    sim = Simulator(random_mechanism(seed), time_step=1 / 60, compiled=False)
    most = 0.0
    for _ in range(100):
        sim.step()
        most = max(most, float(sim.reactions.separation.max()))
    assert most < 1e-5


def test_net_of_hinges_moves_as_any_mesh_does(monkeypatch: pytest.MonkeyPatch) -> None:
    """Where it leaves as little, and removes as much."""
    monkeypatch.setattr(net_gradients, "LEFT_OPEN", 1e-4)
    monkeypatch.setattr(hinge_net, "REMOVED_BY_NET", REMOVED_BY_JOINTS)
    found = []
    for own in (True, False):
        with pytest.MonkeyPatch.context() as patch:
            patch.setattr(grouping, "LOOPED", 0)
            patch.setattr(grouping, "FEW", 0)
            if not own:
                patch.setattr(rows, "is_net", lambda _: False)
            sim = plain(net(4))
            sim.step(20)
        found.append(sim.position.copy())
    assert found[0] == pytest.approx(found[1], abs=1e-6)  # iterations leave a hundredth of 1e-5 m


def test_net_at_rest_asks_for_no_iterations(monkeypatch: pytest.MonkeyPatch) -> None:
    """It starts from the impulses of as long a time: half of it as a step begins and ends."""
    asked, own = [], hinge_net.iterate_net
    monkeypatch.setattr(grouping, "LOOPED", 0)
    monkeypatch.setattr(grouping, "FEW", 0)
    monkeypatch.setattr(hinge_net, "iterate_net", lambda *of: asked.append(own(*of)))
    sim = plain(net(4))
    sim.step(20)
    assert asked
    asked.clear()
    sim.step(5)
    assert not asked


def test_net_that_hangs_gains_no_energy() -> None:
    """Links that are not solved to the end are closed only as far as there is energy for it."""
    scene = net(20)
    sim = Simulator(scene, time_step=1 / 60)
    before = energy(sim, scene)
    for _ in range(120):
        sim.step()
        assert energy(sim, scene) < before + 1e-9  # J: rounding of heights of 1e2 m times 2e3 N
    assert np.abs(sim.velocity).max() < 1e-9
    assert sim.reactions.separation.max() < 5e-4  # a thousandth of the arms


LAWS: dict[str, dict[str, Any]] = {
    "none": {},
    "spring": {"spring": JointSpring(stiffness=20.0, damping=1.0)},
    "motor": {"motor": Motor(speed=2.0, maximum=30.0)},
    "limits": {"limits": Limits(lower=-1.1, upper=1.2, restitution=0.0)},
}


@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("tied", ["at one end", "at both ends", "nowhere"])
def test_trees_of_hinges_move_as_any_mechanism_does(law: str, tied: str) -> None:
    """The factors of a matrix are the oracle: they know nothing of trees."""
    scene = Scene(gravity=(0.0, -G))
    shape = t2.Capsule(length=0.8, radius=0.1)
    for k in range(4):
        turn = (0.5, -0.5)[k % 2]
        at = ((0.5 + k) * math.cos(turn), 0.5 * math.sin(0.5))
        scene.add_body(shape, mass=1.0 + k, position=at, orientation=turn, restitution=0.0)
        if k:
            ends = (k, k - 1) if k == 2 else (k - 1, k)
            anchors = ((-0.5, 0.0), (0.5, 0.0)) if k == 2 else ((0.5, 0.0), (-0.5, 0.0))
            joint = Revolute(**LAWS[law])
            scene.add_joint(joint, *ends, anchor=anchors[0], other_anchor=anchors[1])
    if tied != "nowhere":
        scene.add_joint(Revolute(), (0.0, 0.0), 0, other_anchor=(-0.5, 0.0))
    if tied == "at both ends":
        scene.add_joint(Revolute(), (4 * math.cos(0.5), 0.0), 3, other_anchor=(0.5, 0.0))
    found = []
    for tree in (True, False):
        with pytest.MonkeyPatch.context() as patch:
            if not tree:
                patch.setattr(rows, "hinge_tree", lambda *_: None)
            sim = plain(scene)
            sim.step(20)
        found.append((sim.position.copy(), sim.reactions.force.copy()))
    assert found[0][0] == pytest.approx(found[1][0], abs=1e-4)  # what a substep leaves by IM15
    loads = np.abs(found[1][1]).max()
    assert found[0][1] == pytest.approx(found[1][1], abs=1e-2 * loads + 1e-6)
