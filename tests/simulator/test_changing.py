"""Bodies are added and removed while it runs; the order of adding changes nothing."""

from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

import tamias2d as t2
from tamias2d.engine import tables as tb
from tests.rebuilt import arguments, rebuilt
from tests.simulator.crowd import SHAPES, crowd


@settings(max_examples=8)
@given(st.integers(0, 2**32 - 1))
def test_the_order_of_building_changes_no_bit(seed: int) -> None:
    scene = crowd(25, seed=seed % 1000)
    order = np.random.default_rng(seed).permutation(len(scene)).tolist()
    one, other = t2.Simulator(scene), t2.Simulator(rebuilt(scene, order))
    for _ in range(40):
        one.step()
        other.step()
    assert one.digest() == other.digest()
    assert (one.position[order] == other.position).all()
    assert (one.velocity[order] == other.velocity).all()
    assert (one.contacts.impulse == other.contacts.impulse).all()
    names = [other_body.name for other_body in other_bodies(scene, order)]
    pairs = [[scene.bodies[k].name for k in pair] for pair in one.contacts.bodies]
    assert pairs == [[names[k] for k in pair] for pair in other.contacts.bodies]


def other_bodies(scene: t2.Scene, order: list[int]) -> list[t2.Body]:
    return [scene.bodies[k] for k in order]


def test_a_scene_and_the_same_bodies_added_are_one() -> None:
    scene = crowd(20, seed=8)
    whole = t2.Simulator(scene)
    grown = t2.Simulator(t2.Scene(gravity=scene.gravity))
    for body in reversed(scene.bodies):
        if body.dynamic:
            grown.add(body.shape, **arguments(body))
        else:
            surface = {"friction": body.friction, "restitution": body.restitution}
            grown.add_static(body.shape, **surface)
    for sim in (whole, grown):
        sim.step(50)
    assert whole.digest() == grown.digest()


def test_rows_stay_and_freed_ones_are_used_again() -> None:
    sim = t2.Simulator(crowd(10, seed=2))
    sim.step(5)
    before = sim.position.copy()
    sim.remove([4, 7])
    assert sim.present.tolist() == [k not in (4, 7) for k in range(13)]
    assert len(sim) == 11
    others = sim.present
    assert (sim.position[others] == before[others]).all()
    with pytest.raises(t2.InputError, match="body 4: the simulator has none such"):
        sim.remove(4)
    sim.step()
    assert not sim.position[[4, 7]].any()
    new = sim.add(
        t2.Disc(radius=0.1), mass=1.0, position=[(0.0, 30.0 + k) for k in range(3)], restitution=0
    )
    assert new.tolist() == [4, 7, 13]
    assert sim.position[[4, 7, 13]].tolist() == [[0, 30], [0, 31], [0, 32]]
    sim.step(3)


def test_what_is_removed_leaves_no_trace() -> None:
    """A stack on a body that vanishes falls as if it had always been gone."""
    scene = t2.Scene(gravity=(0.0, -10.0))
    low = scene.add_body(
        t2.Box(width=1.0, height=1.0), mass=1.0, position=(0.0, 0.5), restitution=0.0
    )
    top = scene.add_body(
        t2.Box(width=1.0, height=1.0), mass=1.0, position=(0.0, 1.5), restitution=0.0
    )
    floor = t2.HalfPlane(normal=(0.0, 1.0), offset=0.0)
    scene.add_static(floor, restitution=0.0, friction=0.5)
    sim = t2.Simulator(scene)
    sim.step(30)
    assert len(sim.contacts) == 4
    sim.remove(low)
    assert len(sim.contacts) == 4  # of the last step
    speed = sim.velocity[top, 1]
    sim.step()
    assert (len(sim.contacts), len(sim.ended)) == (0, 0)
    assert sim.velocity[top, 1] == pytest.approx(speed - 10 / 60, abs=1e-12)


