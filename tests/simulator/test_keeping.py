"""What is restored goes on with the same bits; what is not a simulator is refused."""

import copy
import pickle
import warnings
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.simulator.saving import VERSION
from tests.simulator.crowd import SHAPES, crowd


def lively(seed: int) -> t2.Simulator:
    """A crowd that has been stepped, and changed."""
    sim = t2.Simulator(crowd(30, seed=seed))
    sim.step(40)
    sim.remove([5, 9, 20])
    sim.add(
        list(SHAPES[:2]),
        mass=[1.0, 2.0],
        position=[(0.0, 15.0), (3.0, 15.0)],
        friction=0.3,
        restitution=0.1,
    )
    sim.apply_force([3, 4], (1.0, 50.0))
    return sim


def history(sim: t2.Simulator, steps: int) -> list[str]:
    """Digests after each step, and of what touched."""
    found = []
    for _ in range(steps):
        sim.step()
        found.append(sim.digest())
        found.append(repr((sim.contacts, sim.began, sim.ended)))
    return found


def everything(sim: t2.Simulator) -> dict[str, bytes]:
    left = {"digest", "engine.contacts.manifolds"}  # where none touch, lies what others left
    return {key: value.tobytes() for key, value in sim._arrays().items() if key not in left}


@pytest.mark.parametrize("way", ["file", "pickle", "copy"])
def test_it_goes_on_with_the_same_bits(way: str, tmp_path: Path) -> None:
    sim = lively(seed=1)
    if way == "file":
        sim.save(tmp_path / "game.npz")
        other = t2.Simulator.restore(tmp_path / "game.npz")
    else:
        other = pickle.loads(pickle.dumps(sim)) if way == "pickle" else copy.copy(sim)
    assert other.digest() == sim.digest()
    assert repr(other.contacts) == repr(sim.contacts)
    assert history(other, 60) == history(sim, 60)
    assert everything(other) == everything(sim)
    other.velocity[0] = 7.0  # and they share nothing
    assert sim.velocity[0, 0] != 7.0


def test_laws_and_names_are_kept() -> None:
    scene = t2.catalogue.load("spring-chain")
    sim = t2.Simulator(scene)
    sim.step(20)
    other = pickle.loads(pickle.dumps(sim))
    assert history(other, 20) == history(sim, 20)
    name = scene.bodies[-1].name
    assert other.index(name) == sim.index(name)
    still = t2.Simulator(scene)
    assert still.digest() != sim.digest()


@pytest.mark.filterwarnings("ignore::tamias2d.StepWarning")
def test_what_was_warned_of_is_kept(tmp_path: Path) -> None:
    """It is told once, by whatever goes on."""
    scene = t2.Scene(gravity=(0.0, -9.81))
    surface = {"friction": 0.6, "restitution": 0.0}
    scene.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=0.0), **surface)
    for mass, height in ((1.0, 0.5), (1e9, 1.5)):
        scene.add_body(t2.Box(width=1.0, height=1.0), mass=mass, position=(0.0, height), **surface)
    sim = t2.Simulator(scene)
    sim.step(120)
    assert sim.warnings
    sim.save(tmp_path / "sim.npz")
    restored = t2.Simulator.restore(tmp_path / "sim.npz")
    for other in (restored, copy.deepcopy(sim), pickle.loads(pickle.dumps(sim))):
        other.step(10)
        assert other.warnings == sim.warnings


def test_two_threads_give_the_bits_of_one() -> None:
    alone = [history(lively(seed), 40) for seed in (2, 3)]
    with ThreadPoolExecutor(2) as threads:
        together = list(threads.map(lambda seed: history(lively(seed), 40), (2, 3)))
    assert together == alone


def test_many_steps_are_one_after_another() -> None:
    one, other = lively(4), lively(4)
    one.step(50)
    for _ in range(50):
        other.step()
    assert one.digest() == other.digest()


