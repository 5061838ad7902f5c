"""The tables of a scene, before anything has happened."""

import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from tamias2d.contact.core import Core
from tamias2d.event_driven import tables
from tamias2d.event_driven.rebound import MOST_IMPULSES
from tamias2d.event_driven.tables import Few, Hulls, World
from tamias2d.generated import rotation, translation
from tamias2d.motion.loads import Loads
from tamias2d.path import PathPiece
from tamias2d.scene import Body, Disc, HalfPlane, Scene
from tamias2d.state import Array

_FEW = 8  # bodies, all of which are near to each other
_LARGER = 2.0  # times the largest of the many: what is in no cell
_ROOM = 16_384  # impacts that are recorded at once
_SLACK = 0.1  # of a cell
_CROWD = 0.5  # bodies in a cell, about
_SPREAD = 5  # percent of the bodies that may be beyond the cells at either end
_CLEAR = 1.0 + 1e-6  # bodies that touch are nearer to each other than that


def world_of(scene: Scene, paths: Sequence[PathPiece], times: Array, *, keeps_paths: bool) -> World:
    """Return the tables of a scene whose bodies are on some paths, with samples at times, s."""
    pairs, laws = pair_laws(scene)
    hulls, departures = hulls_of(scene), 2 * _ROOM if keeps_paths else 0
    world = blank_world(kinds_of(scene), pairs, times, hulls, impacts=_ROOM, departures=departures)
    world.bodies[:], world.laws[:] = body_table(scene), laws
    loads = Loads(scene)
    for k, path in enumerate(paths):
        set_path(world, k, path)
        world.bodies[k, tables.AX : tables.TURNING + 1] = loads.steady(k)
    return world


def blank_world(
    kinds: NDArray[np.int32],
    pairs: NDArray[np.int64],
    times: Array,
    hulls: Hulls,
    *,
    impacts: int,
    departures: int = 0,
) -> World:
    """Return the tables of n bodies of some kinds, near to each other, with room for records."""
    count, room = len(kinds), 16 * (len(kinds) + 4)
    shaped = kinds >= tables.PLANE
    return World(
        numbers=np.zeros(tables.NUMBERS),
        counts=np.zeros(tables.COUNTS, dtype=np.int64),
        kinds=kinds,
        bodies=np.zeros((count, tables.COLUMNS)),
        hulls=hulls,
        pairs=pairs,
        laws=np.zeros((len(pairs), 2)),
        paths=np.zeros((count, tables.PATH_COLUMNS)),
        notes=np.zeros((count, tables.NOTE_COLUMNS), dtype=np.int32),
        bounces=np.zeros((count, 4)),
        leaving=np.full(count, math.inf),
        sliding=np.full(count, math.inf),
        cells=np.zeros((1, 1), dtype=np.int32),
        everywhere=np.flatnonzero(shaped).astype(np.int32),
        changed=np.arange(count, dtype=np.int32),
        near=np.zeros(count, dtype=np.int32),
        queue=np.zeros(room),
        events=np.zeros((room, tables.EVENT_COLUMNS), dtype=np.int32),
        times=times,
        samples=np.zeros((len(times) * count, 6)),
        impacts=np.zeros((impacts + MOST_IMPULSES, tables.IMPACT_COLUMNS)),
        departures=np.zeros((departures, tables.DEPARTURE_COLUMNS)),
        standing=np.zeros((count, 6)),
        cluster=np.zeros(count, dtype=np.int32),
        touchings=np.zeros((tables.MOST_TOUCHING, tables.TOUCHING_COLUMNS), dtype=np.int32),
        contacts=np.zeros((tables.MOST_TOUCHING, tables.CONTACT_COLUMNS)),
    )


def blank_few() -> Few:
    """Return the table of pairs of few bodies."""
    lanes = tables.LANES
    return Few(
        bodies=np.zeros(tables.LANE_COLUMNS * lanes),
        now=np.zeros(tables.NOW_COLUMNS * lanes),
        times=np.zeros((lanes, lanes)),
        exact=np.zeros((lanes, lanes), dtype=np.int32),
        least=np.zeros(lanes),
        partner=np.zeros(lanes, dtype=np.int32),
    )


