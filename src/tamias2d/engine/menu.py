"""The libraries of compiled code that there are; no scene ever needs another."""

from functools import cache
from types import SimpleNamespace

import numpy as np

from tamias2d.engine.joints.all_stages import JOINT_STAGES
from tamias2d.engine.motion.ballistic import integrate_ballistic, note_course
from tamias2d.engine.query.overlap import build_query_tree, shapes_in_box
from tamias2d.engine.query.overlap_shape import shapes_in_shape
from tamias2d.engine.query.ray_cast import cast_rays
from tamias2d.engine.query.shape_cast import cast_core
from tamias2d.engine.step import step
from tamias2d.engine.world_batch import step_worlds
from tamias2d.kernels import Library

_STEPS = (step, integrate_ballistic, note_course)
CONTACT = Library("contact engine", (*_STEPS, step_worlds), without=JOINT_STAGES)
JOINTED = Library("contact engine with joints", _STEPS)
QUERY = Library("queries", (build_query_tree, cast_rays, cast_core, shapes_in_box, shapes_in_shape))
MENU: tuple[Library, ...] = (CONTACT, JOINTED, QUERY)


def chosen(*, joints: bool, had_joints: bool) -> Library:
    """Return the engine for a world with joints, or without; their bits are the same.

    One that has had joints loads no other for its last ones being gone: that takes a while.
    """
    return JOINTED if joints or (had_joints and not CONTACT.is_loaded()) else CONTACT


def functions(library: Library, *, compiled: bool) -> SimpleNamespace:
    """Return the entries of a library by their names: compiled, or as plain Python."""
    return library.compiled() if compiled else _silent(library)


@cache
def _silent(library: Library) -> SimpleNamespace:
    """Return the plain entries, which do not warn, as compiled arithmetic does not."""
    silent = np.errstate(all="ignore")
    return SimpleNamespace(**{name: silent(f) for name, f in vars(library.plain()).items()})
