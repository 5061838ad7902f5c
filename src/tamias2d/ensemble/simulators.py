"""Many simulators that step together, for loops, learning and control: arrays with a world axis.

Serves: whoever acts on many worlds between steps. Hides: that each world has an engine of its own,
and the threads on which they step. The arrays of all worlds lie one after the other, so that one
look shows all of them.
"""

from collections.abc import Callable, Iterable, Iterator, Mapping
from copy import deepcopy
from dataclasses import dataclass
from threading import Lock
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tamias2d.engine.arrays.memory import aligned_zeros
from tamias2d.engine.interruption import end_if_asked
from tamias2d.engine.tables import GRAVITY_X, GRAVITY_Y
from tamias2d.ensemble.controls import Controls
from tamias2d.ensemble.execution import cores
from tamias2d.ensemble.sampling import Design
from tamias2d.ensemble.thread_pool import ThreadPool
from tamias2d.ensemble.world_reports import WorldReports, in_world, warn_of
from tamias2d.ensemble.worlds import Maker, VariedWorlds, refuse_other_bodies, worlds_of
from tamias2d.errors import InputError, SimulationError, TamiasError
from tamias2d.scene import Scene
from tamias2d.scene.rules import RuleError
from tamias2d.simulator import Simulator
from tamias2d.simulator.exclusive import exclusive
from tamias2d.simulator.settings import checked_count, checked_steps
from tamias2d.simulator.simulator import Start
from tamias2d.state import Array, IntArray
from tamias2d.suggestions import suggests

_FEWEST = 8  # worlds for a thread: fewer are not worth handing over


@dataclass(frozen=True)
class _Shared:
    """What all engines work on: a row for each world, then for each body."""

    pose: Array
    velocity: Array
    load: Array
    gravity: Array
    kind: NDArray[np.int8]
    inverse_mass: Array
    generation: IntArray
    sims: tuple[Simulator, ...]

    @property
    def asleep(self) -> NDArray[np.bool_]:
        return np.stack([sim.asleep for sim in self.sims])


