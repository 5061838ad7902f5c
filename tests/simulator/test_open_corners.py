"""Thin walls that only just meet are told of, where something is thin enough to slip out (IM10)."""

import copy
import pickle
import warnings
from math import pi

import pytest

import tamias2d as t2

NEEDLE = t2.Segment(length=0.5)


def room(*, longer: float, walls: str = "segments") -> t2.Scene:
    """Return a room of 4 m by 4 m, whose walls reach beyond its corners, m."""
    scene = t2.Scene(gravity=(0.0, -9.81))
    length = 4.0 + 2.0 * longer
    shape: t2.Segment | t2.Box = t2.Segment(length=length)
    if walls == "boards":
        shape = t2.Box(width=length, height=1e-3)
    for k, place in enumerate(((0.0, -2.0), (2.0, 0.0), (0.0, 2.0), (-2.0, 0.0))):
        turn = k * 1.5707963267948966
        scene.add_static(shape, position=place, orientation=turn, name=f"wall-{k}")
    return scene


def told(scene: t2.Scene) -> tuple[str, ...]:
    """Return what the first step of a scene warns of."""
    sim = t2.Simulator(scene, compiled=False)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", t2.StepWarning)
        sim.step()
    return sim.warnings


@pytest.mark.parametrize("walls", ["segments", "boards"])
def test_walls_that_only_just_meet_are_told_where_a_needle_moves(walls: str) -> None:
    """The warning names both walls and the needle, the rule, and what to do."""
    scene = room(longer=0.0, walls=walls)
    scene.add_body(NEEDLE, mass=1.0, restitution=0.0, position=(0.0, 0.0), name="needle")
    (text,) = told(scene)
    assert text.startswith(("body 'wall-0' and body", "body 'wall-3' and body"))
    assert "'needle'" in text
    assert "(IM10)" in text
    assert "Chain" in text


@pytest.mark.parametrize("walls", ["segments", "boards"])
def test_walls_that_overlap_are_not_told(walls: str) -> None:
    """Nothing gets past the end of a wall that reaches well beyond the next one."""
    scene = room(longer=0.1, walls=walls)
    scene.add_body(NEEDLE, mass=1.0, restitution=0.0, position=(0.0, 0.0))
    assert told(scene) == ()


def test_a_thick_body_needs_no_warning() -> None:
    """Contacts yield by less than a disc is thick."""
    scene = room(longer=0.0)
    scene.add_body(t2.Disc(radius=0.1), mass=1.0, restitution=0.0, position=(0.0, 0.0))
    assert told(scene) == ()


def test_a_chain_needs_no_warning() -> None:
    """The pieces of a chain know their neighbours."""
    scene = t2.Scene(gravity=(0.0, 0.0))
    corners = [(-2.0, -2.0), (2.0, -2.0), (2.0, 2.0), (-2.0, 2.0)]
    scene.add_static(t2.Chain(vertices=corners, loop=True))
    scene.add_body(NEEDLE, mass=1.0, restitution=0.0, position=(0.0, 0.0))
    assert told(scene) == ()


@pytest.mark.parametrize("shift", [0.0, 0.5])
def test_a_floor_of_segments_is_told_where_they_end_at_each_other(shift: float) -> None:
    """Segments in one line that overlap leave no way through."""
    scene = t2.Scene(gravity=(0.0, -9.81))
    for x in (-1.0, 1.0 - shift):
        scene.add_static(t2.Segment(length=2.0), position=(x, 0.0))
    scene.add_body(NEEDLE, mass=1.0, restitution=0.0, position=(0.0, 1.0))
    assert len(told(scene)) == (0 if shift else 1)


def test_a_wall_on_a_ground_is_told_unless_it_reaches_into_it() -> None:
    """What lies on the ground may be pressed below a wall that stands on it."""
    for deeper, count in ((0.0, 1), (0.2, 0)):
        scene = t2.Scene(gravity=(0.0, -9.81))
        scene.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=0.0))
        upright = 1.5707963267948966
        scene.add_static(t2.Segment(length=2.0), position=(0.0, 1.0 - deeper), orientation=upright)
        scene.add_body(NEEDLE, mass=1.0, restitution=0.0, position=(-1.0, 1.0))
        assert len(told(scene)) == count


def test_parts_of_a_frame_are_told_by_its_name() -> None:
    """A driven frame of thin boards is one body."""
    scene = t2.Scene(gravity=(0.0, 0.0))
    board = t2.Box(width=1e-3, height=2.0)
    sides = [((1.0, 0.0), 0.0), ((0.0, 1.0), 1.5707963267948966), ((-1.0, 0.0), 0.0)]
    parts = [t2.Part(shape=board, position=at, orientation=turn) for at, turn in sides]
    scene.add_kinematic(
        t2.Compound(parts=parts), position=(0.0, 0.0), velocity=(1.0, 0.0), name="frame"
    )
    scene.add_body(NEEDLE, mass=1.0, restitution=0.0, position=(0.0, 0.0))
    (text,) = told(scene)
    assert text.startswith("two parts of body 'frame'")


def test_what_goes_on_does_not_tell_of_walls_that_came_together_since() -> None:
    """They are asked about as they come, and neither a copy nor a state that comes back does so."""
    sim = t2.Simulator(t2.Scene(gravity=(0.0, 0.0)), compiled=False)
    sim.add_static(t2.Segment(length=2.0), position=(0.0, 0.0))
    upright = {"position": (1.5, 1.0), "orientation": pi / 2, "velocity": (-6.0, 0.0)}
    sim.add_kinematic(t2.Segment(length=2.0), **upright)
    sim.add(NEEDLE, mass=1.0, restitution=0.0, position=(0.0, 0.5))
    sim.step(5)  # now one wall ends at the end of the other
    state = sim.copy_state()
    for one in (sim, copy.deepcopy(sim), pickle.loads(pickle.dumps(sim))):
        one.step()
        assert one.warnings == ()
    sim.restore_state(state)
    sim.step()
    assert sim.warnings == ()
    sim.add_static(t2.Segment(length=2.0), position=(0.0, 9.0))
    sim.position[1] = 1.0, 1.0
    with pytest.warns(t2.StepWarning, match="only just meet"):
        sim.step()
