"""Whatever is given to it, right or wrong: it is taken or refused by name, and nothing else."""

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import example, given, settings, strategies as st

import tamias2d as t2
from tamias2d.engine.validity import OVERFLOWED, Invalid
from tamias2d.simulator.invalid_state import invalid_state
from tests.simulator.crowd import SHAPES

NUMBERS = [math.nan, math.inf, -math.inf, 0.0, -0.0, -1.0, 5e-324, 1e-300, 1e300, 1.7e308, 7, -7]
HUGE = [10**400, 2**70, np.float32(2), True, None]
OTHERS = ["1", b"1", 1j, {}, [], [[]], (1,), (1, 2, 3), [[1, 2], [3]], object()]
ARRAYS = [np.zeros((2, 3)), np.zeros((0, 2)), np.array("x"), np.array([None, 1])]
ODD = st.sampled_from([*NUMBERS, *HUGE, *OTHERS, *ARRAYS])
GOOD = st.one_of(st.floats(-10, 10), st.tuples(st.floats(-9, 9), st.floats(-9, 9)))
VALUE = st.one_of(ODD, GOOD, st.lists(st.one_of(ODD, st.floats(-5, 5)), max_size=3))
RULES = (
    *("must be finite", "body: must be 0", "must be 0: its inertia", "must be at most"),
    *("must be within", "cannot hold"),
)
ADDED = (
    *("mass", "position", "velocity", "orientation", "angular_velocity", "force", "torque"),
    *("linear_drag", "angular_drag", "inertia", "restitution", "friction"),
    *("category", "mask", "group", "sensor"),
)


def small() -> t2.Simulator:
    scene = t2.Scene(gravity=(0.0, -10.0))
    floor = t2.HalfPlane(normal=(0.0, 1.0), offset=0.0)
    scene.add_static(floor, restitution=0.2, friction=0.5)
    for k, shape in enumerate(SHAPES[:3]):
        place = (0.2 * k, 1.0 + k)
        scene.add_body(shape, mass=1.0, position=place, restitution=0.1, friction=0.4)
    return t2.Simulator(scene)


@settings(max_examples=150)
@given(st.dictionaries(st.sampled_from(ADDED), VALUE, max_size=3))
@example({"category": {}})
@example({"inertia": [math.nan, np.zeros((2, 3))]})
def test_adding_is_refused_by_name_or_done(values: dict[str, Any]) -> None:
    sim = small()
    before = sim.digest()
    known = {"mass": 1.0, "position": (0.0, 5.0), "restitution": 0.0, **values}
    try:
        added = sim.add(SHAPES[0], **known)
    except t2.InputError as error:
        assert any(key.replace("_", " ") in str(error).replace("_", " ") for key in values)
        assert sim.digest() == before
        return
    for row in np.atleast_1d(added):
        state = [sim.position[row], sim.velocity[row], sim.force[row]]
        assert np.isfinite(np.concatenate(state)).all()
    sim.remove(added)
    sim.step(3)
    twin = small()
    twin.step(3)
    assert sim.digest() == twin.digest()


@settings(max_examples=150)
@given(st.sampled_from(["impulse", "force", "ray", "point", "box", "remove", "step"]), VALUE, VALUE)
def test_calls_are_refused_or_done(name: str, one: Any, other: Any) -> None:
    sim = small()
    calls = {
        "impulse": lambda: sim.apply_impulse([1, 2], one, at=other),
        "force": lambda: sim.apply_force([1, 2], one, at=other),
        "ray": lambda: sim.ray_cast(one, other),
        "point": lambda: sim.at_point(one, mask=other),
        "box": lambda: sim.in_box(one, other),
        "remove": lambda: sim.remove(one),
        "step": lambda: sim.step(one if not isinstance(one, int) or one < 9 else 3),
    }
    before = sim.digest()
    try:
        calls[name]()
    except t2.InputError:
        assert sim.digest() == before


@settings(max_examples=150)
@given(
    st.sampled_from(["position", "orientation", "velocity", "angular_velocity", "force", "torque"]),
    st.integers(0, 3),
    st.floats(width=64),
)
def test_any_number_in_a_view_is_stepped_or_refused(view: str, row: int, value: float) -> None:
    """Beyond what float64 holds it says so, at the latest in the next step; nothing crashes."""
    sim = small()
    sim.step(2)
    getattr(sim, view)[row] = value
    before = sim.position.copy()
    try:
        sim.step()
        sim.step(5)
    except t2.InputError as error:
        message = str(error)
        assert any(rule in message for rule in RULES), message
        assert np.isfinite(np.delete(sim.position, row, axis=0)).all()
        if not math.isfinite(value):
            assert np.array_equal(before, sim.position, equal_nan=True)


