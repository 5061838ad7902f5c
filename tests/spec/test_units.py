"""Units: what they mean in SI, and what is refused."""

import math

import pytest
from hypothesis import given, strategies as st

from tamias2d.spec.messages import SpecFault
from tamias2d.spec.symbols import parse_range
from tamias2d.spec.units import UNITS, parse_quantity, parse_unit


@pytest.mark.parametrize(
    ("text", "value", "dimension"),
    [
        ("848.5 m/s", 848.5, "m s^-1"),
        ("45 deg", math.pi / 4, "1"),
        ("10 kg", 10.0, "kg"),
        ("9.81 m/s^2", 9.81, "m s^-2"),
        ("9.81 m/s**2", 9.81, "m s^-2"),
        ("2 kN", 2000.0, "kg m s^-2"),
        ("1 1/(kg*m^2)", 1.0, "kg^-1 m^-2"),
        ("-3e-2 cm", -3e-4, "m"),
        ("7", 7.0, "1"),
        ("5 N*m", 5.0, "kg m^2 s^-2"),
    ],
)
def test_quantities(text: str, value: float, dimension: str) -> None:
    quantity = parse_quantity(text)
    assert quantity.value == pytest.approx(value, rel=1e-15)
    assert str(quantity.dimension) == dimension


@pytest.mark.parametrize(
    "text",
    [
        "",
        "m",
        "10kg",
        "10 furlong",
        "nan m",
        "inf m",
        "1e400 m",
        "10 m/",
        "10 m^x",
        "10 m m",
        "10 m^99",
        "1,5 m",
        "10 (m",
        "--1 m",
    ],
)
def test_faults(text: str) -> None:
    with pytest.raises(SpecFault):
        parse_quantity(text)


@given(st.text(max_size=30))
def test_any_text_is_read_or_refused(text: str) -> None:
    for read in (parse_quantity, parse_unit, parse_range):
        try:
            read(text)
        except SpecFault as fault:
            assert fault.message


@given(st.sampled_from(sorted(UNITS)), st.floats(-1e6, 1e6))
def test_every_unit_scales_its_value(unit: str, value: float) -> None:
    assert parse_quantity(f"{value!r} {unit}").value == value * UNITS[unit].factor
