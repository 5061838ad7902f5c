"""Worlds whose bodies are altered between steps go the way of each alone, altered likewise.

After a reset they go the way they went, whatever was altered.
"""

import copy
import pickle
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import tamias2d as t2
from tests.ensemble.test_simulators import check
from tests.simulator.crowd import SHAPES, crowd

WORLDS = 5
COUNT = 10  # of bodies that move, behind three walls
FIRST = 3
STATED: Any = {"friction": 0.3, "restitution": 0.1}


def scene_of(seed: int) -> t2.Scene:
    """Bodies of all shapes in a container, some with joints or springs, in a field by mass."""
    scene = crowd(COUNT - 2, seed=seed, size=4.0, overlap=False)
    names = [body.name for body in scene.bodies][FIRST:]
    if seed % 2:
        scene.add_spring(names[0], names[1], stiffness=40.0, damping=1.0, rest_length=2.0)
        scene.add_field(force=("mass*0.5[m/s^2]", "-mass*0.5[1/s^2]*y(position)"))
    for k, name in enumerate(("hub", "arm")):
        place = (2.5 + 0.6 * k, 3.3)
        scene.add_body(SHAPES[k], mass=1.0, position=place, name=name, group=-7, **STATED)
    if seed % 3:
        drive = t2.Revolute(motor=t2.Motor(speed=2.0, maximum=5.0))
        scene.add_joint(drive, "hub", "arm", at=(2.8, 3.3), name="drive")
        rope = t2.Distance(limits=t2.Limits(upper=9.0, restitution=0.0))
        scene.add_joint(rope, (0.0, 0.5), names[4], name="rope")
    return scene


def started(seed: int, **settings: Any) -> tuple[t2.Simulators, list[t2.Simulator]]:
    """Return worlds together, and the same ones alone."""
    settings = {"substeps": 3, "sleeping": seed % 4 > 1, **settings}
    together = t2.Simulators(
        lambda w, _: scene_of(seed + 12 * w), worlds=WORLDS, seed=1, **settings
    )
    return together, [t2.Simulator(scene_of(seed + 12 * w), **settings) for w in range(WORLDS)]


Call = tuple[str, Any, dict[str, Any], list[dict[str, Any]]]


def drawn(chance: np.random.Generator) -> Call:
    """Return a call, its bodies, and its values: of all worlds, and of each alone."""
    one = chance.random() < 0.4
    bodies: Any = int(chance.integers(FIRST, FIRST + COUNT))
    if not one:
        bodies = sorted(chance.permutation(np.arange(FIRST, FIRST + COUNT))[:3].tolist())

    def values(least: float, most: float) -> tuple[Any, list[Any]]:
        shapes = [(), (WORLDS,)] if one else [(), (3,), (WORLDS, 3)]
        shape = shapes[chance.integers(len(shapes))]
        found = chance.uniform(least, most, shape)
        by_world = len(shape) > 0 and shape[0] == WORLDS
        return found.tolist(), [found[w].tolist() if by_world else found.tolist()
                                for w in range(WORLDS)]  # fmt: skip

    def whole(most: int) -> tuple[Any, list[Any]]:
        found, each = values(0, most)
        return np.array(found).astype(int), [np.array(one).astype(int) for one in each]

    def shapes() -> tuple[Any, list[Any]]:
        table = [[SHAPES[k] for k in row] for row in chance.integers(0, len(SHAPES), (WORLDS, 3))]
        if one:
            column = [row[0] for row in table]
            return column, column
        return (table, table) if chance.random() < 0.5 else (table[0], [table[0]] * WORLDS)

    calls: list[tuple[str, dict[str, tuple[Any, list[Any]]]]] = [
        ("set_mass", {"mass": values(0.5, 4.0)}),
        ("set_mass", {"mass": values(0.5, 4.0), "inertia": values(0.1, 2.0)}),
        ("set_drag", {"linear_drag": values(0.0, 2.0), "angular_drag": values(0.0, 0.1)}),
        ("set_surface", {"friction": values(0.0, 1.0), "restitution": values(0.0, 0.3)}),
        ("set_filters", {"mask": whole(4), "group": whole(3)}),
        ("set_shape", {"shape": shapes()}),
        ("set_shape", {"shape": shapes(), "mass": values(0.5, 4.0)}),
    ]
    name, words = calls[chance.integers(len(calls))]
    alone = [{key: each[w] for key, (_, each) in words.items()} for w in range(WORLDS)]
    return name, bodies, {key: given for key, (given, _) in words.items()}, alone


