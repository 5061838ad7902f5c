"""Each law holds in every step of random crowds.

Generated from srs/ by `python -m tools.generate`. Edit the chapter, not this file.
"""

import pytest

from tests.crowd_laws import SEEDS, holds


@pytest.mark.parametrize("seed", SEEDS)
def test_p1_holds_in_a_crowd(seed: int) -> None:
    """P1, srs/requirements.md:426."""
    law = "sum(mass_i*velocity_i_after) == sum(mass_i*velocity_i_before)"
    holds(law, seed, within=1e-12, steady=False, at_most=False)


@pytest.mark.parametrize("seed", SEEDS)
def test_p2_holds_in_a_crowd(seed: int) -> None:
    """P2, srs/requirements.md:436."""
    law = "sum(angular_momentum_i_after) == sum(angular_momentum_i_before)"
    holds(law, seed, within=1e-12, steady=False, at_most=False)


@pytest.mark.parametrize("seed", SEEDS)
def test_p10_holds_in_a_crowd(seed: int) -> None:
    """P10, srs/requirements.md:509."""
    law = "sum(mass_i*(position_i_after - position_i_before)/time_step) == sum(mass_i*velocity_i_before)"
    holds(law, seed, within=1e-11, steady=False, at_most=False)


@pytest.mark.parametrize("seed", SEEDS)
def test_p11_holds_in_a_crowd(seed: int) -> None:
    """P11, srs/requirements.md:521."""
    law = "(position_i_after - position_i_before)/time_step == velocity_i_before"
    holds(law, seed, within=1e-11, steady=True, at_most=False)


@pytest.mark.parametrize("seed", SEEDS)
def test_p13_holds_in_a_crowd(seed: int) -> None:
    """P13, srs/requirements.md:545."""
    law = "sum(kinetic_energy_i_after) == sum(kinetic_energy_i_before)"
    holds(law, seed, within=1e-12, steady=False, at_most=True)
