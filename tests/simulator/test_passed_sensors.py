"""A sensor tells of what passes right through it within a step, too."""

from math import cos, hypot, pi, sin

import numpy as np
import pytest

import tamias2d as t2

STEP = 1 / 60
LINE = 1.0  # m, half of the length of a line that senses
NOWHERE = t2.Scene(gravity=(0.0, 0.0))


def distance(a: complex, b: complex, c: complex, d: complex) -> float:
    """Return the distance of two lines that end, m."""

    def to_line(p: complex, q: complex, r: complex) -> float:
        along = ((p - q) * (r - q).conjugate()).real / abs(r - q) ** 2
        return abs(p - q - min(max(along, 0.0), 1.0) * (r - q))

    def side(p: complex, q: complex, r: complex) -> float:
        return ((q - p).conjugate() * (r - p)).imag

    if side(a, b, c) * side(a, b, d) < 0.0 and side(c, d, a) * side(c, d, b) < 0.0:
        return 0.0
    return min(to_line(a, c, d), to_line(b, c, d), to_line(c, a, b), to_line(d, a, b))


@pytest.mark.parametrize("senses", ["line", "disc"])
@pytest.mark.parametrize("line", ["segment", "board", "chain", "one-sided chain"])
def test_discs_are_sensed_whose_way_comes_near_enough(line: str, senses: str) -> None:
    """The judge is the distance of a disc's whole way from the line (both straight)."""
    random = np.random.default_rng([len(line), len(senses)])
    ends = [(-LINE, 0.0), (LINE, 0.0)]
    shape = {
        "segment": t2.Segment(length=2 * LINE),
        "board": t2.Box(width=2 * LINE, height=1e-5),
        "chain": t2.Chain(vertices=ends),
        "one-sided chain": t2.Chain(vertices=ends, one_sided=True),
    }[line]
    told = passed = 0
    for _ in range(60):
        turn, heading = random.uniform(0, 2 * pi, 2)
        speed, radius = 10 ** random.uniform(0.5, 3), 10 ** random.uniform(-2, -0.5)
        u = complex(cos(heading), sin(heading))
        start = -u * random.uniform(2.0, 4.0) + 1j * u * random.uniform(-1.6, 1.6)
        steps = int(8.0 / (speed * STEP)) + 2
        gap = distance(
            start,
            start + u * speed * steps * STEP,
            LINE * complex(cos(turn), sin(turn)),
            -LINE * complex(cos(turn), sin(turn)),
        )
        if abs(gap - radius) < 0.02 * radius:  # it grazes
            continue
        sim = t2.Simulator(NOWHERE, time_step=STEP, compiled=False)
        sim.add_static(shape, orientation=turn, sensor=senses == "line")
        sim.add(
            t2.Disc(radius=radius),
            mass=1.0,
            position=(start.real, start.imag),
            velocity=(speed * u.real, speed * u.imag),
            sensor=senses == "disc",
        )
        began = ended = 0
        for _ in range(steps):
            sim.step()
            began, ended = began + len(sim.began), ended + len(sim.ended)
        crossed = gap < radius
        if crossed and speed * STEP < 0.3 * radius:  # told as a step begins: not if it is grazed
            assert began <= 1
        else:
            assert began == crossed
        assert began == ended
        told, passed = told + began, passed + crossed
    assert told > 10


def test_it_is_told_where_and_ends_with_the_next_step() -> None:
    """A bullet of 1 cm passes a line at 100 m/s: told in the step in which it does."""
    sim = t2.Simulator(NOWHERE, time_step=STEP, compiled=False)
    line = sim.add_static(t2.Segment(length=2.0), orientation=pi / 2, sensor=True)
    bullet = sim.add(t2.Disc(radius=0.01), mass=1.0, position=(-1.0, 0.3), velocity=(100.0, 0.0))
    sim.step()
    assert sim.began.bodies.tolist() == [[line, bullet]]
    assert sim.began.point == pytest.approx(np.array([[0.0, 0.3]]), abs=1e-5)
    assert abs(sim.began.normal) == pytest.approx(np.array([[1.0, 0.0]]))
    assert sim.began.impulse.tolist() == [0.0]
    assert sim.inside(line).tolist() == [bullet]
    assert len(sim.ended) == 0
    sim.step()
    assert len(sim.began) == 0
    assert sim.ended.tolist() == [[line, bullet]]
    assert sim.inside(line).tolist() == []
    assert sim.velocity[bullet].tolist() == [100.0, 0.0]


@pytest.mark.parametrize("beyond", [0.2, -0.3])
def test_what_bounces_before_a_sensor_is_not_sensed_there(beyond: float) -> None:
    """A ball that a wall throws back passes what is before the wall, and not what is beyond."""
    sim = t2.Simulator(NOWHERE, time_step=STEP, compiled=False)
    sim.add_static(t2.Segment(length=4.0), orientation=pi / 2, restitution=1.0)
    sensor = sim.add_static(
        t2.Segment(length=4.0), orientation=pi / 2, position=(beyond, 0.0), sensor=True
    )
    ball = sim.add(
        t2.Disc(radius=0.05), mass=1.0, position=(-0.9, 0.0), velocity=(90.0, 0.0), restitution=1.0
    )
    sim.step()
    assert sim.velocity[ball, 0] == pytest.approx(-90.0)
    assert sim.inside(sensor).tolist() == ([ball] if beyond < 0.0 else [])


def test_a_driven_sensor_senses_what_stands() -> None:
    """A gate that is driven over a static post at 60 m/s tells of it once."""
    sim = t2.Simulator(NOWHERE, time_step=STEP, compiled=False)
    post = sim.add_static(t2.Disc(radius=0.02))
    gate = sim.add_kinematic(
        t2.Segment(length=1.0),
        position=(-1.53, 0.1),
        orientation=pi / 2,
        velocity=(60.0, 0.0),
        sensor=True,
    )
    began = [tuple(pair) for _ in range(4) if sim.step() is None for pair in sim.began.bodies]
    assert [sorted(pair) for pair in began] == [sorted((post, gate))]


def test_a_pass_is_told_in_a_call_of_many_steps() -> None:
    """Events of many steps are those of as many calls; and a spinning bar passes, too."""
    found = []
    for calls in (1, 12):
        sim = t2.Simulator(NOWHERE, time_step=STEP, compiled=False)
        sim.add_static(t2.Box(width=0.01, height=0.4), sensor=True)
        sim.add(
            t2.Box(width=0.3, height=0.02),
            mass=1.0,
            position=(-3.0, 0.1),
            velocity=(hypot(30.0, 10.0), 0.0),
            angular_velocity=40.0,
        )
        events = []
        for _ in range(calls):
            sim.step(12 // calls)
            events += [("began", *pair) for pair in sim.began.bodies.tolist()]
            events += [("ended", *pair) for pair in sim.ended.tolist()]
        found.append(events)
    assert found[0] == found[1]
    assert len(found[0]) == 2
