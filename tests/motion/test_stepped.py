"""Which way `simulate` takes through contacts, and what a run by steps is and says."""

import math
import re
from pathlib import Path

import numpy as np
import pytest

import tamias2d as t2
from tamias2d import replay
from tamias2d.contact import OverlapError
from tamias2d.errors import InputError
from tamias2d.motion import ClosedForm, Stepped
from tamias2d.solve import Interrupted
from tamias2d.state import place_between
from tamias2d.study.certify import certify
from tamias2d.study.error import apart
from tamias2d.study.scale import radii, scale

G = 9.81
FLOOR = t2.HalfPlane(normal=(0, 1), offset=0)
BOX = t2.Box(width=1, height=1)
WAY = {
    "pyramid-30": "moving bodies can meet, more than 100",
    "disc-pile": "moving bodies can meet, more than 100",
    "tumbler": "body 'drum': it is kinematic",
    "bullet-wall": "impacts could be located up to 0.049925 s",
    "arch": "bodies touch at the start",
    "card-house": "bodies touch at the start",
}


def column(count: int = 3, *, gap: float = 0.0) -> t2.Scene:
    scene = t2.Scene(gravity=(0, -G))
    scene.add_static(FLOOR, friction=0.5, restitution=0, name="floor")
    for k in range(count):
        place = (0.0, 0.5 + gap + k * (1 + gap))
        scene.add_body(BOX, mass=1, position=place, friction=0.5, restitution=0)
    return scene


def conveyor() -> t2.Scene:
    """A box that is put on a belt, which takes it along."""
    scene = t2.Scene(gravity=(0, -G))
    belt = t2.Box(width=40, height=1)
    scene.add_kinematic(belt, position=(0, -0.5), velocity=(1, 0), friction=0.5, name="belt")
    scene.add_body(BOX, mass=2, position=(0, 0.5), friction=0.5, restitution=0)
    return scene


@pytest.mark.parametrize("name", WAY)
def test_scenes_of_the_catalogue_that_are_stepped_say_why(name: str) -> None:
    scene = t2.catalogue.load(name)
    run = t2.simulate(scene, duration=1.0 if len(scene) > 100 else 2.1)
    assert run.method == Stepped()
    assert run.time_step == 1 / 60
    assert WAY[name] in run.notes[0]


@pytest.mark.parametrize(
    "name", ["stack-10-heavy", "free-discs", "billiard", "resting", "cradle", "cradle-touching"]
)
def test_scenes_of_the_catalogue_that_can_be_located_are(name: str) -> None:
    run = t2.simulate(t2.catalogue.load(name), duration=0.5)
    assert run.method == ClosedForm()
    assert run.cost is not None
    assert run.cost.contacts == 0


def test_a_note_has_no_digits_that_nobody_reads() -> None:
    note = t2.simulate(t2.catalogue.load("bullet-wall"), duration=0.1).notes[0]
    assert max(map(len, re.findall(r"[0-9.]+(?= s)", note))) <= 8


def test_a_method_that_is_asked_for_is_taken() -> None:
    run = t2.simulate(t2.catalogue.load("tc3"), duration=0.5, method=Stepped(), time_step=0.01)
    assert run.notes[0] == "Stepped(substeps=4): as asked"


def test_bodies_that_overlap_by_more_than_rounding_are_refused_unless_steps_are_asked_for() -> None:
    scene = column(2, gap=-1e-3)
    with pytest.raises(OverlapError):
        t2.simulate(scene, duration=0.5)
    run = t2.simulate(scene, duration=0.5, method=Stepped(), time_step=1 / 60)
    assert "of the smaller body, 0.001" in run.notes[2]  # m
    assert t2.simulate(column(2, gap=-1e-9), duration=0.5).method == Stepped()


def test_the_shape_of_a_run() -> None:
    run = t2.simulate(conveyor(), duration=1.0, method=Stepped(substeps=2), time_step=0.01)
    assert run.times == pytest.approx(np.arange(101) / 100)
    assert run.position.shape == run.velocity.shape == (101, 2, 2)
    assert run.orientation.shape == run.angular_velocity.shape == (101, 2)
    assert run.energy.shape == run.angular_momentum.shape == (101,)
    assert run.momentum[:, 0] == pytest.approx(2 * run.velocity[:, 1, 0])
    assert run.cost is not None
    assert run.cost.steps == 100
    assert run.cost.contacts == 200  # a box on its side: two points a step
    assert run.cost.impacts == 1
    assert run.impacts.bodies.tolist() == [[0, 1]]
    assert run.impacts.time.tolist() == [0.01]
    assert run.impacts.normal == pytest.approx(np.array([[0, 1]]))
    assert run.impacts.impulse == pytest.approx(2 * G * 0.01, rel=0.05)  # it sinks in a little
    words = [note.split(":")[0] for note in run.notes[1:]]
    assert words == ["contacts", "overlap", "energy", "error"]


