"""Faults of the kind that other programs shipped must make cases fail.

Each puts a wrong function in the place of a generated one. A suite that passes with it is broken.
"""

from collections.abc import Callable
from functools import wraps
from typing import Any

import pytest

from tamias2d.errors import SimulationError
from tamias2d.event_driven import EventDriven
from tamias2d.generated import (
    continuous_collision,
    definitions,
    detection,
    drag,
    firm_contact,
    friction,
    gravitation,
    impact,
    island_energy,
    rest,
    rolling,
    rotation,
    schemes,
    sleeping,
    soft_contact,
    spring,
    translation,
)
from tamias2d.solve import located, sampling
from tamias2d.solve.plan import Plan
from tamias2d.verify import FAIL, suite
from tamias2d.verify.case import Case
from tamias2d.verify.items import items

Wrap = Callable[..., Callable[..., Any]]


def with_argument(place: int, change: Callable[[Any], Any]) -> Wrap:
    def wrap(true: Callable[..., Any]) -> Callable[..., Any]:
        def false(*given: Any) -> Any:
            return true(*given[:place], change(given[place]), *given[place + 1 :])

        return false

    return wrap


def instead(other: Callable[..., Any]) -> Wrap:
    return lambda _true: lambda *given: other(*given)


def times(factor: float) -> Wrap:
    """A result that is wrong by a factor."""

    def scaled(value: Any) -> Any:
        return (
            tuple(factor * part for part in value) if isinstance(value, tuple) else factor * value
        )

    return lambda true: lambda *given: scaled(true(*given))


def half(vector: Any) -> Any:
    return tuple(part / 2 for part in vector)


def nothing(vector: Any) -> Any:
    return tuple(0.0 * part for part in vector)


def opposite(vector: Any) -> Any:
    return tuple(-part for part in vector)


def by_corners(*given: Any) -> bool:
    """The formula of 2018, which takes centres for corners."""
    (xa, ya), wa, ha, (xb, yb), wb, hb = given
    return bool(xa < xb + wb and xa + wa > xb and ya < yb + hb and ya + ha > yb)


