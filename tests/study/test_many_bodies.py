"""Studies of scenes of many bodies say in advance what they do not run."""

import tamias2d as t2
from tamias2d.study.refined import Refined, refined
from tamias2d.study.step_doubling import shorter_runs
from tamias2d.study.work_precision import study
from tests.study.test_contact_study import TIMES, brick


def crowd() -> t2.Scene:
    """A hundred and one discs in a row, which meet in the end."""
    scene = t2.Scene(gravity=(0.0, 0.0), name="crowd", duration=1.0)
    for k in range(101):
        scene.add_body(
            t2.Disc(radius=0.4),
            mass=1.0,
            position=(float(k), 0.0),
            velocity=(0.1 if k else 1.0, 0.0),
            restitution=1.0,
        )
    return scene


def test_many_bodies_are_followed_by_the_closed_form_only() -> None:
    found = study(crowd(), duration=0.5, phases_asked=1, timed=False)
    why = {point.method: point.failure for point in found.points}
    assert why["ClosedForm"] is None
    assert "closed form only" in (why["RungeKutta4"] or "")
    assert found.floor < 1e-12


def test_runs_are_trusted_no_more_than_those_of_longer_steps() -> None:
    def at(step: float) -> Refined:
        return refined(brick(), duration=0.4, times=TIMES, time_step=step, grid=1 / 60)

    coarse, fine = at(1 / 60), at(1 / 120)
    both = fine.after(coarse)
    assert (both.doubt >= coarse.doubt).all()
    assert (both.doubt >= fine.doubt).all()
    assert both.finest is fine.finest


def test_a_stepped_run_is_trusted_no_more_than_steps_of_its_own_length_agree() -> None:
    run = t2.simulate(brick(), duration=0.4, method=t2.Stepped(), time_step=1 / 60, times=TIMES)
    own = refined(brick(), duration=0.4, times=TIMES, time_step=1 / 60, grid=1 / 60)
    found = shorter_runs(run)
    assert (found.doubt >= own.doubt).all()
    assert found.time_step == own.time_step / 2
