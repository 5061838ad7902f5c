"""Stepped worlds of one scene: its simulator is made once, and compiled code goes through them.

Serves: the solving of blocks. Hides: which ensembles this fits, and where the values of a world go.
A start follows from its values but for the order of its bodies, which goes by where they are: so
there is a simulator for each order, in which bodies that are alike stand in for each other. Each
world has the bits that it has alone.
"""

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from tamias2d.engine.bodies.canonical_order import strips
from tamias2d.engine.shapes.shape_rows import shape_rows
from tamias2d.engine.shapes.stated_surfaces import as_stated
from tamias2d.engine.world_batch import (
    GRAVITY,
    START,
    START_INVERSE,
    START_LOAD,
    START_POSE,
    START_SURFACE,
    START_VELOCITY,
    begin_world,
)
from tamias2d.ensemble.request import STATE, Request
from tamias2d.ensemble.worlds import VariedWorlds, Worlds, inertia_of, value_of
from tamias2d.errors import InputError, SceneError, SimulationError
from tamias2d.motion import Stepped
from tamias2d.record.dataset import BODIES, DIMENSIONS
from tamias2d.scene import Body, HalfPlane, Scene
from tamias2d.scene.acting import steady_load
from tamias2d.scene.compound import Shape
from tamias2d.simulator import Restart, Sampling, Simulator, states_of
from tamias2d.simulator.batch import scene_batch
from tamias2d.simulator.step_warnings import strongest_gravity
from tamias2d.state import Array, IntArray

_SURFACE = ("restitution", "friction")
_MOTION = ("position", "orientation", "velocity", "angular_velocity")
_REFUSALS = (SimulationError, SceneError, InputError)
_BRIEF = 2**13  # bodies times steps
_PILOT, _MOST = 64, 0.98
_LARGEST = 1e100  # what is beyond it is left to the ordinary way, which tells why it cannot be


@dataclass(frozen=True)
class Kept:
    """What was kept of stepped worlds."""

    arrays: dict[str, Array]
    """By name, with the worlds along the first axis."""
    done: NDArray[np.bool_]
    """(k,): which worlds were stepped; the others are to be solved in the ordinary way."""


class _Starts(NamedTuple):
    """How w worlds of n bodies start, and what these are, as `engine.world_batch` takes it."""

    given: Array  # (w, 2 + 14 n), of which all others are views

    pose: Array  # (w, n, 3)
    velocity: Array  # (w, n, 3)
    load: Array  # (w, n, 3)
    inverse: Array  # (w, n, 2), of masses and inertias
    surface: Array  # (w, n, 3), friction, restitution and surface speed
    gravity: Array  # (w, 2)


def mostly_stepped(worlds: Worlds, request: Request) -> bool:
    """Whether compiled code steps most worlds in microseconds each: then threads are enough."""
    if not (_asked(request) and isinstance(worlds, VariedWorlds)):
        return False
    step: Any = request.time_step
    if len(worlds.base) * request.duration > _BRIEF * step:
        return False
    found = stepped(worlds, request, 0, min(len(worlds), _PILOT))
    return found is not None and bool(found.done.mean() > _MOST)


def stepped(worlds: Worlds, request: Request, first: int, last: int) -> Kept | None:
    """Step the worlds from `first` to before `last`; None if the ensemble is not of this kind."""
    if not (isinstance(worlds, VariedWorlds) and _asked(request) and _fits(worlds)):
        return None
    rows, count = worlds.part(first, last), last - first
    with np.errstate(all="ignore"):
        starts = _starts(rows, count)
        order, decided = _orders(rows, starts.pose)
        done = decided & (np.abs(starts.given) < _LARGEST).all(axis=1)
    kinds = np.array(_kinds(worlds.base))
    step: Any = request.time_step
    sampling = Sampling(request.times, request.duration, step)
    states = np.empty((count, len(sampling.stops), 6 * len(kinds)))
    stands_for = np.empty_like(order)
    for group in _alike(kinds[order], done):
        try:
            world = _Prepared(rows.scene(first + int(group[0])), request, sampling)
        except _REFUSALS:
            done[group] = False
            continue
        stands_for[group[:, None], order[group[0]]] = order[group]
        done[group] = world.step(group, stands_for, starts, states)
    return Kept(_kept(states, done, sampling, request), done)


