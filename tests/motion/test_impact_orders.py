"""Impacts within steps do not cost a scheme its order.

The answers are known from outside: between impacts the motion has a closed form that is written
down here, and its meetings with the wall are found by scipy's root finder.
"""

import math
from collections.abc import Callable

import numpy as np
import pytest
from scipy.optimize import brentq

import tamias2d as t2
from tamias2d.motion.methods import Method
from tamias2d.verify.schemes import EqualSteps

Flow = Callable[[float, float, float, float], tuple[float, float]]
"""From time, gap and its rate at that time to both at a later time."""
Meetings = tuple[list[float], float, float]

LAG = 1e-9  # s after a bounce, so that it is not found again


def bounced(flow: Flow, gap: float, rate: float, restitution: float, end: float) -> Meetings:
    """Return the times of all bounces, and gap and rate at the end."""
    start, times = 0.0, []
    while True:
        grid = np.linspace(start + LAG, end, 2000)
        gaps = [flow(start, gap, rate, time)[0] for time in grid]
        below = next((k for k, value in enumerate(gaps) if value < 0), None)
        if below is None:
            return times, *flow(start, gap, rate, end)
        time = brentq(
            lambda t, s, g, r: flow(s, g, r, t)[0],
            grid[below - 1],
            grid[below],
            args=(start, gap, rate),
            xtol=1e-15,
            rtol=1e-15,
        )
        _, rate = flow(start, gap, rate, time)
        start, gap, rate = time, 0.0, -restitution * rate
        times.append(time)


def ball_flow(start: float, gap: float, rate: float, time: float) -> tuple[float, float]:
    """Free fall, driven by 3 sin(5 t)."""
    t = time - start
    push = rate + 3 / 5 * math.cos(5 * start)
    moved = push * t - 3 / 25 * (math.sin(5 * time) - math.sin(5 * start)) - 9.81 * t * t / 2
    return gap + moved, push - 3 / 5 * math.cos(5 * time) - 9.81 * t


def driven_ball() -> tuple[t2.Scene, float, Meetings]:
    scene = t2.Scene(gravity=(0.0, -9.81))
    scene.add_body(
        t2.Disc(radius=0.1),
        mass=1.0,
        position=(0.0, 1.0),
        force=(0.0, "3[N]*sin(5[rad/s]*time)"),
        restitution=0.8,
        name="ball",
    )
    scene.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=0.0))
    return scene, 1.43, bounced(ball_flow, 0.9, 0.0, 0.8, 1.43)


def spring_flow(start: float, gap: float, rate: float, time: float) -> tuple[float, float]:
    """Spring with an angular frequency of 5 rad/s, which is relaxed at a gap of -0.3 m."""
    phase = 5 * (time - start)
    c, s = math.cos(phase), math.sin(phase)
    return -0.3 + (gap + 0.3) * c + rate / 5 * s, -5 * (gap + 0.3) * s + rate * c


def spring_and_wall() -> tuple[t2.Scene, float, Meetings]:
    scene = t2.Scene(gravity=(0.0, 0.0))
    scene.add_body(t2.Disc(radius=0.1), mass=2.0, position=(0.0, 0.9), restitution=0.9, name="ball")
    scene.add_spring("ball", (0.0, -0.2), stiffness=50.0, rest_length=0.0)
    scene.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=0.0))
    return scene, 1.71, bounced(spring_flow, 0.8, 0.0, 0.9, 1.71)


def errors(scene: t2.Scene, duration: float, wanted: Meetings, **how: object) -> list[float]:
    """Return those of the times, of the last gap and of its rate."""
    times, gap, rate = wanted
    run = t2.simulate(scene, duration=duration, times=[0.0, duration], **how)  # type: ignore[arg-type]
    assert len(run.impacts) == len(times)
    return [
        float(np.abs(run.impacts.time - times).max()),
        abs(run.position[-1, 0, 1] - 0.1 - gap),
        abs(run.velocity[-1, 0, 1] - rate),
    ]


@pytest.mark.parametrize("made", [driven_ball, spring_and_wall])
@pytest.mark.parametrize(
    ("method", "steps"),
    [
        (t2.SemiImplicitEuler(), 600),
        (t2.VelocityVerlet(), 200),
        (t2.ExponentialDrag(), 200),
        (t2.RungeKutta4(), 60),
        (t2.Yoshida4(), 60),
    ],
    ids=str,
)
def test_order_of_steps_that_are_cut_by_impacts(
    made: Callable[[], tuple[t2.Scene, float, Meetings]], method: Method, steps: int
) -> None:
    scene, duration, wanted = made()
    assert len(wanted[0]) >= 2
    assert method.facts is not None
    found = np.array(
        [
            errors(scene, duration, wanted, method=method, time_step=duration / (steps * 2**k))
            for k in range(5)
        ]
    )
    orders = np.log2(found[0] / found[-1]) / 4
    assert orders == pytest.approx(np.full(3, method.facts.order), abs=0.1), found


@pytest.mark.parametrize("made", [driven_ball, spring_and_wall])
@pytest.mark.parametrize("pair", [t2.DormandPrince5, t2.Dop853], ids=lambda kind: kind.__name__)
def test_adaptive_steps_hold_their_tolerance_through_impacts(
    made: Callable[[], tuple[t2.Scene, float, Meetings]], pair: type[Method]
) -> None:
    scene, duration, wanted = made()
    for rtol in (1e-4, 1e-6, 1e-8, 1e-10, 1e-12):
        worst = max(errors(scene, duration, wanted, method=pair(rtol=rtol)))  # type: ignore[call-arg]
        assert worst < 100 * rtol


def test_order_five_at_impacts_within_equal_steps() -> None:
    scene, duration, wanted = spring_and_wall()
    found = np.array(
        [
            errors(
                scene,
                duration,
                wanted,
                method=EqualSteps("dormand_prince_5"),
                time_step=duration / (12 * 2**k),
            )
            for k in range(5)
        ]
    )
    orders = np.log2(found[0] / found[-1]) / 4
    assert orders[:2] == pytest.approx([5, 5], abs=0.1), found


def test_coarse_steps_of_bodies_that_act_on_each_other_go_on() -> None:
    """Steps that end at the impact of one move the impact of another, which moves them back."""
    scene = t2.Scene(gravity=(0.0, 0.0))
    for x, y in ((1.5, 0.0), (0.0, 1.5), (1.2, 1.2), (1.2, -1.2)):
        for side in (-1.0, 1.0):
            post = side * x, side * y
            scene.add_static(t2.Disc(radius=0.4), position=post, restitution=1.0)
    disc = t2.Disc(radius=0.2)
    scene.add_body(disc, mass=1.0, position=(0.1, 0.2), velocity=(2.0, 1.3), restitution=1.0)
    scene.add_body(disc, mass=1.0, position=(-0.4, 0.1), velocity=(-1.0, 0.3), restitution=1.0)
    scene.add_spring(8, 9, stiffness=3.0, rest_length=0.6)
    run = t2.simulate(scene, duration=8.0, method=t2.SemiImplicitEuler(), time_step=0.5)
    assert run.times[-1] == 8.0
