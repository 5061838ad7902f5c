"""Tamias2D: 2D rigid-body physics, generated from its requirements specification.

The names below are loaded when they are first used, so that importing the package costs little.
"""

import sys
from importlib import import_module
from types import ModuleType
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from tamias2d.errors import (
        InputError,
        RecordingError,
        SceneError,
        SimulationError,
        SpecError,
        TamiasError,
    )
    from tamias2d.motion.methods import (
        ClosedForm,
        ExplicitEuler,
        Legacy2018,
        Reference,
        RungeKutta4,
        SemiImplicitEuler,
        VelocityVerlet,
    )
    from tamias2d.run import Impacts, Run
    from tamias2d.scene import (
        Body,
        Box,
        Disc,
        HalfPlane,
        Polygon,
        Scene,
        catalogue,
        load,
        needs,
        scene_text,
    )
    from tamias2d.simulate import simulate
    from tamias2d.trace import trace
    from tamias2d.verify import verify

_HOMES = {
    "tamias2d.errors": (
        "InputError RecordingError SceneError SimulationError SpecError TamiasError"
    ),
    "tamias2d.motion.methods": (
        "ClosedForm ExplicitEuler Legacy2018 Reference RungeKutta4 SemiImplicitEuler VelocityVerlet"
    ),
    "tamias2d.run": "Impacts Run",
    "tamias2d.scene": (
        "Body Box Disc HalfPlane Polygon Scene catalogue load needs scene_text"
    ),
    "tamias2d.simulate": "simulate",
    "tamias2d.trace": "trace",
    "tamias2d.verify": "verify",
}
_HOME_OF = {name: home for home, names in _HOMES.items() for name in names.split()}

__all__ = sorted(_HOME_OF)


def __getattr__(name: str) -> object:
    if name not in _HOME_OF:
        raise AttributeError(f"module 'tamias2d' has no attribute {name!r}")
    value = getattr(import_module(_HOME_OF[name]), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return [*globals(), *__all__]


class _Package(ModuleType):
    """Keeps `tamias2d.simulate` the function: importing its module would put itself there."""

    def __setattr__(self, name: str, value: object) -> None:
        if not (name in _HOME_OF and isinstance(value, ModuleType)):
            super().__setattr__(name, value)


sys.modules[__name__].__class__ = _Package
