"""Shapes that are cast, against gaps between outlines that NumPy measures."""

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

import tamias2d as t2
from tamias2d.scene.compound import Shape
from tests.simulator.crowd import crowd
from tests.simulator.test_questions import distance, outline

SAME = 1e-9  # m, of places of about 10 m
SHAPES = (
    t2.Disc(radius=0.4),
    t2.Box(width=0.8, height=0.3),
    t2.Capsule(length=0.7, radius=0.1),
    t2.Polygon(vertices=[(0.0, 0.0), (0.8, 0.1), (0.3, 0.9)]),
    t2.Segment(length=0.6),
    t2.Compound(
        parts=[
            t2.Part(shape=t2.Disc(radius=0.2)),
            t2.Part(shape=t2.Box(width=0.2, height=0.4), position=(0.6, 0.0)),
        ]
    ),
)


@pytest.fixture(scope="module")
def crowded() -> tuple[t2.Scene, t2.Simulator]:
    scene = crowd(60, seed=3)
    return scene, t2.Simulator(scene)


def pieces_at(shape: Shape, place: np.ndarray, angle: float) -> list[tuple[np.ndarray, float]]:
    asked = t2.Scene(gravity=(0.0, 0.0))
    asked.add_body(shape, mass=1.0, position=(0.0, 0.0), restitution=0.0)
    return outline(asked.bodies[0], place, angle)


def cross(one: np.ndarray, other: np.ndarray) -> bool:
    """Whether sides of two outlines cross."""
    a, c = one[:, None], other[None]
    b, d = np.roll(one, -1, axis=0)[:, None], np.roll(other, -1, axis=0)[None]
    across = left_of(a, b, c) * left_of(a, b, d) < 0
    return bool((across & (left_of(c, d, a) * left_of(c, d, b) < 0)).any())


def left_of(start: np.ndarray, end: np.ndarray, points: np.ndarray) -> np.ndarray:
    """How far points are to the left of lines, times their lengths."""
    along, to = end - start, points - start
    left: np.ndarray = along[..., 0] * to[..., 1] - along[..., 1] * to[..., 0]
    return left


def apart(one: np.ndarray, other: np.ndarray) -> float:
    """How far two convex cores are from each other; 0 where they overlap."""
    if cross(one, other):
        return 0.0
    return float(min(distance(one, other).min(), distance(other, one).min()))


def gap_to(
    scene: t2.Scene, sim: t2.Simulator, k: int, pieces: list[tuple[np.ndarray, float]]
) -> float:
    """How far pieces are from a body; not positive where they overlap."""
    shape = scene.bodies[k].shape
    if isinstance(shape, t2.HalfPlane):
        normal = np.array(shape.normal)
        return min(float((core @ normal).min()) - shape.offset - r for core, r in pieces)
    body = outline(scene.bodies[k], sim.position[k], sim.orientation[k])
    return min(apart(core, other) - r - s for core, r in pieces for other, s in body)


@settings(max_examples=60)
@given(st.integers(0, 2**32 - 1))
def test_a_shape_stops_where_it_touches_what_it_meets_first(
    crowded: tuple[t2.Scene, t2.Simulator], seed: int
) -> None:
    scene, sim = crowded
    chance = np.random.default_rng(seed)
    shape, angle = SHAPES[seed % len(SHAPES)], chance.uniform(-4, 4)
    start, end = chance.uniform(-9, 9, (2, 2))
    solid = [k for k, body in enumerate(scene.bodies) if not body.sensor]
    first = pieces_at(shape, start, angle)
    ignored = [k for k in solid if gap_to(scene, sim, k, first) <= SAME]  # it starts in these
    hit = sim.shape_cast(shape, start, end, orientation=angle, ignoring=ignored)
    others = [k for k in solid if k not in ignored]
    fraction, met = hit.fraction[0], int(hit.body[0])
    for share in np.linspace(0, 1, 12):
        there = pieces_at(shape, start + share * fraction * (end - start), angle)
        assert min(gap_to(scene, sim, k, there) for k in others) > -SAME
    if met < 0:
        assert (fraction, hit.point[0].tolist()) == (1.0, end.tolist())
        assert hit.normal[0].tolist() == [0.0, 0.0]
        return
    there = pieces_at(shape, start + fraction * (end - start), angle)
    assert abs(gap_to(scene, sim, met, there)) < SAME
    assert np.hypot(*hit.normal[0]) == pytest.approx(1.0, abs=1e-12)
    assert hit.normal[0] @ (end - start) < 0
    point = [(hit.point, 0.0)]
    assert abs(gap_to(scene, sim, met, point)) < SAME  # it is on both
    assert min(abs(distance(core, hit.point)[0] - r) for core, r in there) < SAME
    beyond = start + (fraction + 1e-5) * (end - start)
    grazes = hit.normal[0] @ (end - start) > -1e-3 * np.hypot(*(end - start))
    assert grazes or gap_to(scene, sim, met, pieces_at(shape, beyond, angle)) <= 0


def room() -> t2.Simulator:
    scene = t2.Scene(gravity=(0.0, 0.0))
    scene.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=0.0), name="floor")
    scene.add_static(t2.Box(width=2.0, height=2.0), position=(5.0, 1.0), name="box", category=2)
    scene.add_static(t2.Disc(radius=1.0), position=(-5.0, 1.0), name="disc")
    scene.add_body(
        t2.Disc(radius=1.0), mass=1.0, position=(0.0, 3.0), sensor=True, name="zone", restitution=0
    )
    return t2.Simulator(scene)


