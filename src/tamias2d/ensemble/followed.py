"""Ensembles of convex bodies and half-planes, whose worlds compiled code follows to their impacts.

Serves: the solving of blocks. Hides: which ensembles these are, and how what varies becomes the
tables of compiled code, for all worlds at once.
"""

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from itertools import combinations
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tamias2d.contact import MANY, has_thin_pair, is_known
from tamias2d.contact.core import Core
from tamias2d.ensemble.request import STATE, Request
from tamias2d.ensemble.worlds import VariedWorlds, Worlds, inertia_of, value_of
from tamias2d.event_driven import LIBRARY, tables
from tamias2d.event_driven.arrangement import blank_few, blank_world, hulls_of, kinds_of
from tamias2d.event_driven.length import hypot_agrees
from tamias2d.generated import definitions, rotation, translation
from tamias2d.kernels.groups import addresses
from tamias2d.motion import ClosedForm
from tamias2d.record.dataset import BODIES, DIMENSIONS
from tamias2d.scene import Body, Disc, HalfPlane, Scene
from tamias2d.state import Array
from tamias2d.work_limit import WORK_LIMIT

_MOST_IMPACTS = 10_000
_VARIED = (
    *("position", "velocity", "orientation", "angular_velocity", "mass", "inertia", "force"),
    *("torque", "radius", "restitution", "friction"),
)
_OF_PAIRS = ("restitution_of_pairs", "friction_of_pairs")
_LARGEST = 1e100  # what is beyond it is left to the ordinary way, which tells why it cannot be
_WORTH = 100  # worlds: to compile for fewer takes longer than it saves
_LEAST_PILOT, _MOST_PILOT, _PILOT_SHARE = 64, 1024, 64  # worlds; one of so many


@dataclass(frozen=True)
class Followed:
    """What compiled code has found of a block of worlds."""

    arrays: dict[str, Array]
    """What is kept, by name, with the worlds along the first axis."""
    done: NDArray[np.bool_]
    """(k,): which worlds it could follow; the others are to be solved in the ordinary way."""


