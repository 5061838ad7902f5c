"""The catalogue: scenes that tests, measurements, docs and the command line share.

Serves: tests, docs, the command line. Hides: where the files are.

One YAML file a scene; a file is found by its name.
"""

import difflib
from importlib.resources import files

from tamias2d.errors import SceneError
from tamias2d.scene.reading import read_scene
from tamias2d.scene.scene import Scene

_SUFFIX = ".yaml"


def names() -> list[str]:
    """Return the names of all scenes, in alphabetical order."""
    found = (entry.name for entry in files(__name__).iterdir())
    return sorted(name.removesuffix(_SUFFIX) for name in found if name.endswith(_SUFFIX))


def load(name: str) -> Scene:
    """Return a scene of the catalogue.

    Raises:
        SceneError: the catalogue has no such scene.
    """
    if name not in names():
        close = difflib.get_close_matches(name, names(), n=1)
        hint = f"Did you mean '{close[0]}'?" if close else f"Take one of {', '.join(names())}."
        raise SceneError(f"scene '{name}': not in the catalogue (R2). {hint}")
    text = (files(__name__) / f"{name}{_SUFFIX}").read_text(encoding="utf-8")
    return read_scene(text, file=f"{name}{_SUFFIX}", name=name)
