"""The crowds in which laws are judged: what happens in them, and that a breach is found."""

import pytest

from tests.crowd_laws import SEEDS, Step, holds, steps_of


def test_they_meet_in_whole_steps_and_in_parts_and_fly_on() -> None:
    steps = [step for seed in SEEDS for step in steps_of(seed)]
    assert sum(step.whole and step.contacts > 0 for step in steps) >= 20
    assert sum(not step.whole and step.contacts > 0 for step in steps) >= 20
    assert sum(int(step.steady.sum()) for step in steps) > 500


@pytest.mark.parametrize(
    ("equation", "name"),
    [
        ("sum(mass_i*velocity_i_after) == sum(mass_i*velocity_i_before)", "velocity_i_after"),
        ("sum(kinetic_energy_i_after) == sum(kinetic_energy_i_before)", "kinetic_energy_i_after"),
    ],
)
def test_a_breach_is_found(equation: str, name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Of one in ten thousand million."""
    rules = {"within": 1e-12, "steady": False, "at_most": True}
    holds(equation, 0, **rules)  # type: ignore[arg-type]
    (step, *_) = steps_of(0)
    value = step.values[name]
    more = tuple(part * (1 + 1e-10) for part in value) if isinstance(value, tuple) else value * 9.0
    broken = Step({**step.values, name: more}, step.steady, step.whole, step.contacts)
    monkeypatch.setattr("tests.crowd_laws.steps_of", lambda *_: [broken])
    with pytest.raises(AssertionError, match="seed 0, step 0"):
        holds(equation, 0, **rules)  # type: ignore[arg-type]
