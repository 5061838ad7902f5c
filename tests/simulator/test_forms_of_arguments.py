"""Bodies that are added one by one, or in one call, from numbers in any form: the same bits.

Plain numbers of one body are judged without arrays, and what they say of a shape is kept: neither
may let pass, say or make anything else than arrays do.
"""

from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

import tamias2d as t2
from tamias2d.engine.arrays.world import named_arrays
from tests.simulator.crowd import SHAPES

_FORMS: dict[str, Any] = {
    "plain": lambda value: value,
    "numpy": lambda value: np.float64(value) if np.ndim(value) == 0 else tuple(np.array(value)),
    "list": lambda value: value if np.ndim(value) == 0 else list(value),
    "array": np.array,
    "row": lambda value: np.array([value]),
    "rows of lists": lambda value: [list(value)] if np.ndim(value) else [value],
}
_number = st.floats(-1e6, 1e6) | st.integers(-9, 9)
_share = st.floats(0.0, 1.0) | st.integers(0, 1)
_pair = st.tuples(_number, _number)
_bodies = st.fixed_dictionaries(
    {
        "shape": st.sampled_from(SHAPES),
        "mass": st.floats(1e-3, 1e3) | st.integers(1, 9),
        "position": _pair,
        "velocity": _pair,
        "orientation": _number,
        "angular_velocity": _number,
        "force": _pair,
        "torque": _number,
        "linear_drag": st.sampled_from((0.0, 0.5)),
        "friction": _share,
        "restitution": _share,
    },
    optional={"inertia": st.floats(0.1, 9.0), "angular_drag": st.just(0.25)},
)
_filters = st.fixed_dictionaries(
    {
        "category": st.integers(0, 2**63 - 1),
        "mask": st.integers(0, 2**63 - 1) | st.none(),
        "group": st.integers(-(2**63), 2**63 - 1),
        "sensor": st.booleans(),
    }
)
_BASE: dict[str, Any] = {"shape": SHAPES[0], "mass": 1.0, "position": (0.0, 0.0)}


def _empty() -> t2.Simulator:
    """Return a simulator without bodies, in which there is room for some."""
    sim = t2.Simulator(t2.Scene(gravity=(0.0, -9.81)), compiled=False)
    sim._engine.reserve_shapes(32, 256, 4)
    return sim


def _bits(sim: t2.Simulator) -> dict[str, bytes]:
    sim._engine.settle()
    arrays = named_arrays(sim._engine.world) | {"generation": sim.generation, "mass": sim.mass}
    return {name: values.tobytes() for name, values in arrays.items()}


@given(_bodies, _filters, st.data())
def test_numbers_in_any_form_make_the_same_body(
    body: dict[str, Any], filters: dict[str, Any], data: st.DataObject
) -> None:
    plain, other = _empty(), _empty()
    plain.add(**body, **filters)
    formed = {
        key: value if key == "shape" else _FORMS[data.draw(st.sampled_from(list(_FORMS)))](value)
        for key, value in body.items()
    }
    other.add(**formed, **filters)
    assert _bits(plain) == _bits(other)


@settings(max_examples=50)
@given(st.lists(_bodies, min_size=1, max_size=5), _filters)
def test_one_after_another_and_all_in_one_call_are_the_same(
    bodies: list[dict[str, Any]], filters: dict[str, Any]
) -> None:
    drags = {"linear_drag": 0.0, "angular_drag": 0.0}  # rows of their rates are as they came
    alike = {**drags, "inertia": bodies[0].get("inertia")}
    each = [{**body, **alike} for body in bodies]
    single, many = _empty(), _empty()
    rows = [single.add(**body, **filters) for body in each]
    columns = {key: [body[key] for body in each] for key in each[0] if key != "inertia"}
    assert many.add(**columns, **filters, inertia=alike["inertia"]).tolist() == rows
    assert _bits(single) == _bits(many)


def test_particles_are_the_same_alone_and_among_others() -> None:
    single, many = _empty(), _empty()
    for k, shape in enumerate((None, SHAPES[1], None)):
        single.add(shape, mass=1.0, position=(float(k), 0.0), restitution=0.0)
    places = [(float(k), 0.0) for k in range(3)]
    many.add([None, SHAPES[1], None], mass=1.0, position=places, restitution=0.0)
    assert _bits(single) == _bits(many)


BAD: dict[str, list[Any]] = {
    "mass": [0.0, -1.0, np.nan, np.inf, 1e-320, True],
    "inertia": [0.0, -np.inf, 1e-320, False],
    "orientation": [np.nan, -np.inf, True],
    "torque": [np.inf, False],
    "linear_drag": [-1e-9, np.nan, True],
    "friction": [-1.0, np.nan, True],
    "restitution": [1.5, -0.5, np.inf, False],
    "category": [-1, 2**63, 0.5, True],
    "mask": [-1, 1.0, False],
    "group": [2**63, 0.0, False],
    "sensor": [0, 1, 1.0, None],
}


@pytest.mark.parametrize(("key", "value"), [(key, bad) for key in BAD for bad in BAD[key]])
def test_what_is_bad_is_told_in_the_same_words(key: str, value: Any) -> None:
    """Also where a good value that equals it was taken just before."""
    sim = _empty()
    good = {"mass": 1, "inertia": 1.0, "sensor": bool(value), "restitution": 0.0}.get(key, 1)
    if key != "sensor" and isinstance(value, bool):
        good = type(good)(value) if value or key not in ("mass", "inertia") else good
    sim.add(**{**_BASE, "restitution": 0.5, key: good})
    said = []
    for given_value in (value, value) if key == "sensor" else (value, value, [value]):
        with pytest.raises(t2.InputError) as told:
            sim.add(**{**_BASE, "restitution": 0.5, key: given_value})
        said.append(str(told.value).replace("[True]", "True").replace("[False]", "False"))
    assert len(set(said)) == 1
    assert len(sim) == 1


@pytest.mark.parametrize("value", [2**53 + 1, -(2**60) - 1])
def test_whole_numbers_beyond_those_of_float64_are_rounded_as_arrays_are(value: int) -> None:
    plain, other = _empty(), _empty()
    plain.add(**{**_BASE, "torque": value, "restitution": 0.0})
    other.add(**{**_BASE, "torque": np.array([value]), "restitution": 0.0})
    assert _bits(plain) == _bits(other)


def test_a_view_stays_the_same_where_a_row_is_used_again() -> None:
    sim = _empty()
    ball = sim.add(**_BASE, restitution=0.0)
    view = sim.position
    sim.remove(ball)
    sim._engine.settle()
    assert sim.add(**{**_BASE, "position": (3.0, 4.0)}, restitution=0.0) == ball
    assert sim.position is view
    assert view[ball].tolist() == [3.0, 4.0]
