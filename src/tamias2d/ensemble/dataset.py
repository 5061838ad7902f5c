"""Datasets of ensembles: what was kept, what varied, and all by which a world is made again.

Serves: ensembles and whoever reads their results. Hides: which attribute holds what.
"""

import hashlib
import inspect
import json
from collections.abc import Callable, Mapping
from importlib import metadata
from typing import Any

import numpy as np

from tamias2d.certificate import source_digest
from tamias2d.ensemble.outline import outline_of
from tamias2d.ensemble.places import place_at
from tamias2d.ensemble.request import Request
from tamias2d.ensemble.sampling import checked_values
from tamias2d.ensemble.solving import OUTCOMES
from tamias2d.ensemble.worlds import MadeWorlds, VariedWorlds
from tamias2d.errors import RecordingError
from tamias2d.record.dataset import AXES, BODIES, DIMENSIONS, TIMES, attributes, extra
from tamias2d.scene import Scene, scene_text
from tamias2d.scene.reading import read_scene
from tamias2d.scene.rules import RuleError, checked_count
from tamias2d.suggestions import suggests

WORLDS = "world"
_RECIPE = "recipe"
_SCENE, _VARIED = "scene", "varied"
_UNFIT = (
    "a variable of the dataset has this name: must not be empty, begin with a dot, or have a "
    "slash, a backslash or what cannot be printed"
)


def refuse_bad_names(worlds: VariedWorlds | MadeWorlds, request: Request) -> None:
    """Raise `RuleError` if a variable of the dataset has a name that it, or a store, cannot hold.

    Stores have a folder of each variable's name, so that one with a slash would be in a folder of
    its own, in which nobody looks.
    """
    paths = [place.path for place in worlds.values] if isinstance(worlds, VariedWorlds) else []
    taken = (*DIMENSIONS, "outcome", WORLDS, TIMES, BODIES, AXES, *paths)
    for name in request.quantities:
        if name in taken:
            raise RuleError(
                f"quantity {name!r}: the dataset has this name for something else (R5). Give "
                "another name.",
                "quantities",
            )
        if _unfit(name):
            raise RuleError(f"quantity {name!r}: {_UNFIT} (R5). Give another name.", "quantities")
    for path in paths:
        if _unfit(path):
            raise RuleError(f"vary {path!r}: {_UNFIT} (R2). Rename what is varied.", "vary")


def _unfit(name: str) -> bool:
    return not name.isprintable() or not name or name[0] == "." or "/" in name or "\\" in name


def dataset_of(
    worlds: VariedWorlds | MadeWorlds,
    request: Request,
    array: Callable[[str, tuple[int, ...]], Any],
) -> Any:
    """Return the `xarray.Dataset` of an ensemble; `array` makes each variable by name and shape."""
    with extra():
        import xarray
    variables: dict[str, Any] = {
        name: (
            (WORLDS, *DIMENSIONS.get(name, ())),
            array(name, (len(worlds), *request.shape(name))),
            attributes(name),
        )
        for name in request.kept
    }
    meaning = {"flag_values": list(range(len(OUTCOMES))), "flag_meanings": " ".join(OUTCOMES)}
    variables["outcome"] = ((WORLDS,), array("outcome", (len(worlds),)), meaning)
    return xarray.Dataset(variables, _coordinates(worlds, request), _attributes(worlds, request))


def _coordinates(worlds: VariedWorlds | MadeWorlds, request: Request) -> dict[str, Any]:
    axes = {axis for name in request.keep for axis in DIMENSIONS[name]}
    known: dict[str, Any] = {
        TIMES: (TIMES, np.array(request.times), attributes(TIMES)),
        BODIES: (BODIES, np.array([request.names[k] for k in request.bodies], dtype=str)),
        AXES: (AXES, np.array(["x", "y"])),
    }
    varied = {}
    for place, values in worlds.values.items() if isinstance(worlds, VariedWorlds) else ():
        dimensions = (WORLDS, AXES) if place.vector else (WORLDS,)
        axes |= set(dimensions) - {WORLDS}
        varied[place.path] = (dimensions, values, {"units": place.symbol.unit})
    numbers = {WORLDS: (WORLDS, np.arange(len(worlds)))}
    return numbers | {name: known[name] for name in known if name in axes} | varied