def set_path(world: World, k: int, path: PathPiece) -> None:
    """Put a body on a path of constant acceleration."""
    (x, y), turn, (u, v), spin = path.at(path.start)
    world.paths[k] = (x, y, turn, u, v, spin, *path.acceleration(path.start), path.start)


def body_table(scene: Scene) -> Array:
    """Return what the bodies are: their columns from the inverse mass on."""
    rows = np.zeros((len(scene), tables.COLUMNS))
    for row, body in zip(rows, scene.bodies, strict=True):
        row[tables.INVERSE_MASS] = body.inverse_mass
        row[tables.INVERSE_INERTIA] = body.inverse_inertia
        row[tables.RESTITUTION] = -1.0 if body.restitution is None else body.restitution
        row[tables.FRICTION] = -1.0 if body.friction is None else body.friction
        if isinstance(body.shape, HalfPlane):
            row[tables.NORMAL_X], row[tables.NORMAL_Y] = _turned(body, body.shape.normal)
            row[tables.OFFSET] = body.shape.offset
        elif body.shape is not None:
            core = Core(0, body)
            row[tables.RADIUS], row[tables.ROUNDING] = core.bounding_radius, core.radius
    return rows


def hulls_of(scene: Scene) -> Hulls:
    """Return the outlines of all bodies, and room for two of them at hand."""
    shapes: list[tuple[int, int, int]] = []
    outline: list[tuple[float, ...]] = []
    most = 1
    for body in scene.bodies:
        core = Core(0, body)
        count = (len(core.corners), len(core.sides)) if core.solid else (0, 0)
        shapes.append((len(outline), *count))
        outline += _outline(core, max(count))
        most = max(most, *count)
    return blank_hulls(
        np.array(shapes), np.array(outline).reshape(-1, tables.OUTLINE_COLUMNS), most
    )


def blank_hulls(shapes: NDArray[np.int64], outline: Array, most: int) -> Hulls:
    """Return the tables of outlines with so many corners at most."""
    return Hulls(
        shapes=shapes.astype(np.int32).reshape(-1, tables.SHAPE_COLUMNS),
        outline=outline,
        stands=np.zeros((tables.STANDS, tables.STAND_COLUMNS)),
        forms=np.zeros((tables.STANDS, tables.SHAPE_COLUMNS), dtype=np.int32),
        placed=np.zeros((tables.STANDS, most, tables.PLACED_COLUMNS)),
        axes=np.zeros((2 * most, tables.AXIS_COLUMNS)),
        owners=np.zeros((2 * most, tables.OWNER_COLUMNS), dtype=np.int32),
        gaps=np.zeros((most * most, tables.GAP_COLUMNS)),
        search=np.zeros(tables.SEARCH_COLUMNS),
    )


def _outline(core: Core, count: int) -> list[tuple[float, ...]]:
    """Return the rows of a body's corners and sides; what it has not is 0."""
    none = (0.0, 0.0, 0.0), (0.0, 0.0, 0.0, 0.0, 0.0)
    corners = [(*at, far) for at, far in zip(core.corners, core.reaches, strict=True)] or [none[0]]
    sides = [(*side.normal, side.offset, *side.ends) for side in core.sides] or [none[1]]
    return [(*corners[k], *sides[k]) for k in range(count)]


def _turned(body: Body, normal: tuple[float, float]) -> tuple[float, float]:
    if body.orientation == 0:
        return normal
    c, s = math.cos(body.orientation), math.sin(body.orientation)
    x, y = normal
    return c * x - s * y, s * x + c * y


def kinds_of(scene: Scene) -> NDArray[np.int32]:
    """Return the kind of each body."""
    return np.array([_kind(body) for body in scene.bodies], dtype=np.int32)