def test_a_masked_value_is_refused_by_the_simulator() -> None:
    sim = t2.Simulator(t2.Scene(gravity=(0, 0)))
    disc = t2.Disc(radius=0.5)
    masked = np.ma.array([1.0, 2.0], mask=[True, False])
    with pytest.raises(t2.InputError, match=r"mass of .*: found a masked value"):
        sim.add(disc, mass=masked, position=[(0, 0), (3, 0)], restitution=0.5)
    sim.add(disc, mass=masked.filled(1.0), position=[(0, 0), (3, 0)], restitution=0.5)
    with pytest.raises(t2.InputError, match=r"orientation of .*: found a masked value"):
        sim.orientation = masked


def test_what_nothing_can_push_stays_as_it_is() -> None:
    sim = small()
    twin = small()
    sim.apply_impulse(0, (1.0, 2.0), at=(3.0, 4.0))
    sim.apply_force(0, (1.0, 2.0), at=(3.0, 4.0))
    sim.step(3)
    twin.step(3)
    np.testing.assert_array_equal(sim.position, twin.position)
    np.testing.assert_array_equal(sim.velocity, twin.velocity)


@pytest.mark.parametrize("row", [0, 1])
@pytest.mark.parametrize(("view", "value"), [("force", (5.0, 0.0)), ("torque", 2.0)])
@pytest.mark.parametrize("far", [False, True])
def test_a_load_on_what_nothing_pushes_is_refused(
    view: str, value: object, row: int, far: bool
) -> None:
    sim = t2.Simulator(t2.Scene(gravity=(0.0, -10.0)))
    sim.add_static(t2.Disc(radius=0.5), position=(0.0, -1.0), restitution=0.0)
    sim.add_kinematic(t2.Disc(radius=0.5), position=(9.0, 0.0), restitution=0.0)
    height = 50.0 if far else 0.0
    ball = sim.add(t2.Disc(radius=0.5), mass=1.0, position=(0.0, height), restitution=0.0)
    sim.step(3)
    before = sim.position.copy()
    getattr(sim, view)[row] = value
    with pytest.raises(t2.InputError, match=rf"{view}\[{row}\] .* must be 0, since nothing"):
        sim.step(2)
    np.testing.assert_array_equal(sim.position, before)
    getattr(sim, view)[row] = 0.0
    getattr(sim, view)[ball] = value
    sim.step(2)


def test_what_is_written_to_the_row_of_a_removed_body_is_refused() -> None:
    sim = t2.Simulator(t2.Scene(gravity=(0.0, 0.0)))
    disc = t2.Disc(radius=0.5)
    gone = sim.add(disc, mass=1.0, position=(0.0, 0.0), velocity=(1.0, 0.0), restitution=0.0)
    sim.step()
    sim.remove(gone)
    sim.velocity *= 0.5  # of what is there, for all rows
    for moment in ("at once", "after a step"):
        sim.velocity[gone] = 5.0, 0.0
        with pytest.raises(t2.InputError, match=r"velocity\[0\] of row 0, which has no body"):
            sim.step()
        sim.velocity[gone] = 0.0
        sim.step()
        assert sim.time == pytest.approx((2 if moment == "at once" else 3) / 60)
    sim.position[gone] = 1.0, 0.0
    with pytest.raises(t2.InputError, match=r"position\[0\] of row 0, which has no body"):
        sim.step()
    sim.position[gone] = 0.0
    assert sim.add(disc, mass=1.0, position=(3.0, 0.0), restitution=0.0) == gone
    sim.step()


def test_rays_that_do_not_match_are_called_rays() -> None:
    with pytest.raises(t2.InputError, match=r"\(3, 2\) for 3 rays"):
        small().ray_cast([(0, 9), (5, 9)], [(0, 0), (5, -1), (1, 1)])


def test_what_overflows_in_a_mechanism_is_told_with_a_joint_of_it() -> None:
    found = Invalid("velocity", 0, [1.0, 2.0, 3.0], OVERFLOWED)
    kinds = np.zeros(1, dtype=np.int8)
    said = str(invalid_state(found, kinds, lambda row: f"body {row}", None, "rope"))
    assert "the mechanism of joint 'rope', which holds it (R4, R13)" in said
    alone = str(invalid_state(found, kinds, lambda row: f"body {row}"))
    assert "joint" not in alone
    assert "float64 cannot hold what a step makes of it" in alone