def _kept(
    states: Array, done: NDArray[np.bool_], sampling: Sampling, request: Request
) -> dict[str, Array]:
    """Return what is kept of the worlds that are done; NaN of the others."""
    worlds, stops, columns = states.shape
    whole = (states if done.all() else states[done]).reshape(-1, stops, 6, columns // 6)
    history = sampling.history(whole)
    bodies, arrays = list(request.bodies), {}
    for name in request.keep:
        values = getattr(history, name)
        arrays[name] = np.full((worlds, *request.shape(name)), np.nan)
        arrays[name][done] = values[:, :, bodies] if BODIES in DIMENSIONS[name] else values
    return arrays


def _asked(request: Request) -> bool:
    """Whether the request is one for states, by steps."""
    states = request.tolerance is None and not request.quantities
    return isinstance(request.method, Stepped) and states and set(request.keep) <= set(STATE)


def _fits(worlds: VariedWorlds) -> bool:
    """Whether all that varies has its place in the arrays of a simulator, and nothing follows."""
    scene = worlds.base
    alone = not (scene.springs or scene.fields or scene.joints or scene.attraction is not None)
    steady = all(body.constant and not body.quadratic_drag for body in scene.bodies)
    return alone and steady and all(_has_place(scene, place.keys) for place in worlds.values)


def _has_place(scene: Scene, keys: tuple[Any, ...]) -> bool:
    if keys[0] != "bodies":
        return bool(keys[0] == "gravity")
    body, key = scene.bodies[scene.index(keys[1])], keys[2]
    slowed = body.linear_drag or body.angular_drag
    if body.dynamic and not body.inverse_inertia and key in ("angular_velocity", "torque"):
        return False  # nothing turns it: each scene refuses what would
    moves = key in _MOTION and not (body.static and isinstance(body.shape, HalfPlane))
    pushed = key in ("force", "torque") or (key in ("mass", "inertia") and not slowed)
    return key in (*_SURFACE, "surface_speed") or moves or (pushed and body.shape is not None)


# -- the values of all worlds


def _starts(worlds: VariedWorlds, count: int) -> _Starts:
    scene = worlds.base
    given = np.zeros((count, GRAVITY + START * len(scene)))
    bodies = given[:, GRAVITY:].reshape(count, len(scene), START)
    found = _Starts(
        given=given,
        pose=bodies[..., START_POSE : START_POSE + 3],
        velocity=bodies[..., START_VELOCITY : START_VELOCITY + 3],
        load=bodies[..., START_LOAD : START_LOAD + 3],
        inverse=bodies[..., START_INVERSE : START_INVERSE + 2],
        surface=bodies[..., START_SURFACE : START_SURFACE + 3],
        gravity=given[:, :GRAVITY],
    )
    for k, body in enumerate(scene.bodies):
        _fill(worlds, k, body, found)
    for c in (0, 1):
        found.gravity[:, c] = value_of(worlds, ("gravity", c), scene.gravity[c])
    return found


def _fill(worlds: VariedWorlds, k: int, body: Body, found: _Starts) -> None:
    """Fill in how a body starts in all worlds, and what it is."""

    def value(base: Any, *keys: str | int) -> Any:
        return value_of(worlds, ("bodies", body.name, *keys), base)

    load = steady_load(worlds.base, k)
    for c in (0, 1):
        found.pose[:, k, c] = value(body.position[c], "position", c)
        found.velocity[:, k, c] = value(body.velocity[c], "velocity", c)
        found.load[:, k, c] = 0.0 + value(load[c], "force", c)
    found.pose[:, k, 2] = value(body.orientation, "orientation")
    found.velocity[:, k, 2] = value(body.angular_velocity, "angular_velocity")
    found.load[:, k, 2] = 0.0 + value(load[2], "torque")
    found.inverse[:, k, 0] = 1 / value(body.mass, "mass")
    found.inverse[:, k, 1] = 1 / inertia_of(worlds, body)
    for column, key in enumerate(("friction", "restitution")):
        found.surface[:, k, column] = value(as_stated(getattr(body, key)), key)
    found.surface[:, k, 2] = value(body.surface_speed, "surface_speed")


# -- the order of bodies


def _orders(worlds: VariedWorlds, pose: Array) -> tuple[IntArray, NDArray[np.bool_]]:
    """Return the order of the bodies in each world (w, n), and whether it is all that decides.

    What else orders bodies is told only where it is the same in all worlds.
    """
    scene = worlds.base
    batch = scene_batch(scene)
    reach = np.array([_reach(shape) for shape in batch.shapes])
    x, y = pose[..., 0], pose[..., 1]
    keys = np.stack((np.broadcast_to(batch.kind, x.shape), strips(x, reach), y, x))
    order = np.lexsort(keys[::-1], axis=-1)
    found = np.take_along_axis(keys, order[None], axis=-1)
    same = (found[..., 1:] == found[..., :-1]).all(axis=0)
    varied = {place.keys[1] for place in worlds.values if place.keys[0] == "bodies"}
    varies = np.array([body.name in varied for body in scene.bodies])[order]
    return order, ~(same & (varies[:, 1:] | varies[:, :-1])).any(axis=-1)


def _reach(shape: Shape | None) -> float:
    """Return how far the parts of a shape reach from its centre, as far as they have an end."""
    ends = [part.bounding_radius for part in shape_rows(shape)]
    return max((far for far in ends if math.isfinite(far)), default=0.0)


def _kinds(scene: Scene) -> list[int]:
    """Return a number for each body, the same for those that differ in what a start tells alone."""
    laws = scene.restitution_of_pairs or scene.friction_of_pairs
    found: dict[Any, int] = {}
    return [
        found.setdefault(k if laws or not body.dynamic else _without_start(body), k)
        for k, body in enumerate(scene.bodies)
    ]


def _without_start(body: Body) -> Body:
    """Return a body with nothing of what a start tells."""
    told: dict[str, Any] = {"name": "", "position": (0.0, 0.0), "orientation": 0.0}
    told |= {"velocity": (0.0, 0.0), "angular_velocity": 0.0, "force": (0.0, 0.0), "torque": 0.0}
    if not (body.linear_drag or body.angular_drag):
        told |= {"mass": 1.0, "inertia": 1.0, "inertia_stated": True}
    told |= {key: None if getattr(body, key) is None else 0.0 for key in _SURFACE}
    return replace(body, **told)


def _alike(order: IntArray, some: NDArray[np.bool_]) -> Iterator[IntArray]:
    """Yield the worlds in which the kinds of bodies have one order, of some."""
    there = np.flatnonzero(some)
    which = np.zeros(len(there), dtype=np.intp)
    for column in order[there].T:  # whole rows take twenty times as long
        _, which = np.unique(which * order.shape[1] + column, return_inverse=True)
    for k in range(int(which.max(initial=-1)) + 1):
        yield there[which == k]


# -- the worlds of one order


class _Prepared:
    """The simulator of all worlds of one order."""

    def __init__(self, scene: Scene, request: Request, sampling: Sampling) -> None:
        method: Any = request.method
        step: Any = request.time_step
        self._sim = Simulator(scene, time_step=step, substeps=method.substeps)
        self._restart, self._sampling = Restart(self._sim), sampling
        self._strongest = strongest_gravity(self._sim._engine, step)

    def step(
        self, rows: IntArray, stands_for: IntArray, starts: _Starts, states: Array
    ) -> NDArray[np.bool_]:
        """Step the worlds of some rows, and write their states; return which it could.

        Each body of the simulator stands for one of the world.
        """
        given, stops = starts.given, np.array(self._sampling.stops)
        done = np.ones(len(rows), dtype=np.bool_)
        strong = np.hypot(*starts.gravity[rows].T) > self._strongest
        k = 0
        while k < len(rows):
            end = k + int(np.argmax(np.append(strong[k:], True)))
            k += self._restart.step_worlds(rows[k:end], given, stands_for, stops, states)
            if k < len(rows):  # it has something to tell, or needs longer arrays
                row = rows[k]
                done[k] = self._alone(given[row], stands_for[row], states[row])
                k += 1
        return done

    def _alone(self, given: Array, stands_for: IntArray, states: Array) -> bool:
        """Step a world by itself, and write its states; return whether that could be done."""
        self._restart()
        engine = self._sim._engine
        begin_world(given, stands_for, engine.world)
        try:
            found = states_of(self._sim, self._sampling)
        except _REFUSALS:
            return False
        states.reshape(found.shape)[:, :, stands_for] = found
        return True
