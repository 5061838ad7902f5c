"""Parts of a compound with surfaces of their own, in steps (R3).

Expected values come from Coulomb's law, from Newton's law of impact, and from what is the same with
values that hold from the start.
"""

import copy
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.scene import Shape
from tamias2d.simulator import saving

G = 10.0
PLANE = t2.HalfPlane(normal=(0.0, 1.0), offset=0.0)
BOARD = t2.Box(width=2.0, height=0.1)
BALL = t2.Disc(radius=0.2)
SURFACES = {"friction": 0.16, "restitution": 1.0}  # of the ground


def sledge(*, runner: float | None = 0.25, back: float | None = None) -> t2.Compound:
    """A flat body with a runner below and a back above."""
    return t2.Compound(
        parts=[
            t2.Part(shape=BOARD, position=(0.0, -0.05), friction=runner),
            t2.Part(shape=BOARD, position=(0.0, 0.05), friction=back),
        ]
    )


def mallet() -> t2.Compound:
    """A ball that bounces, above one that does as its body states."""
    ends = [
        t2.Part(shape=BALL, position=(0.0, 0.5), restitution=0.75),
        t2.Part(shape=BALL, position=(0.0, -0.5)),
    ]
    return t2.Compound(parts=[*ends, t2.Part(shape=t2.Box(width=0.1, height=0.8))])


def sliding(shape: t2.Compound, *, upside_down: bool = False, **settings: Any) -> t2.Simulator:
    scene = t2.Scene(gravity=(0.0, -G))
    scene.add_static(PLANE, name="ice", **SURFACES)
    scene.add_body(
        shape, mass=2.0, position=(0.0, 0.1), velocity=(4.0, 0.0), restitution=0.0, friction=1.0,
        orientation=np.pi if upside_down else 0.0, name="sledge",
    )  # fmt: skip
    return t2.Simulator(scene, **settings)


def deceleration(sim: t2.Simulator) -> float:
    """Return by how much a sledge is braked, m/s^2, over thirty steps."""
    before = sim.velocity[1, 0]
    sim.step(30)
    return float(before - sim.velocity[1, 0]) / 30 / sim.time_step


def dropped(*, upside_down: bool, **body: Any) -> t2.Scene:
    """Return a mallet that cannot turn, let go 1.8 m above the ground: it meets that at 6 m/s."""
    scene = t2.Scene(gravity=(0.0, -G))
    scene.add_static(PLANE, name="ground", **SURFACES)
    shape, turn = mallet(), np.pi if upside_down else 0.0
    height = 0.7 + (-1 if upside_down else 1) * shape.centroid[1] + 1.8
    place: Any = {"position": (0.0, height), "orientation": turn, "inertia": np.inf}
    scene.add_body(shape, mass=3.0, name="mallet", **place, **{"restitution": 0.25, **body})
    return scene


@pytest.mark.parametrize(("upside_down", "friction"), [(False, 0.2), (True, 0.4)])
def test_what_slides_is_braked_by_the_part_that_touches(upside_down: bool, friction: float) -> None:
    """With the ground's 0.16, the runner's 0.25 makes 0.2, and the body's 1 makes 0.4 (DD23)."""
    assert deceleration(sliding(sledge(), upside_down=upside_down)) == pytest.approx(
        friction * G,
        rel=1e-5,  # it settles in its first steps
    )


@pytest.mark.parametrize(("upside_down", "restitution"), [(False, 0.25), (True, 0.75)])
def test_what_falls_bounces_by_the_part_that_meets(upside_down: bool, restitution: float) -> None:
    """Steps locate the impact, so that the speed after it is that of Newton's law to rounding."""
    scene = dropped(upside_down=upside_down)
    sim = t2.Simulator(scene)
    while sim.velocity[1, 1] <= 0.0:
        sim.step()
    later = sim.time - 0.6
    assert sim.velocity[1, 1] == pytest.approx(restitution * 6.0 - G * later, abs=1e-9)
    run = t2.simulate(scene, times=(0.7,), duration=0.7)
    assert run.method == t2.Stepped()
    assert run.velocity[0, 1, 1] == pytest.approx(restitution * 6.0 - G * 0.1, abs=1e-9)


def test_what_is_set_for_a_pair_wins_over_parts() -> None:
    scene = t2.Scene(gravity=(0.0, -G))
    scene.add_static(PLANE, name="ice", **SURFACES)
    place: Any = {"position": (0.0, 0.1), "velocity": (4.0, 0.0)}
    scene.add_body(sledge(back=0.5), mass=2.0, name="sledge", restitution=0.0, **place)
    scene.set_friction("sledge", "ice", 0.3)
    assert deceleration(t2.Simulator(scene)) == pytest.approx(0.3 * G, rel=1e-5)