def test_what_is_removed_takes_its_contacts_out_of_both_runs_of_the_list() -> None:
    sim = t2.Simulator(crowd(60, seed=1, overlap=False))
    world = sim._engine.world
    counts = world.broad_phase.counts
    while not 0 < counts[tb.FIRST_RUN] < counts[tb.CONTACTS]:
        sim.step()
    runs = [runs_of(world)]
    gone = int(runs[0][0][len(runs[0][0]) // 2][0])
    sim.remove(gone)
    sim._engine.settle()
    runs.append(runs_of(world))
    kept = [[pair for pair in run if gone not in pair] for run in runs[0]]
    assert runs[1] == kept
    assert len(kept[0]) < len(runs[0][0])


def test_a_body_for_which_there_is_room_falls_too() -> None:
    """Where no array grows, compiled code is still told of one body more."""
    sim = t2.Simulator(t2.Scene(gravity=(0.0, -9.81)))
    for k in range(40):
        sim.add(SHAPES[0], mass=1.0, position=(3.0 * k, 0.0), restitution=0.0)
        sim.step()
        assert sim.velocity[: k + 1, 1] == pytest.approx(-9.81 / 60 * np.arange(k + 1, 0, -1))


def test_there_is_room_to_clip_what_has_more_vertices() -> None:
    sim = t2.Simulator(crowd(60, seed=1, overlap=False))
    sim.step()
    sim.remove(range(40))
    sim.step()  # now there is room for vertices
    circle = np.linspace(0.0, 2 * np.pi, 30, endpoint=False)
    many = t2.Polygon(vertices=np.column_stack((np.cos(circle), np.sin(circle))).tolist())
    sim.add(many, mass=1.0, position=(0.0, 40.0), restitution=0.0)
    assert sim._engine.capacities.clip > 2 * 30
    sim.step()


def runs_of(world: tb.World) -> list[list[tuple[int, ...]]]:
    """Return the bodies of the contacts on the list, run by run."""
    side, first, size = world.broad_phase.counts[[tb.BUFFER, tb.FIRST_RUN, tb.CONTACTS]]
    slots = world.buffers.pairs[side, :size, tb.SLOT_A : tb.SLOT_B + 1]
    pairs = [tuple(pair) for pair in world.state.body_of_slot[slots].tolist()]
    return [pairs[:first], pairs[first:]]


@given(
    st.tuples(st.floats(-50, 50), st.floats(1, 50)),
    st.floats(-0.0, 1.0),
    st.floats(0.5, 2.0),
)
def test_plain_numbers_and_arrays_of_them_are_one(
    place: tuple[float, float], friction: float, mass: float
) -> None:
    """Plain ones are judged without arrays; -0 is 0 in both ways."""
    digests = []
    for made in (float, np.float64):
        sim = t2.Simulator(t2.Scene(gravity=(0.0, -9.81)), compiled=False)
        sim.add(
            SHAPES[1], mass=made(mass), position=tuple(made(x) for x in place),
            velocity=(made(-0.0), made(1.0)), friction=made(friction), restitution=made(0.5),
            torque=made(place[0]),
        )  # fmt: skip
        digests.append(sim.digest())
    assert digests[0] == digests[1]


def test_a_row_that_is_used_again_knows_nothing_of_who_had_it() -> None:
    """A disc thrown at a wall after a stack was there, or where there never was one."""
    scene = t2.Scene(gravity=(0.0, -10.0))
    floor = t2.HalfPlane(normal=(0.0, 1.0), offset=0.0)
    scene.add_static(floor, restitution=0.0, friction=0.5)
    used, fresh = t2.Simulator(scene), t2.Simulator(scene)
    stack = used.add(
        SHAPES[1], mass=1.0, position=[(0.0, 0.25 + 0.5 * k) for k in range(4)], restitution=0
    )
    used.step(30)
    used.remove(stack)
    used.digest()  # this lets go of the rows too
    fresh.step(30)
    for sim in (used, fresh):
        sim.add(SHAPES[0], mass=2.0, position=(0.0, 0.4), velocity=(3.0, 0.0), friction=0.2)
        sim.step(20)
    assert used.position[1].tolist() == fresh.position[1].tolist()
    assert used.velocity[1].tolist() == fresh.velocity[1].tolist()
    assert used.angular_velocity[1] == fresh.angular_velocity[1] != 0.0


def test_thousands_at_once() -> None:
    sim = t2.Simulator(t2.Scene(gravity=(0.0, -9.81)))
    place = np.stack(np.meshgrid(np.arange(50.0), np.arange(60.0)), axis=-1).reshape(-1, 2)
    chance = np.random.default_rng(0)
    mass = chance.uniform(1, 2, 3000)
    shapes = [SHAPES[k % 2] for k in range(3000)]
    found = sim.add(shapes, mass=mass, position=place * 3, velocity=(1.0, 0.0), restitution=0.2)
    assert found.tolist() == list(range(3000))
    assert (sim.mass == 1 / (1 / mass)).all()
    sim.step(2)
    np.testing.assert_allclose(sim.velocity, [(1.0, -9.81 / 30)] * 3000, rtol=1e-12)


def test_capacity_grows_without_a_change() -> None:
    """One by one, through many growths of the arrays, or all at once: the same bits."""
    places = [(3.0 * k, 1.0 + k % 7) for k in range(200)]
    one, many = (t2.Simulator(t2.Scene(gravity=(0.0, -9.81))) for _ in range(2))
    for place in places:
        one.add(t2.Disc(radius=0.5), mass=1.0, position=place, restitution=0.3)
    many.add(t2.Disc(radius=0.5), mass=1.0, position=places, restitution=0.3)
    for sim in (one, many):
        floor = t2.HalfPlane(normal=(0.0, 1.0), offset=0.0)
        sim.add_static(floor, restitution=0.3)
        sim.step(100)
    assert one.digest() == many.digest()


def test_who_can_meet_without_a_restitution_is_refused() -> None:
    scene = t2.Scene(gravity=(0.0, 0.0))
    scene.add_static(t2.Box(width=1.0, height=1.0), name="floor")
    scene.add_body(t2.Disc(radius=0.5), mass=1.0, position=(0.0, 5.0), name="ball")
    with pytest.raises(t2.SceneError, match=r"pair 'floor' and 'ball': not stated.*\(R3\)"):
        t2.Simulator(scene)
    scene.set_restitution("floor", "ball", 0.5)
    sim = t2.Simulator(scene)
    given = {"shape": t2.Disc(radius=0.5), "mass": 1.0, "position": [(0.0, 9.0), (5.0, 9.0)]}
    with pytest.raises(t2.SceneError, match="pair body 'floor' and body 0 of those added"):
        sim.add(**given)
    with pytest.raises(t2.SceneError, match="pair body 0 of those added and body 1 of those"):
        sim.add(**given, mask=4, category=4)
    assert len(sim) == 2
    sim.add(**given, mask=0)
    sim.add(**given, sensor=True)
    sim.add(**given, restitution=0.0)
    sim.add(**{**given, "shape": None})
    sim.add_static(t2.Box(width=1.0, height=1.0), position=(0.0, -20.0), mask=8)
    assert len(sim) == 11
    walls = t2.Simulator(t2.Scene(gravity=(0.0, 0.0)))
    walls.add_static(t2.Box(width=1.0, height=1.0), position=[(0.0, 0.0), (1.0, 0.0)])


BAD: dict[str, tuple[dict[str, Any], str]] = {
    "mass": ({"mass": -1.0}, r"mass\[0\] -1 kg of the bodies added: must be > 0"),
    "one mass": ({"mass": [1.0, 0.0]}, r"mass\[1\] 0 kg of the bodies added: must be > 0"),
    "masses": ({"mass": [1.0, 1.0, 1.0]}, r"found an array of shape \(3,\): must be one number"),
    "tiny": ({"mass": 1e-320}, "float64 cannot hold its inverse"),
    "place": ({"position": [(0, 0), (np.nan, 0)]}, r"position\[1\]\[0\] of the bodies added"),
    "places": ({"position": [(0, 0, 0)]}, r"position of the bodies added: found an array of shape"),
    "ragged": ({"position": [(0, 0), (0,)]}, "its rows must have one length"),
    "turns": ({"orientation": [(0, 0), (0,)]}, "its rows must have one length"),
    "restitution": ({"restitution": 1.5}, r"restitution\[0\] 1.5 of the bodies added"),
    "friction": ({"friction": [-1.0, 0.0]}, r"friction\[0\] -1 of the bodies added"),
    "category": ({"category": [1, -2]}, "category -2 of the bodies added"),
    "mask": ({"mask": 0.5}, "mask of the bodies added: found 0.5: must be a whole number"),
    "sensor": ({"sensor": 1}, "sensor of the bodies added"),
    "shape": ({"shape": "ball"}, "shape of the bodies added: found 'ball'"),
    "shapes": ({"shape": [SHAPES[0]] * 3}, "found 2 rows beside 3 shapes"),
    "plane": (
        {"shape": t2.HalfPlane(normal=(0, 1), offset=0)},
        "shape of the bodies added: found a half-plane: it cannot move",
    ),
    "spin": ({"shape": None, "angular_velocity": 1.0}, "its angular_velocity is not 0"),
    "inertia": ({"inertia": 0.0}, r"inertia\[0\] 0 kg"),
    "text": ({"velocity": "fast"}, "velocity of the bodies added: found 'fast'"),
    "drag": ({"linear_drag": -1.0}, r"linear drag\[0\] -1 kg/s of the bodies added"),
}


@pytest.mark.parametrize("name", BAD)
def test_bad_bodies_are_refused_before_anything_is_added(name: str) -> None:
    sim = t2.Simulator(crowd(4, seed=1))
    before = sim.digest()
    values, says = BAD[name]
    given = {
        "shape": SHAPES[0],
        "mass": 1.0,
        "position": [(0.0, 20.0), (5.0, 20.0)],
        "restitution": 0.5,
        **values,
    }
    with pytest.raises(t2.InputError, match=says):
        sim.add(**given)
    assert (sim.digest(), len(sim)) == (before, 7)


def test_a_half_plane_that_is_added_takes_no_place() -> None:
    sim = t2.Simulator(t2.Scene(gravity=(0.0, 0.0)))
    with pytest.raises(t2.InputError, match="a half-plane has none"):
        sim.add_static(t2.HalfPlane(normal=(0, 1), offset=0), position=(0.0, 1.0))
