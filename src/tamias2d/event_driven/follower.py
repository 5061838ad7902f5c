"""The bodies of one scene, followed from impact to impact (`contact.Follower`)."""

from collections import defaultdict
from collections.abc import Callable, Iterable, Sequence
from time import perf_counter

import numpy as np
from numpy.typing import NDArray

from tamias2d.contact.follower import Memory, Tracks
from tamias2d.contact.rest_time import NONE, Estimate
from tamias2d.contact.touching import PairOf
from tamias2d.event_driven import tables
from tamias2d.event_driven.arrangement import set_path, states_at, with_cells, world_of
from tamias2d.event_driven.follow import follow, follow_worlds
from tamias2d.event_driven.kinds import is_pushed
from tamias2d.event_driven.length import hypot_agrees
from tamias2d.event_driven.tables import World
from tamias2d.kernels import Library
from tamias2d.kernels.groups import addresses
from tamias2d.motion.track import sample
from tamias2d.motion.uniform import Uniform
from tamias2d.path import PathPiece
from tamias2d.scene import Scene
from tamias2d.state import Array, History, State

LIBRARY = Library("located impacts", (follow, follow_worlds))
_NEAR = 1.1  # times the radii: more than what may touch
_TAKE, _LOAD = 0.003, 0.5  # s: of what is at hand, and of what is kept
_LOOK = 0.1  # s, after which it is asked which of the last two it is


def compiled_code() -> Callable[[World], int]:
    """Return `follow`, compiled."""
    entry = LIBRARY.compiled().follow

    def code(world: World) -> int:
        status: int = entry(addresses(world))
        return status

    return code


