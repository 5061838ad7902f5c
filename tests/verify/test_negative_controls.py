"""Faults of the kind that other programs shipped must make cases fail.

Each puts a wrong function in the place of a generated one. A suite that passes with it is broken.
"""

from collections.abc import Callable
from functools import wraps
from typing import Any

import pytest

from tamias2d.generated import (
    definitions,
    detection,
    impact,
    rotation,
    schemes,
    translation,
)
from tamias2d.verify import FAIL, engine
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
]


@pytest.mark.parametrize(("module", "name", "wrap", "ids"), CONTROLS)
def test_a_fault_is_found(
    module: Any, name: str, wrap: Wrap, ids: list[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    true = getattr(module, name)
    monkeypatch.setattr(module, name, wraps(true)(wrap(true)))
    for id in ids:
        verdicts = {outcome.verdict for outcome in engine.judge(Case(items()[id]))}
        assert FAIL in verdicts, f"{id} passes with a wrong {name}"


def test_a_model_without_its_function_fails(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delattr(translation, "position")
    with pytest.raises(AttributeError, match="position"):
        engine.judge(Case(items()["TC2"]))