def test_a_belt_takes_a_box_along_as_friction_says() -> None:
    """It slides for v/(mu g), and then rides: x = v t - v^2/(2 mu g); by the law of friction."""
    run = t2.simulate(conveyor(), duration=2.0)
    assert run.velocity[-1, 1] == pytest.approx((1.0, 0.0), abs=1e-6)
    ridden = 2.0 - 1 / (2 * 0.5 * G)
    assert run.position[-1, 1, 0] == pytest.approx(ridden, abs=1 / 60 * 0.5)  # half a step of it
    assert run.position[-1, 0, 0] == pytest.approx(2.0)


def test_the_approach_of_what_begins_to_touch() -> None:
    """A box dropped from 1 m meets the floor at sqrt(2 g h), within what one step changes."""
    scene = t2.Scene(gravity=(0, -G))
    scene.add_static(FLOOR, restitution=0)
    scene.add_body(BOX, mass=3, position=(0, 1.5), restitution=0)
    run = t2.simulate(scene, duration=1.0, method=Stepped(), time_step=1e-3)
    speed = math.sqrt(2 * G)
    assert run.impacts.time[0] == pytest.approx(speed / G, abs=2e-3)
    assert -run.impacts.normal_velocity[0] == pytest.approx(speed, abs=2e-3 * G)
    assert run.impacts.impulse.max() <= 3 * speed * 1.01


def struck_wall() -> t2.Scene:
    """A disc of 1 mm meets a wall after 0.1 ms, and half as fast leaves it; stepped."""
    scene = t2.Scene(gravity=(0, 0))
    surface = {"restitution": 0.5, "friction": 0.0}
    scene.add_static(t2.HalfPlane(normal=(-1.0, 0.0), offset=0.0), **surface)
    disc, place = t2.Disc(radius=5e-4), (-7e-4, 0.0)
    scene.add_body(disc, mass=1e-6, position=place, velocity=(2.0, 0.0), **surface)
    scene.add_kinematic(disc, position=(0.0, 1.0), velocity=(0.0, 0.0), **surface)
    return scene


def test_a_run_of_a_millisecond_takes_steps_that_fit_into_it() -> None:
    run = t2.simulate(struck_wall(), duration=1e-3, times=np.linspace(0.0, 1e-3, 6))
    assert run.method == Stepped()
    assert run.time_step == 1e-3 / 240
    places = np.array([-0.7, -0.6, -0.8, -1.0, -1.2, -1.4]) * 1e-3
    assert run.position[:, 1, 0] == pytest.approx(places, abs=1e-6)
    assert run.velocity[1:, 1, 0] == pytest.approx(-1.0)


@pytest.mark.parametrize("duration", [0.5, 0.51, 4.0])
def test_a_run_of_half_a_second_takes_the_usual_steps(duration: float) -> None:
    assert t2.simulate(struck_wall(), duration=duration).time_step == 1 / 60


def test_a_step_that_is_longer_than_the_run_is_refused() -> None:
    with pytest.raises(InputError, match=r"longer than the run of 0\.001 s.*Give at most"):
        t2.simulate(struck_wall(), duration=1e-3, method=Stepped(), time_step=1 / 60)
    run = t2.simulate(struck_wall(), duration=1e-3, method=Stepped(), time_step=1e-3)
    assert run.cost is not None
    assert run.cost.steps == 1


def test_a_world_of_an_ensemble_takes_the_steps_that_a_run_takes() -> None:
    times = np.linspace(0.0, 1e-3, 6)
    vary = {"bodies.body1.mass": [1e-6]}
    worlds = t2.ensemble(struck_wall(), vary=vary, duration=1e-3, times=times, bodies=[1])
    run = t2.simulate(struck_wall(), duration=1e-3, times=times)
    np.testing.assert_array_equal(worlds["position"][0, :, 0], run.position[:, 1])


