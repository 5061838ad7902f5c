"""A simulator that goes back to what it was goes on as a copy that was made then."""

import pickle
import warnings
from collections.abc import Callable
from copy import deepcopy
from typing import Any

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.simulator.kept_state import PARTS
from tests.simulator.crowd import crowd
from tests.simulator.test_keeping import everything, history, lively

SURFACE = {"friction": 0.5, "restitution": 0.1}


def nothing(sim: t2.Simulator) -> None:
    """Only steps are taken."""


def fewer(sim: t2.Simulator) -> None:
    sim.remove(np.flatnonzero(sim.dynamic)[:3])
    sim.step(3)
    sim.add(t2.Disc(radius=0.3), mass=1.0, position=(0.0, 12.0), name="late", **SURFACE)


def many_more(sim: t2.Simulator) -> None:
    """So many that arrays get longer."""
    place = [(-4.0 + k % 9, 15.0 + k // 9) for k in range(300)]
    sim.add(t2.Box(width=0.5, height=0.5), mass=1.0, position=place, linear_drag=0.3, **SURFACE)
    sim.step(20)


def tied(sim: t2.Simulator) -> None:
    a, b = np.flatnonzero(sim.dynamic)[:2].tolist()
    sim.add_joint(t2.Distance(), a, b, name="late")
    sim.step(5)


def other_rules(sim: t2.Simulator) -> None:
    bodies = np.flatnonzero(sim.dynamic)[::2]
    sim.set_filters(bodies, mask=0)
    sim.set_surface(bodies, friction=0.0)
    sim.gravity[:] = 3.0, 3.0
    sim.force[bodies] = 2.0, 0.0
    sim.apply_force(bodies, (1.0, 1.0))


def other_bodies(sim: t2.Simulator) -> None:
    bodies = np.flatnonzero(sim.dynamic)
    sim.set_mass(bodies[::2], mass=7.0)
    sim.set_drag(bodies, linear_drag=0.5, angular_drag=0.1)
    sim.set_shape(bodies[1::2], t2.Disc(radius=0.2), mass=3.0)
    sim.apply_impulse(bodies, (0.5, 1.0))
    sim.wake(bodies)


def other_surroundings(sim: t2.Simulator) -> None:
    sim.add_static(t2.Box(width=1.0, height=1.0), position=(0.0, 5.0), surface_speed=1.0, **SURFACE)
    moving = sim.add_kinematic(t2.Disc(radius=0.5), position=(2.0, 6.0), **SURFACE)
    sim.velocity[moving] = 0.0, -1.0
    sim.position[sim.dynamic] += 0.25, 0.0


def governed(sim: t2.Simulator) -> None:
    """Joints of all sorts are told otherwise."""
    a = int(np.flatnonzero(sim.dynamic)[0])
    place = tuple(sim.position[a].tolist())
    sim.add_joint(t2.Target(spring=t2.JointSpring(stiffness=9.0)), place, a, name="held")
    sim.set_target("held", (place[0], place[1] + 0.1))
    sim.set_spring("held", t2.JointSpring(stiffness=20.0))
    if "spring" in sim.joints:  # the mechanism below
        sim.set_motor("joint4", t2.Motor(speed=-1.0))
        sim.set_limits("joint1", t2.Limits(lower=-0.5, upper=0.5, restitution=0.0))
        sim.remove_joint("joint2")


CHANGES = [
    nothing, fewer, many_more, tied, other_rules, other_bodies, other_surroundings, governed,
]  # fmt: skip


def mechanism() -> t2.Simulator:
    """Joints of all sorts that steps change: limits, a motor, a ratchet, one that breaks."""
    scene = t2.Scene(gravity=(0.0, -9.81))
    for k in range(6):
        scene.add_body(
            t2.Capsule(length=0.8, radius=0.1), mass=1.0, position=(k + 0.5, 0.0), **SURFACE
        )
    limits = t2.Limits(lower=-0.4, upper=0.4, restitution=0.3)
    scene.add_joint(t2.Revolute(), (0.0, 0.0), 0, at=(0.0, 0.0))
    scene.add_joint(t2.Revolute(limits=limits), 0, 1, at=(1.0, 0.0))
    scene.add_joint(t2.Revolute(), 1, 2, at=(2.0, 0.0), break_force=60.0)
    scene.add_joint(t2.Ratchet(pitch=0.05, restitution=0.0), (0.0, 0.0), 3)
    scene.add_joint(t2.Revolute(motor=t2.Motor(speed=3.0)), (4.0, 0.0), 3, at=(4.0, 0.0))
    scene.add_joint(t2.Distance(spring=t2.JointSpring(stiffness=50.0)), 4, 5, name="spring")
    scene.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=-3.0), **SURFACE)
    sim = t2.Simulator(scene)
    sim.step(20)
    sim.set_motor("joint4", t2.Motor(speed=5.0, maximum=20.0))
    return sim


