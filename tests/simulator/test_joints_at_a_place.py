"""A joint at a place of the world has the anchors that this place is on its bodies."""

import numpy as np
import pytest

import tamias2d as t2

PLACE = (1.25, 0.5)
SPRING = t2.JointSpring(stiffness=10.0)
KINDS = [
    t2.Revolute(),
    t2.Weld(),
    t2.Prismatic(axis=(1.0, 0.0)),
    t2.Groove(axis=(1.0, 0.0)),
    t2.Wheel(axis=(1.0, 0.0), spring=SPRING),
    t2.Target(spring=SPRING),
]
LIMITS = t2.Limits(lower=-1.0, upper=1.0, restitution=0.0)
PLACELESS = [
    (t2.Distance(), "two points"),
    (t2.Pulley(posts=[(0.0, 5.0), (2.0, 5.0)]), "two points"),
    (t2.Rotary(limits=LIMITS), "angles, and no point"),
    (t2.Ratchet(pitch=0.1, restitution=0.0), "angles, and no point"),
    (t2.Gear(ratio=2.0), "angles, and no point"),
    (t2.Equation("x(point_a - point_b)"), "its equations say themselves"),
]


def two_bodies() -> t2.Scene:
    scene = t2.Scene(gravity=(0.0, -9.81))
    for name, x, turn in (("a", 0.0, 0.7), ("b", 2.0, -2.1)):
        scene.add_body(
            t2.Box(width=1.0, height=0.2),
            mass=1.0,
            position=(x, 0.3),
            orientation=turn,
            restitution=0.0,
            name=name,
        )
    return scene


@pytest.mark.parametrize("kind", KINDS, ids=lambda kind: type(kind).__name__)
def test_it_holds_both_bodies_there(kind: t2.Revolute) -> None:
    scene = two_bodies()
    sim = t2.Simulator(scene)
    scene.add_joint(kind, "a", "b", at=PLACE, name="joint")
    sim.add_joint(kind, "a", "b", at=PLACE, name="joint")
    anchors = [sim.to_local(body, PLACE) for body in ("a", "b")]
    np.testing.assert_allclose(scene.joints[0].anchors[:2], anchors, rtol=0, atol=1e-15)
    other = t2.Simulator(scene)
    for each in (sim, other):
        each.step(30)
    assert sim.digest() == other.digest()
    if type(kind) in (t2.Revolute, t2.Weld):
        apart = np.subtract(*(sim.to_world(body, at) for body, at in zip("ab", anchors)))  # noqa: B905
        assert np.hypot(*apart) < 1e-4


def test_bodies_are_taken_where_they_are_now() -> None:
    sim = t2.Simulator(two_bodies())
    sim.step(20)
    sim.add_joint(t2.Revolute(), (0.0, 0.0), "b", at=(0.0, 0.0), name="hinge")
    sim.step(100)
    assert sim.reactions.separation[0] < 1e-4
    sim.add_joint(t2.Target(spring=SPRING), (0.5, 0.5), "a", at=sim.position[0])
    sim.step()


def test_a_point_of_the_plane_stays_what_it_is() -> None:
    scene = two_bodies()
    with pytest.raises(t2.InputError, match="it does not hold at the start"):
        scene.add_joint(t2.Revolute(), "a", (5.0, 5.0), at=PLACE)
    scene.add_joint(t2.Groove(axis=(1.0, 0.0)), (0.0, PLACE[1]), "a", at=PLACE)
    assert scene.joints[0].anchors[0] == (0.0, PLACE[1])


@pytest.mark.parametrize(("kind", "says"), PLACELESS, ids=lambda x: type(x).__name__)
def test_what_holds_no_single_place_is_refused(kind: t2.Gear, says: str) -> None:
    scene = two_bodies()
    sim = t2.Simulator(scene)
    for each in (scene, sim):
        with pytest.raises(t2.InputError, match=rf"kind {type(kind).__name__}: .*{says}"):
            each.add_joint(kind, "a", "b", at=PLACE)


@pytest.mark.parametrize("key", ["anchor", "other_anchor", "third_anchor"])
def test_anchors_beside_a_place_are_refused(key: str) -> None:
    scene = two_bodies()
    for each in (scene, t2.Simulator(scene)):
        with pytest.raises(t2.InputError, match=rf"found {key}, too: .*Leave one out"):
            each.add_joint(t2.Revolute(), "a", "b", at=PLACE, **{key: (0.0, 0.0)})  # type: ignore[arg-type]
        with pytest.raises(t2.InputError, match=r"at\[1\] of a joint: found nan"):
            each.add_joint(t2.Revolute(), "a", "b", at=(0.0, np.nan))


FILE = """gravity: [0 m/s^2, -9.81 m/s^2]
bodies:
  rod:
    {shape: box, width: 1 m, height: 1 cm, mass: 1 kg, position: [50 cm, 0 m], orientation: 90 deg}
joints:
  - kind: revolute
    between: [rod, [50 cm, 25 cm]]
    at: [50 cm, 25 cm]
"""


def test_a_scene_file_may_say_the_place() -> None:
    scene = t2.load(FILE)
    np.testing.assert_allclose(scene.joints[0].anchors[0], (0.25, 0.0), rtol=0, atol=1e-15)
    text = t2.scene_text(scene)
    assert "at:" not in text
    assert t2.load(text) == scene


@pytest.mark.parametrize(
    ("old", "new", "place", "message"),
    [
        ("at: [50 cm, 25 cm]", "at: [50 cm, 25 s]", "8:17", "must be in m"),
        ("    at:", "    anchor: [0 m, 0 m]\n    at:", "9:9", "found anchor, too"),
        ("kind: revolute", "kind: distance", "8:9", "it holds two points"),
    ],
)
def test_a_bad_place_in_a_file_has_its_line(old: str, new: str, place: str, message: str) -> None:
    with pytest.raises(t2.SceneError, match=message) as caught:
        t2.load(FILE.replace(old, new))
    assert str(caught.value).startswith(f"scene:{place}: "), caught.value