def _attributes(worlds: VariedWorlds | MadeWorlds, request: Request) -> dict[str, Any]:
    varied = worlds.values if isinstance(worlds, VariedWorlds) else {}
    made = worlds.base if isinstance(worlds, VariedWorlds) else None
    asked = {
        "duration": request.duration,
        "method": "" if request.method is None else str(request.method),
        "time_step": request.time_step or "",
        "tolerance": request.tolerance or "",
        "work_limit": request.work_limit,
    }
    return {
        "title": f"ensemble of {len(worlds)} worlds",
        **asked,
        _VARIED: [place.path for place in varied],
        _SCENE: "" if made is None else scene_text(made),
        "program": f"tamias2d {metadata.version('tamias2d')}",
        _RECIPE: _recipe(worlds, request),
    }


def _recipe(worlds: VariedWorlds | MadeWorlds, request: Request) -> str:
    """Return the SHA-256 of all that decides the numbers of an ensemble."""
    total = hashlib.sha256()
    if isinstance(worlds, VariedWorlds):
        total.update(scene_text(worlds.base).encode())
        for place, values in worlds.values.items():
            total.update(f"{place.path}{values.shape}".encode() + values.tobytes())
    else:
        total.update(f"{worlds.seed} {worlds.count} {_text_of(worlds.make)}".encode())
    words = {name: repr(value) for name, value in vars(request).items() if name != "quantities"}
    words |= {name: _text_of(function) for name, function in request.quantities.items()}
    total.update(json.dumps(words, sort_keys=True).encode() + source_digest().encode())
    return total.hexdigest()


def _text_of(function: Callable[..., Any]) -> str:
    """Return the source of a function, or else its name."""
    try:
        return inspect.getsource(function)
    except (OSError, TypeError):
        return f"{function.__module__}.{getattr(function, '__qualname__', type(function).__name__)}"


def refuse_other(
    found: Mapping[str, Any], worlds: VariedWorlds | MadeWorlds, request: Request, where: str
) -> None:
    """Raise `RecordingError` if the attributes of a store are not those of an ensemble."""
    if found.get(_RECIPE) != _recipe(worlds, request):
        raise RecordingError(
            f"{where}: holds another ensemble, or one of another version of the program (R8). "
            "Give another `out`, or delete it."
        )


@suggests
def world_scene(dataset: Any, world: int) -> Scene:
    """Return the scene of one world of an ensemble, by its number in the dataset of the results.

    `simulate`, with the ensemble's own arguments, then gives the bits that the dataset holds.

    Raises:
        InputError: there is no such world, or the ensemble was made by a function.
        RecordingError: the dataset is not one of an ensemble.
    """
    about = getattr(dataset, "attrs", {})
    if not {_SCENE, _VARIED, _RECIPE} <= about.keys():
        raise RecordingError(
            "dataset: its attributes are not those of an ensemble (R8). Give what `t2.ensemble` "
            "returned, or open it by `xarray.open_zarr`."
        )
    number = checked_count(world, "world", 0)
    if number not in dataset[WORLDS].values:
        raise RuleError(
            f"world {number}: the dataset has no such world (R5). Give one of "
            f"{dataset.sizes[WORLDS]} in `dataset.world`.",
            "world",
        )
    if not about[_SCENE]:
        raise RuleError(
            "world: the scenes of this ensemble were made by a function (R8). Call it with the "
            "number of the world, and with `t2.random_stream(seed, world)`.",
            "world",
        )
    base = read_scene(about[_SCENE], file="scene of the ensemble")
    outline = outline_of(base)
    places = [place_at(path, outline) for path in about[_VARIED]]
    one = dataset.sel({WORLDS: [number]})
    values = {place: checked_values(one[place.path].values, place, 1) for place in places}
    return VariedWorlds(base, values, 1, first=number).scene(number)