def test_bits_are_those_of_a_body_that_states_the_same() -> None:
    """Also where each part states all, so that the body's own values count nowhere."""
    found = []
    for runner, back, own in ((None, None, 0.25), (0.25, 0.25, 0.9), (None, 0.25, 0.25)):
        sim = sliding(sledge(runner=runner, back=back))
        sim.set_surface("sledge", friction=own)
        sim.step(60)
        found.append(sim.digest())
    assert len(set(found)) == 1


def test_a_part_gets_another_surface_between_steps() -> None:
    sim = sliding(sledge())
    sim.set_surface("sledge", friction=0.64)  # the runner states its own
    assert deceleration(sim) == pytest.approx(0.2 * G, rel=1e-5)
    sim.set_surface("sledge", part=1, friction=0.0)
    assert deceleration(sim) == pytest.approx(0.2 * G, rel=1e-5)
    sim.set_surface(["sledge"], part=[0], friction=0.04)
    assert deceleration(sim) == pytest.approx(0.08 * G, rel=1e-5)
    stated = sim.body("sledge")
    assert isinstance(stated.shape, t2.Compound)
    assert stated.friction == 0.64
    assert [part.friction for part in stated.shape.parts] == [0.04, 0.0]
    assert [part.restitution for part in stated.shape.parts] == [None, None]


def test_parts_of_bodies_that_were_just_added_among_freed_rows_are_their_own() -> None:
    """A part is found by its number, wherever the shapes of removed bodies left room."""
    sim = t2.Simulator(t2.Scene(gravity=(0.0, 0.0)))
    surface: Any = {"restitution": 0.5}
    bodies = sim.add(mallet(), mass=1.0, position=[(5.0 * k, 0.0) for k in range(9)], **surface)
    sim.step()
    sim.remove(bodies[::3])
    sim.step()
    new = sim.add(mallet(), mass=1.0, position=[(5.0 * k, 9.0) for k in range(4)], **surface)
    chosen = [*new.tolist(), int(bodies[1]), int(new[0])]
    sim.set_surface(chosen, part=[0, 1, 2, 1, 2, 1], friction=[0.1, 0.2, 0.3, 0.4, 0.5, 0.6])
    told = [[part.friction for part in sim.body(k).shape.parts] for k in chosen[:5]]  # type: ignore[union-attr]
    none = None
    assert told == [
        [0.1, 0.6, none],
        [none, 0.2, none],
        [none, none, 0.3],
        [none, 0.4, none],
        [none, none, 0.5],
    ]
    kinds = [type(part.shape) for part in sim.body(int(new[3])).shape.parts]  # type: ignore[union-attr]
    assert kinds == [t2.Disc, t2.Disc, t2.Box]


def test_a_part_has_its_number_before_the_next_step() -> None:
    """Also where the shape of a removed body left room for another part below it."""
    parts = [t2.Part(shape=BOARD), t2.Part(shape=BALL, position=(0.0, 1.0))]
    sim = t2.Simulator(t2.Scene(gravity=(0.0, 0.0)))
    sim.add(t2.Compound(parts=parts), mass=1.0, position=(0.0, 0.0), restitution=0.0)
    sim.step()
    sim.remove(0)
    sim.step()
    sim.add(t2.Compound(parts=parts[::-1]), mass=1.0, position=(0.0, 0.0), restitution=0.0)
    sim.set_surface(0, part=0, friction=0.5)
    found = sim.body(0).shape
    assert isinstance(found, t2.Compound)
    assert [(type(p.shape), p.friction) for p in found.parts] == [
        (t2.Disc, 0.5),
        (t2.Polygon, None),
    ]


def test_what_parts_state_moves_with_their_shapes() -> None:
    """Bodies that come together are put in order from left to right, and their shapes with them."""
    scene = t2.Scene(gravity=(0.0, 0.0))
    for k, x in enumerate((9.0, 0.0, 5.0)):
        own = {"restitution": 0.0, "friction": 0.125 * k}
        scene.add_body(sledge(runner=0.25 * k), mass=1.0, position=(x, 0.0), **own)  # type: ignore[arg-type]
    sim = t2.Simulator(scene)
    sim.step()
    told = [(sim.body(k).friction, sim.body(k).shape.parts[0].friction) for k in range(3)]  # type: ignore[union-attr]
    assert told == [(0.0, 0.0), (0.125, 0.25), (0.25, 0.5)]


