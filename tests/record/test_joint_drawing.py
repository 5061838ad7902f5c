"""Joints and springs as they are drawn: where they are at each sample, and gone once broken."""

from pathlib import Path

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.record import drawing, joint_drawing
from tamias2d.scene import catalogue
from tools.joint_pictures import kinds

SCENES = kinds()


def drawn(name: str) -> tuple[t2.Run, list[joint_drawing.Line]]:
    run = t2.simulate(SCENES[name], duration=0.3, times=np.linspace(0, 0.3, 4))
    return run, list(joint_drawing.lines(run, drawing.view_of(run)))


@pytest.mark.parametrize("name", SCENES)
def test_every_kind_is_drawn_at_each_sample(name: str) -> None:
    run, lines = drawn(name)
    assert lines
    for line in lines:
        assert line.points.shape[::2] == (4, 2)
        assert np.isfinite(line.points).all()
        assert line.kind in joint_drawing.COLOURS
    assert {line.name for line in lines} >= {
        joint.name for joint in run.scene.joints if joint.model != "angle"
    }


def test_a_rod_goes_from_anchor_to_anchor_and_is_gone_once_broken() -> None:
    run, lines = drawn("break_force=...")
    rod = next(line for line in lines if line.points.shape[1] == 2)
    held = run.times < run.joint_events.time[0]
    assert 0 < held.sum() < 4
    assert rod.points[held, 1] == pytest.approx(run.position[held, 0], abs=1e-14)
    assert not np.ptp(rod.points[~held], axis=1).any()


def test_links_without_shapes_go_from_anchor_to_anchor() -> None:
    """A chain of two rods that have no shape, and a bob on an arm: each has lines to its joints."""
    scene = t2.Scene(gravity=(0.0, -10.0))
    for x in (0.5, 1.5):
        scene.add_body(None, mass=1.0, inertia=0.1, position=(x, 0.0))
    scene.add_joint(t2.Revolute(), (0.0, 0.0), 0, at=(0.0, 0.0), name="root")
    scene.add_joint(t2.Revolute(), 0, 1, at=(1.0, 0.0), name="elbow")
    scene.add_body(t2.Disc(radius=0.1), mass=1.0, position=(9.0, 0.0), restitution=0.0)
    scene.add_joint(t2.Revolute(), (8.0, 0.0), 2, at=(8.0, 0.0), name="shown")
    run = t2.simulate(scene, duration=0.3, times=np.linspace(0, 0.3, 4))
    lines = joint_drawing.lines(run, drawing.view_of(run))
    limbs = [line for line in lines if line.points.shape[1] == 2]
    assert [line.name for line in limbs] == ["root", "elbow", "elbow"]
    turn = run.orientation[:, 0]
    along = 0.5 * np.column_stack((np.cos(turn), np.sin(turn)))
    for line, end in zip(limbs, (-along, along), strict=False):
        assert line.points[:, 0] == pytest.approx(run.position[:, 0], abs=1e-14)
        assert line.points[:, 1] == pytest.approx(run.position[:, 0] + end, abs=1e-14)
    assert limbs[2].points[:, 1] == pytest.approx(limbs[1].points[:, 1], abs=1e-12)


def test_a_spring_does_not_hang_in_the_air() -> None:
    """Of a body without shape a line leads to where the spring holds it."""
    scene = t2.Scene(gravity=(0.0, 0.0))
    for x in (0.0, 5.0):
        scene.add_body(None, mass=1.0, inertia=0.1, position=(x, 0.0), angular_velocity=1.0)
    scene.add_spring(0, 1, stiffness=1.0, rest_length=0.5, anchor=(0.0, 1.0))
    run = t2.simulate(scene, duration=0.3, times=np.linspace(0, 0.3, 4))
    coil, limb = joint_drawing.lines(run, drawing.view_of(run))
    assert (coil.kind, limb.kind) == ("spring", "joint")
    assert limb.points[:, 0] == pytest.approx(run.position[:, 0], abs=1e-14)
    assert limb.points[:, 1] == pytest.approx(coil.points[:, 0], abs=1e-14)


