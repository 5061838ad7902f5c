"""Chains in Python and in files: what they are, and what is refused by name."""

import itertools
import math

import numpy as np
import pytest
from hypothesis import given, strategies as st

import tamias2d as t2
from tamias2d.record import drawing
from tamias2d.scene import in_pieces, owners, pieces_of

HILL = [(4.0, 0.0), (2.0, 1.0), (0.0, 0.0), (-3.0, 0.5)]
FILE = """
gravity: [0 m/s^2, -9.81 m/s^2]
statics:
  hill:
    shape: chain
    vertices:
      - [400 cm, 0 m]
      - [2 m, 1 m]
      - [0, 0]
      - [-3 m, 0.5 m]
    one_sided: true
    position: [1 m, 2 m]
    friction: 0.5
"""


def ground() -> t2.Scene:
    scene = t2.Scene(gravity=(0.0, -9.81))
    scene.add_static(
        t2.Chain(vertices=HILL, one_sided=True), position=(1.0, 2.0), friction=0.5, name="hill"
    )
    return scene


def test_a_file_with_units_says_what_python_does() -> None:
    assert t2.load(FILE) == ground()
    assert t2.load(t2.scene_text(ground())) == ground()
    loop = t2.Scene(gravity=(0.0, 0.0))
    loop.add_static(t2.Chain(vertices=[*HILL, (0.0, -3.0)], loop=True), name="loop")
    assert t2.load(t2.scene_text(loop)) == loop
    assert t2.load(t2.scene_text(loop)).digest() == loop.digest()


@pytest.mark.parametrize(
    ("values", "says"),
    [
        ({"vertices": [(0, 0)]}, "vertices of a chain: found 1: must be at least 2"),
        ({"vertices": [(0, 0), (1, 0)], "loop": True}, "a loop: found 2: must be at least 3"),
        ({"vertices": [(0, 0), (1, 0), (1, 0), (2, 0)]}, r"vertices\[2\] .* the same as the one"),
        ({"vertices": [(0, 0), (1, 0), (0, 1), (0, 0)], "loop": True}, "loop closes by itself"),
        ({"vertices": [(0, 0), (math.nan, 0)]}, r"vertices\[1\]\[0\] of a chain: .* finite"),
        ({"vertices": [(0, 0), (1, math.inf)]}, r"vertices\[1\]\[1\] of a chain: .* finite"),
        ({"vertices": [(0, 0), (1e-200, 0)]}, r"vertices\[1\]"),
        ({"vertices": [(0, 0), (1e200, 0)]}, r"vertices\[1\]"),
        ({"vertices": [(0, 0), 3]}, r"vertices\[1\]"),
        ({"vertices": 3}, "vertices of a chain: found 3: must be a list"),
        (
            {"vertices": [(0, 0), (4, 0), (4, 2), (2, -1)]},
            r"vertices\[2\] \(4, 2\) .* meets the one that begins at vertices\[0\].*A16",
        ),
        ({"vertices": [(0, 0), (4, 0), (4, 2), (2, 0)]}, r"vertices\[2\] .*A16"),
        ({"vertices": [(0, 0), (2, 0), (1, 0)]}, r"vertices\[1\] .*A16"),
        ({"vertices": [(0, 0), (2, 0), (3, 0), (2.5, 1), (1, 0)]}, r"vertices\[3\] .*A16"),
        (
            {"vertices": [(0, 0), (2, 2), (2, 0), (0, 2)], "loop": True},
            r"vertices\[2\] .* vertices\[0\].*A16",
        ),
        ({"vertices": [(0, 0), (2, 0), (2, 1), (1, 0)], "loop": True}, "A16"),
        ({"vertices": HILL, "loop": 1}, "loop of a chain: found 1: must be True or False"),
        ({"vertices": HILL, "one_sided": "yes"}, "one_sided of a chain"),
    ],
)
def test_a_bad_chain_is_refused_by_name(values: dict[str, object], says: str) -> None:
    with pytest.raises(t2.InputError, match=says):
        t2.Chain(**values)  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("change", "says"),
    [
        (("- [2 m, 1 m]", "- [2 kg, 1 m]"), r"8:\d+: .*2 kg.* must be in m"),
        (("- [2 m, 1 m]", "- [4 m, 0 m]"), "the same as the one before it"),
        (("one_sided: true", "one_sided: 1"), "one sided: .*must be true or false"),
        (("one_sided: true", "sides: 1"), "key 'sides' of static body 'hill': unknown"),
    ],
)
def test_a_bad_file_is_refused_with_the_place(change: tuple[str, str], says: str) -> None:
    with pytest.raises(t2.SceneError, match=says):
        t2.load(FILE.replace(*change))


