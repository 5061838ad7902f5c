"""Errors of runs with impacts: each measure sees its own fault, and no other."""

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest

from tamias2d.motion import ClosedForm, SemiImplicitEuler
from tamias2d.run import Impacts, Run
from tamias2d.scene import Disc, HalfPlane, Scene
from tamias2d.simulate import simulate
from tamias2d.study.event_errors import Errors, errors
from tamias2d.study.graph import graph_distance
from tamias2d.study.sampled import Sampled, sampled
from tamias2d.study.truth import common_times, floor_of, truth_of

DURATION = 1.5  # two impacts


def thrown(scene: Scene, up: float) -> Sampled:
    """The same bounce from `up` m higher."""
    other = Scene(gravity=scene.gravity, name=scene.name)
    disc = Disc(radius=0.5)
    other.add_body(disc, mass=1.0, position=(0.0, 1.5 + up), restitution=0.8, name="disc")
    other.add_static(HalfPlane(normal=(0.0, 1.0), offset=0.0), name="floor")
    first = simulate(other, duration=DURATION)
    return sampled(
        lambda times: simulate(other, duration=DURATION, times=times),
        common_times(DURATION),
        first.impacts,
    )


def test_the_truth_has_no_error(bounce: Scene) -> None:
    truth = truth_of(bounce, DURATION)
    found = errors(truth.history, truth.history)
    assert found == Errors(
        position=0.0, event_time=0.0, event_state=0.0, missed=0, extra=0, graph=0.0,
        drift=found.drift,
    )  # fmt: skip
    assert found.drift is not None
    assert found.drift < 1e-14


def test_an_independent_way_finds_the_truth(bounce: Scene) -> None:
    assert floor_of(truth_of(bounce, DURATION)) < 1e-12


def test_event_times_are_compared_by_pair_and_order(bounce: Scene) -> None:
    """From h instead of 1 m the k-th impact is later by the root of h: closed form by hand."""
    up = 1e-3
    found = errors(thrown(bounce, up), truth_of(bounce, DURATION).history)
    first = np.sqrt(2 / 9.81)
    last = first * (1 + 2 * 0.8)  # of the second, and last, impact
    assert found.event_time == pytest.approx(last * (np.sqrt(1 + up) - 1) / DURATION, rel=1e-9)
    assert found.missed == found.extra == 0


def test_states_at_their_own_events_do_not_peak(bounce: Scene) -> None:
    """Velocities a moment after each impact agree, though at one time they differ by a jump."""
    late, truth = thrown(bounce, 1e-3), truth_of(bounce, DURATION).history
    found = errors(late, truth)
    jump = np.abs(late.common.velocity - truth.common.velocity).max()
    assert jump > 4.0
    fastest = np.sqrt(2 * 9.81)
    assert found.event_state == pytest.approx(
        0.8 * (np.sqrt(1.001) - 1) * fastest / fastest, rel=1e-3
    )


def test_graphs_do_not_mind_when_a_jump_is(bounce: Scene) -> None:
    truth = truth_of(bounce, DURATION).history
    distances = [
        errors(thrown(bounce, up), truth).graph or 0.0 for up in (1e-2, 1e-3, 1e-4, 1e-5, 1e-6)
    ]
    assert distances[0] < 0.02
    for coarse, fine in pairwise(distances):  # no floor of the sampling comes in
        assert coarse / fine == pytest.approx(10, rel=0.2)


def test_a_graph_that_jumps_elsewhere_is_seen(bounce: Scene) -> None:
    run = truth_of(bounce, DURATION).history.run
    moved = run.velocity.copy()
    moved[len(moved) // 3] += 0.5 * np.sqrt(2 * 9.81)
    assert graph_distance(replace(run, velocity=moved), run) > 0.1


@pytest.mark.parametrize(("kept", "missed", "extra"), [(1, 1, 0), (0, 2, 0)])
def test_impacts_that_are_missing_are_counted(
    bounce: Scene, kept: int, missed: int, extra: int
) -> None:
    truth = truth_of(bounce, DURATION).history
    fewer = Sampled(with_impacts(truth.run, kept), truth.shared)
    found = errors(fewer, truth)
    assert (found.missed, found.extra) == (missed, extra)
    turned = errors(truth, fewer)
    assert (turned.missed, turned.extra) == (extra, missed)


def with_impacts(run: Run, count: int) -> Run:
    fields = vars(run.impacts)
    return replace(run, impacts=Impacts(**{name: fields[name][:count] for name in fields}))


def test_what_is_not_finite_is_no_small_error(bounce: Scene) -> None:
    truth = truth_of(bounce, DURATION).history
    position = truth.run.position.copy()
    position[7] = np.nan
    found = errors(Sampled(replace(truth.run, position=position), truth.shared), truth)
    assert found.size == np.inf
    assert found.graph == np.inf


def test_a_poor_method_is_seen_in_every_measure(bounce: Scene) -> None:
    truth = truth_of(bounce, DURATION).history
    method = SemiImplicitEuler()
    first = simulate(bounce, duration=DURATION, method=method, time_step=DURATION / 64)
    poor = sampled(
        lambda times: simulate(
            bounce, duration=DURATION, method=method, time_step=DURATION / 64, times=times
        ),
        truth.shared,
        first.impacts,
    )
    found = errors(poor, truth)
    for value in (found.position, found.event_time, found.event_state, found.graph, found.drift):
        assert value is not None
        assert value > 1e-3
    assert found.size == max(found.position, found.event_time or 0, found.event_state or 0)


def test_closed_form_is_the_truth_where_there_is_one(bounce: Scene) -> None:
    assert truth_of(bounce, DURATION).history.run.method == ClosedForm()


def test_the_size_is_the_largest_of_places_times_and_states() -> None:
    assert Errors(position=1e-3).size == 1e-3
    assert Errors(position=1e-3, event_time=2e-2, event_state=1e-2).size == 2e-2
    assert Errors(position=1e-3, event_time=2e-3, event_state=1e-2).size == 1e-2
