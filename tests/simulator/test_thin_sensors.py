"""A sensor tells what overlaps it, and no more: where it is thin and was crossed, too."""

from math import pi

import pytest

import tamias2d as t2

REACH = 0.3  # m, of all heroes along their way
HEROES = {
    "box": t2.Box(width=0.6, height=0.6),
    "capsule": t2.Capsule(length=0.2, radius=0.2),
    "triangle": t2.Polygon(vertices=[(-0.3, -0.3), (0.3, 0.0), (-0.3, 0.3)]),
    "segment": t2.Segment(length=0.6),
    "disc": t2.Disc(radius=0.3),
}
UPWARDS, DOWNWARDS = [(0.0, -2.0), (0.0, 2.0)], [(0.0, 2.0), (0.0, 0.5), (0.0, -2.0)]
LINES = {
    "chain": (t2.Chain(vertices=UPWARDS), 0.0),
    "chain of two": (t2.Chain(vertices=DOWNWARDS), 0.0),
    "solid on the right": (t2.Chain(vertices=UPWARDS, one_sided=True), 0.0),
    "solid on the left": (t2.Chain(vertices=DOWNWARDS, one_sided=True), 0.0),
    "segment": (t2.Segment(length=4.0), pi / 2),
    "board": (t2.Box(width=1e-4, height=4.0), 0.0),
}


@pytest.mark.parametrize("senses", ["line", "hero"])
@pytest.mark.parametrize("hero", HEROES)
@pytest.mark.parametrize("line", LINES)
def test_who_has_crossed_a_line_is_not_inside(line: str, hero: str, senses: str) -> None:
    """Told is who is less far from the line than he reaches, as each step begins."""
    sim = t2.Simulator(t2.Scene(gravity=(0.0, 0.0)), compiled=False)
    shape, turn = LINES[line]
    sensor = sim.add_static(shape, orientation=turn, sensor=senses == "line")
    runner = sim.add(
        HEROES[hero],
        mass=1.0,
        position=(-0.67, 0.1),
        velocity=(3.0, 0.0),
        restitution=0.0,
        sensor=senses == "hero",
    )
    began = ended = 0
    if hero == "triangle":
        ahead, behind = 0.4, -0.2  # of its centroid
    else:
        ahead, behind = REACH, -REACH
    for _ in range(28):
        x = sim.position[runner, 0]
        sim.step()
        inside = sim.inside(sensor if senses == "line" else runner).tolist()
        expected = -ahead < x < -behind
        assert bool(inside) == expected, x
        began, ended = began + len(sim.began), ended + len(sim.ended)
    assert (began, ended) == (1, 1)


def test_a_sensor_lets_a_shape_keep_its_side_of_the_ground() -> None:
    """A box slides on a chain as it does without a line that crosses it, to the last bit."""
    places = []
    for senses in (False, True):
        sim = t2.Simulator(t2.Scene(gravity=(0.0, -9.81)), compiled=False)
        ground = [(2.0, 0.0), (1.0, 0.1), (0.0, 0.0), (-2.0, 0.0)]
        sim.add_static(t2.Chain(vertices=ground), friction=0.1, restitution=0.0)
        if senses:
            line = t2.Chain(vertices=[(0.2, -1.0), (0.2, 0.2), (0.3, 1.0)])
            sim.add_static(line, sensor=True)
        box = sim.add(
            t2.Box(width=0.4, height=0.2),
            mass=1.0,
            position=(-0.3, 0.1),
            velocity=(3.0, 0.0),
            friction=0.1,
            restitution=0.0,
        )
        sim.step(15)
        places.append((*sim.position[box].tolist(), float(sim.orientation[box])))
    assert places[0] == places[1]
