"""A scene keeps what it shows of its bodies up to date."""

from dataclasses import replace

import tamias2d as t2
from tamias2d.scene.other_bodies import with_bodies


def scene_of(*places):
    scene = t2.Scene(gravity=(0.0, 0.0))
    for x in places:
        scene.add_body(t2.Disc(radius=0.5), mass=1.0, position=(x, 0.0))
    return scene


def test_bodies_that_are_added_later_are_shown():
    scene = scene_of(0.0)
    first = scene.bodies
    scene.add_body(t2.Disc(radius=0.5), mass=1.0, position=(2.0, 0.0))
    assert scene.bodies[:1] == first
    assert [body.position[0] for body in scene.bodies] == [0.0, 2.0]


def test_a_scene_that_starts_otherwise_shows_its_own_bodies():
    scene = scene_of(0.0, 2.0)
    moved = [replace(body, position=(body.position[0] + 5.0, 0.0)) for body in scene.bodies]
    other = with_bodies(scene, moved)
    assert [body.position[0] for body in other.bodies] == [5.0, 7.0]
    assert [body.position[0] for body in scene.bodies] == [0.0, 2.0]
    assert other != scene


def test_scenes_are_equal_whether_they_were_looked_at_or_not():
    one, other = scene_of(0.0, 2.0), scene_of(0.0, 2.0)
    assert len(one.bodies) == 2
    assert one == other
    assert one != scene_of(0.0)
