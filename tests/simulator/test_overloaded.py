"""What steps of a length cannot hold is told by name, and what they hold is not."""

import warnings
from collections.abc import Iterator

import numpy as np
import pytest

import tamias2d as t2

SURFACE = {"friction": 0.6, "restitution": 0.0}


def on_floor(**settings: float) -> t2.Simulator:
    sim = t2.Simulator(t2.Scene(gravity=(0.0, -9.81)), **settings)  # type: ignore[arg-type]
    sim.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=0.0), **SURFACE)
    return sim


def pyramid(rows: int, *, size: float = 1.0, time_step: float = 1 / 60) -> t2.Simulator:
    sim = on_floor(time_step=time_step)
    place = [(1.02 * (i - 0.5 * (rows - j)), j + 0.5) for j in range(rows) for i in range(rows - j)]
    box = t2.Box(width=size, height=size)
    sim.add(box, mass=1.0, position=size * np.array(place), **SURFACE)
    return sim


def stack(masses: list[float], *, size: float = 1.0, time_step: float = 1 / 60) -> t2.Simulator:
    sim = on_floor(time_step=time_step)
    place = [(0.0, size * (0.5 + k)) for k in range(len(masses))]
    box = t2.Box(width=size, height=size)
    sim.add(box, mass=np.array(masses), position=place, **SURFACE)
    return sim


@pytest.fixture(autouse=True)
def not_raised() -> Iterator[None]:
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", t2.StepWarning)
        yield


@pytest.mark.parametrize("settings", [{"size": 1e-3}, {"time_step": 0.5}])
def test_a_pile_that_sinks_together_is_told(settings: dict[str, float]) -> None:
    sim = pyramid(10, **settings)
    before = sim.position.copy()
    sim.step(120)
    size = settings.get("size", 1.0)
    assert np.abs(sim.position - before).max() > 0.3 * size  # it has collapsed
    assert len(sim.warnings) == 1
    assert "overlap by more than a quarter" in sim.warnings[0]
    assert "body " in sim.warnings[0]
    assert "Give a shorter step or more substeps" in sim.warnings[0]


def test_masses_that_cannot_be_solved_are_told() -> None:
    sim = stack([1.0, 1e9])
    sim.step(120)
    assert np.abs(sim.position[1:, 0]).max() > 1.0  # the light box was shot away
    assert ["masses so different" in text for text in sim.warnings] == [True]


@pytest.mark.parametrize(
    "sim",
    [
        lambda: stack([1.0, 1e7]),
        lambda: stack([1.0, 1.0, 1e4]),
        lambda: stack([1.0] * 5, size=1e-3),
        lambda: stack([1.0] * 5, time_step=0.5),
        lambda: pyramid(10),
        lambda: pyramid(10, size=0.03),
        lambda: pyramid(10, time_step=0.1),
    ],
)
def test_what_holds_is_not_told_of(sim: object) -> None:
    made: t2.Simulator = sim()  # type: ignore[operator]
    size = float(made.position[1, 1]) / 0.5
    before = made.position.copy()
    made.step(120)
    assert made.warnings == ()
    assert np.abs(made.position - before).max() < 0.2 * size


def frame(ratio: float, substeps: int = 4) -> t2.Simulator:
    """A heavy disc above two light feet, three rods between them."""
    sim = t2.Simulator(t2.Scene(gravity=(0.0, -9.81)), substeps=substeps)
    sim.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=0.0), **SURFACE)
    disc = t2.Disc(radius=0.05)
    left, right = sim.add(disc, mass=1.0, position=[(0.0, 0.05), (1.5, 0.05)], **SURFACE)
    top = int(sim.add(disc, mass=ratio, position=(0.75, 1.2), **SURFACE))
    for pair in ((int(left), int(right)), (int(left), top), (int(right), top)):
        sim.add_joint(t2.Distance(), *pair)
    return sim


def borne(sim: t2.Simulator) -> float:
    """Return what the floor bears in the mean of nine seconds, over the weight."""
    sim.step(60)
    told = []
    for _ in range(540):
        sim.step()
        told.append(sim.contacts.impulse.sum())
    return float(np.mean(told) / sim.time_step / (sim.mass[1:].sum() * 9.81))


@pytest.mark.parametrize(("ratio", "substeps"), [(90.0, 4), (200.0, 16)])
def test_what_joints_put_on_light_feet_is_borne(ratio: float, substeps: int) -> None:
    sim = frame(ratio, substeps)
    assert borne(sim) == pytest.approx(1.0, abs=1e-3)
    assert sim.warnings == ()


def test_what_hangs_too_heavily_on_light_feet_is_told() -> None:
    sim = frame(200.0)
    assert borne(sim) > 1.5  # overlaps heal with more than the weight, which the bound takes back
    assert ["joined to masses so different" in text for text in sim.warnings] == [True]


def test_a_run_notes_it() -> None:
    scene = t2.Scene(gravity=(0.0, -9.81))
    scene.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=0.0), **SURFACE)
    for name, mass, height in (("light", 1.0, 0.5), ("heavy", 1e9, 1.5)):
        box = t2.Box(width=1.0, height=1.0)
        scene.add_body(box, mass=mass, position=(0.0, height), name=name, **SURFACE)
    run = t2.simulate(scene, duration=2.0, time_step=1 / 60, method=t2.Stepped())
    assert any("'light'" in note and "masses so different" in note for note in run.notes)


def test_a_lift_that_is_moved_by_its_position_is_named_with_what_helps() -> None:
    sim = t2.Simulator(t2.Scene(gravity=(0.0, -10.0)))
    board = t2.Box(width=4.0, height=0.4)
    lift = sim.add_kinematic(board, position=(0.0, 0.0), name="lift", **SURFACE)
    box = t2.Box(width=0.5, height=0.5)
    sim.add(box, mass=1.0, position=(0.0, 0.45), name="box", **SURFACE)
    for frame in range(120):
        sim.position[lift] = 0.0, frame / 30
        sim.step()
    (text,) = sim.warnings
    assert "'lift', which goes on whatever it meets" in text
    assert "Move it by a velocity, not by its position" in text


def test_a_crusher_is_named_though_the_floor_is_what_is_pressed_into() -> None:
    sim = on_floor()
    plate = t2.Box(width=4.0, height=0.4)
    sim.add_kinematic(plate, position=(0.0, 2.0), velocity=(0.0, -1.0), name="press", **SURFACE)
    box = t2.Box(width=0.5, height=0.5)
    sim.add(box, mass=1.0, position=(0.0, 0.25), name="box", **SURFACE)
    sim.step(90)
    assert sim.warnings
    assert "'press', which goes on whatever it meets" in sim.warnings[0]
    assert "stop it where it cannot go" in sim.warnings[0]
