"""A block of worlds solved one after the other, each with the bits that it has alone.

Serves: whoever runs ensembles, in this process or elsewhere. Hides: how a world is solved, and
what becomes of one that is refused.
"""

from dataclasses import dataclass
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from tamias2d.balance import balance
from tamias2d.ensemble.followed import followed
from tamias2d.ensemble.request import Request, kept_of
from tamias2d.ensemble.stepped import stepped
from tamias2d.ensemble.worlds import Worlds, refuse_other_bodies
from tamias2d.errors import InputError, SceneError, SimulationError, TamiasError
from tamias2d.motion import Stepped
from tamias2d.record.dataset import BODIES, DIMENSIONS
from tamias2d.scene import Scene
from tamias2d.simulate import simulate
from tamias2d.simulator import states_at
from tamias2d.solve import planned
from tamias2d.solve.plan import Plan
from tamias2d.state import Array

UNKNOWN, LOCATED, STEPPED, REFUSED = range(4)
OUTCOMES = ("unknown", "located", "stepped", "refused")
"""What became of a world: not yet known, impacts located, contacts stepped, or a refusal."""

_REFUSALS = (SimulationError, SceneError, InputError)

Arrays: TypeAlias = dict[str, Array]


@dataclass(frozen=True)
class Block:
    """What was kept of the worlds from `first` on."""

    first: int
    arrays: Arrays
    """By name, with the worlds (k, ...) along the first axis; NaN where a world was refused."""
    outcome: NDArray[np.int8]
    """(k,), one of `OUTCOMES`"""
    refusal: TamiasError | None
    """The first one of the block."""

    @property
    def last(self) -> int:
        """The number after that of the last world."""
        return self.first + len(self.outcome)


def solved_block(worlds: Worlds, request: Request, first: int, last: int) -> Block:
    """Return what is kept of the worlds from `first` to before `last`.

    Raises:
        InputError: a world has other bodies than it should.
    """
    count = last - first
    arrays = {name: np.full((count, *request.shape(name)), np.nan) for name in request.kept}
    outcome = np.full(count, REFUSED, dtype=np.int8)
    refusal: TamiasError | None = None
    for quick, kind in ((followed, LOCATED), (stepped, STEPPED)):
        if (found := quick(worlds, request, first, last)) is not None:
            outcome[found.done] = kind
            whole = slice(None) if found.done.all() else found.done
            for name, values in found.arrays.items():
                arrays[name][whole] = values[whole]
    for row in np.flatnonzero(outcome == REFUSED).tolist():
        world = first + row
        scene = worlds.scene(world)
        refuse_other_bodies(scene, world, request.names)
        try:
            solved, outcome[row] = _solved(scene, request)
        except _REFUSALS as fault:
            refused = next(kind for kind in _REFUSALS if isinstance(fault, kind))
            refusal = refusal or refused(f"world {world} of the ensemble: {fault}")
            continue
        except Exception as fault:  # of a function of the user's
            fault.add_note(f"It was raised in world {world} of the ensemble.")
            raise
        for name, values in solved.items():
            arrays[name][row] = values
    return Block(first, arrays, outcome, refusal)


def _solved(scene: Scene, request: Request) -> tuple[Arrays, int]:
    """Return what is kept of a world, and its outcome."""
    if not request.quantities and request.tolerance is None:
        plan = planned(
            scene,
            request.duration,
            request.method,
            request.time_step,
            request.times,
            request.work_limit,
        )
        if isinstance(plan.method, Stepped):
            return _stepped(plan, plan.method, request), STEPPED
    run = simulate(scene, **request.arguments())
    return kept_of(run, request), STEPPED if isinstance(run.method, Stepped) else LOCATED


def _stepped(plan: Plan, method: Stepped, request: Request) -> Arrays:
    """Return what is kept of a world that is stepped, without its contacts."""
    history = states_at(
        plan.scene,
        time_step=plan.time_step or plan.duration,
        substeps=method.substeps,
        times=plan.times,
        duration=plan.duration,
    )
    known = history._asdict()
    if not known.keys() >= set(request.keep):
        energy, momentum, angular_momentum = balance(plan.scene, history)
        known |= {"energy": energy, "momentum": momentum, "angular_momentum": angular_momentum}
    bodies = list(request.bodies)
    return {
        name: known[name][:, bodies] if BODIES in DIMENSIONS[name] else known[name]
        for name in request.keep
    }