def asleep() -> t2.Simulator:
    scene = t2.Scene(gravity=(0.0, -9.81))
    scene.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=0.0), **SURFACE)
    for k in range(4):
        scene.add_body(t2.Box(width=1.0, height=1.0), mass=1.0, position=(0.0, 0.5 + k), **SURFACE)
    sim = t2.Simulator(scene, sleeping=True)
    sim.step(200)
    assert sim.asleep[1:].all()
    return sim


def fast() -> t2.Simulator:
    """Steps that are taken in parts."""
    sim = t2.Simulator(t2.Scene(gravity=(0.0, -9.81)))
    sim.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=0.0), **SURFACE)
    place = [(0.025 * (k % 10), 0.05 + 0.025 * (k // 10)) for k in range(60)]
    sim.add(t2.Disc(radius=0.01), mass=0.01, position=place, velocity=(0.0, -6.0), **SURFACE)
    sim.step(2)
    assert sim.parts > 1
    return sim


def few_discs() -> t2.Simulator:
    sim = t2.Simulator(t2.Scene(gravity=(0.0, -9.81)))
    sim.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=0.0), **SURFACE)
    sim.add(t2.Disc(radius=0.1), mass=1.0, position=[(0.0, 1.0), (0.5, 2.0)], **SURFACE)
    sim.step(30)
    return sim


def loaded() -> t2.Simulator:
    """What acts depends on masses, places, velocities and time."""
    scene = t2.Scene(gravity=(0.0, 0.0))
    for k in range(4):
        place = (1.5 * k, 0.3 * k * k)
        scene.add_body(t2.Disc(radius=0.2), mass=1.0 + k, position=place, name=f"b{k}", **SURFACE)
    scene.add_body(
        t2.Disc(radius=0.2), mass=1.0, position=(9.0, 0.0), quadratic_drag=0.1, **SURFACE
    )
    scene.add_attraction(gravitational_constant=2.0)
    scene.add_field(force=("mass*0.5[m/s^2]", "sin(2[1/s]*time)*1[N]"))
    scene.add_spring("b0", "b1", stiffness=5.0, rest_length=1.0)
    sim = t2.Simulator(scene)
    sim.step(10)
    return sim


def of_catalogue(name: str) -> Callable[[], t2.Simulator]:
    def made() -> t2.Simulator:
        sim = t2.Simulator(t2.catalogue.load(name))
        sim.step(15)
        return sim

    return made


SIMULATORS = {
    "lively": lambda: lively(seed=2),
    "new": lambda: t2.Simulator(crowd(10, seed=3)),
    "mechanism": mechanism,
    "asleep": asleep,
    "fast": fast,
    "few discs": few_discs,
    "loaded": loaded,
    "springs": of_catalogue("spring-chain"),
    "ragdolls": of_catalogue("ragdolls"),
}


@pytest.mark.filterwarnings("ignore::tamias2d.StepWarning")
@pytest.mark.parametrize("change", CHANGES)
@pytest.mark.parametrize("kind", SIMULATORS)
def test_it_goes_on_as_what_was_saved_then(
    kind: str, change: Callable[[t2.Simulator], None]
) -> None:
    sim = SIMULATORS[kind]()
    state, saved, events = sim.copy_state(), pickle.dumps(sim), sim.joint_events
    twin = pickle.loads(saved)
    told = history(twin, 10), repr(twin.reactions), twin.joint_events
    seen = {sim._snapshot().revision}
    longer = change is many_more  # then arrays stay longer, with nothing in it
    for _ in range(2):
        change(sim)
        sim.step(7)
        seen.add(sim._snapshot().revision)
        sim.restore_state(state)
        assert sim._snapshot().revision not in seen  # a recorder looks at all bodies anew
        assert sim.joint_events == events
        other = pickle.loads(saved)
        assert longer or everything(sim) == everything(other)
        assert sim.position.shape == other.position.shape
        for told_of in ("joints", "warnings", "time", "parts"):
            assert getattr(sim, told_of) == getattr(other, told_of)
        assert (history(sim, 10), repr(sim.reactions), sim.joint_events) == told
        assert longer or everything(sim) == everything(twin)


class _Watched:
    """Notes what of a simulator is used."""

    def __init__(self, sim: t2.Simulator, used: set[str]) -> None:
        self.__dict__.update(_sim=sim, _used=used)

    def __getattr__(self, name: str) -> Any:
        self._used.add(name)
        return getattr(self._sim, name)

    def __setattr__(self, name: str, value: Any) -> None:
        self._used.add(name)
        setattr(self._sim, name, value)


@pytest.mark.filterwarnings("ignore::tamias2d.StepWarning")
def test_all_that_changes_a_simulator_is_tried_here() -> None:
    """A new call that changes one has to be among the changes above."""
    used: set[Any] = set()
    for change in CHANGES:
        change(_Watched(mechanism(), used))  # type: ignore[arg-type]
    words = ("set_", "add", "remove", "apply_", "wake")
    changing = {name for name in dir(t2.Simulator) if name.startswith(words)}
    assert changing <= used
    assert {"position", "velocity", "force", "gravity"} <= used  # views


def test_a_state_is_all_that_may_change() -> None:
    """Whoever gives a simulator another attribute decides whether a state holds it."""
    follow = {"_events", "_jointed", "_seen", "_unsettled", "_varying", "_views", "_earlier"}
    stay = {"_engine", "_heard", "_lock", "_sleeps", "_substeps", "_time_step"}
    # the engine goes back itself, and recorders hear on
    texts = {"_warned"}  # whose texts a state holds
    kinds = t2.Simulator.__mro__
    names = {name for kind in kinds for name in getattr(kind, "__slots__", ())} - {"__weakref__"}
    assert set(PARTS) | follow | stay | texts == names
    assert len(PARTS) + len(follow) + len(stay) + len(texts) == len(names)


@pytest.mark.filterwarnings("ignore::tamias2d.StepWarning")
@pytest.mark.parametrize("change", ["mass", "shape"])
def test_what_was_heavier_attracts_as_before(change: str) -> None:
    sim, twin = loaded(), loaded()
    state = sim.copy_state()
    if change == "mass":
        sim.set_mass(0, mass=100.0)
    else:
        sim.set_shape(0, t2.Disc(radius=0.2), mass=100.0)
    sim.step()
    sim.restore_state(state)
    assert sim.body(0).mass == twin.body(0).mass
    assert history(sim, 20) == history(twin, 20)


def test_what_was_moved_as_it_slept_wakes_again() -> None:
    """Though it has come to sleep where it was put, which the engine remembers."""
    sim = t2.Simulator(t2.Scene(gravity=(0.0, 0.0)), sleeping=True)
    sim.add(t2.Disc(radius=0.2), mass=1.0, position=(0.0, 0.0), **SURFACE)
    sim.step(60)
    sim.position[0] = 1.0, 0.0
    state = sim.copy_state()
    for _ in range(2):
        sim.step()
        assert sim.asleep.tolist() == [False]
        sim.step(60)
        assert sim.asleep.tolist() == [True]
        sim.restore_state(state)


@pytest.mark.filterwarnings("ignore::tamias2d.StepWarning")
def test_what_comes_after_going_back_is_as_it_would_have_been() -> None:
    """Rows, generations and ranks are given as in a simulator that had not been elsewhere."""
    sim = lively(seed=4)
    state, twin = sim.copy_state(), deepcopy(sim)
    many_more(sim)
    sim.restore_state(state)
    for each in (sim, twin):
        fewer(each)
        each.step(3)
        many_more(each)
    assert sim.generation.tolist() == twin.generation.tolist()
    assert sim.index("late") == twin.index("late")
    assert history(sim, 10) == history(twin, 10)
    sim.restore_state(state)
    with pytest.raises(t2.InputError, match="has none such"):
        sim.index("late")


@pytest.mark.filterwarnings("ignore::tamias2d.StepWarning")
def test_states_do_not_change_each_other() -> None:
    sim = mechanism()
    states: list[Any] = []
    digests = []
    for _ in range(5):
        states.append(sim.copy_state())
        digests.append((sim.digest(), sim.joints))
        sim.set_limits("joint1", t2.Limits(lower=-0.1 * len(states), restitution=0.0))
        sim.step(15)
    for k in (3, 0, 4, 1, 1, 2):
        sim.restore_state(states[k])
        assert (sim.digest(), sim.joints) == digests[k]
        sim.step(3)
        sim.remove_joint(sim.joints[0])


def test_views_stay_valid() -> None:
    sim = lively(seed=1)
    view, force = sim.position, sim.force
    state = sim.copy_state()
    place = view[3].copy()
    sim.step(10)
    sim.restore_state(state)
    assert view[3].tolist() == place.tolist()
    view[3], force[3] = (1.0, 2.0), (0.0, 5.0)
    assert (sim.position[3].tolist(), sim.force[3].tolist()) == ([1.0, 2.0], [0.0, 5.0])
    many_more(sim)
    longer = sim.velocity
    sim.restore_state(state)
    assert len(longer) > len(sim.velocity)
    longer[3] = 7.0, 8.0
    assert sim.velocity[3].tolist() == [7.0, 8.0]
    longer[-1] = np.nan  # a row of no body, which is none of what there is
    sim.step()
    assert np.isfinite(sim.position).all()


def test_a_call_after_going_back_tells_what_was_told_then() -> None:
    sim = lively(seed=5)
    sim.step(4)
    told = repr((sim.contacts, sim.began, sim.ended))
    state = sim.copy_state()
    sim.step(5)
    sim.restore_state(state)
    assert repr((sim.contacts, sim.began, sim.ended)) == told
    near = sim.in_box((-2.0, -2.0), (2.0, 2.0)).tolist()
    sim.position[np.flatnonzero(sim.dynamic)] += 50.0, 0.0
    assert sim.in_box((-2.0, -2.0), (2.0, 2.0)).tolist() != near
    sim.restore_state(state)
    assert sim.in_box((-2.0, -2.0), (2.0, 2.0)).tolist() == near


def test_a_warning_is_told_again_where_it_was_not_told_yet() -> None:
    sim = t2.Simulator(t2.Scene(gravity=(0.0, -9.81)))
    sim.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=0.0), **SURFACE)
    unit = t2.Box(width=1.0, height=1.0)
    sim.add(unit, mass=[1.0, 1e9], position=[(0.0, 0.5), (0.0, 1.5)], **SURFACE)
    state = sim.copy_state()
    for _ in range(2):
        with warnings.catch_warnings(record=True) as told:
            warnings.simplefilter("always")
            sim.step(120)
        assert len(told) == len(sim.warnings) > 0
        sim.restore_state(state)
        assert sim.warnings == ()