BOX = t2.Box(width=2.0, height=2.0)


@pytest.mark.parametrize(
    ("start", "end", "asked", "met", "stops", "point", "normal"),
    [
        ((0.5, 5.0), (0.5, -5.0), {}, "floor", (0.5, 1.0), (0.5, 0.0), (0.0, 1.0)),
        ((5.0, 9.0), (5.0, 0.0), {}, "box", (5.0, 3.0), (5.0, 2.0), (0.0, 1.0)),
        ((5.5, 9.0), (5.5, 0.0), {}, "box", (5.5, 3.0), (5.25, 2.0), (0.0, 1.0)),
        ((5.5, 9.0), (5.5, 0.0), {"mask": 1}, "floor", (5.5, 1.0), (5.5, 0.0), (0.0, 1.0)),
        ((5.5, 9.0), (5.5, 0.0), {"ignoring": "box"}, "floor", (5.5, 1.0), (5.5, 0), (0, 1)),
        ((0.0, 1.0), (9.0, 1.0), {}, "box", (3.0, 1.0), (4.0, 1.0), (-1.0, 0.0)),
        ((0.0, 1.0), (-9.0, 1.0), {}, "disc", (-3.0, 1.0), (-4.0, 1.0), (1.0, 0.0)),
        ((5.0, 3.0), (5.0, 2.0), {}, "box", (5.0, 3.0), (5.0, 2.0), (0.0, 1.0)),
        ((5.0, 2.9), (5.0, 2.0), {}, "box", (5.0, 2.9), (5.0, 2.0), (0.0, 1.0)),
    ],
)
def test_known_answers(
    start: tuple[float, float],
    end: tuple[float, float],
    asked: dict[str, object],
    met: str,
    stops: tuple[float, float],
    point: tuple[float, float],
    normal: tuple[float, float],
) -> None:
    sim = room()
    hit = sim.shape_cast(BOX, start, end, **asked)  # type: ignore[arg-type]
    assert hit.body[0] == sim.index(met)
    place = np.array(start) + hit.fraction[0] * (np.array(end) - start)
    assert place == pytest.approx(stops, abs=1e-12)
    assert hit.point[0] == pytest.approx(point, abs=1e-12)
    assert hit.normal[0] == pytest.approx(normal, abs=1e-12)


@pytest.mark.parametrize("height", [3.0, 2.9, 3.0 - 1e-13])
@pytest.mark.parametrize("end", [(9.0, 0.0), (-7.0, 0.0), (1.0, 1.0)])
def test_what_it_slides_along_or_leaves_is_not_met(height: float, end: tuple[float, float]) -> None:
    sim, start = room(), np.array((5.0, height))
    assert sim.shape_cast(BOX, start, start + end).body[0] == -1


def test_a_disc_that_passes_by_just_so_is_not_met() -> None:
    sim, disc = room(), t2.Disc(radius=0.5)
    for over, met in ((-1e-9, sim.index("disc")), (1e-9, -1)):
        assert sim.shape_cast(disc, (-9.0, 2.5 + over), (0.0, 2.5 + over)).body[0] == met


def test_all_at_once_is_one_by_one() -> None:
    sim = t2.Simulator(crowd(40, seed=5))
    start, end = np.random.default_rng(1).uniform(-9, 9, (2, 50, 2))
    for shape in SHAPES:
        many = sim.shape_cast(shape, start, end, orientation=0.3)
        for k in range(0, 50, 5):
            one = sim.shape_cast(shape, start[k], end[k], orientation=0.3)
            assert (one.body[0], one.fraction[0]) == (many.body[k], many.fraction[k])
        assert len(set(many.body.tolist())) > 5


def test_far_from_the_origin() -> None:
    scene = t2.Scene(gravity=(0.0, 0.0))
    scene.add_static(t2.Box(width=2.0, height=2.0), position=(1e6, -1e6), orientation=0.7)
    sim = t2.Simulator(scene)
    hit = sim.shape_cast(t2.Disc(radius=0.5), (1e6 + 9.0, -1e6), (1e6, -1e6))
    corner = np.cos(0.7) + np.sin(0.7), np.sin(0.7) - np.cos(0.7)
    reach = corner[0] + np.sqrt(0.25 - corner[1] ** 2)
    assert hit.fraction[0] * 9.0 == pytest.approx(9.0 - reach, abs=1e-9)


@pytest.mark.parametrize(
    ("shape", "end", "given", "says"),
    [
        (t2.HalfPlane(normal=(0.0, 1.0), offset=0.0), (1.0, 0.0), {}, r"shape of .*bounded"),
        (None, (1.0, 0.0), {}, r"shape of the shape cast: found None"),
        (BOX, (0.0, 0.0), {}, r"end\[0\] of the shape cast: found the start"),
        (BOX, (np.nan, 0.0), {}, "end"),
        (BOX, (1.0, 0.0), {"orientation": "up"}, "orientation"),
        (BOX, (1.0, 0.0), {"ignoring": "nobody"}, "nobody"),
        (BOX, (1.0, 0.0), {"mask": 1.5}, "mask"),
    ],
)
def test_a_cast_that_cannot_be_is_refused(
    shape: object, end: object, given: dict[str, object], says: str
) -> None:
    with pytest.raises(t2.InputError, match=says):
        room().shape_cast(shape, (0.0, 0.0), end, **given)  # type: ignore[arg-type]