def test_samples_at_the_ends_of_steps_are_states_of_the_simulator() -> None:
    scene = t2.catalogue.load("arch")
    run = t2.simulate(scene, duration=0.5)
    sim = t2.Simulator(scene)
    for k in range(1, 31):
        sim.step()
        assert (run.position[k] == sim.position).all()
        assert (run.angular_velocity[k] == sim.angular_velocity).all()


def test_samples_between_steps_lie_on_the_parabola_of_free_flight() -> None:
    scene = column(2, gap=0.1)
    step = 0.02
    times = [0.0, 0.01, 0.02, 0.025, 0.0999]
    run = t2.simulate(scene, duration=0.0999, method=Stepped(), time_step=step, times=times)
    ends = t2.simulate(scene, duration=0.1, method=Stepped(), time_step=step)
    assert len(run.times) == 5
    np.testing.assert_array_equal(run.position[2], ends.position[1])
    for k, time in enumerate(times):
        fallen = np.array([0.6, 1.7]) - G * time**2 / 2
        np.testing.assert_allclose(run.position[k, 1:, 1], fallen, rtol=0, atol=1e-14)
        np.testing.assert_allclose(run.velocity[k, 1:, 1], -G * time, rtol=0, atol=1e-14)
    assert run.cost is not None
    assert run.cost.steps == 5


@pytest.mark.parametrize("share", [0.02, 0.1, 0.3, 0.5, 0.7, 0.9, 0.98])
@pytest.mark.parametrize("restitution", [0.0, 0.5, 1.0])
def test_between_the_ends_of_a_step_with_an_impact_no_place_is_below_the_floor(
    share: float, restitution: float
) -> None:
    """It comes with 3 m/s, meets the floor at a share of the step, and leaves or stays."""
    step = 0.1
    before = np.array(3.0 * share * step)
    after = np.array(3.0 * restitution * (1 - share) * step)
    for at in np.linspace(0.0, 1.0, 51):
        place = place_between(
            before, after, np.array(-3.0), np.array(3.0 * restitution), step, np.array(at)
        )
        assert -1e-15 <= place <= max(before, after) + 1e-15


@pytest.mark.parametrize("suffix", [".npz", ".rrd"])
def test_a_recording_is_computed_again_to_the_bit(tmp_path: Path, suffix: str) -> None:
    if suffix == ".rrd":
        pytest.importorskip("rerun")
    run = t2.simulate(t2.catalogue.load("dominoes"), duration=1.0)
    assert len(run.impacts)
    run.save(tmp_path / f"run{suffix}")
    answer = replay.check(tmp_path / f"run{suffix}")
    assert answer.identical, answer.says


@pytest.mark.parametrize("substeps", [0, -1, 1.5, True, "4", math.nan])
def test_wrong_substeps_are_refused(substeps: object) -> None:
    with pytest.raises(t2.InputError, match=r"substeps .* whole number"):
        Stepped(substeps=substeps)  # type: ignore[arg-type]


def test_a_whole_number_of_numpy_is_one() -> None:
    """It is kept as Python's, which a recording can hold."""
    substeps = Stepped(substeps=np.int64(2)).substeps  # type: ignore[arg-type]
    assert substeps == 2
    assert type(substeps) is int


@pytest.mark.parametrize("step", [None, 0, -1.0, math.nan, math.inf])
def test_wrong_steps_are_refused(step: float | None) -> None:
    with pytest.raises(t2.InputError, match=r"time.step"):
        t2.simulate(column(), duration=1.0, method=Stepped(), time_step=step)


def test_what_float64_cannot_hold_is_refused() -> None:
    scene = t2.Scene(gravity=(0, -1e308))
    scene.add_body(BOX, mass=1, position=(0, 0), restitution=0)
    with pytest.raises(t2.SimulationError, match="beyond what float64 holds"):
        t2.simulate(scene, duration=100.0, method=Stepped(), time_step=1.0)


@pytest.mark.parametrize(
    ("law", "told"),
    [
        ("1[N]*log(1 - time/1[s])", r"force\[0\] of field 0: .* no finite value at time 1\.0 s"),
        ("1[N]*exp(x(velocity)*2000[s/m])", r"force\[0\] of field 0 at 0\.0 s: .* body 'ball'"),
    ],
)
def test_a_law_without_a_value_is_told_by_name(law: str, told: str) -> None:
    scene = t2.Scene(gravity=(0, 0))
    scene.add_body(None, mass=1, position=(1, 0), velocity=(0.3, 0), name="ball")
    scene.add_field(force=(law, 0))
    with pytest.raises(t2.TamiasError, match=told):
        t2.simulate(scene, duration=2.0, method=Stepped(), time_step=0.01)
    with pytest.raises(t2.TamiasError, match=told):
        t2.Simulator(scene, time_step=0.01, compiled=False).step(200)