CONTROLS: list[tuple[Any, str, Wrap, list[str]]] = [
    # the program of 2018
    (translation, "position", with_argument(1, half), ["TC6", "TC7", "OA1", "OA2"]),
    (definitions, "inertia_box", lambda true: lambda *g: true(*g) / 100, ["OD2", "OB4", "OS1"]),
    (impact, "angular_velocity_b_after", with_argument(1, lambda j: -j), ["OB1"]),
    (detection, "overlap", instead(by_corners), ["OD1"]),
    # engines of today: restitution without effect, no effect of the arm
    (impact, "impulse", with_argument(0, lambda e: 0.0 * e + 1.0), ["OB1", "OB3", "OB6b"]),
    (impact, "normal_velocity", with_argument(2, nothing), ["OB1", "OB4"]),
    (impact, "inverse_effective_mass", with_argument(2, nothing), ["OB1"]),
    (impact, "velocity_a_after", with_argument(1, lambda j: 0.999 * j), ["OB3", "OB8b"]),
    # slips of the pen
    (translation, "acceleration", with_argument(0, opposite), ["OA2", "TC4", "TC11"]),
    (translation, "velocity", with_argument(2, lambda t: 0.5 * t), ["TC2", "OA1"]),
    (rotation, "angular_acceleration", with_argument(1, lambda i: 2 * i), ["TC8", "OA3"]),
    (rotation, "orientation", with_argument(2, lambda a: 2 * a), ["TC8", "OA3"]),
    (definitions, "kinetic_energy", with_argument(3, lambda w: 0 * w), ["OD3"]),
    (definitions, "torque", with_argument(0, opposite), ["OD3"]),
    (definitions, "pair_restitution", instead(max), ["OD3"]),
    (schemes, "velocity_verlet", instead(schemes.semi_implicit_euler), ["OA14a", "OA9b"]),
    (schemes, "runge_kutta_4", instead(schemes.velocity_verlet), ["OA14a", "OA5"]),
    (schemes, "legacy_2018_translation", with_argument(2, lambda v: 2 * v), ["TC2", "TC6"]),
    (schemes, "legacy_2018_rotation", with_argument(3, lambda a: a + 1), ["TC8"]),
    # friction: twice as much, in the wrong sense, without the arm, with the turning of A or B lost
    (friction, "friction_force", times(2.0), ["OF1a", "OF2", "OF5c", "OF6"]),
    (friction, "friction_force", times(-1.0), ["OF1a", "OF2"]),
    (friction, "sticking_impulse", times(2.0), ["OF3b", "OF4"]),
    (friction, "share", times(0.5), ["OF3a", "OF4"]),
    (friction, "tangential_velocity", with_argument(1, lambda w: 0.0 * w), ["OF4", "OF11"]),
    (friction, "tangential_velocity", with_argument(4, lambda w: 0.0 * w), ["OF4", "OF6"]),
    (friction, "tangential_acceleration", with_argument(1, lambda a: -a), ["OF5e"]),
    (friction, "tangential_acceleration", with_argument(4, lambda a: -a), ["OF6", "OF10"]),
    (friction, "tangential_acceleration_turning", with_argument(3, lambda w: w + 1e-6), ["OF10"]),
    # a disc on a half-plane: held up and back by twice as much, or at the wrong time
    (rolling, "disc_force", times(2.0), ["OF5c", "OF6"]),
    (rolling, "rolling_friction", times(2.0), ["OF5a", "OF5b", "OF5d"]),
    (rolling, "inverse_rolling_mass", times(2.0), ["OF5a", "OF5b", "OF5d"]),
    (rolling, "sliding_time", times(2.0), ["OF6"]),
    # rest: a corner that is accelerated the wrong way, or does not circle
    (rest, "normal_acceleration", with_argument(4, lambda a: -a), ["OB16"]),
    (rest, "gap_acceleration_side", with_argument(2, lambda w: 0.0 * w), ["OB16"]),
    # forces: half, twice, the wrong way
    (drag, "velocity", with_argument(3, lambda t: 2 * t), ["OA5", "OA6"]),
    (drag, "angular_drag_rate", times(2.0), ["OF9"]),
    (spring, "spring_force", times(2.0), ["OA9d", "OA9c"]),
    (spring, "angular_frequency", times(2.0), ["OA9", "OA9b"]),
    (spring, "spring_energy", times(2.0), ["OA9"]),
    (gravitation, "attraction", times(-1.0), ["OA12", "OA12c"]),
    (gravitation, "gravitational_energy", times(2.0), ["OA12c"]),
    # the soft step: no arm, no damping, an impulse that pulls, friction that drives
    (soft_contact, "row_velocity", with_argument(2, lambda arm: 0.0 * arm), ["OG1"]),
    (soft_contact, "separation_later", with_argument(3, lambda arm: -arm), ["OG1"]),
    (soft_contact, "mass_share", with_argument(1, lambda z: 0.0 * z), ["OG2"]),
    (soft_contact, "soft_normal_impulse", times(-1.0), ["OG2"]),
    (soft_contact, "limited_tangent_impulse", with_argument(3, lambda mu: 2 * mu), ["OG2"]),
    (firm_contact, "accumulated_impulse_wanted", with_argument(1, lambda u: -u), ["OG4"]),
    (firm_contact, "firm_lever", with_argument(1, lambda arm: -arm), ["OG4"]),
    (firm_contact, "momentum_a_after", with_argument(1, lambda given: -given), ["OG5"]),
    (island_energy, "work", with_argument(5, lambda turn: -turn), ["OG6"]),
    (island_energy, "damped_share", times(2.0), ["OG7"]),
    (continuous_collision, "advance_closing", times(2.0), ["OG9"]),
    (continuous_collision, "centre_acceleration_turning", times(0.5), ["OG9"]),
    (sleeping, "quiet_square", times(2.0), ["OG10"]),
]


@pytest.mark.parametrize(("module", "name", "wrap", "ids"), CONTROLS)
def test_a_fault_is_found(
    module: Any, name: str, wrap: Wrap, ids: list[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    true = getattr(module, name)
    monkeypatch.setattr(module, name, wraps(true)(wrap(true)))
    for caller in (located, sampling):  # kernels are made from the text of what is wrong here
        monkeypatch.setattr(caller, "march_by_kernels", lambda *_: None)
    monkeypatch.setattr(EventDriven, "pays", lambda *_: False)  # it is compiled, too

    def not_located(_: Plan, reason: str) -> Plan:
        raise SimulationError(reason)

    monkeypatch.setattr(Plan, "by_steps", not_located)  # steps are compiled, and may be as exact
    for id in ids:
        verdicts = {outcome.verdict for outcome in suite.judge(Case(items()[id]))}
        assert FAIL in verdicts, f"{id} passes with a wrong {name}"


def test_a_model_without_its_function_fails(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delattr(translation, "position")
    with pytest.raises(AttributeError, match="position"):
        suite.judge(Case(items()["TC2"]))
