"""The code for joints is loaded where they are expected, and stays; its bits are the same."""

import copy
import json
import pickle
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

import tamias2d as t2
from tamias2d.engine.menu import CONTACT, JOINTED
from tamias2d.kernels import Library
from tamias2d.scene import catalogue
from tests.engine.test_hashes import SMALL, STORE, steps

SURFACE: Any = {"friction": 0.5, "restitution": 0.0}


@pytest.fixture
def without_contact(monkeypatch: pytest.MonkeyPatch) -> None:
    """Let the engine for scenes without joints not have been loaded."""
    monkeypatch.setattr(Library, "is_loaded", lambda library: library is JOINTED)


def entries(sim: t2.Simulator) -> object:
    """Return what a simulator takes steps with."""
    return sim._engine._entries


def swinging(**settings: Any) -> t2.Simulator:
    """Boxes on the ground, the first of which hangs on a rope."""
    sim = t2.Simulator(t2.Scene(gravity=(0.0, -10.0)), **settings)
    sim.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=0.0), **SURFACE)
    places = [(0.3 * k, 3.0 + 1.1 * k) for k in range(10)]
    sim.add(t2.Box(width=1.0, height=1.0), mass=1.0, position=places, **SURFACE)
    sim.add_joint(t2.Distance(), (0.0, 5.0), 1, name="rope")
    sim.step(10)
    return sim


@pytest.mark.usefixtures("without_contact")
@pytest.mark.parametrize("name", SMALL)
def test_scenes_without_joints_have_the_bits_that_are_stored(name: str) -> None:
    sim = t2.Simulator(catalogue.load(name), joints=True)
    sim.step(steps(name))
    assert entries(sim) is JOINTED.compiled()
    assert sim.digest() == json.loads(STORE.read_text())[name]


@pytest.mark.parametrize("sleeping", [False, True])
def test_what_had_joints_goes_on_with_the_same_bits(
    sleeping: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    digests = []
    for library in (CONTACT, JOINTED):
        monkeypatch.setattr(Library, "is_loaded", lambda asked, library=library: asked is library)
        sim = swinging(sleeping=sleeping)
        sim.remove_joint("rope")
        sim.step()
        assert entries(sim) is library.compiled()
        found = []
        for _ in range(40):
            sim.step(10)
            found.append((sim.digest(), sim.asleep.tolist()))
        assert sim.asleep.any() == sleeping
        digests.append(found)
    assert digests[0] == digests[1]


@pytest.mark.usefixtures("without_contact")
def test_a_simulator_that_has_had_no_joints_takes_the_engine_without() -> None:
    sim = t2.Simulator(t2.Scene(gravity=(0.0, 0.0)))
    sim.step()
    assert entries(sim) is CONTACT.compiled()


@pytest.fixture
def loaded(monkeypatch: pytest.MonkeyPatch) -> list[Library]:
    """The libraries that are loaded from now on, as often as they are asked for."""
    found: list[Library] = []
    compiled = Library.compiled

    def noted(library: Library) -> Any:
        found.append(library)
        return compiled(library)

    monkeypatch.setattr(Library, "compiled", noted)
    functions = "tamias2d.engine.step_calls.functions"
    monkeypatch.setattr(functions, lambda library, **_: library.compiled())
    return found


def saved(sim: t2.Simulator, folder: Path) -> t2.Simulator:
    sim.save(folder / "game.npz")
    return t2.Simulator.restore(folder / "game.npz")


def pickled(sim: t2.Simulator, _folder: Path) -> t2.Simulator:
    again: t2.Simulator = pickle.loads(pickle.dumps(sim))
    return again


def copied(sim: t2.Simulator, _folder: Path) -> t2.Simulator:
    return copy.deepcopy(sim)


@pytest.mark.usefixtures("without_contact")
def test_what_goes_back_to_a_state_expects_joints_on() -> None:
    sim = t2.Simulator(t2.Scene(gravity=(0.0, -10.0)), joints=True)
    sim.restore_state(sim.copy_state())
    sim.step()
    assert entries(sim) is JOINTED.compiled()


@pytest.mark.usefixtures("without_contact")
@pytest.mark.parametrize("again", [saved, pickled, copied])
def test_what_expects_joints_does_so_again(
    again: Callable[[t2.Simulator, Path], t2.Simulator], loaded: list[Library], tmp_path: Path
) -> None:
    sim = t2.Simulator(t2.Scene(gravity=(0.0, -10.0)), joints=True)
    loaded.clear()
    other = again(again(sim, tmp_path), tmp_path)
    assert loaded == [JOINTED, JOINTED]
    other.step()
    assert entries(other) is JOINTED.compiled()
    loaded.clear()
    again(t2.Simulator(t2.Scene(gravity=(0.0, -10.0))), tmp_path)
    assert loaded == []


def test_joints_that_are_expected_are_loaded_at_once(loaded: list[Library]) -> None:
    t2.Simulator(t2.Scene(gravity=(0.0, 0.0)))
    assert loaded == []
    t2.Simulator(t2.Scene(gravity=(0.0, 0.0)), joints=True)
    assert loaded == [JOINTED]


def test_joints_are_expected_or_not() -> None:
    with pytest.raises(t2.InputError, match="joints: found 1: must be True or False"):
        t2.Simulator(t2.Scene(gravity=(0.0, 0.0)), joints=1)  # type: ignore[arg-type]
