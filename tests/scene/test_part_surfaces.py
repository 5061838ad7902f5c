"""Parts of a compound that state surfaces of their own (R3), in Python and in files."""

import math
from collections.abc import Callable

import pytest

import tamias2d as t2
from tamias2d.errors import InputError, SceneError
from tamias2d.scene import Body, Part, needs
from tamias2d.scene.surfaces import surface_values

HAMMER = """gravity: [0 m/s^2, -10 m/s^2]
bodies:
  hammer:
    shape: compound
    parts:
      - {shape: disc, radius: 10 cm, position: [0 m, 1 m], restitution: 0.75, friction: 0.25}
      - {shape: box, width: 2 cm, height: 2 m, friction: 1.5}
    mass: 2 kg
    position: [0 m, 3 m]
    restitution: 0.125
statics:
  floor: {shape: half-plane, normal: [0, 1], offset: 0 m, restitution: 0.5, friction: 0.16}
"""


def load(text: str) -> t2.Scene:
    from tamias2d.scene.reading import read_scene

    return read_scene(text, file="scene")


def test_a_file_says_what_parts_state_and_is_written_so() -> None:
    scene = load(HAMMER)
    head, shaft = scene.bodies[0].shape.parts  # type: ignore[union-attr]
    assert (head.restitution, head.friction) == (0.75, 0.25)
    assert (shaft.restitution, shaft.friction) == (None, 1.5)
    text = t2.scene_text(scene)
    assert load(text) == scene
    assert load(text).digest() == scene.digest()
    silent = load(HAMMER.replace(", friction: 1.5", ""))
    assert silent != scene
    assert silent.digest() != scene.digest()


def test_pieces_about_the_centre_of_mass_keep_what_parts_state() -> None:
    shape = load(HAMMER).bodies[0].shape
    assert isinstance(shape, t2.Compound)
    stated = [(part.restitution, part.friction) for part in shape.parts]
    assert [(piece.restitution, piece.friction) for piece in shape.pieces] == stated


@pytest.mark.parametrize(
    ("good", "bad", "place", "words"),
    [
        ("restitution: 0.75", "restitution: 1.5", "6:73", "restitution 1.5 of a part: must be"),
        ("friction: 1.5", "friction: -1", "7:58", "friction -1 of a part: must be >= 0"),
        ("friction: 1.5", "friction: 1 m", "7:58", "must be a pure number"),
        ("friction: 1.5", "fricton: 1.5", "7:48", "'friction'"),
        ("friction: 1.5", "surface_speed: 1 m/s", "7:48", "surface_speed"),
    ],
)
def test_a_fault_of_a_part_is_named_at_its_place(
    good: str, bad: str, place: str, words: str
) -> None:
    assert HAMMER.count(good) == 1
    with pytest.raises(SceneError) as caught:
        load(HAMMER.replace(good, bad))
    assert str(caught.value).startswith(f"scene:{place}: "), caught.value
    assert words in str(caught.value)


@pytest.mark.parametrize(
    "wrong",
    [
        lambda: Part(shape=t2.Disc(radius=1), friction=-0.1),
        lambda: Part(shape=t2.Disc(radius=1), friction=math.inf),
        lambda: Part(shape=t2.Disc(radius=1), restitution=1.1),
        lambda: Part(shape=t2.Disc(radius=1), restitution="1"),  # type: ignore[arg-type]
    ],
)
def test_a_part_obeys_the_rules_of_a_body(wrong: Callable[[], Part]) -> None:
    with pytest.raises(InputError, match="of a part: "):
        wrong()


def test_a_pair_mixes_what_its_parts_state_unless_it_has_a_value_of_its_own() -> None:
    """DD17 takes the smaller restitution, DD23 the root of the product: 0.2 of 0.25 and 0.16."""
    scene = load(HAMMER)
    assert scene.restitution(0, 1, parts=(0, None)) == 0.5
    assert scene.restitution(1, 0, parts=(None, 1)) == 0.125
    assert scene.restitution(0, 1) == 0.125
    assert scene.friction(0, 1, parts=(0, None)) == pytest.approx(0.2, abs=1e-15)
    assert scene.friction(1, 0, parts=(None, 1)) == pytest.approx(math.sqrt(0.24), abs=1e-15)
    assert scene.friction(0, 1) == 0.16  # the body states none
    scene.set_friction("hammer", "floor", 0.375)
    scene.set_restitution("hammer", "floor", 0.875)
    assert scene.friction(0, 1, parts=(0, None)) == 0.375
    assert scene.restitution(0, 1, parts=(1, None)) == 0.875


@pytest.mark.parametrize("parts", [(2, None), (-1, None), (True, None), (0.0, None), (None, 0)])
def test_a_part_that_is_not_there_is_refused(parts: tuple[int, None]) -> None:
    with pytest.raises(InputError, match=r"part of '(hammer|floor)': found .* \(R3\)"):
        load(HAMMER).friction(0, 1, parts=parts)


@pytest.mark.parametrize("parts", [(0,), 0, None, (0, None, 1)])
def test_parts_that_are_not_two_are_refused(parts: object) -> None:
    for ask in (load(HAMMER).friction, load(HAMMER).restitution):
        with pytest.raises(InputError, match=r"^parts: found .*: must be two, .* \(R3\)\. Give"):
            ask(0, 1, parts=parts)  # type: ignore[arg-type]


def test_a_rough_part_makes_a_body_rough() -> None:
    rough = load(HAMMER.replace(", friction: 0.16", ""))
    smooth = load(HAMMER.replace(", friction: 0.16", "").replace("1.5", "0").replace("0.25}", "0}"))
    assert "friction (IM9, GD8)" in needs(rough, 2.0)
    assert "friction (IM9, GD8)" not in needs(smooth, 2.0)


def test_values_are_those_of_parts_pieces_and_bodies() -> None:
    chain = t2.Chain(vertices=[(0.0, 0.0), (1.0, 0.0), (2.0, 1.0)])
    hammer, floor = load(HAMMER)
    assert surface_values(hammer, "restitution") == (0.75, 0.125)
    assert surface_values(floor, "friction") == (0.16,)
    assert surface_values(Body(name="c", shape=chain, dynamic=False), "friction") == (None, None)
    assert surface_values(Body(name="p", shape=None, dynamic=True, friction=1.0), "friction") == ()
