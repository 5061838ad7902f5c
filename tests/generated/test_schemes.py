"""Each scheme converges with the order that it claims.

Generated from srs/ by `python -m tools.generate`. Edit the chapter, not this file.
"""

import pytest

from tamias2d.generated import schemes
from tests.support import (
    observed_order,
    observed_order_of_levels,
    observed_order_under_drag,
)


def test_yoshida_4_has_order_4() -> None:
    """srs/schemes/composed.md:10."""
    found = observed_order(schemes.yoshida_4)
    assert found == pytest.approx(4, abs=0.1)


def test_dormand_prince_5_has_order_5() -> None:
    """srs/schemes/embedded.md:17."""
    found = observed_order(schemes.dormand_prince_5, span=10.0, steps=32)
    assert found == pytest.approx(5, abs=0.1)


def test_dop853_has_order_8() -> None:
    """srs/schemes/embedded.md:60."""
    found = observed_order(schemes.dop853, span=30.0, steps=20)
    assert found == pytest.approx(8, abs=0.1)


def test_explicit_euler_has_order_1() -> None:
    """srs/schemes/euler.md:30."""
    found = observed_order(schemes.explicit_euler)
    assert found == pytest.approx(1, abs=0.1)


def test_semi_implicit_euler_has_order_1() -> None:
    """srs/schemes/euler.md:57."""
    found = observed_order(schemes.semi_implicit_euler)
    assert found == pytest.approx(1, abs=0.1)


def test_exponential_verlet_has_order_2() -> None:
    """srs/schemes/exponential.md:10."""
    found = observed_order_under_drag(schemes.exponential_verlet)
    assert found == pytest.approx(2, abs=0.1)


def test_legacy_2018_translation_has_order_0() -> None:
    """srs/schemes/legacy.md:19."""
    found = observed_order_of_levels(schemes.legacy_2018_translation)
    assert found == pytest.approx(0, abs=0.1)


def test_legacy_2018_rotation_has_order_1() -> None:
    """srs/schemes/legacy.md:38."""
    found = observed_order_of_levels(schemes.legacy_2018_rotation)
    assert found == pytest.approx(1, abs=0.1)


def test_runge_kutta_4_has_order_4() -> None:
    """srs/schemes/runge_kutta.md:8."""
    found = observed_order(schemes.runge_kutta_4)
    assert found == pytest.approx(4, abs=0.1)


def test_velocity_verlet_has_order_2() -> None:
    """srs/schemes/verlet.md:7."""
    found = observed_order(schemes.velocity_verlet)
    assert found == pytest.approx(2, abs=0.1)
