"""Many simulators that step together, for loops, learning and control: arrays with a world axis.

Serves: whoever acts on many worlds between steps. Hides: that each world has an engine of its own,
and the threads on which they step. The arrays of all worlds lie one after the other, so that one
look shows all of them.
"""

from collections.abc import Callable, Iterable, Iterator, Mapping
from copy import deepcopy
from threading import Lock
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tamias2d.ensemble.execution import cores
from tamias2d.ensemble.sampling import Design
from tamias2d.ensemble.shared_arrays import SharedArrays, shared_arrays
from tamias2d.ensemble.thread_pool import ThreadPool
from tamias2d.ensemble.world_altering import WorldAltering
from tamias2d.ensemble.world_joints import WorldJoints
from tamias2d.ensemble.world_reports import WorldReports, in_world, warn_of
from tamias2d.ensemble.world_steps import WorldSteps
from tamias2d.ensemble.worlds import Maker, VariedWorlds, refuse_other_bodies, worlds_of
from tamias2d.errors import TamiasError
from tamias2d.scene import Scene
from tamias2d.scene.rules import RuleError, checked_count
from tamias2d.simulator import Simulator
from tamias2d.simulator.exclusive import exclusive
from tamias2d.simulator.settings import checked_steps
from tamias2d.simulator.simulator import Start
from tamias2d.suggestions import suggests

_FEWEST = 8  # worlds for a thread: fewer are not worth handing over


@suggests
class Simulators(WorldAltering, WorldReports):
    """A scene in many worlds, each of which is stepped as by a `Simulator` alone, to the bit.

    The views are those of `Simulator` with an axis of worlds before all others: `position`
    (worlds, n, 2), `orientation` (worlds, n), `velocity`, `angular_velocity`, `force`, `torque`,
    and `gravity` (worlds, 2). What is written counts from the next step on.
    """

    __slots__ = (
        "__weakref__",
        "_jointed",
        "_shared",
        "_starts",
        "_steps",
        "_threads",
    )

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
        self._jointed = WorldJoints(sims, [start.joints for start in self._starts])
        self._engine: Any = shared_arrays(sims)
        self._shared: SharedArrays = self._engine
        self._steps = WorldSteps(sims, self._shared)
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
        steps, faults = checked_steps(count), dict[int, TamiasError]()
        try:
            self._on_threads(lambda part: self._steps.take(steps, part, faults))
        finally:
            warn_of(self._sims)
        if faults:
            world, fault = min(faults.items())
            raise type(fault)(in_world(world, fault)) from fault

    @exclusive
    def reset(self, mask: object | None = None) -> None:
        """Put the worlds of a mask (worlds,) back to their start, or all of them.

        Each goes on from there with the bits that it had: what was set or altered in it since, such
        as motors, masses and shapes, is what it was then. So what another episode varies is set
        after the reset.

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

    def _on_threads(self, act: Callable[[range], None]) -> None:
        """Do something with all worlds, on all threads."""
        parts = list(self._parts())
        if len(parts) == 1:
            act(parts[0])
        else:
            self._threads.run(act, parts)

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
