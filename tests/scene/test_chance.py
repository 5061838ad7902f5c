"""Scene files and arguments that chance has changed: taken and right, or one named error.

A hundred thousand seeds were tried once; here are some of each.
"""

import math
import random
from typing import Any

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.scene import pieces_of

FILES = [t2.catalogue.text(name) for name in ("showcase", "own-law", "spring-chain", "tc11-corner")]
LETTERS = "[]{}:,-#'\"\\\t0 ax\x07é&*!|>%@`"
WORDS = ["[1 m, 2 m]", "[[a]]", "{a: b}", "~", "inf m", "1e-320 m", "1e308 kg", "|\n  x", "&a 1"]
VALUES: list[Any] = [
    *(0, -1, 1e-9, 1e9, 5e-324, 1e-310, 1e-160, 1e155, 1e308, math.nan, math.inf, 10**400, 1j),
    *(None, True, "1 m", "1[N]", "#", b"x", (), {}, [1], (1, 2), (0.5, "time*1[N/s]"), print),
    *(np.float32(0.3), np.array(1.0), np.array([1.0]), np.ma.masked, np.zeros((2, 2)), t2.Disc),
]


def changed(text: str, chance: random.Random) -> str:
    lines = text.split("\n")
    for _ in range(chance.randrange(1, 4)):
        k = chance.randrange(len(lines))
        line, other = lines[k], lines[chance.randrange(len(lines))]
        at = chance.randrange(len(line) + 1)
        lines[k] = chance.choice(
            [
                line[:at] + chance.choice(LETTERS) + line[at + chance.randrange(2) :],
                f"{line.partition(':')[0]}: {chance.choice(WORDS)}",
                " " * chance.randrange(6) + line.strip(),
                f"{line}\n{other}",
                "",
            ]
        )
    return "\n".join(lines) + "\n"


def value(chance: random.Random) -> Any:
    if chance.random() < 0.85:
        return chance.uniform(0.1, 9.0)
    return chance.choice([chance.choice(VALUES), 10 ** chance.uniform(-330, 308)])


def single(chance: random.Random) -> Any:
    size = [value(chance) for _ in range(6)]
    return chance.choice(
        [
            lambda: t2.Disc(radius=size[0]),
            lambda: t2.Box(width=size[0], height=size[1]),
            lambda: t2.Capsule(length=size[0], radius=size[1]),
            lambda: t2.Segment(length=size[0]),
            lambda: t2.Polygon(vertices=[(size[0], 0), (0, size[1]), (size[2], size[3])]),
        ]
    )()


def shape(chance: random.Random) -> Any:
    if chance.random() < 0.5:
        return single(chance)
    places = [(value(chance), value(chance)) for _ in range(3)]
    return t2.Compound(
        parts=[
            t2.Part(shape=single(chance), position=at, orientation=value(chance)) for at in places
        ]
    )


def body(chance: random.Random) -> t2.Scene:
    scene = t2.Scene(gravity=(0, value(chance)))
    keys = [
        "velocity",
        "force",
        "torque",
        "inertia",
        "restitution",
        "friction",
        "mask",
        "linear_drag",
    ]
    more = {key: value(chance) for key in chance.sample(keys, 2)}
    more |= {key: (value(chance), value(chance)) for key in ("velocity", "force") if key in more}
    at = (value(chance), value(chance))
    scene.add_body(shape(chance), mass=value(chance), position=at, **more)
    return scene


@pytest.mark.parametrize("seed", range(6))
def test_a_changed_file_is_right_or_refused(seed: int) -> None:
    chance, taken = random.Random(seed), 0
    for _ in range(50):
        try:
            scene = t2.load(changed(chance.choice(FILES), chance))
        except t2.SceneError as refusal:
            assert "\n" not in str(refusal)
        else:
            assert t2.load(t2.scene_text(scene)) == scene
            taken += 1
    assert 0 < taken < 50


@pytest.mark.parametrize("seed", range(6))
def test_arguments_are_right_or_refused(seed: int) -> None:
    chance, taken = random.Random(seed), 0
    for _ in range(400):
        try:
            scene = body(chance)
        except t2.InputError as refusal:
            assert "\n" not in str(refusal)
        else:
            assert t2.load(t2.scene_text(scene)) == scene
            cores = [piece.core for piece in pieces_of(scene.bodies[0].shape)]
            assert all(len(set(core)) == len(core) for core in cores)
            taken += 1
    assert 0 < taken < 400