def test_bad_files_are_refused(tmp_path: Path) -> None:
    sim, path = lively(5), tmp_path / "game.npz"
    with pytest.raises(t2.RecordingError, match="a simulator is saved as"):
        sim.save(tmp_path / "game.zip")
    with pytest.raises(t2.RecordingError, match=r"there is no directory .* Make it first"):
        sim.save(tmp_path / "nowhere" / "game.npz")
    with pytest.raises(t2.RecordingError, match="no such file"):
        t2.Simulator.restore(path)
    sim.save(path)
    content = path.read_bytes()
    damaged = bytearray(content)
    damaged[len(content) // 2] ^= 1
    for bad in (b"", b"text", content[: len(content) // 2], bytes(damaged)):
        path.write_bytes(bad)
        with pytest.raises(t2.RecordingError, match=r"damaged|cannot be read"):
            t2.Simulator.restore(path)
    np.savez(path, something=np.zeros(3))
    with pytest.raises(t2.RecordingError, match=r"found .nothing. of version nothing"):
        t2.Simulator.restore(path)
    np.savez(path, mark=np.array("tamias2d simulator"), version=0)
    with pytest.raises(t2.RecordingError, match="of version 0: must be"):
        t2.Simulator.restore(path)
    np.savez(path, mark=np.array("tamias2d simulator"), version=VERSION, about=np.array("{}"))
    with pytest.raises(t2.RecordingError, match="its digest is not that"):
        t2.Simulator.restore(path)
    for name in ("a\0b.npz", "\0.npz", "x" * 252 + ".npz"):
        with pytest.raises(t2.RecordingError, match="cannot be written"):
            sim.save(tmp_path / name)
        with pytest.raises(t2.RecordingError, match="no such file"):
            t2.Simulator.restore(tmp_path / name)
    for name in ("a\0b", "a\nb"):
        with pytest.raises(t2.RecordingError, match=r"a\\(x00|n)b'?: a simulator is saved as"):
            sim.save(tmp_path / name)
    assert list(tmp_path.iterdir()) == [path]


def kept(sim: t2.Simulator, keep: str, path: Path) -> t2.Simulator:
    """Return the simulator that was kept in some way."""
    if keep == "copy":
        return copy.deepcopy(sim)
    if keep == "pickle":
        return pickle.loads(pickle.dumps(sim))
    sim.save(path)
    return t2.Simulator.restore(path)


@pytest.mark.parametrize("keep", ["copy", "pickle", "file"])
def test_events_of_joints_are_kept(keep: str, tmp_path: Path) -> None:
    sim = t2.Simulator(t2.Scene(gravity=(0.0, -9.81)))
    load = sim.add(t2.Disc(radius=0.1), mass=2.0, position=(0.0, -0.5), restitution=0.0)
    rope = t2.Distance(limits=t2.Limits(upper=1.0, restitution=0.0))
    sim.add_joint(rope, (0.0, 0.0), load, name="rope")
    sim.add_joint(t2.Distance(), (3.0, 0.0), load, name="thread", break_force=1.0)
    told: set[str] = set()
    while not {"rope", "thread"} <= told:
        sim.step()
        told |= {event.joint for event in sim.joint_events}
        other = kept(sim, keep, tmp_path / "game.npz")
        assert other.joint_events == sim.joint_events
        assert [event.words for event in other.joint_events] == [
            event.words for event in sim.joint_events
        ]


@pytest.mark.parametrize("keep", ["copy", "pickle", "file"])
def test_what_was_put_beyond_a_limit_is_warned_of_by_a_copy_too(keep: str, tmp_path: Path) -> None:
    sim = t2.Simulator(t2.Scene(gravity=(0.0, 0.0)))
    plank = sim.add(t2.Box(width=1.0, height=0.1), mass=1.0, position=(0.5, 0.0), restitution=0.0)
    limits = t2.Limits(lower=-0.5, upper=0.5, restitution=0.0)
    sim.add_joint(t2.Revolute(limits=limits), (0.0, 0.0), plank, other_anchor=(-0.5, 0.0))
    sim.step()
    sim.position[plank], sim.orientation[plank] = (0.5 * np.cos(1.0), 0.5 * np.sin(1.0)), 1.0
    other = kept(sim, keep, tmp_path / "game.npz")
    for each in (sim, other):
        with pytest.warns(t2.StepWarning, match="beyond its upper limit by hand"):
            each.step()
    assert other.warnings == sim.warnings


@pytest.mark.parametrize("keep", ["copy", "file"])
def test_what_turns_far_is_warned_of_by_a_copy_too(keep: str, tmp_path: Path) -> None:
    scene = t2.Scene(gravity=(0.0, 0.0))
    scene.add_body(t2.Disc(radius=0.1), mass=1.0, position=(1.0, 0.0), restitution=0.0)
    scene.add_joint(t2.Distance(), (0.0, 0.0), 0, name="rod")
    sim = t2.Simulator(scene)
    sim.step(3)
    sim.velocity[0] = 0.0, 400.0
    sim.save(tmp_path / "game.npz")
    other = copy.deepcopy(sim) if keep == "copy" else t2.Simulator.restore(tmp_path / "game.npz")
    for each in (sim, other):
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", t2.StepWarning)
            each.step(3)
    assert any("turned by more than half a radian" in text for text in sim.warnings)
    assert other.warnings == sim.warnings