def _kind(body: Body) -> int:
    if isinstance(body.shape, HalfPlane):
        return tables.PLANE
    if body.shape is None:
        return tables.MOVING_PARTICLE if body.dynamic else tables.PARTICLE
    if isinstance(body.shape, Disc):
        return tables.DISC if body.dynamic else tables.FIXED_DISC
    return tables.HULL if body.dynamic else tables.FIXED_HULL


def pair_laws(scene: Scene) -> tuple[NDArray[np.int64], Array]:
    """Return the pairs with a restitution or friction of their own, and these."""
    restitutions, frictions = scene.restitution_of_pairs, scene.friction_of_pairs
    pairs = sorted(restitutions.keys() | frictions.keys())
    keys = [i * len(scene) + j for i, j in pairs]
    laws = [(restitutions.get(pair, -1.0), frictions.get(pair, -1.0)) for pair in pairs]
    return np.array(keys, dtype=np.int64), np.array(laws, dtype=np.float64).reshape(-1, 2)


def with_cells(world: World, now: float) -> World:
    """Return a world that is divided into cells by where its bodies are now, s, none in one yet."""
    world.notes[:, tables.ACROSS : tables.BEFORE + 1] = 0
    world.notes[:, tables.ACROSS] = -1
    world.leaving[:] = math.inf
    small = _small(world, np.flatnonzero(world.kinds > tables.PLANE))
    inside = np.isin(np.arange(len(world.kinds)), small)
    shaped = world.kinds >= tables.PLANE
    everywhere = np.flatnonzero(shaped & ~inside).astype(np.int32)
    if not len(small):
        return world._replace(everywhere=everywhere, cells=np.zeros((1, 1), dtype=np.int32))
    world.notes[small, tables.ACROSS] = 0
    world.leaving[small] = tables.NOWHERE
    places = states_at(world, small, now)[:, :2]
    low, high = np.percentile(places, (_SPREAD, 100 - _SPREAD), axis=0)
    extent = (high - low) * 100 / (100 - 2 * _SPREAD)
    diameter = 2 * float(world.bodies[small, tables.RADIUS].max()) * _CLEAR
    least = diameter / (1 - 2 * _SLACK)
    size = max(least, math.sqrt(_CROWD * float(extent[0] * extent[1]) / len(small)))
    size = max(size, float(extent.max()) / len(small))
    across, up = (3 + np.ceil(2 * extent / size)).astype(int).tolist()
    origin = (low + high) / 2 - np.array([across, up]) * size / 2
    world.numbers[tables.CELL], world.numbers[tables.SLACK] = size, _SLACK * size
    world.numbers[[tables.ORIGIN_X, tables.ORIGIN_Y]] = origin
    cells = np.zeros((across, up), dtype=np.int32)
    return world._replace(everywhere=everywhere, cells=cells)


def _small(world: World, bodies: NDArray[np.int64]) -> NDArray[np.int64]:
    """Return the bodies for which cells pay: not the largest few, if these are much larger."""
    if len(bodies) <= _FEW:
        return bodies[:0]
    order = bodies[np.argsort(world.bodies[bodies, tables.RADIUS], kind="stable")]
    radii = world.bodies[order, tables.RADIUS]
    most = len(order) - 1 - math.isqrt(len(order)) // 4
    return np.sort(order[radii <= _LARGER * radii[most]])


def states_at(world: World, bodies: NDArray[np.int64], time: float | Array) -> Array:
    """Return the states (m, 6) of some bodies (m,) on their paths at a time, s; (k, m, 6) at k."""
    x, y, turn, u, v, spin, ax, ay, turning, start = world.paths[bodies].T
    elapsed = np.asarray(time)[..., np.newaxis] - start
    return np.stack(
        (
            *translation.position((x, y), (u, v), (ax, ay), elapsed),
            rotation.orientation(turn, spin, turning, elapsed),
            *translation.velocity((u, v), (ax, ay), elapsed),
            rotation.angular_velocity(spin, turning, elapsed),
        ),
        axis=-1,
    )