def test_what_sleeps_wakes_where_a_part_changes() -> None:
    sim = sliding(sledge(runner=0.5), sleeping=True)
    sim.velocity[1] = 0.0
    sim.step(120)
    assert sim.asleep[1]
    sim.set_surface("sledge", part=1, friction=1.0)  # which it had from its body
    assert sim.asleep[1]
    sim.set_surface("sledge", part=0, friction=0.25)
    assert not sim.asleep[1]


@pytest.mark.parametrize("kept", ["file", "pickle", "state", "copy of the body"])
def test_what_parts_state_is_kept(kept: str, tmp_path: Path) -> None:
    sim = sliding(sledge(back=0.5))
    sim.set_surface("sledge", part=0, friction=0.36)
    sim.set_surface("sledge", friction=0.7)
    sim.step(5)
    if kept == "file":
        sim.save(tmp_path / "game.npz")
        other = t2.Simulator.restore(tmp_path / "game.npz")
    elif kept == "pickle":
        other = copy.copy(sim)
    elif kept == "state":
        state, other = sim.copy_state(), copy.copy(sim)
        sim.set_surface("sledge", part=0, friction=0.0)
        sim.set_surface("sledge", part=1, restitution=0.0)
        sim.set_surface("sledge", friction=0.0)
        sim.step(5)
        sim.restore_state(state)
    else:
        body = sim.body("sledge")
        scene = t2.Scene(gravity=(0.0, -G))
        scene.add_static(PLANE, **SURFACES)
        same: Any = {key: getattr(body, key) for key in ("mass", "position", "velocity")}
        same |= {"orientation": body.orientation, "angular_velocity": body.angular_velocity}
        same |= {"friction": body.friction, "restitution": body.restitution}
        scene.add_body(body.shape, name="sledge", **same)
        other = t2.Simulator(scene)
    stated = [(s.friction, [p.friction for p in s.shape.parts]) for s in map(of, (sim, other))]  # type: ignore[union-attr]
    assert stated == [(0.7, [0.36, 0.5])] * 2
    assert deceleration(other) == pytest.approx(0.24 * G, rel=1e-3)  # it settles
    if kept != "copy of the body":
        assert deceleration(sim) == pytest.approx(0.24 * G, rel=1e-3)
        assert sim.digest() == other.digest()


def of(sim: t2.Simulator) -> Any:
    return sim.body("sledge")


def test_a_saved_surface_that_does_not_follow_from_what_is_stated_is_refused(
    tmp_path: Path,
) -> None:
    sim = sliding(sledge())
    path = tmp_path / "game.npz"
    sim.save(path)
    arrays = saving.read(path)
    arrays["engine.shapes.stated"][1, 0] = 0.3
    del arrays["digest"]
    np.savez(path, digest=np.array(saving.digest(arrays)), **arrays)
    with pytest.raises(t2.RecordingError, match="must follow from what is stated"):
        t2.Simulator.restore(path)


def test_another_compound_brings_the_surfaces_of_its_parts() -> None:
    """What the body states stays, also where no part of the shape before had it."""
    sim = sliding(sledge(back=0.0))
    sim.velocity[1, 0] = 9.0
    sim.step(10)
    sim.set_shape("sledge", sledge(runner=0.0625, back=0.5))
    assert deceleration(sim) == pytest.approx(0.1 * G, rel=1e-2)
    sim.set_shape("sledge", sledge(runner=None))
    assert deceleration(sim) == pytest.approx(0.4 * G, rel=1e-2)
    sim.set_shape("sledge", t2.Box(width=2.0, height=0.2))
    assert deceleration(sim) == pytest.approx(0.4 * G, rel=1e-2)
    assert (of(sim).friction, of(sim).restitution) == (1.0, 0.0)


def silent(x: float, shape: Shape, **more: Any) -> dict[str, Any]:
    return {"shape": shape, "mass": 1.0, "position": (x, 0.0), **more}


def stating(*values: float | None) -> t2.Compound:
    return t2.Compound(
        parts=[
            t2.Part(shape=BALL, position=(0.0, float(k)), restitution=value)
            for k, value in enumerate(values)
        ]
    )