def test_a_chain_does_not_move_freely() -> None:
    scene, chain = t2.Scene(gravity=(0.0, 0.0)), t2.Chain(vertices=HILL)
    with pytest.raises(t2.InputError, match="found a chain: it cannot move"):
        scene.add_body(chain, mass=1.0, position=(0, 0))
    with pytest.raises(t2.InputError, match="must be of one piece"):
        t2.Part(shape=chain)  # type: ignore[arg-type]
    assert len(scene) == 0
    simulator = t2.Simulator(scene, compiled=False)
    with pytest.raises(t2.InputError, match="it cannot move"):
        simulator.add(chain, mass=1.0, position=(0, 0))


def test_corners_are_the_turns_between_pieces() -> None:
    square = t2.Chain(vertices=[(0, 0), (1, 0), (1, 1), (0, 1)], loop=True)
    assert square.corners == ((0.0, 1.0),) * 5
    assert len(square.segments) == 4
    line = t2.Chain(vertices=[(0, 0), (1, 0), (2, 0), (2, -1)])
    assert line.corners == ((-1.0, 0.0), (1.0, 0.0), (0.0, -1.0), (-1.0, 0.0))
    assert line.area == 0.0
    assert line.bounding_radius == pytest.approx(math.sqrt(5))


def test_pieces_stand_where_the_chain_does() -> None:
    scene = ground()
    scene.add_body(t2.Disc(radius=0.1), mass=1.0, position=(0, 9), restitution=0.3, name="ball")
    scene.set_friction("hill", "ball", 0.1)
    pieces = in_pieces(scene)
    assert owners(pieces) == [0, 1, 0, 0, 0]
    assert pieces.friction(1, 4) == 0.1
    assert pieces.friction(0, 1) == 0.1
    placed = [np.array(body.shape.core) + body.position for body in pieces.bodies[2:]]  # type: ignore[union-attr]
    expected = np.array(HILL) + np.array((1.0, 2.0))
    for k, ends in enumerate(placed):
        assert ends == pytest.approx(expected[k : k + 2], abs=1e-15)
    for part, (start, end) in zip(
        pieces_of(t2.Chain(vertices=HILL)), itertools.pairwise(HILL), strict=True
    ):
        assert np.array(part.core) == pytest.approx(np.array([start, end]), abs=1e-15)
    assert in_pieces(t2.catalogue.load("tc1")) is not pieces
    plain = t2.catalogue.load("tc1")
    assert in_pieces(plain) is plain


def test_a_chain_is_drawn_as_one_line() -> None:
    (line,) = drawing.outlines(ground().bodies[0])
    assert line == pytest.approx(np.array(HILL))
    loop = t2.Scene(gravity=(0.0, 0.0))
    loop.add_static(t2.Chain(vertices=[*HILL, (0.0, -3.0)], loop=True))
    (line,) = drawing.outlines(loop.bodies[0])
    assert line == pytest.approx(np.array([*HILL, (0.0, -3.0), HILL[0]]))


@given(st.integers(3, 60), st.integers(0, 2**32 - 1), st.booleans())
def test_chains_that_cross_are_those_of_which_two_pieces_do(
    count: int, seed: int, loop: bool
) -> None:
    """Heights over rising places never cross; a swap of two far vertices mostly does."""
    chance = np.random.default_rng(seed)
    places = np.cumsum(chance.uniform(0.1, 1.0, count))
    points = np.column_stack((places, chance.normal(0.0, 3.0, count)))
    if loop:
        points = np.vstack((points, [(places[-1] + 1.0, -99.0), (places[0] - 1.0, -99.0)]))
    t2.Chain(vertices=points, loop=loop)
    i, j = sorted(chance.choice(count, 2, replace=False))
    points[[i, j]] = points[[j, i]]
    following = np.roll(points, -1, axis=0)
    pieces = list(zip(points, following, strict=True))[: None if loop else -1]
    crosses = any(
        crossing(*pieces[a], *pieces[b])
        for a in range(len(pieces))
        for b in range(a + 2, len(pieces) - (loop and a == 0))
    )
    if crosses:
        with pytest.raises(t2.InputError, match="A16"):
            t2.Chain(vertices=points, loop=loop)
    else:
        t2.Chain(vertices=points, loop=loop)


def crossing(p: np.ndarray, q: np.ndarray, r: np.ndarray, s: np.ndarray) -> bool:
    """Solve for where two lines meet."""
    ways = np.column_stack((q - p, r - s))
    if abs(np.linalg.det(ways)) < 1e-12:
        return False
    at = np.linalg.solve(ways, r - p)
    return bool((at >= 0).all() and (at <= 1).all())
