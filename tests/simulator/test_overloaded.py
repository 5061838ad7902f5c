"""What steps of a length cannot hold is told by name, and what they hold is not."""

import warnings
from collections.abc import Iterator

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.scene.compound import Shape

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


def floors() -> dict[str, Shape]:
    return {
        "half-plane": t2.HalfPlane(normal=(0.0, 1.0), offset=0.0),
        "chain": t2.Chain(vertices=[(8.0, 0.0), (-8.0, 0.0)]),
        "one-sided chain": t2.Chain(vertices=[(8.0, 0.0), (-8.0, 0.0)], one_sided=True),
        "segment": t2.Segment(length=16.0),
    }


def pressed(
    floor: str, shape: Shape, widths: float, *, height: float, substeps: int = 4
) -> t2.Simulator:
    """Something on a floor that gravity moves by so many of its widths, m, in a substep."""
    gravity = widths * (60 * substeps) ** 2
    sim = t2.Simulator(t2.Scene(gravity=(0.0, -gravity)), substeps=substeps)
    sim.add_static(floors()[floor], name="floor", **SURFACE)
    sim.add(shape, mass=1.0, position=(0.0, height), name="body", **SURFACE)
    return sim


@pytest.mark.parametrize("floor", floors())
def test_what_sinks_through_a_floor_is_told_whatever_the_floor_is(floor: str) -> None:
    sim = pressed(floor, t2.Box(width=0.8, height=0.4), 1.44 * 0.4, height=0.2)
    sim.step(60)
    assert sim.position[1, 1] < 0.0
    assert any("overlap by more than a quarter" in text for text in sim.warnings)


@pytest.mark.parametrize("substeps", [1, 4, 8])
@pytest.mark.parametrize("widths", [1.1, 4.0, 100.0])
@pytest.mark.parametrize("floor", floors())
def test_what_is_pressed_by_more_than_its_width_in_a_substep_is_told(
    floor: str, widths: float, substeps: int
) -> None:
    box = t2.Box(width=1.0, height=1.0)
    sim = pressed(floor, box, widths, height=0.5, substeps=substeps)
    sim.step(120)
    (text,) = [text for text in sim.warnings if "presses them together" in text]
    assert "'floor'" in text
    assert "'body'" in text
    assert "Give a shorter step or more substeps" in text


@pytest.mark.parametrize("floor", floors())
@pytest.mark.parametrize(
    ("shape", "height", "width"),
    [
        (t2.Box(width=1.0, height=1.0), 0.5, 1.0),
        (t2.Disc(radius=0.5), 0.5, 1.0),
        (t2.Capsule(length=1.0, radius=0.1), 0.1, 0.2),
    ],
)
def test_what_is_pressed_by_less_is_held_and_not_told(
    floor: str, shape: Shape, height: float, width: float
) -> None:
    sim = pressed(floor, shape, 0.5 * width, height=height)
    sim.step(120)
    assert sim.warnings == ()
    assert sim.position[1, 1] == pytest.approx(height, abs=0.15 * width)


def test_what_is_pulled_away_is_not_told() -> None:
    sim = on_floor()
    rocket = sim.add(t2.Box(width=0.1, height=0.2), mass=1.0, position=(0.0, 0.1), **SURFACE)
    sim.force[rocket] = 0.0, 1e5
    sim.step(10)
    assert sim.position[rocket, 1] > 100.0
    assert sim.warnings == ()


def test_discs_that_are_followed_exactly_are_not_told_however_they_are_pressed() -> None:
    sim = pressed("half-plane", t2.Disc(radius=0.5), 100.0, height=0.5)
    sim.step(120)
    assert [text for text in sim.warnings if "presses them together" in text] == []
    assert sim.position[1, 1] == pytest.approx(0.5, abs=1e-9)