class EventDriven:
    """The bodies of one scene, as compiled code knows them."""

    def __init__(self, scene: Scene, times: Array | None, *, many: bool) -> None:
        """Take a scene, and the times of samples, s; without these, all paths are kept.

        Of `many` bodies, compiled code is worth while from the start.
        """
        self._scene = scene
        self._keeps_paths = times is None
        self._times = np.zeros(0) if times is None else times
        self._many = many
        self._started = perf_counter()
        self._price = 0.0
        self.code: Callable[[World], int] | None = None
        """What goes on from event to event, once that pays."""
        self._world: World | None = None
        self._tracks: Tracks = ()
        self._until = 0.0
        self._leads = False  # the paths are in the tables, not in the tracks
        self._given: dict[int, tuple[int, PathPiece]] = {}
        self._places: Array | None = None
        self._several: dict[int, dict[PairOf, Estimate]] = {}

    @property
    def now(self) -> float:
        """The time that is reached, s."""
        return float(self.world.numbers[tables.NOW])

    @property
    def looked_at(self) -> int:
        """For how many pairs an impact has been searched."""
        return int(self.world.counts[tables.LOOKED_AT])

    @property
    def world(self) -> World:
        """The tables, once the bodies were taken over."""
        assert self._world is not None
        return self._world

    def pays(self, time: float, until: float) -> bool:
        """Return whether to follow from a time on, s, is faster than not to.

        The bits do not depend on it, nor does anything else.
        """
        if self.code is None and (self._many or self._is_worth(time, until)):
            self.code = compiled_code()
        return self.code is not None

    def _is_worth(self, time: float, until: float) -> bool:
        """Whether compiled code costs less than the rest of the run at the pace so far."""
        spent, at_hand = perf_counter() - self._started, LIBRARY.is_loaded()
        if (spent < _LOOK and not at_hand) or time <= 0 or not hypot_agrees():
            return False
        if not self._price:
            self._price = _TAKE if at_hand else _LOAD
            if not at_hand and not LIBRARY.is_kept():
                self._price = LIBRARY.time_of_compiling()
        return spent / time * (until - time) > self._price

    def take(self, time: float, until: float, tracks: Tracks, *, begun: bool) -> None:
        """Take all bodies over at a time, s, on the last paths of their tracks."""
        paths = [track[-1] for track in tracks]
        if self._world is None:
            self._world = world_of(self._scene, paths, self._times, keeps_paths=self._keeps_paths)
        self._tracks, self._until = tracks, until
        for body, path in enumerate(paths):
            self._tell(body, time, tracks[body])
            self._put(body, path)
        self._leads = True
        self._world = world = with_cells(self._world, time)
        world.numbers[[tables.NOW, tables.END]] = time, until
        world.counts[tables.CHANGED] = len(paths)
        world.changed[:] = np.arange(len(paths))
        world.counts[tables.AT_START] = not begun
        world.counts[tables.EVENTS] = 0

    def go(self, limit: float) -> tuple[int, ...] | None:
        """Go on to a time, s, or until something is not decided."""
        assert self.code is not None
        self._places = None
        self.world.numbers[tables.LIMIT] = limit
        status = self.code(self.world)
        if status == tables.CROWDED:
            self._world = _with_room(self.world)
        if status == tables.INSTANT:
            counts = self.world.counts
            return int(counts[tables.MEETING]), int(counts[tables.OTHER])
        return () if status == tables.SEARCH else None

    def impacts(self) -> Array:
        """Return the impacts (m, 9) since this was last asked; paths that are kept are, too."""
        counts = self.world.counts
        found = self.world.impacts[: counts[tables.IMPACTS]].copy()
        rows = self.world.departures[: counts[tables.DEPARTURES]].tolist()
        counts[tables.IMPACTS] = counts[tables.DEPARTURES] = 0
        for body, *path in rows:
            self._give(int(body), self._uniform(path))
        return found

    def path(self, body: int) -> PathPiece:
        """Return the path of a body now."""
        version, path = self._given[body]
        if version == self.world.notes[body, tables.VERSION]:
            return path
        path = self._uniform(self.world.paths[body].tolist())
        self._given[body] = int(self.world.notes[body, tables.VERSION]), path
        return path

    def _uniform(self, row: Sequence[float]) -> PathPiece:
        x, y, turn, u, v, spin, ax, ay, turning, start = row
        state = State((x, y), turn, (u, v), spin)
        return Uniform(start=start, end=self._until, state=state, acceleration=(ax, ay, turning))

    def set_path(self, body: int, path: PathPiece) -> None:
        """Put a body on another path from now on."""
        self._tell(body, self.now, [self.path(body)])
        self.world.notes[body, tables.VERSION] += 1
        self._put(body, path)
        if self._keeps_paths:
            self._tracks[body].append(path)
        counts = self.world.counts
        if body not in self.world.changed[: counts[tables.CHANGED]]:
            self.world.changed[counts[tables.CHANGED]] = body
            counts[tables.CHANGED] += 1

    def _put(self, body: int, path: PathPiece) -> None:
        set_path(self.world, body, path)
        self._given[body] = int(self.world.notes[body, tables.VERSION]), path

    def _give(self, body: int, path: PathPiece) -> None:
        self._tracks[body].append(path)
        self._given[body] = int(self.world.notes[body, tables.VERSION]), path

    def near(self, body: int) -> list[int]:
        """Return all bodies, in order, that may touch a body now."""
        world = self.world
        if self._places is None:
            self._places = states_at(world, np.arange(len(world.kinds)), self.now)[:, :2]
        solid = world.kinds >= tables.PLANE
        pushed = world.kinds >= tables.DISC
        way = np.abs(self._places - self._places[body]).max(axis=1)
        reach = _NEAR * (world.bodies[:, tables.RADIUS] + world.bodies[body, tables.RADIUS])
        close = (world.kinds == tables.PLANE) | (way <= reach)
        close &= solid & (pushed | pushed[body]) & bool(solid[body])
        close[body] = False
        found: list[int] = np.flatnonzero(close).tolist()
        return found

    def recall(self) -> Memory:
        """Return what is known of all bodies."""
        bounces = self.world.bounces
        known = {
            body: self._bounces_of(body, bounces[body].tolist())
            for body in np.flatnonzero(bounces[:, tables.WITH]).tolist()
            if is_pushed(body, self.world)
        }
        found = {
            pair: estimate
            for of_body in known.values()
            for pair, estimate in of_body.items()
            if all(pair in known.get(k, {}) for k in pair if is_pushed(k, self.world))
        }
        stalled = self.world.notes[:, tables.STALLED].tolist()
        return Memory({}, found, dict(enumerate(stalled)))

    def _bounces_of(self, body: int, row: Sequence[float]) -> dict[PairOf, Estimate]:
        """Return the bounces of a body since it last met another one."""
        other, *estimate = row
        if other == tables.SEVERAL:
            return self._several[body]
        pair = min(body, int(other) - 1), max(body, int(other) - 1)
        return {pair: Estimate(*estimate)}

    def remember(self, bodies: Iterable[int], memory: Memory) -> None:
        """Replace what is known of some bodies."""
        known: dict[int, dict[PairOf, Estimate]] = defaultdict(dict)
        for pair, estimate in memory.bounces.items():
            for body in pair:
                known[body][pair] = estimate
        for body in bodies:
            note = self.world.notes[body]
            note[tables.STALLED] = memory.stalled.get(body, 0)
            note[tables.HELD_BY] = memory.supports.get(body, -1) + 1
            self._several[body] = known[body]
            pair, estimate = next(iter(known[body].items()), ((-1, -1), NONE))
            other = pair[1] if pair[0] == body else pair[0]
            self.world.bounces[body] = (other + 1, *estimate)
            if len(known[body]) > 1 and is_pushed(body, self.world):  # many may bounce on a floor
                self.world.bounces[body, tables.WITH] = tables.SEVERAL

    def give_back(self) -> None:
        """Add the paths that all bodies have now to their tracks."""
        for body, track in enumerate(self._tracks):
            path = self.path(body)
            if track[-1] is not path:
                track.append(path)
        self._leads = False

    def history(self, tracks: Tracks, times: Array) -> History:
        """Return the states at the first so many of the times of samples, s."""
        if self._world is None or self._keeps_paths:
            return sample(tracks, times)
        known = np.array(
            [self._leads or self._is_on(k, track[-1]) for k, track in enumerate(tracks)]
        )
        for body in np.flatnonzero(~known).tolist():
            self._tell(body, np.inf, tracks[body])
        self._tell_last(np.flatnonzero(known), len(times))
        rows = self._world.samples.reshape(-1, len(tracks), 6)[: len(times)]
        position, velocity = rows[..., :2].copy(), rows[..., 3:5].copy()
        return History(position, rows[..., 2].copy(), velocity, rows[..., 5].copy())

    def _is_on(self, body: int, path: PathPiece) -> bool:
        """Whether the tables have the path of a body: one on which contacts turn they have not."""
        return self.path(body) is path and isinstance(path, Uniform)

    def _tell_last(self, bodies: NDArray[np.int64], count: int) -> None:
        """Write down the states of bodies on their paths of now at so many samples, all at once."""
        told = self.world.notes[bodies, tables.TOLD]
        samples = self.world.samples.reshape(-1, len(self.world.kinds), 6)
        for first in np.unique(told[told < count]).tolist():
            some = bodies[told == first]
            samples[first:count, some] = states_at(self.world, some, self._times[first:count])

    def _tell(self, body: int, until: float, paths: Sequence[PathPiece]) -> None:
        """Write down the states of a body at all samples before a time, s, from its last paths."""
        told = int(self.world.notes[body, tables.TOLD])
        last = int(np.searchsorted(self._times, until, side="left"))
        if last <= told:
            return
        found = sample([paths], self._times[told:last])
        rows = self.world.samples.reshape(-1, len(self._tracks), 6)[told:last, body]
        rows[:, :2], rows[:, 2] = found.position[:, 0], found.orientation[:, 0]
        rows[:, 3:5], rows[:, 5] = found.velocity[:, 0], found.angular_velocity[:, 0]
        self.world.notes[body, tables.TOLD] = last


def _with_room(world: World) -> World:
    """Return a world whose queue is twice as long."""
    room = len(world.queue)
    events = np.zeros((room, tables.EVENT_COLUMNS), dtype=np.int32)
    return world._replace(
        queue=np.append(world.queue, np.zeros(room)), events=np.append(world.events, events, axis=0)
    )