def test_a_slide_has_ticks_at_its_limits_and_a_hinge_spokes() -> None:
    _, lines = drawn("Prismatic(limits=...)")
    ticks = [line.points[-1].mean(axis=0) for line in lines if line.kind == "limit"]
    along = np.array((1.0, -0.6)) / np.hypot(1.0, 0.6)
    assert np.array(ticks) == pytest.approx(np.array([0 * along, 0.9 * along]), abs=1e-14)
    _, lines = drawn("Revolute(limits=...)")
    spoke = next(line.points[0] for line in lines if line.kind == "limit")
    assert np.arctan2(*spoke[1][::-1]) == pytest.approx(-0.8)
    assert np.arctan2(*spoke[-2][::-1]) == pytest.approx(0.8)


def test_arcs_of_limits_do_not_cover_a_heap_of_small_bodies() -> None:
    scene = catalogue.load("ragdolls")
    run = t2.simulate(scene, duration=0.02, times=[0.0, 0.02])
    view = drawing.view_of(run)
    joints = {joint.name: joint for joint in scene.joints}
    arcs = [line for line in joint_drawing.lines(run, view) if line.kind == "limit"]
    assert arcs
    for arc in arcs:
        shapes = [scene.bodies[k].shape for k in joints[arc.name].bodies]
        smaller = min(shape.bounding_radius for shape in shapes if shape)
        radius = np.hypot(*(arc.points[0, 1] - arc.points[0, 0]))
        assert 0 < radius <= 0.5 * smaller + 1e-12


def test_arrows_are_in_proportion_to_the_reactions() -> None:
    run = t2.simulate(SCENES["Weld()"], duration=0.3, times=np.linspace(0, 0.3, 4))
    view = drawing.view_of(run)
    found = joint_drawing.reactions(run, view)
    assert found is not None
    places, arrows = found
    force = run.reactions.force[:, :, 1]
    assert np.hypot(*np.moveaxis(arrows, -1, 0)).max() == pytest.approx(view.reach / 4)
    scale = arrows[0, 0, 1] / force[0, 0, 1]
    assert arrows == pytest.approx(scale * force, rel=1e-12)
    assert places[:, 0] == pytest.approx(np.tile((-0.5, 0.0), (4, 1)), abs=1e-12)


def test_the_view_holds_what_bodies_hang_from() -> None:
    run, _ = drawn("Pulley(posts=...)")
    view = drawing.view_of(run)
    assert view.center[1] + view.half[1] > 0.3


def test_events_of_joints_stand_at_the_samples_that_show_them(tmp_path: Path) -> None:
    chunk = pytest.importorskip("rerun.chunk")
    run, _ = drawn("break_force=...")
    run.save(tmp_path / "run.rrd")
    parts = (part for part in chunk.RrdReader(tmp_path / "run.rrd").stream() if not part.is_static)
    batches = {part.entity_path: part.to_record_batch() for part in parts}
    (step,) = np.searchsorted(run.times, run.joint_events.time)
    assert step > 0
    for path in ("/impacts/joints", "/joint_events"):
        assert batches[path].column("step").to_pylist() == [step]
    (((text,),),) = [batches["/impacts/joints"].column("TextLog:text").to_pylist()]
    assert text.endswith("breaks")


def test_a_recording_shows_joints_reactions_and_events(tmp_path: Path) -> None:
    chunk = pytest.importorskip("rerun.chunk")
    run, _ = drawn("break_force=...")
    run.save(tmp_path / "run.rrd")
    paths = {part.entity_path for part in chunk.RrdReader(tmp_path / "run.rrd").stream()}
    assert any(path.startswith("/world/joints/") for path in paths)
    assert "/world/reactions" in paths
    assert "/impacts/joints" in paths
