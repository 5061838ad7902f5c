"""The libraries of compiled code that there are; no scene ever needs another."""

from functools import cache
from types import SimpleNamespace

import numpy as np

from tamias2d.engine.motion.ballistic import integrate_ballistic, note_course
from tamias2d.engine.query.overlap import build_query_tree, shapes_in_box
from tamias2d.engine.query.ray_cast import cast_rays
from tamias2d.engine.step import step
from tamias2d.kernels import Engine

CONTACT = Engine("contact engine", (step, integrate_ballistic, note_course))
QUERY = Engine("queries", (build_query_tree, cast_rays, shapes_in_box))
MENU: tuple[Engine, ...] = (CONTACT, QUERY)


@cache
def functions(engine: Engine, *, compiled: bool) -> SimpleNamespace:
    """Return the entries of an engine by their names: compiled, or as plain Python."""
    if compiled:
        return engine.compiled()
    silent = np.errstate(all="ignore")  # compiled arithmetic does not warn
    return SimpleNamespace(**{name: silent(f) for name, f in vars(engine.plain()).items()})