def altered(
    chance: np.random.Generator, together: t2.Simulators, alone: list[t2.Simulator]
) -> None:
    name, bodies, words, each = drawn(chance)
    getattr(together, name)(bodies, **words)
    for sim, own in zip(alone, each, strict=True):
        getattr(sim, name)(bodies, **own)


def digests(sims: t2.Simulators) -> list[str]:
    return [sims.world(k).digest() for k in range(len(sims))]


@pytest.mark.filterwarnings("ignore::tamias2d.StepWarning")
@pytest.mark.parametrize("seed", range(8))
def test_worlds_are_altered_as_each_alone_and_a_reset_undoes_it(seed: int) -> None:
    chance = np.random.default_rng(seed)
    together, alone = started(seed)
    fresh = together.world(0).body(FIRST)
    together.step(40)
    for sim in alone:
        sim.step(40)
    first = digests(together)
    for _ in range(8):
        for _ in range(1 + int(chance.integers(2))):
            altered(chance, together, alone)
        count = int(chance.choice([1, 1, 7, 40]))
        together.step(count)
        for sim in alone:
            sim.step(count)
        check(together, alone)
        assert together.asleep.tolist() == [sim.asleep.tolist() for sim in alone]
    assert digests(together) == [sim.digest() for sim in alone]
    assert [together.world(1).body(k) for k in range(FIRST + COUNT)] == [
        alone[1].body(k) for k in range(FIRST + COUNT)
    ]

    copied = pickle.loads(pickle.dumps(together))
    mask = np.arange(WORLDS) % 2 == 0
    for sims in (together, copied):
        sims.reset(mask)
        sims.step(40)
        assert [a == b for a, b in zip(digests(sims), first, strict=True)] == mask.tolist()
    assert digests(copied) == digests(together)
    assert pickle.loads(pickle.dumps(copied)).world(1).body(4) == together.world(1).body(4)
    together.reset()
    assert together.world(0).body(FIRST) == fresh
    together.step(40)
    assert digests(together) == first


@pytest.mark.filterwarnings("ignore::tamias2d.StepWarning")
@pytest.mark.parametrize("seed", [1, 4, 10])
def test_another_episode_is_altered_after_the_reset(seed: int) -> None:
    """It goes as in worlds that were made anew."""
    together, before = started(seed)
    chance = np.random.default_rng(seed)
    for _ in range(3):
        for _ in range(4):
            altered(chance, together, before)
        together.step(20)
    other, alone = started(seed)
    together.reset()
    for sims in (together, other):
        sims.set_mass([4, 5], mass=np.arange(1.0, 11.0).reshape(WORLDS, 2))
        sims.set_shape(6, [SHAPES[k] for k in range(WORLDS)])
        sims.set_filters(7, group=-np.arange(WORLDS))
        sims.step(20)
    assert digests(together) == digests(other)
    for w, sim in enumerate(alone):
        sim.set_mass([4, 5], mass=[1.0 + 2 * w, 2.0 + 2 * w])
        sim.set_shape(6, SHAPES[w])
        sim.set_filters(7, group=-w)
        sim.step(20)
    assert digests(together) == [sim.digest() for sim in alone]


def pucks() -> t2.Scene:
    """A wall, a box and a compound, which need no restitution for a pair of them."""
    scene = t2.Scene(gravity=(0.0, 0.0))
    wall = t2.HalfPlane(normal=(1.0, 0.0), offset=-5.0)
    scene.add_static(wall, name="wall", **STATED)
    for k, name in enumerate(("box", "bar")):
        place = (4.0 * k, 0.0)
        scene.add_body(SHAPES[1 + 3 * k], mass=2.0, position=place, name=name, **STATED)
    scene.add_body(None, mass=1.0, position=(9.0, 9.0), name="dust")
    return scene


