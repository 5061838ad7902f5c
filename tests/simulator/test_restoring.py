"""Saved states that somebody has edited: refused by name, or another state that is sound."""

import json
import random
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.engine.arrays.world import saved_fields
from tamias2d.engine.saving.saved_checks import UnfitError, check_saved
from tamias2d.engine.saving.saved_state import saved_arrays
from tamias2d.engine.tables import CONTACTS
from tamias2d.simulator import saving
from tamias2d.simulator.simulator import _restored
from tests.simulator.crowd import crowd

Arrays = dict[str, np.ndarray[Any, Any]]
STEPS = 4


@pytest.fixture(scope="module")
def states() -> list[Arrays]:
    lively = t2.Simulator(crowd(14, seed=3, size=4.0))
    lively.step(30)
    lively.remove([5, 9])
    lively.apply_force([3], (1.0, 5.0))
    asleep = t2.Simulator(crowd(10, seed=5, size=4.0), sleeping=True)
    asleep.step(300)
    springs = t2.Simulator(t2.catalogue.load("spring-chain"))
    springs.step(5)
    scene = crowd(8, seed=7, size=3.0)
    scene.set_restitution("body3", "body4", 0.5)
    scene.set_friction("body4", "body5", 0.5)
    listed = t2.Simulator(scene)
    listed.step(30)  # its list of pairs holds, and has a second run of one pair
    return [sim._arrays() for sim in (lively, asleep, springs, listed)]


def restored(arrays: Arrays, *, forged: bool = True, compiled: bool = True) -> t2.Simulator:
    """What is read from arrays; forged ones have the digest that they should have."""
    if forged:
        content = {name: values for name, values in arrays.items() if name != "digest"}
        arrays = {**content, "digest": np.array(saving.digest(content))}
    return _restored(arrays, "pickle", compiled)


def edited(states: list[Arrays], which: int, name: str, change: Callable[[Any], Any]) -> Arrays:
    arrays = {key: values.copy() for key, values in states[which].items()}
    arrays[name] = change(arrays[name])
    return arrays


def put(place: Any, value: Any) -> Callable[[Any], Any]:
    def change(values: Any) -> Any:
        values[place] = value
        return values

    return change


def told(**changes: Any) -> Callable[[Any], Any]:
    return lambda about: np.array(json.dumps(json.loads(str(about)) | changes))


