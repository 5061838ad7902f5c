"""A scene taken apart and put together is the same; a place that is changed changes only itself."""

import dataclasses

import pytest

import tamias2d as t2
from tamias2d.ensemble.outline import outline_of, scene_of
from tamias2d.ensemble.places import place_at
from tests.ensemble.scenes import bouncing

OWN = t2.load(
    """
gravity: [0, -9.81 m/s^2]
bodies:
  a.b:
    shape: box
    width: 1 m
    height: 2 m
    mass: 3 kg
    position: [0 m, 0 m]
    force: ["2[N]*sin(3[rad/s]*time)", 1 N]
    inertia: 2 kg*m^2
  lift-wheel:
    shape: capsule
    length: 1 m
    radius: 0.1 m
    mass: 3 kg
    position: [9 m, 9 m]
kinematics:
  lift:
    shape: segment
    length: 2 m
    position: [4 m, 0 m]
    velocity: [0 m/s, 1 m/s]
    category: 2
springs:
  - {bodies: [a.b, lift-wheel], stiffness: 1 N/m, rest_length: 1 m, anchor: [0.1 m, 0 m]}
fields:
  - force: [0 N, "-1[N/m]*1[m]"]
restitution_of_pairs:
  - {bodies: [lift, a.b], restitution: 0.5}
order: [lift, a.b, lift-wheel]
"""
)


@pytest.mark.parametrize("name", t2.catalogue.names())
def test_every_scene_of_the_catalogue_comes_back(name: str) -> None:
    scene = t2.catalogue.load(name)
    assert scene_of(outline_of(scene), scene) == scene


def test_a_scene_with_laws_pairs_springs_and_fields_comes_back() -> None:
    again = scene_of(outline_of(OWN), OWN)
    assert again == OWN
    assert again.digest() == OWN.digest()


@pytest.mark.parametrize(
    ("path", "value", "found"),
    [
        ("gravity", (1.0, 2.0), lambda s: s.gravity),
        ("gravity.x", 3.0, lambda s: s.gravity[0]),
        ("bodies.a.b.mass", 7.0, lambda s: s.bodies[1].mass),
        ("bodies.a.b.width", 7.0, lambda s: s.bodies[1].shape.width),
        ("bodies.a.b.position.y", 7.0, lambda s: s.bodies[1].position[1]),
        ("bodies.lift.velocity.y", 7.0, lambda s: s.bodies[0].velocity[1]),
        ("kinematics.lift.velocity.y", 7.0, lambda s: s.bodies[0].velocity[1]),
        ("bodies.lift-wheel.radius", 0.2, lambda s: s.bodies[2].shape.radius),
        ("restitution_of_pairs.a.b.lift", 0.3, lambda s: s.restitution(0, 1)),
        ("restitution_of_pairs.lift.a.b", 0.3, lambda s: s.restitution(0, 1)),
        ("friction_of_pairs.lift.lift-wheel", 0.3, lambda s: s.friction(0, 2)),
        ("springs.0.stiffness", 7.0, lambda s: s.springs[0].stiffness),
        ("springs.0.anchor.x", 7.0, lambda s: s.springs[0].anchor[0]),
    ],
)
def test_a_place_is_found_and_changes_alone(path: str, value: object, found: object) -> None:
    outline = outline_of(OWN)
    place = place_at(path, outline)
    changed = scene_of(place.put(outline, value), OWN)
    assert found(changed) == value  # type: ignore[operator]
    assert found(OWN) != value  # type: ignore[operator]
    if path.startswith("friction_of_pairs"):  # there was none
        return
    back = scene_of(place.put(outline_of(changed), _at(outline, place.keys)), OWN)
    assert back == OWN


def test_an_inertia_that_follows_from_the_mass_follows_it() -> None:
    scene = bouncing()
    outline = outline_of(scene)
    heavy = scene_of(place_at("bodies.ball.mass", outline).put(outline, 10.0), scene)
    assert heavy.bodies[1].inertia == 10 * scene.bodies[1].inertia
    stated = dataclasses.replace(OWN.bodies[1])
    outline = outline_of(OWN)
    heavy = scene_of(place_at("bodies.a.b.mass", outline).put(outline, 10.0), OWN)
    assert heavy.bodies[1].inertia == stated.inertia


@pytest.mark.parametrize(
    ("path", "meant"),
    [
        ("bodies.bal.restitution", "bodies.ball.restitution"),
        ("bodies.ball.bounciness", "bodies.ball.restitution"),
        ("bodies.ball.pos.x", "bodies.ball.position.x"),
        ("body.ball.radius", "bodies.ball.radius"),
        ("static.floor.ofset", "statics.floor.offset"),
        ("gravty.y", "gravity.y"),
        ("gravity.z", "gravity.y"),
        ("spring.0.stifness", "springs.0.stiffness"),
        ("restitution_of_pairs.ball.flor", "restitution_of_pairs.ball.floor"),
        ("friction_of_pair.floor.ball", "friction_of_pairs.floor.ball"),
    ],
)
def test_a_misspelt_path_is_answered_by_what_was_meant(path: str, meant: str) -> None:
    with pytest.raises(
        t2.InputError, match=rf"^vary '{path}': .*\(R2\)\. Did you mean '{meant}'\?"
    ):
        place_at(path, outline_of(bouncing()))


@pytest.mark.parametrize("path", ["", "zzz", "bodies", "bodies.ball", "bodies.ball.category", 3])
def test_what_is_no_place_is_refused_by_name(path: object) -> None:
    with pytest.raises(t2.InputError, match=r"the scene has no such place \(R2\)"):
        place_at(path, outline_of(bouncing()))  # type: ignore[arg-type]


def test_what_a_file_has_among_its_statics_is_found_there() -> None:
    outline = outline_of(bouncing())
    assert place_at("statics.floor.offset", outline).keys == ("bodies", "floor", "offset")
    for path in ("statics.ball.mass", "kinematics.floor.offset"):
        with pytest.raises(t2.InputError, match=r"no such place \(R2\)"):
            place_at(path, outline)


def test_places_that_are_proposed_are_there() -> None:
    with pytest.raises(t2.InputError, match=r"for example, gravity, bodies.ball.position, bodies."):
        place_at("zzz", outline_of(bouncing()))


def _at(outline: object, keys: tuple[object, ...]) -> object:
    for key in keys:
        outline = outline.get(key) if isinstance(outline, dict) else outline[key]  # type: ignore[index]
    return outline