def share_followed(worlds: Worlds, request: Request) -> float:
    """Return the share of the first worlds that compiled code can follow."""
    pilot = min(max(_LEAST_PILOT, len(worlds) // _PILOT_SHARE), _MOST_PILOT, len(worlds))
    found = followed(worlds, request, 0, pilot)
    return 0.0 if found is None else float(found.done.mean())


def followed(worlds: Worlds, request: Request, first: int, last: int) -> Followed | None:
    """Follow the worlds from `first` to before `last`; None if the ensemble is not of this kind.

    Each world that is done has the bits that `simulate` gives for it.
    """
    if not (isinstance(worlds, VariedWorlds) and len(worlds) >= _WORTH):
        return None
    if not (_asked(request) and _fits(worlds)):
        return None
    rows = worlds.part(first, last)
    scene, count = worlds.base, last - first
    times, size = np.array(request.times), len(scene)
    many = tables.Worlds(
        world=_world(scene, times, request.duration),
        few=blank_few(),
        bodies=_tables(rows, count),
        laws=_laws(rows, count),
        samples=np.zeros((count, len(times) * size, 6)),
        status=np.zeros(count, dtype=np.int32),
    )
    with np.errstate(all="ignore"):
        good = (np.abs(many.bodies) < _LARGEST).all(axis=(1, 2))
        good &= (many.bodies[:, _pushed(scene), tables.INVERSE_MASS] > 0.0).all(axis=1)
    LIBRARY.compiled().follow_worlds(addresses(many))
    samples = many.samples
    states = samples.reshape(count, len(times), size, 6)
    good &= (many.status == 1) & (np.abs(samples) < _LARGEST).all(axis=(1, 2))
    return Followed(_kept(states, request), good)


def _world(scene: Scene, times: Array, duration: float) -> tables.World:
    """Return the tables in which one world after the other is followed."""
    pairs = [i * len(scene) + j for i, j in combinations(range(len(scene)), 2)]
    kinds, keys = kinds_of(scene), np.array(pairs, dtype=np.int64)
    world = blank_world(kinds, keys, times, hulls_of(scene), impacts=_MOST_IMPACTS)
    world.numbers[[tables.LIMIT, tables.END]] = duration
    world.counts[tables.SETTLES] = 1
    return world


def _asked(request: Request) -> bool:
    """Whether the request is one for states on exact paths."""
    return (
        (request.method is None or isinstance(request.method, ClosedForm))
        and request.tolerance is None
        and not request.quantities
        and set(request.keep) <= set(STATE)
        and request.work_limit >= WORK_LIMIT
    )


def _fits(worlds: VariedWorlds) -> bool:
    """Whether all bodies and all that varies are such as compiled code knows."""
    scene = worlds.base
    alone = not (scene.springs or scene.fields or scene.joints or scene.attraction is not None)
    if not alone or len(_pushed(scene)) > MANY or not all(map(_known, scene.bodies)):
        return False
    varied = all(
        place.keys[0] in ("gravity", *_OF_PAIRS) or _of_body(scene, place.keys)
        for place in worlds.values
    )
    return varied and hypot_agrees() and not has_thin_pair(scene)


def _known(body: Body) -> bool:
    slowed = body.linear_drag or body.quadratic_drag or body.angular_drag
    twisted = body.shape is None and bool(body.angular_velocity or body.torque)
    return is_known(body) and body.constant and not (slowed or twisted)


def _of_body(scene: Scene, keys: tuple[Any, ...]) -> bool:
    """Whether what varies is of a body, and such as compiled code knows."""
    body = scene.bodies[scene.index(keys[1])] if keys[0] == "bodies" else None
    if body is None or keys[2] not in _VARIED or isinstance(body.shape, HalfPlane):
        return body is not None and keys[2] in ("restitution", "friction")
    if keys[2] == "radius":
        return isinstance(body.shape, Disc)
    turns = body.inverse_inertia > 0.0 or not body.dynamic
    return turns or keys[2] not in ("angular_velocity", "torque", "inertia")


def _pushed(scene: Scene) -> list[int]:
    return [k for k, body in enumerate(scene.bodies) if body.dynamic]


def _tables(worlds: VariedWorlds, count: int) -> Array:
    """Return the columns (w, n, 18) of all bodies."""
    found = np.zeros((count, len(worlds.base), tables.COLUMNS))
    for k in range(len(worlds.base)):
        _fill(worlds, k, found[:, k])
    return found


def _fill(worlds: VariedWorlds, k: int, found: Array) -> None:
    """Fill in the columns (w, 18) of a body."""
    body = worlds.base.bodies[k]

    def value(key: str, *component: int) -> Any:
        base = getattr(body, key)
        return value_of(
            worlds,
            ("bodies", body.name, key, *component),
            base[component[0]] if component else base,
        )

    found[:, tables.X], found[:, tables.Y] = value("position", 0), value("position", 1)
    found[:, tables.TURN] = value("orientation")
    if isinstance(body.shape, HalfPlane):
        found[:, tables.NORMAL_X], found[:, tables.NORMAL_Y] = body.shape.normal
        found[:, tables.OFFSET] = body.shape.offset
    elif isinstance(body.shape, Disc):
        found[:, tables.RADIUS] = found[:, tables.ROUNDING] = _radius(worlds, body)
    elif body.shape is not None:
        core = Core(0, body)
        found[:, tables.RADIUS], found[:, tables.ROUNDING] = core.bounding_radius, core.radius
    if body.dynamic:
        for name, column in _motion(worlds, body, value):
            found[:, name] = column


def _radius(worlds: VariedWorlds, body: Body) -> Any:
    assert isinstance(body.shape, Disc)
    return value_of(worlds, ("bodies", body.name, "radius"), body.shape.radius)


def _inertia(worlds: VariedWorlds, body: Body) -> Any:
    """Return inertias, kg m^2; that of a disc follows from its radius, too."""
    stated = value_of(worlds, ("bodies", body.name, "inertia"), body.inertia)
    if not isinstance(body.shape, Disc) or body.inertia_stated or stated is not body.inertia:
        return inertia_of(worlds, body)
    mass = value_of(worlds, ("bodies", body.name, "mass"), body.mass)
    return definitions.inertia_disc(mass, _radius(worlds, body))


def _motion(worlds: VariedWorlds, body: Body, value: Any) -> Iterator[tuple[int, Any]]:
    """Yield the columns of how a body moves, and what moves it."""
    yield tables.VX, value("velocity", 0)
    yield tables.VY, value("velocity", 1)
    yield tables.SPIN, value("angular_velocity")
    mass, inertia = value("mass"), _inertia(worlds, body)
    gravity = tuple(value_of(worlds, ("gravity", c), worlds.base.gravity[c]) for c in (0, 1))
    force = (0.0 + value("force", 0), 0.0 + value("force", 1))
    yield from zip(
        (tables.AX, tables.AY), translation.acceleration(gravity, force, mass), strict=True
    )
    yield tables.TURNING, rotation.angular_acceleration(0.0 + value("torque"), inertia)
    yield tables.INVERSE_MASS, 1 / mass
    yield tables.INVERSE_INERTIA, 1 / inertia


def _laws(worlds: VariedWorlds, count: int) -> Array:
    """Return (w, p, 2): restitution, -1 where nothing states it, and friction, of all pairs."""
    scene = worlds.base
    pairs = list(combinations(range(len(scene)), 2))
    found = np.zeros((count, len(pairs), 2))
    for place, (i, j) in enumerate(pairs):
        restitution = _of_pair(
            worlds, (i, j), "restitution", scene.restitution_of_pairs, definitions.pair_restitution
        )
        friction = _of_pair(
            worlds, (i, j), "friction", scene.friction_of_pairs, definitions.pair_friction
        )
        found[:, place, 0] = -1.0 if restitution is None else restitution
        found[:, place, 1] = 0.0 if friction is None else friction
    return found


def _of_pair(
    worlds: VariedWorlds,
    pair: tuple[int, int],
    key: str,
    of_pairs: Mapping[tuple[int, int], float],
    combined: Callable[[Any, Any], Any],
) -> Any:
    """Return what two bodies state of their contact: for the pair, or each for itself."""
    first, second = (worlds.base.bodies[k] for k in pair)
    of_pair = of_pairs.get(pair)
    for names in ((first.name, second.name), (second.name, first.name)):
        of_pair = value_of(worlds, (f"{key}_of_pairs", names), of_pair)
    if of_pair is not None:
        return of_pair
    own = [
        value_of(worlds, ("bodies", body.name, key), getattr(body, key)) for body in (first, second)
    ]
    stated = [value for value in own if value is not None]
    return combined(stated[0], stated[-1]) if stated else None


def _kept(states: Array, request: Request) -> dict[str, Array]:
    parts = {
        "position": states[..., :2],
        "orientation": states[..., 2],
        "velocity": states[..., 3:5],
        "angular_velocity": states[..., 5],
    }
    bodies = list(request.bodies)
    return {
        name: parts[name][:, :, bodies] if BODIES in DIMENSIONS[name] else parts[name]
        for name in request.keep
    }
