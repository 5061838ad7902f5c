"""Scene files of the catalogue in which words and numbers were changed."""

import random
import re
import warnings
from importlib.resources import files

import numpy as np

import tamias2d as t2
from tamias2d.scene import catalogue
from tamias2d.scene.reading import read_scene
from tools.fuzz.numbers import ODD

_WORDS = ("", "~", "[]", "{}", "[1, 2", "yes", "!!python/object:os.system", "&a", "*a", "1 kg", "m")
_TOKEN = re.compile(r"[\w.+-]+|[^\w\s]")
WORK = 300  # steps and impacts of a run


def case(seed: int) -> str:
    """Read a damaged file, and simulate what it says; return what came of it."""
    chance = random.Random(seed)
    text = _damaged(_text(chance.choice(_names())), chance)
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", t2.StepWarning)
            scene = read_scene(text, file="fuzzed.yaml")
            run = t2.simulate(scene, duration=0.02, work_limit=WORK)
    except t2.TamiasError:
        return "refused"
    assert np.isfinite(run.position).all(), "a state is not finite"
    return "done"


def _names() -> list[str]:
    return [name for name in catalogue.names() if _path(name).is_file()]


def _path(name: str):  # type: ignore[no-untyped-def]  # a Traversable of either importlib
    return files(catalogue.__name__) / f"{name}.yaml"


def _text(name: str) -> str:
    return str(_path(name).read_text())


def _damaged(text: str, chance: random.Random) -> str:
    for _ in range(chance.choice((1, 1, 2, 4))):
        tokens = list(_TOKEN.finditer(text))
        one, other = chance.choice(tokens), chance.choice(tokens)
        new = chance.choice(
            (str(chance.choice(ODD)), chance.choice(_WORDS), other.group(), one.group() * 2, "nan")
        )
        text = text[: one.start()] + new + text[one.end() :]
    return text