def test_masses_are_told_as_they_are() -> None:
    sims = t2.Simulators(pucks(), worlds=3)
    sims.set_mass("box", mass=[1.0, 2.0, 4.0])
    assert sims.mass[:, 1].tolist() == [1.0, 2.0, 4.0]
    sims.set_shape("bar", SHAPES[0], mass=8)
    assert sims.mass[:, 2].tolist() == [8.0] * 3
    copied = copy.copy(sims)
    sims.reset(np.array([False, True, False]))
    assert sims.mass[:, 1:3].tolist() == [[1.0, 8.0], [2.0, 2.0], [4.0, 8.0]]
    assert copied.mass[:, 1:3].tolist() == [[1.0, 8.0], [2.0, 8.0], [4.0, 8.0]]
    copied.reset()
    assert copied.mass[:, 1:3].tolist() == [[2.0, 2.0]] * 3


def test_parts_get_surfaces_of_their_own() -> None:
    sims = t2.Simulators(pucks(), worlds=2)
    sims.set_surface("bar", friction=[0.5, 0.7], part=[0, 1])
    parts = [sims.world(w).body("bar").shape.parts for w in range(2)]  # type: ignore[union-attr]
    assert [[part.friction for part in own] for own in parts] == [[0.5, None], [None, 0.7]]
    sims.set_surface(["bar", "box"], friction=[[0.1, 0.2], [0.3, 0.4]])
    assert [sims.world(w).body("box").friction for w in range(2)] == [0.2, 0.4]
    sims.set_surface("wall", surface_speed=[1.0, -1.0])
    assert [sims.world(w).body("wall").surface_speed for w in range(2)] == [1.0, -1.0]
    sims.reset()
    assert sims.world(1).body("bar") == t2.Simulator(pucks()).body("bar")


def test_what_was_told_of_walls_is_told_again_after_a_reset() -> None:
    """Walls that only just met, and do not where one was made longer."""
    scene = t2.Scene(gravity=(0.0, -10.0))
    for k, x in enumerate((-1.0, 1.0)):
        wall = t2.Segment(length=2.0)
        scene.add_static(wall, position=(x, 0.0), name=f"wall{k}", **STATED)
    thin = t2.Box(width=1.0, height=0.004)
    scene.add_body(thin, mass=1.0, position=(0.0, 1.0), name="sheet", **STATED)
    with pytest.warns(t2.StepWarning, match="wall"):
        sims = t2.Simulators(scene, worlds=1)
    told = sims.warnings
    sims.set_shape("wall0", t2.Segment(length=2.5))
    sims.step()
    sims.reset()
    with pytest.warns(t2.StepWarning, match="wall"):
        sims.step()
    assert sims.warnings == told