def test_an_equation_without_a_value_is_told_by_name() -> None:
    scene = t2.Scene(gravity=(-G, 0))
    scene.add_body(None, mass=1, position=(1, 1), name="bead")
    wire = t2.Equation("y(position_a) - sqrt(x(position_a)*1[m])")
    scene.add_joint(wire, "bead", name="wire")
    with pytest.raises(t2.SimulationError, match=r"0\.6 s: .*joint 'wire' has no value") as refused:
        t2.simulate(scene, duration=2.0, method=Stepped(), time_step=0.01)
    assert isinstance(refused.value.run, t2.Run)


def test_a_tolerance_is_met_or_refused_where_contacts_are_stepped() -> None:
    run = t2.simulate(conveyor(), duration=1.0, tolerance=1e-3)
    assert run.certificate is not None
    assert run.certificate.bound is not None
    assert run.certificate.bound <= 1e-3
    with pytest.raises(t2.ToleranceError, match="more than 100"):
        t2.recommend(t2.catalogue.load("pyramid-30"), duration=1.0, tolerance=1e-3)
    slope = t2.Scene(gravity=(1, -1))
    slope.add_static(FLOOR, friction=0.1, restitution=0)
    for y in (0.5, 1.5):
        slope.add_body(BOX, mass=1, position=(0, y), friction=0.1)
    run = t2.simulate(slope, duration=1.0, tolerance=1e-3)
    assert run.certificate is not None
    assert run.certificate.bound is not None
    assert run.certificate.bound <= 1e-3


def test_an_interrupted_run_keeps_the_steps_that_were_taken(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    taken = t2.Simulator.step

    def stop(sim: t2.Simulator, count: int = 1) -> None:
        if sim.time > 0.4:
            raise KeyboardInterrupt
        taken(sim, count)

    monkeypatch.setattr(t2.Simulator, "step", stop)
    with pytest.raises(Interrupted, match=r"interrupted at 0\.41") as stopped:
        t2.simulate(conveyor(), duration=1.0)
    assert len(stopped.value.run.position) == len(stopped.value.run.times) == 26


@pytest.mark.parametrize(
    ("name", "duration"),
    [("oblique-discs", 3.0), ("spinning-square", 0.75), ("bouncing-elastic", 2.0), ("kepler", 2.0)],
)
def test_a_certificate_bounds_what_the_located_way_shows_to_be_the_error(
    name: str, duration: float
) -> None:
    scene = t2.catalogue.load(name)
    run = certify(t2.simulate(scene, duration=duration, method=Stepped(), time_step=1 / 60))
    assert run.certificate is not None
    assert run.certificate.kind == "step doubling"
    assert run.certificate.bound is not None
    truth = t2.simulate(scene, duration=duration, times=run.times)
    assert truth.method != Stepped()
    error = float(apart(run, truth).max()) / scale(run)
    # what starts that differ by 1e-9 of a radius end up with is no smaller, however good the run
    moved = 1e-9 * float(radii(scene).max()) / scale(run)
    assert error <= run.certificate.bound < max(10 * error, 30 * moved)


def test_a_certificate_says_what_steps_leave_open() -> None:
    run = certify(t2.simulate(t2.catalogue.load("arch"), duration=0.5))
    assert run.certificate is not None
    assert "shorter steps" in run.certificate.claims[0]
    assert "at all contacts at once" in run.certificate.does_not_claim[-1]


def test_where_no_bound_is_found_the_energy_is_told_or_nothing() -> None:
    """Dominoes have fallen after 4 s, as with shorter steps; a drum that is driven gives energy."""
    run = certify(t2.simulate(t2.catalogue.load("dominoes"), duration=4.0))
    assert run.certificate is not None
    assert run.certificate.bound is not None
    tumbling = certify(t2.simulate(t2.catalogue.load("tumbler"), duration=0.5))
    assert tumbling.certificate is not None
    assert tumbling.certificate.kind == "none"
    assert tumbling.certificate.bound is None
