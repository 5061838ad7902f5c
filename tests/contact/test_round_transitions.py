"""A contact passes smoothly from the side of a capsule to its round end, and from body to body."""

import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import tamias2d as t2
from tamias2d.contact.core import Core, place
from tamias2d.contact.gap import axes, nearest_gap
from tamias2d.scene import Body
from tamias2d.state import State

ORDERS = [("capsule", "support"), ("support", "capsule")]


def rolled_off(order, support, *, x, turn=0.0, friction=0.0, length=0.6, height=0.0):
    """A capsule whose side lies on the point (0, height) of a support, and slides and turns."""
    scene = t2.Scene(gravity=(0.0, -9.81))
    for name in order:
        if name == "support":
            shape, position, orientation = support
            scene.add_static(
                shape,
                position=position,
                orientation=orientation,
                friction=friction,
                restitution=0.0,
                name=name,
            )
        else:
            scene.add_body(
                t2.Capsule(length=length, radius=0.1),
                mass=1.0,
                position=(x, height + 0.1),
                velocity=(1.0, 0.0),
                orientation=turn,
                friction=friction,
                restitution=0.0,
                name=name,
            )
    return t2.simulate(scene, duration=0.6, method=t2.ClosedForm())


CORNER = t2.Polygon(vertices=[(-0.4, -1.0), (0.4, -1.0), (0.0, 0.0)]), (0.0, -2 / 3), 0.0
END = t2.Capsule(length=1.0, radius=0.05), (0.0, -0.55), math.pi / 2


@pytest.mark.parametrize("order", ORDERS)
@pytest.mark.parametrize("support", [CORNER, END], ids=["corner", "round end"])
@pytest.mark.parametrize("x", [0.01, 0.1, 0.13, 0.17, 0.2])
def test_a_smooth_capsule_rolls_off_without_an_impulse(order, support, x):
    """Nothing strikes it as its round end comes upon the support, and no energy is lost."""
    run = rolled_off(order, support, x=x)
    assert run.position[-1, order.index("capsule"), 1] < -0.2
    assert not len(run.impacts)
    assert run.energy == pytest.approx(run.energy[0], rel=1e-12)


@pytest.mark.parametrize("support", [CORNER, END], ids=["corner", "round end"])
@pytest.mark.parametrize("friction", [0.0, 0.3])
@pytest.mark.parametrize("x", [0.01, 0.1, 0.2])
def test_the_order_of_bodies_decides_nothing(support, friction, x):
    runs = [rolled_off(order, support, x=x, friction=friction) for order in ORDERS]
    one, other = (
        run.position[-1, order.index("capsule")] for run, order in zip(runs, ORDERS, strict=True)
    )
    assert one == pytest.approx(other, abs=1e-12)


def attracted(order):
    """Two smooth capsules that fall on each other, slide round and go on."""
    bodies = {
        "one": {
            "shape": t2.Capsule(length=0.35, radius=0.15),
            "mass": 0.6,
            "position": (-0.7, 0.05),
            "velocity": (1.5, 0.2),
            "orientation": 1.1,
            "angular_velocity": -2.0,
        },
        "other": {
            "shape": t2.Capsule(length=0.4, radius=0.2),
            "mass": 1.0,
            "position": (0.7, -0.05),
            "velocity": (-1.2, 0.0),
            "orientation": -2.6,
            "angular_velocity": 0.5,
        },
    }
    scene = t2.Scene(gravity=(0.0, 0.0))
    for name in order:
        scene.add_body(name=name, restitution=0.0, friction=0.0, **bodies[name])
    scene.add_attraction(gravitational_constant=3.0)
    return t2.simulate(scene, duration=1.2, method=t2.Dop853(rtol=1e-10))


def test_capsules_that_slide_round_each_other_do_so_in_either_order():
    one, other = attracted(("one", "other")), attracted(("other", "one"))
    assert one.position[-1, 0] == pytest.approx(other.position[-1, 1], abs=1e-9)
    assert one.position[-1, 1] == pytest.approx(other.position[-1, 0], abs=1e-9)


def test_the_middle_of_an_end_is_told_from_a_side_to_rounding():
    """The corner is beyond the end of the side by less than a distance would tell."""
    capsule = Core(0, Body(name="c", shape=t2.Capsule(length=1, radius=0.1), dynamic=True, mass=1))
    box = Core(1, Body(name="b", shape=t2.Box(width=0.4, height=0.4), dynamic=True, mass=1))
    still = State((0.0, 0.0), 0.0, (0.0, 0.0), 0.0)
    for beyond, sided in ((-1e-12, True), (1e-12, False)):
        corner = State((0.5 + beyond + 0.2, -0.3), 0.0, (0.0, 0.0), 0.0)
        pair = place(capsule, still), place(box, corner)
        best = max(axes(*pair), key=lambda axis: axis.gap)
        assert (best.side is not None) == sided
    assert nearest_gap(*pair, best).corner_p == (0.5, 0.0)