@suggests
class Simulators(Controls, WorldReports):
    """A scene in many worlds, each of which is stepped as by a `Simulator` alone, to the bit.

    The views are those of `Simulator` with an axis of worlds before all others: `position`
    (worlds, n, 2), `orientation` (worlds, n), `velocity`, `angular_velocity`, `force`, `torque`,
    and `gravity` (worlds, 2). What is written counts from the next step on.
    """

    __slots__ = ("__weakref__", "_joint_names", "_starts", "_threads")

    def __init__(
        self,
        scene: Scene | Maker,
        *,
        worlds: int | None = None,
        vary: Mapping[str, Any] | None = None,
        seed: int | None = None,
        design: Design | None = None,
        time_step: float = 1 / 60,
        substeps: int = 4,
        sleeping: bool = False,
        threads: int | None = None,
        compiled: bool = True,
    ) -> None:
        """Start so many `worlds` where the scene does, or as `vary` and `seed` say for `ensemble`.

        `time_step` in s, `substeps`, `sleeping` and `compiled` are those of `Simulator`. Worlds
        are spread over `threads`, as many as there are cores unless stated.

        Raises:
            InputError: an argument breaks a rule, or a world has other bodies than the first.
            SceneError: a world's scene cannot be stepped.
        """
        described = _described(scene, worlds, vary, seed, design)
        count = cores() if threads is None else checked_count(threads, "threads", 1)
        settings: dict[str, Any] = {
            "time_step": time_step,
            "substeps": substeps,
            "sleeping": sleeping,
            "compiled": compiled,
        }
        self._begin(tuple(_simulators(described, settings)), count)
        warn_of(self._sims)

    def _begin(
        self, sims: tuple[Simulator, ...], threads: int, starts: tuple[Start, ...] = ()
    ) -> None:
        """Step simulators on so many threads, which start now unless it is said how they did."""
        for sim in sims:
            sim._warned.keep_back()
        self._sims = sims
        self._starts = starts or tuple(sim._start() for sim in sims)
        self._joint_names = tuple(
            dict.fromkeys(joint.name for start in self._starts for joint in start.joints)
        )
        self._engine: Any = _shared(sims)
        self._threads = ThreadPool(threads)
        self._lock = Lock()
        self._look()

    def __len__(self) -> int:
        """How many worlds there are."""
        return len(self._sims)

    @exclusive
    def step(self, count: int = 1) -> None:
        """Take so many steps in all worlds; after Ctrl-C some have taken more than others.

        Raises:
            InputError: a value that was set in a world is not finite; its state is as it was
                before that step, and all others have taken theirs.
            SimulationError: a force that varies has no finite value in a world.

        Warns:
            StepWarning: as `Simulator` does, for each world.
        """
        steps = checked_steps(count)

        def advance(sim: Simulator) -> None:
            sim._seen = True  # its arrays are shared
            sim.step(steps)

        try:
            self._each(advance)
        finally:
            warn_of(self._sims)

    @exclusive
    def reset(self, mask: object | None = None) -> None:
        """Put the worlds of a mask (worlds,) back to their start, or all of them.

        Each goes on from there with the bits that it had.

        Raises:
            InputError: the mask is not one truth value for each world.
        """
        for world in np.flatnonzero(self._checked(mask)).tolist():
            self._sims[world]._rewind(self._starts[world])

    @exclusive
    def world(self, world: int) -> Simulator:
        """Return one world as a `Simulator` of its own, which goes on with the same bits.

        Raises:
            InputError: there is no such world.
        """
        number = checked_count(world, "world", 0)
        if number >= len(self):
            raise RuleError(
                f"world {number}: there are {len(self)} (R15). Give one from 0 to {len(self) - 1}.",
                "world",
            )
        one = deepcopy(self._sims[number])
        warn_of(self._sims)
        return one

    @exclusive
    def __reduce__(self) -> tuple[Any, ...]:
        return _restored, (
            [sim.__reduce__() for sim in self._sims],
            self._threads.size,
            self._starts,
        )

    def index(self, name: str) -> int:
        """Return the index of a body by its name; raise `InputError` if there is none."""
        return self._sims[0].index(name)

    def __repr__(self) -> str:
        return f"<Simulators of {len(self)} worlds of {self._engine.pose.shape[1]} bodies>"

    def _checked(self, mask: object | None) -> NDArray[np.bool_]:
        given = np.asarray(np.ones(len(self), dtype=bool) if mask is None else mask)
        if given.dtype != np.bool_ or given.shape != (len(self),):
            raise RuleError(
                f"mask: found {given.dtype} of shape {given.shape}: must be one truth value for "
                f"each of {len(self)} worlds (R15). Give an array such as `sims.time > 10`.",
                "mask",
            )
        return given

    def _each(self, act: Callable[[Simulator], None]) -> None:
        """Do something in all worlds, on all threads; raise the first fault once all are done."""
        faults: dict[int, TamiasError] = {}

        def go(part: range) -> None:
            for world in part:
                end_if_asked()
                try:
                    act(self._sims[world])
                except (InputError, SimulationError) as fault:
                    faults[world] = fault

        parts = list(self._parts())
        if len(parts) == 1:
            go(parts[0])
        else:
            self._threads.run(go, parts)
        if faults:
            world, fault = min(faults.items())
            raise type(fault)(in_world(world, fault)) from fault

    def _parts(self) -> Iterator[range]:
        size = max(-(-len(self) // self._threads.size), _FEWEST)
        for first in range(0, len(self), size):
            yield range(first, min(first + size, len(self)))


def _described(
    scene: Scene | Maker,
    worlds: int | None,
    vary: Mapping[str, Any] | None,
    seed: int | None,
    design: Design | None,
) -> Any:
    if isinstance(scene, Scene) and vary is None:
        if seed is not None or design is not None:
            raise RuleError(
                "seed: found one, but nothing varies (R15). Say by `vary` what does, or leave it "
                "out.",
                "seed",
            )
        return VariedWorlds(scene, {}, checked_count(worlds, "worlds", 1))
    return worlds_of(scene, vary, worlds, seed, design)


def _simulators(described: Any, settings: Mapping[str, Any]) -> Iterator[Simulator]:
    names: tuple[str, ...] | None = None
    for world in range(len(described)):
        scene = described.scene(world)
        names = names or tuple(body.name for body in scene.bodies)
        refuse_other_bodies(scene, world, names)
        yield Simulator(scene, **settings)


def _restored(
    kept: Iterable[tuple[Any, ...]], threads: int, starts: tuple[Start, ...]
) -> Simulators:
    """Return worlds that go on from what each of their simulators was reduced to."""
    sims = Simulators.__new__(Simulators)
    sims._begin(tuple(make(*content) for make, content in kept), threads, starts)
    return sims


def _shared(sims: tuple[Simulator, ...]) -> _Shared:
    """Let all engines work on arrays that lie one after the other."""
    engines = [sim._engine for sim in sims]
    size, world = engines[0].size, engines[0].world
    pose, velocity, load, settings = (
        aligned_zeros((len(sims), *array.shape))
        for array in (
            world.state.pose,
            world.state.velocity,
            world.state.load,
            world.control.settings,
        )
    )
    for k, (sim, engine) in enumerate(zip(sims, engines, strict=True)):
        state = engine.world.state
        pose[k], velocity[k], load[k] = state.pose, state.velocity, state.load
        settings[k] = engine.world.control.settings
        engine.replace(
            state__pose=pose[k],
            state__velocity=velocity[k],
            state__load=load[k],
            control__settings=settings[k],
        )
        sim._look()
    return _Shared(
        pose=pose[:, :size],
        velocity=velocity[:, :size],
        load=load[:, :size],
        gravity=settings[:, GRAVITY_X : GRAVITY_Y + 1],
        kind=np.stack([engine.kind for engine in engines]),
        inverse_mass=np.stack([engine.inverse_mass for engine in engines]),
        generation=np.stack([engine.generation for engine in engines]),
        sims=sims,
    )