BAD: list[tuple[Callable[[t2.Simulators], object], type[Exception], str]] = [
    (lambda s: s.set_mass(1, mass=[1, 1, -1]), t2.InputError, r"^world 2: mass\[0\] -1"),
    (lambda s: s.set_mass([1, 2], mass=[[1, 1], [1, 0], [1, 1]]), t2.InputError,
     r"^world 1: mass\[1\] 0"),
    (lambda s: s.set_mass(1, mass=[1.0, 1e-200, 1e-310]), t2.InputError, "^world 2: mass"),
    (lambda s: s.set_mass(1, mass=1.0, inertia=[1, np.nan, 1]), t2.InputError, "^world 1: inertia"),
    (lambda s: s.set_mass(0, mass=1.0), t2.InputError, "^world 0: mass of body 'wall': nothing"),
    (lambda s: s.set_mass("cat", mass=1.0), t2.InputError, "body 'cat'|bodies: found 'cat'"),
    (lambda s: s.set_mass(1, mass=[1, 2]), t2.InputError,
     r"mass of the worlds: found int64 of shape \(2,\): .* \(\) or \(3,\) \(R4\)"),
    (lambda s: s.set_mass([1, 2], mass=[1, 2, 3]), t2.InputError, r"\(\) or \(2,\) or \(3, 2\)"),
    (lambda s: s.set_mass(1, mass=[1, None, 2]), t2.InputError, "mass of the worlds: found object"),
    (lambda s: s.set_mass(1, mass="heavy"), t2.InputError, "mass of the worlds: found <U5"),
    (lambda s: s.set_mass(1, mass=None), t2.InputError, "^world 0: mass .*found None"),
    (lambda s: s.set_drag(1, linear_drag=[0, 0, -1]), t2.InputError, "^world 2: linear drag"),
    (lambda s: s.set_mass(1, mass=[1, 1e-308, 1], inertia=1), t2.InputError, "^world 1: linear"),
    (lambda s: s.set_drag(1), t2.InputError, "^world 0: the bodies: found nothing to change"),
    (lambda s: s.set_surface(1, friction=[0, 0, -1]), t2.InputError, "^world 2: friction"),
    (lambda s: s.set_surface(2, friction=0, part=[0, 1, 2]), t2.InputError, "^world 2: .*part"),
    (lambda s: s.set_surface(1, surface_speed=1), t2.InputError, "^world 0: surface_speed of body"),
    (lambda s: s.set_filters(1, mask=[1, 1, 0.5]), t2.InputError, "^world 0: mask .*whole number"),
    (lambda s: s.set_filters(1, mask=[1, -1, 1]), t2.InputError, "^world 1: mask"),
    (lambda s: s.set_shape(1, [SHAPES[0]] * 2), t2.InputError, "shape of the worlds: found 2 for"),
    (lambda s: s.set_shape([1, 2], [SHAPES] * 3), t2.InputError, "^world 0: shape .* 5 for 2"),
    (lambda s: s.set_shape(1, [SHAPES[0], SHAPES[0], "disc"]), t2.InputError, "^world 2: shape"),
    (lambda s: s.set_shape(3, SHAPES[0]), t2.InputError, "^world 0: shape of body 'dust'"),
    (lambda s: s.set_shape(1, SHAPES[0], mass=[1, 1, -1]), t2.InputError, "^world 2: mass"),
]  # fmt: skip


@pytest.mark.parametrize("steps", [0, 2])
@pytest.mark.parametrize(("call", "error", "says"), BAD)
def test_what_cannot_be_is_refused_and_altered_in_no_world(
    call: Callable[[t2.Simulators], object], error: type[Exception], says: str, steps: int
) -> None:
    sims = t2.Simulators(pucks(), worlds=3, threads=1)
    sims.set_drag(1, linear_drag=5.0)
    sims.step(steps)
    before = [[sims.world(w).body(k) for k in range(4)] for w in range(3)]
    with pytest.raises(error, match=says):
        call(sims)
    assert [[sims.world(w).body(k) for k in range(4)] for w in range(3)] == before


def silent(world: int, random: object) -> t2.Scene:  # noqa: ARG001
    """Two discs that may not touch and state no restitution, but in the first world."""
    scene = t2.Scene(gravity=(0.0, 0.0))
    for k in range(2):
        own = 0.5 if world == 0 else None
        scene.add_body(t2.Disc(radius=0.1), mass=1.0, position=(k, 0.0), group=-1, restitution=own)
    return scene


def test_a_world_in_which_a_restitution_is_missing_is_named() -> None:
    sims = t2.Simulators(silent, worlds=3, seed=1)
    with pytest.raises(t2.SceneError, match=r"^world 1: restitution of the pair"):
        sims.set_filters([0, 1], group=0)
    assert [sims.world(w).body(0).group for w in range(3)] == [-1] * 3
    sims.set_filters([0, 1], group=[[0, 0], [-2, -2], [-3, -3]])
    assert [sims.world(w).body(0).group for w in range(3)] == [0, -2, -3]