LIVELY, LISTED = 0, 3
EDITS = {
    "slot": ("engine.state.slot_of_body", put(5, 10_000), "below 32"),
    "slot twice": ("engine.state.slot_of_body", put(5, 6), "gives two bodies one slot"),
    "last slot": ("engine.state.slot_of_body", put([5, 31], [31, 13]), "last one must be idle"),
    "last body": ("engine.state.kind", put(31, 1), "last one must be idle"),
    "owner": ("engine.state.body_of_shape", put(3, 2**32 - 1), "below 32"),
    "absent owner": ("engine.state.body_of_shape", put(3, 5), "names a body that is absent"),
    "more bodies": ("engine.state.kind", put(20, 1), "more bodies than there are ranks"),
    "propagator": ("engine.state.properties", put((4, 5), 7.0), "whole numbers"),
    "half propagator": ("engine.state.properties", put((4, 5), 0.5), "whole numbers"),
    "no mass": ("engine.state.properties", put((4, 0), np.nan), "must be numbers"),
    "massless": ("engine.state.properties", put((4, 0), np.inf), "masses must be numbers"),
    "unmoved": ("engine.state.properties", put((4, 0), 0.0), "that move must have masses"),
    "turned": ("engine.state.properties", put((0, 1), 1.0), "must have no inertia"),
    "negative radius": ("engine.state.properties", put((4, 2), -1.0), "must not be negative"),
    "nobody's radius": ("engine.state.properties", put((20, 2), 1.0), "where there is no body"),
    "drag": ("engine.state.drag_rates", put((0, 0), -1.0), "must not be negative"),
    "vertices": ("engine.shapes.first", put(2, 900), "below"),
    "beyond vertices": ("engine.shapes.first", put(18, 45), "there are no such rows"),
    "many vertices": ("engine.shapes.vertex_count", put(2, 900), "must fit the kinds"),
    "shared vertices": ("engine.shapes.vertex_count", put(4, 42), "too large in all"),
    "no vertices": ("engine.shapes.vertex_count", put(18, 0), "a shape without vertices"),
    "untaken": ("engine.shapes.vertex_count", put(3, 0), "never taken must come last"),
    "rounding": ("engine.shapes.radius", put(3, -1.0), "must not be negative"),
    "friction": ("engine.shapes.stated", put((3, 2), -2.0), "must not be negative"),
    "restitution": ("engine.shapes.stated", put((3, 3), 1.5), "must be at most 1"),
    "surface": ("engine.shapes.material", put((3, 0), 0.25), "must follow from what is stated"),
    "kind": ("engine.shapes.kind", put(4, 9), "below 8"),
    "other kind": ("engine.shapes.kind", put(3, 1), "must fit the kinds"),
    "leaf": ("engine.tree.leaf_of_shape", put(4, 900), "below"),
    "pair": ("engine.contacts.pairs", put((0, 0), 900), "below"),
    "pair slots": ("engine.contacts.pairs", put((0, 2), 9), "slots of their bodies"),
    "pair of one": ("engine.contacts.pairs", put(0, (4, 5, 4, 4)), "must be of two bodies"),
    "still pair": ("engine.contacts.pairs", put(0, (0, 1, 0, 1)), "one of the bodies must move"),
    "turned pair": ("engine.contacts.pairs", put(0, (17, 0, 15, 0)), "must be by rank"),
    "pair twice": ("engine.contacts.pairs", put(1, (0, 17, 0, 15)), "must differ"),
    "order": ("engine.contacts.pairs", put(1, (16, 17, 14, 15)), "must be in canonical order"),
    "half-planes": ("engine.shapes.kind", put(3, 3), "two half-planes never meet"),
    "points": ("engine.contacts.flags", put((0, 0), 3), "below"),
    "side": ("engine.contacts.flags", put((9, 4), 32 * 100), "a side that a shape has not"),
    "manifold": ("engine.contacts.manifolds", put((0, 0), np.inf), "must be numbers"),
    "run": ("engine.broad_phase.counts", put(5, 10**6), "longer than the list"),
    "horizon": ("engine.broad_phase.counts", put(2, 0), "must be those of a list of pairs"),
    "rank": ("engine.rank", put(4, 0), "must differ"),
    "no rank": ("engine.rank", put(4, -1), "must be given to bodies alone"),
    "rank of none": ("engine.rank", put(5, -2), "must be -1 or more"),
    "high rank": ("engine.rank", put(4, 2**62), "is too large"),
    "short ranks": ("engine.rank", lambda rank: rank.astype("i4"), "must be int64"),
    "rows": ("engine.state.pose", lambda pose: pose[:-1], "no rows of an engine"),
    "columns": ("engine.state.pose", lambda pose: pose[:, :2], "must be float64 of shape"),
    "type": ("engine.state.pose", lambda pose: pose.astype("f4"), "must be float64"),
    "shape": ("engine.shapes.radius", lambda radius: radius[:-1], "must be float64 of shape"),
    "report": ("touching.contacts.bodies", put((0, 0), 99), "names a body that is not there"),
    "report length": ("touching.contacts.impulse", lambda a: a[:-1], "must have one length"),
    "pushed": ("pushed", put((0, 0), np.inf), "must be numbers"),
    "no time step": ("about", told(time_step=0.0), "must be > 0"),
    "time step": ("about", told(time_step=1e300), "must be from"),
    "substeps": ("about", told(substeps=0), "at least 1"),
    "steps": ("about", told(steps=2**70), "less than"),
    "no parts": ("about", told(parts=0), "at least 1"),
    "parts": ("about", told(parts=3), "must be numbers, rows and names"),
    "half a part": ("about", told(parts=2.5), "must be a whole number"),
    "staying": ("about", told(staying=[999]), "names a body not there"),
    "staying twice": ("about", told(staying=[0, 0]), "names a body twice"),
    "half a row": ("about", told(staying=[0.5]), "must be numbers, rows and names"),
    "names": ("about", told(names={"a": 99}), "names a body not there"),
    "names twice": ("about", told(names={"a": 0, "b": 0}), "names a body twice"),
    "names of others": ("about", told(names={}), "names other bodies"),
    "scene": ("about", told(scene="}"), "about"),
    "events": ("about", told(joint_events=[[0.1, "rod", 0, 99, 0.0]]), "joint_events: must be"),
    "half an event": ("about", told(joint_events=[[0.1, "rod"]]), "joint_events: must be"),
    "no events": ("about", told(joint_events={}), "must be numbers, rows and names"),
    "nothing": ("about", lambda _: np.array("[" * 100_000), "about"),
}  # fmt: skip


LISTED_EDITS = {
    "leaf twice": ("engine.tree.leaf_of_shape", put(4, 3), "must be one for each shape"),
    "turned overrides": ("engine.shapes.pair_overrides", put((0, 0), 10.0), "lower shapes"),
    "order of overrides": (
        "engine.shapes.pair_overrides",
        put((0, [0, 1]), (10.0, 11.0)),
        "order of shapes",
    ),
    "override": ("engine.shapes.pair_overrides", put((1, 3), 1.5), "must be at most 1"),
}


