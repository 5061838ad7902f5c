"""Equal scenes give equal bits, whatever the order in which all there is was stated."""

import numpy as np
from hypothesis import given, settings, strategies as st

import tamias2d as t2
from tests.simulator.crowd import SHAPES, crowd


def rich(order: list[int], pairs: list[int]) -> t2.Scene:
    """A scene with all that there can be; `order` is that of its bodies, `pairs` of its springs."""
    scene = t2.Scene(gravity=(0.0, -9.81))
    chance = np.random.default_rng(7)
    place = chance.uniform(-5, 5, (12, 2)) + np.array((0.0, 6.0))
    mass, spin = chance.uniform(0.5, 3, 12), chance.uniform(-3, 3, 12)
    for k in order:
        name, at = f"n{k}", (float(place[k, 0]), float(place[k, 1]))
        if k == 0:
            floor = t2.HalfPlane(normal=(0.0, 1.0), offset=0.0)
            scene.add_static(floor, friction=0.6, restitution=0.1, name=name)
        elif k == 1:
            scene.add_kinematic(
                t2.Segment(length=8.0), position=at, angular_velocity=1.0, friction=0.9, name=name
            )
        else:
            scene.add_body(
                SHAPES[k % len(SHAPES)],
                mass=float(mass[k]),
                position=at,
                angular_velocity=float(spin[k]),
                friction=0.3 if k % 2 else None,
                restitution=0.2,
                quadratic_drag=0.1 * (k % 3),
                linear_drag=0.05 * (k % 2),
                group=-1 if k in (4, 5) else 0,
                category=1 + 2 * (k % 2),
                sensor=k == 6,
                name=name,
            )
    for k in pairs:
        one, other = f"n{2 + k}", f"n{(5 + 2 * k) % 10 + 2}"
        if one != other:
            scene.add_spring(one, other, stiffness=20.0 + k, rest_length=1.0, damping=0.1)
    scene.add_spring("n3", "n1", stiffness=5.0, rest_length=0.0, anchor=(0.1, 0.1))
    scene.add_attraction(gravitational_constant=0.5)
    scene.add_field(force=("-0.3[N/m]*x(position)", "0"), bodies=sorted(["n2", "n8", "n9"]))
    scene.set_friction("n2", "n0", 0.9)
    scene.set_restitution("n3", "n0", 0.6)
    return scene


@settings(max_examples=10)
@given(st.permutations(range(12)), st.permutations(range(6)))
def test_no_order_changes_a_bit(order: list[int], pairs: list[int]) -> None:
    one, other = (
        t2.Simulator(rich(list(range(12)), list(range(6)))),
        t2.Simulator(rich(order, pairs)),
    )
    names = np.array([other.index(f"n{k}") for k in range(12)])
    for _ in range(60):
        one.step()
        other.step()
        assert (one.position == other.position[names]).all()
        assert (one.angular_velocity == other.angular_velocity[names]).all()
    assert one.digest() == other.digest()
    assert len(one.contacts) > 0


def test_queries_compiled_have_the_bits_of_plain_ones() -> None:
    rays = np.random.default_rng(2).uniform(-9, 9, (40, 4))
    low, high = np.minimum(rays[:, :2], rays[:, 2:]), np.maximum(rays[:, :2], rays[:, 2:])
    found = []
    for compiled in (True, False):
        sim = t2.Simulator(crowd(25, seed=4), compiled=compiled)
        hits = sim.ray_cast(rays[:, :2], rays[:, 2:])
        assert len(set(hits.body.tolist())) > 5
        boxes = [sim.in_box(*corners).tolist() for corners in zip(low, high, strict=True)]
        arrays = [values.tobytes() for values in vars(hits).values()]
        found.append((arrays, boxes, [sim.at_point(point).tolist() for point in low]))
    assert found[0] == found[1]