def test_a_part_without_a_restitution_makes_a_pair_without_one() -> None:
    """Two bodies can meet with all of their parts, and both may be silent there (R3)."""
    scene = t2.Scene(gravity=(0.0, 0.0))
    for x in (0.0, 9.0):
        scene.add_body(stating(0.5, 0.5), mass=1.0, position=(x, 0.0))
    sim = t2.Simulator(scene)
    sim.add(**silent(18.0, stating(0.5, None)))  # the others state all
    with pytest.raises(t2.SceneError, match="restitution of the pair body 2 and body 0 of those"):
        sim.add(**silent(27.0, stating(None, 0.5)))
    with pytest.raises(t2.SceneError, match="restitution of the pair body 'body0' and body 2"):
        sim.set_shape(0, stating(0.5, None))
    sim.set_shape(2, stating(0.1, 0.2))
    sim.set_shape(0, stating(0.5, None))
    sim.set_surface(0, restitution=0.3)
    sim.set_shape(1, BALL)
    sim.step()


@pytest.mark.parametrize(
    ("wrong", "message"),
    [
        ({"part": 3, "friction": 0.1}, "part of body 1: found 3: it has 3 parts"),
        ({"part": -1, "friction": 0.1}, "part -1: must be a whole number of at least 0"),
        ({"part": 0.5, "friction": 0.1}, "part 0.5: must be a whole number"),
        ({"part": [0, 1], "friction": 0.1}, "part of the bodies: found an array of shape"),
        ({"part": 0, "friction": -1.0}, "friction\\[0\\] -1 of the bodies: must be >= 0"),
        ({"part": 0, "restitution": 2.0}, "restitution\\[0\\] 2 of the bodies"),
        ({"part": 0, "surface_speed": 1.0}, "surface_speed of a part: the surface of a body runs"),
        ({"part": 0}, "found nothing to change"),
    ],
)
def test_what_cannot_be_set_of_a_part_is_refused(wrong: Any, message: str) -> None:
    sim = t2.Simulator(t2.Scene(gravity=(0.0, 0.0)))
    sim.add_static(BALL, position=(9.0, 0.0), restitution=0.0)
    sim.add_static(mallet(), restitution=0.0)
    with pytest.raises(t2.InputError, match=message):
        sim.set_surface(1, **wrong)


@pytest.mark.parametrize(
    "shape", [BALL, PLANE, t2.Chain(vertices=[(0.0, 0.0), (1.0, 0.0), (2.0, 1.0)])]
)
def test_what_is_no_compound_has_no_parts(shape: Shape) -> None:
    sim = t2.Simulator(t2.Scene(gravity=(0.0, 0.0)))
    sim.add_static(shape, restitution=0.0)
    with pytest.raises(t2.InputError, match="part of body 0: found 0: the body is no compound"):
        sim.set_surface(0, part=0, friction=0.5)


def test_a_compound_of_one_part_that_states_something_is_told_as_one() -> None:
    sim = t2.Simulator(t2.Scene(gravity=(0.0, 0.0)))
    one = t2.Compound(parts=[t2.Part(shape=BALL, friction=0.5)])
    sim.add(one, mass=1.0, position=(0.0, 0.0), restitution=0.0)
    assert sim.body(0).shape == one
    sim.set_surface(0, part=0, friction=0.25)
    assert sim.body(0).shape == t2.Compound(parts=[t2.Part(shape=BALL, friction=0.25)])


def test_plain_python_has_the_same_bits() -> None:
    sims = [
        t2.Simulator(dropped(upside_down=True), compiled=compiled) for compiled in (True, False)
    ]
    for sim in sims:
        sim.step(40)
    assert sims[0].digest() == sims[1].digest()


@pytest.mark.parametrize("reverse", [False, True])
def test_order_of_adding_changes_nothing_where_only_parts_differ(reverse: bool) -> None:
    """Bodies in one place are put in order by what their parts state."""
    shapes: list[Callable[[], t2.Compound]] = [
        lambda: sledge(runner=0.1, back=0.5),
        lambda: sledge(runner=0.1, back=0.2),
    ]
    digests = set()
    for order in (shapes, shapes[::-1]):
        scene = t2.Scene(gravity=(0.0, -G))
        scene.add_static(PLANE, **SURFACES)
        for make in order[:: -1 if reverse else 1]:
            scene.add_body(
                make(), mass=2.0, position=(0.0, 0.1), orientation=np.pi, velocity=(4.0, 0.0),
                restitution=0.0, friction=1.0, group=-1,
            )  # fmt: skip
        sim = t2.Simulator(scene)
        sim.step(10)
        digests.add(sim.digest())
    assert len(digests) == 1
