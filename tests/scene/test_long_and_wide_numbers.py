"""Numbers that are too long for a message, and digits that only look like those of a number."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

import tamias2d as t2
from tamias2d.spec.messages import SpecFault
from tamias2d.spec.units import parse_quantity, parse_unit

LONG = 10**400
LONGER = 10**5000
"""Longer than what Python writes."""


def disc(**values: Any) -> t2.Scene:
    scene = t2.Scene(gravity=(0.0, 0.0))
    given = {"mass": 1.0, "position": (0.0, 0.0), "restitution": 0.0, **values}
    scene.add_body(t2.Disc(radius=1.0), name="disc", **given)
    return scene


def simulator() -> t2.Simulator:
    return t2.Simulator(disc(), compiled=False)


USES: dict[str, Callable[[Any], object]] = {
    "radius": lambda value: t2.Disc(radius=value),
    "mass": lambda value: disc(mass=value),
    "position": lambda value: disc(position=(0.0, value)),
    "category": lambda value: disc(category=value),
    "mask": lambda value: disc(mask=value),
    "duration": lambda value: t2.simulate(disc(), duration=value),
    "tolerance": lambda value: t2.simulate(disc(), duration=1.0, tolerance=value),
    "quality": lambda value: t2.simulate(disc(), duration=1.0, quality=value),
    "time step": lambda value: t2.Simulator(disc(), time_step=value),
    "substeps": lambda value: t2.Simulator(disc(), substeps=value),
    "steps": lambda value: simulator().step(value),
    "row": lambda value: simulator().body(value),
    "impulse": lambda value: simulator().apply_impulse(0, (value, 0.0)),
    "speed": lambda value: disc().add_joint(
        t2.Revolute(motor=t2.Motor(speed=value)), "disc", (0.0, 0.0)
    ),
}


@pytest.mark.parametrize(
    "value", [LONG, -LONG, LONGER, "1" + 400 * "0"], ids=["long", "negative", "longer", "text"]
)
@pytest.mark.parametrize("use", USES)
def test_a_long_number_is_refused_in_a_short_line(use: str, value: Any) -> None:
    with pytest.raises(t2.InputError) as refused:
        USES[use](value)
    assert len(str(refused.value)) < 300
    assert 60 * "0" not in str(refused.value)


def test_a_message_says_how_long_a_number_is() -> None:
    with pytest.raises(t2.InputError, match=r"10{19}\.\.\. \(401 digits\) of body 'body0': must"):
        t2.Scene(gravity=(0.0, 0.0)).add_body(
            None, mass=1.0, position=(0.0, 0.0), restitution=0.0, category=LONG
        )
    with pytest.raises(t2.InputError, match=r"'10{19}\.\.\. \(401 characters\)' does not fit"):
        disc(force=(f"{LONG}[N]", "0[N]"))
    with pytest.raises(t2.InputError, match="found int with a number of more than 4300 digits"):
        t2.Disc(radius=LONGER)


WIDE = ("\uff11\uff10", "1\uff10", "1.\uff15", "1e\uff11", "\u0663", "\u00b2")
"""Digits that take the place of two, of another script, and raised ones."""


@pytest.mark.parametrize("text", WIDE)
@pytest.mark.parametrize("unit", ["", " m"])
def test_digits_are_0_to_9(text: str, unit: str) -> None:
    with pytest.raises(SpecFault, match="digits are 0 to 9"):
        parse_quantity(text + unit)
    with pytest.raises(SpecFault, match="digits are 0 to 9"):
        parse_unit("m^" + text)


@pytest.mark.parametrize("text", WIDE)
@pytest.mark.parametrize("key", ["radius", "category"])
def test_they_are_in_scene_files_too(text: str, key: str, tmp_path: Path) -> None:
    path = tmp_path / "wide.yaml"
    values = {"radius": "1 m", "category": "1"} | {key: text + " m" * (key == "radius")}
    stated = ", ".join(f"{name}: {value}" for name, value in values.items())
    body = f"{{shape: disc, {stated}, mass: 1 kg, position: [0 m, 0 m], restitution: 0.5}}"
    path.write_text(
        f"gravity: [0 m/s^2, 0 m/s^2]\nduration: 1 s\nbodies:\n  b: {body}\n", encoding="utf-8"
    )
    with pytest.raises(t2.SceneError, match=f"{key}: .*(digits are 0 to 9|must be a whole number)"):
        t2.load(path)


@pytest.mark.parametrize("text", ["\uff11*x", "2*x + \uff11", "x**\uff12", "3[m^\uff12]"])
def test_they_are_in_expressions(text: str) -> None:
    with pytest.raises(t2.InputError, match=r"is not ASCII\. Write names as words, digits as 0"):
        disc(force=(text, "0[N]"))