def test_plain_python_goes_back_too() -> None:
    scene = t2.Scene(gravity=(0.0, -9.81))
    scene.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=0.0), **SURFACE)
    scene.add_body(t2.Box(width=1.0, height=1.0), mass=1.0, position=(0.0, 0.6), **SURFACE)
    sim = t2.Simulator(scene, compiled=False)
    sim.step(4)
    state = sim.copy_state()
    told = history(sim, 3)
    sim.add(t2.Disc(radius=0.2), mass=1.0, position=(5.0, 1.0), **SURFACE)
    sim.step()
    sim.restore_state(state)
    assert history(sim, 3) == told


def test_what_is_no_state_of_it_is_refused() -> None:
    sim, other = (t2.Simulator(crowd(4, seed=1)) for _ in range(2))
    state = sim.copy_state()
    with pytest.raises(t2.InputError, match=r"state: it is one of another simulator \(R4\)"):
        other.restore_state(state)
    for wrong in (None, sim, "game.npz"):
        with pytest.raises(t2.InputError, match=r"must be one of copy_state\(\) \(R4\)"):
            sim.restore_state(wrong)  # type: ignore[arg-type]
    for way in (pickle.dumps, deepcopy):
        with pytest.raises(t2.RecordingError, match="belongs to that simulator"):
            way(state)