def rolled(capsule_first, *, radius, friction, duration):
    """A capsule stands with one end on a round support of a radius, m, and tips over.

    It rolls on it, which is one degree of freedom: returned are its turns, and those that follow
    from the energy of rolling, by another integrator.
    """
    mass, length, end = 1.5, 0.5, 0.1
    tilt, spin, lean, g = 0.3, -0.5, 0.1, 9.81
    share = end / (radius + end)
    x = -(radius + end) * math.sin(lean) - length / 2 * math.sin(tilt)
    y = (radius + end) * math.cos(lean) + length / 2 * math.cos(tilt)
    u = -spin * (end * math.cos(lean) + length / 2 * math.cos(tilt))
    v = -spin * (end * math.sin(lean) + length / 2 * math.sin(tilt))
    scene = t2.Scene(gravity=(0.0, -g))
    rough = {"friction": friction, "restitution": 0.0}

    def add_support():
        if radius:
            scene.add_static(
                t2.Capsule(length=1.0, radius=radius),
                position=(0.0, -0.5),
                orientation=math.pi / 2,
                **rough,
            )
        else:
            scene.add_static(CORNER[0], position=CORNER[1], **rough)

    def add_capsule():
        scene.add_body(
            t2.Capsule(length=length, radius=end),
            mass=mass,
            position=(x, y),
            velocity=(u, v),
            orientation=math.pi / 2 + tilt,
            angular_velocity=spin,
            name="capsule",
            **rough,
        )

    for add in (add_capsule, add_support) if capsule_first else (add_support, add_capsule):
        add()
    body = scene.index("capsule")
    inertia = scene.bodies[body].inertia
    times = np.linspace(0.0, duration, 11)
    run = t2.simulate(scene, duration=duration, times=times, method=t2.ClosedForm())

    def rates(_, state):
        turn, rate = state
        on = lean + share * (turn - tilt)
        size = mass * (end**2 + length**2 / 4 + end * length * math.cos(on - turn)) + inertia
        slope = -mass * end * length * math.sin(on - turn) * (share - 1)
        pull = mass * g * (end * math.sin(on) + length / 2 * math.sin(turn))
        return rate, (pull - slope * rate**2 / 2) / size

    truth = solve_ivp(rates, (0.0, duration), (tilt, spin), t_eval=times, rtol=1e-12, atol=1e-13).y[
        0
    ]
    return run.orientation[:, body] - math.pi / 2, truth, run.energy


@pytest.mark.parametrize("capsule_first", [True, False])
@pytest.mark.parametrize("radius", [0.0, 0.15], ids=["corner", "round end"])
def test_a_capsule_rolls_on_a_point_and_on_a_round_end(capsule_first, radius):
    turns, truth, energy = rolled(capsule_first, radius=radius, friction=2.0, duration=0.4)
    assert turns == pytest.approx(truth, abs=1e-11)
    assert energy == pytest.approx(energy[0], rel=1e-12)


@pytest.mark.parametrize("plank_first", [True, False])
def test_a_plank_rocks_on_a_cylinder_without_slipping(plank_first):
    """As the energy of rolling has it, with the contact as far along the plank as on the rim."""
    mass, thick, radius, spin, g = 2.0, 0.2, 0.7, 1.3, 9.81
    half = thick / 2
    scene = t2.Scene(gravity=(0.0, -g))
    rough = {"friction": 0.9, "restitution": 0.0}

    def add_plank():
        scene.add_body(
            t2.Box(width=1.6, height=thick),
            mass=mass,
            position=(0.0, radius + half),
            velocity=(-half * spin, 0.0),
            angular_velocity=spin,
            name="plank",
            **rough,
        )

    def add_cylinder():
        scene.add_static(t2.Disc(radius=radius), **rough)

    for add in (add_plank, add_cylinder) if plank_first else (add_cylinder, add_plank):
        add()
    body = scene.index("plank")
    inertia = scene.bodies[body].inertia
    times = np.linspace(0.0, 1.2, 11)
    run = t2.simulate(scene, duration=1.2, times=times, method=t2.ClosedForm())

    def rates(_, state):
        turn, rate = state
        size = mass * (half**2 + (radius * turn) ** 2) + inertia
        pull = mass * g * (half * math.sin(turn) - radius * turn * math.cos(turn))
        return rate, (pull - mass * radius**2 * turn * rate**2) / size

    truth = solve_ivp(rates, (0.0, 1.2), (0.0, spin), t_eval=times, rtol=1e-12, atol=1e-13).y[0]
    assert run.orientation[:, body] == pytest.approx(truth, abs=1e-11)
