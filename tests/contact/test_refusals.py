"""What cannot be decided is refused by name, with the time, the bodies and the run so far."""

import math

import pytest

import tamias2d as t2
from tamias2d.contact import OverlapError, UndecidedContactError, UnlocatedContactError
from tamias2d.errors import SceneError

DISC = t2.Disc(radius=0.5)


def cradle(gap: float) -> t2.Scene:
    scene = t2.Scene(gravity=(0, 0))
    for k in range(5):
        ahead = -2.0 if k == 0 else k * (1 + gap)
        speed = 1.0 if k == 0 else 0.0
        scene.add_body(DISC, mass=1, position=(ahead, 0), velocity=(speed, 0), restitution=1)
    return scene


def test_cradle_with_gaps_passes_the_blow_on():
    """B7."""
    run = t2.simulate(cradle(0.01), duration=4.0)
    assert run.velocity[-1, :, 0].tolist() == [0, 0, 0, 0, 1]


def test_touching_cradle_passes_the_blow_on():
    """B7: rigid bodies do not say how a blow goes through bodies that touch; A18 does."""
    run = t2.simulate(cradle(0.0), duration=4.0)
    assert run.velocity[-1, :, 0].tolist() == [0, 0, 0, 0, 1]
    assert run.impacts.time.tolist() == [2.0] * 4
    assert run.notes[-1].startswith("rule: 1 instants")
    assert "at 2.0 s" in run.notes[-1]


def wedge(angle: float) -> t2.Scene:
    """A disc that falls into the corner of two walls at once."""
    scene = t2.Scene(gravity=(0, -9.81))
    for side in (-1, 1):
        normal = (side * math.sin(angle), math.cos(angle))
        scene.add_static(t2.HalfPlane(normal=normal, offset=0))
    scene.add_body(DISC, mass=1, position=(0, 3), restitution=1)
    return scene


def test_disc_into_a_right_corner_comes_straight_back():
    """X10: the walls are at right angles, so that neither impact acts on the other."""
    run = t2.simulate(wedge(math.pi / 4), duration=2.0)
    assert run.impacts.time[0] == run.impacts.time[1]
    assert abs(run.position[:, 2, 0]).max() < 1e-14


def test_disc_into_another_corner_comes_straight_back():
    """Both walls answer together, so that it stays on the line of symmetry, to the bit."""
    run = t2.simulate(wedge(0.6), duration=2.0, method=t2.ClosedForm())
    assert run.impacts.time[0] == run.impacts.time[1]
    assert set(run.position[:, 2, 0].tolist()) == {0.0}
    assert run.energy[-1] == pytest.approx(run.energy[0], rel=1e-14)


@pytest.mark.parametrize(("speed", "restitution"), [(0, 1), (1, 0)])
def test_corner_that_stays_on_a_corner_is_refused(speed: float, restitution: float):
    scene = t2.Scene(gravity=(0, 0))
    box = t2.Box(width=1, height=1)
    apart = 0.5 + 2 * speed
    scene.add_body(box, mass=1, position=(-apart, -apart), velocity=(speed, speed), restitution=1)
    scene.add_body(box, mass=1, position=(apart, apart), velocity=(-speed, -speed))
    scene.set_restitution(0, 1, restitution)
    with pytest.raises(UndecidedContactError, match="corner meets corner"):
        t2.simulate(scene, duration=4.0, method=t2.ClosedForm())


def test_overlap_names_both_and_the_depth():
    scene = t2.Scene(gravity=(0, 0))
    scene.add_body(DISC, mass=1, position=(0, 0), restitution=1, name="left")
    scene.add_body(DISC, mass=1, position=(0.75, 0), name="right")
    with pytest.raises(OverlapError, match=r"'left' and 'right': they overlap by 0\.25 m") as found:
        t2.simulate(scene, duration=1.0)
    assert isinstance(found.value, SceneError)


def test_touching_is_no_overlap():
    """Far from the origin and under an angle, where rounding is largest."""
    angle = 0.3
    scene = t2.Scene(gravity=(0, 0))
    x, y = 1e6 + math.cos(angle), 3e5 + math.sin(angle)
    scene.add_body(DISC, mass=1, position=(1e6, 3e5), restitution=1)
    scene.add_body(DISC, mass=1, position=(x, y))
    assert len(t2.simulate(scene, duration=1.0).impacts) == 0


def test_missing_restitution_is_named_when_it_is_needed():
    scene = t2.Scene(gravity=(0, 0))
    scene.add_body(DISC, mass=1, position=(0, 0), velocity=(1, 0), name="left")
    scene.add_body(DISC, mass=1, position=(3, 0), name="right")
    with pytest.raises(SceneError, match="'left' and 'right'"):
        t2.simulate(scene, duration=4.0)


def test_the_2018_scheme_knows_no_contacts():
    scene = t2.Scene(gravity=(0, 0))
    scene.add_body(DISC, mass=1, position=(0, 0), velocity=(2, 0), restitution=1)
    scene.add_body(DISC, mass=1, position=(3, 0))
    t2.simulate(scene, duration=1.0, method=t2.Legacy2018(), time_step=0.1)
    with pytest.raises(UnlocatedContactError, match=r"Legacy2018\(\) knows no contacts"):
        t2.simulate(scene, duration=4.0, method=t2.Legacy2018(), time_step=0.1)