@pytest.mark.parametrize("edit", EDITS)
def test_an_edit_is_refused_by_name(states: list[Arrays], edit: str) -> None:
    name, change, says = EDITS[edit]
    with pytest.raises(t2.RecordingError, match=says):
        restored(edited(states, LIVELY, name, change))


@pytest.mark.parametrize("edit", LISTED_EDITS)
def test_an_edit_of_a_list_that_holds_is_refused_by_name(states: list[Arrays], edit: str) -> None:
    name, change, says = LISTED_EDITS[edit]
    with pytest.raises(t2.RecordingError, match=says):
        restored(edited(states, LISTED, name, change))


def test_every_array_is_asked_for(states: list[Arrays]) -> None:
    for name in states[LIVELY].keys() - {"pushed", "digest"}:
        arrays = {key: values for key, values in states[LIVELY].items() if key != name}
        with pytest.raises(t2.RecordingError, match=r"missing|nothing|about|rank|generation"):
            restored(arrays)


def test_contacts_without_shapes_are_refused() -> None:
    arrays = t2.Simulator(t2.Scene(gravity=(0.0, 0.0)))._arrays()
    for name in ("pairs", "manifolds", "flags", "axes"):
        values = arrays[f"engine.contacts.{name}"]
        arrays[f"engine.contacts.{name}"] = np.zeros((1, values.shape[1]), values.dtype)
    arrays["engine.broad_phase.counts"][CONTACTS] = 1
    with pytest.raises(t2.RecordingError, match="there are no shapes"):
        restored(arrays)


def test_more_rows_than_an_engine_has_are_refused(states: list[Arrays]) -> None:
    rows = np.broadcast_to(np.int32(0), 2**31)  # of no memory, so that no file can have it
    with pytest.raises(UnfitError, match="more rows than an engine"):
        check_saved({**saving.part(states[LIVELY], "engine"), "shapes.kind": rows})


def test_an_accident_is_found_by_the_digest(states: list[Arrays]) -> None:
    arrays = edited(states, 0, "engine.state.pose", put((4, 0), 1.25))
    with pytest.raises(t2.RecordingError, match="its digest is not that of what it holds"):
        restored(arrays, forged=False)
    assert restored(arrays).position[4, 0] == 1.25


def test_all_that_decides_is_saved(states: list[Arrays]) -> None:
    """An engine that goes on from the saved arrays after each step has the same bits."""
    for arrays in states:
        one, other = restored(arrays), restored(arrays)
        for _ in range(20):
            one.step()
            other = restored(other._arrays())
            other.step()
            assert one.digest() == other.digest()
            assert repr(one.contacts) == repr(other.contacts)
        for field in saved_fields():
            if field.name == "contacts.manifolds":
                continue  # where a pair does not touch, there is what another one left
            mine, theirs = (saved_arrays(sim._engine)[field.name] for sim in (one, other))
            assert mine.tobytes() == theirs.tobytes(), field.name


NUMBERS = (0, 1, 2, 3, 7, -1, 10_000, 2**31 - 1, 2**32 - 1, -(2**31), 2**62, -(2**63))
REALS = (0.0, 1.0, -1.0, 0.5, 3.0, 1e300, -1e300, 1e-300, np.nan, np.inf, -np.inf)


def damaged(arrays: Arrays, chance: random.Random) -> Arrays:
    """A saved state in which somebody has changed a few bits, numbers or rows."""
    found = {key: values.copy() for key, values in arrays.items()}
    names = sorted(found.keys() - {"mark", "version", "digest", "about"})
    for _ in range(chance.choice((1, 1, 2))):
        name = chance.choice(names)
        values = np.ascontiguousarray(found[name])
        flat = values.reshape(-1)
        if not flat.size:
            continue
        match chance.randrange(4):
            case 0:
                flat.view(np.uint8)[chance.randrange(values.nbytes)] ^= 1 << chance.randrange(8)
            case 1:
                numbers: Any = REALS if values.dtype.kind == "f" else NUMBERS
                flat[chance.randrange(flat.size)] = np.array(chance.choice(numbers)).astype(
                    values.dtype
                )
            case 2:
                one, other = chance.randrange(len(values)), chance.randrange(len(values))
                values[[one, other]] = values[[other, one]]
            case _:
                values = values[: chance.randrange(len(values))]
        found[name] = values
    return found


@pytest.mark.parametrize("seed", range(300))
def test_no_edit_breaks_it(states: list[Arrays], seed: int) -> None:
    chance = random.Random(seed)
    arrays = damaged(states[seed % len(states)], chance)
    try:
        sim = restored(arrays)
        sim.step(STEPS)
    except t2.TamiasError:
        return
    assert np.isfinite(sim.position).all()
    assert np.isfinite(sim.velocity).all()
