"""Runs of a quality: no overlap and no energy from nothing beyond a share, however long they are.

It is what remains to be asked where no run says where single bodies are: in piles, after the
horizon. Both are looked at in the run itself, so that no other run is needed to certify it.
"""

import math
from dataclasses import dataclass, replace

import numpy as np

from tamias2d.balance import balance, kinetic_energy
from tamias2d.certificate import Basis, Certificate, hashes, not_claimed
from tamias2d.contact import steps_because
from tamias2d.errors import InputError
from tamias2d.motion import Stepped
from tamias2d.run import Run
from tamias2d.scene import Scene
from tamias2d.scene.reach import pairs_that_can_meet
from tamias2d.scene.rules import is_number, shown
from tamias2d.solve import solve, with_reason
from tamias2d.state import Array, History
from tamias2d.study.cheapest_steps import ladder
from tamias2d.study.companion import RefusedError
from tamias2d.study.engines.overlap import worst
from tamias2d.study.invariants import energy_error
from tamias2d.study.refined import stepped, work_of
from tamias2d.study.refusal import ToleranceError, rounded_up
from tamias2d.study.stepped_plan import WORK, first_step

_MEASURE = (
    "deepest overlap relative to the radius of the smaller body, and change of the energy that no "
    "impact, friction or joint accounts for, relative to the largest kinetic one or to what lifts "
    "bodies by their radius"
)
_LOOKS = 30  # at a pilot run
_STALE = 16  # times shorter steps must halve what is wrong, or no steps will do
_MARGIN = 1.5  # times what a pilot saw the whole run may show


@dataclass(frozen=True)
class Quality:
    """What is wrong with a run, whatever else is known of it."""

    overlap: float
    """The deepest, relative to the radius of the smaller body."""
    energy: float | None
    """From nothing, or lost for no reason; relative. None where a body is driven or pushed."""

    @property
    def size(self) -> float:
        """The larger of both."""
        return max(self.overlap, self.energy or 0.0)


def quality_of(scene: Scene, history: History) -> Quality:
    """Return the quality of a history, at its samples."""
    energy, _, _ = balance(scene, history)
    kinetic = kinetic_energy(scene, history.velocity, history.angular_velocity)
    return Quality(
        worst(scene, *_states(history)).share_of_size, energy_error(scene, energy, kinetic)
    )


def of_quality(
    scene: Scene, *, duration: float, quality: float, times: Array, progress: bool, work_limit: int
) -> Run:
    """Return the cheapest run of a quality at sample times (k,), s, with its certificate.

    Raises as `simulate` does.
    """
    if steps_because(scene, duration) is None:
        first = solve(
            scene, duration=duration, times=times, progress=progress, work_limit=work_limit
        )
        if not isinstance(first.method, Stepped):
            return _certified(first, quality)
    work, best, held = WORK * work_limit, math.inf, math.inf
    nearest = (math.inf, 0.0, 0)
    reached: dict[float, float] = {}
    looks = np.linspace(0.0, duration, _LOOKS + 1)
    for step, substeps in ladder(scene, duration, 2 * first_step(duration), duration / 2**22):
        work -= work_of(scene, duration, step, substeps)
        reached.setdefault(step, best)
        before = reached.get(step * _STALE, math.inf)
        if work < 0 or (math.isfinite(before) and best > before / 2):
            break
        seen = _seen(scene, duration, looks, step, substeps)
        if seen > quality:
            best = min(best, _MARGIN * seen)
            nearest = min(nearest, (seen, step, substeps))
            continue
        found = max(seen, _seen(scene, duration, times, step, substeps))
        if found <= quality:
            method = Stepped(substeps)
            run = solve(
                scene,
                duration=duration,
                method=method,
                time_step=step,
                times=times,
                progress=progress,
            )
            note = f"{method} with steps of {step:.4g} s: the cheapest of quality {quality:g}"
            return _certified(with_reason(run, note), quality)
        best, held = min(best, found), min(held, found)
    if math.isinf(held) and math.isfinite(nearest[0]):
        held = max(nearest[0], _seen(scene, duration, times, *nearest[1:]))
    raise _refusal(quality, held)


def _seen(scene: Scene, duration: float, times: Array, step: float, substeps: int) -> float:
    """Return what is wrong with a run by steps at times (k,), s: infinite if it is refused."""
    try:
        return quality_of(scene, stepped(scene, duration, times, step, substeps)).size
    except RefusedError:
        return math.inf


def checked_quality(value: object) -> float:
    """Return a quality that a run can be asked for; raise `InputError` otherwise."""
    remedy = "Give a share such as 0.01."
    if not (is_number(value) and 0 < value < 1):
        raise InputError(
            f"quality {shown(value)}: must be a number between 0 and 1, a share of a body's "
            f"radius and of the energy (R5). {remedy}"
        )
    return float(value)


def certify_quality(run: Run) -> Run:
    """Return a run with the certificate of its quality, whatever this is."""
    return _stating(run, quality_of(run.scene, _history(run)))


def _certified(run: Run, quality: float) -> Run:
    """Return a run with its certificate; raise `ToleranceError` if it is not of the quality."""
    found = quality_of(run.scene, _history(run))
    if found.energy is None and not pairs_that_can_meet(run.scene, run.duration):
        raise InputError(
            f"quality {quality:g}: nothing in the scene can touch, and something gives energy: "
            "there is nothing to measure (R5). Ask for a tolerance."
        )
    if found.size > quality:
        raise _refusal(quality, found.size)
    return _stating(run, found)


def _stating(run: Run, found: Quality) -> Run:
    """Return a run with a certificate that states a quality."""
    energy = "that of the energy is not known: something gives some"
    if found.energy is not None:
        energy = f"the energy changes by {found.energy:.1e}"
    certificate = Certificate(
        kind="invariants",
        measure=_MEASURE,
        bound=found.size,
        how=f"overlaps are at most {found.overlap:.1e}, and {energy}",
        claims=(f"overlap and energy at all {len(run.times)} samples",),
        does_not_claim=(*not_claimed(None), "where single bodies are"),
        observed_order=None,
        predictability_horizon=None,
        hashes=hashes(run.scene),
        basis=Basis("quality"),
    )
    return replace(run, certificate=certificate)


def _refusal(quality: float, best: float) -> ToleranceError:
    """Return the error that offers what some steps hold at all samples."""
    offer = rounded_up(best) if best < 1.0 else 1.0
    return ToleranceError(
        f"quality {quality:g}: no steps within the work limit hold it (R5, R12).",
        offer if offer < 1.0 else None,
        otherwise="give a larger work_limit",
        of="quality",
    )


def _history(run: Run) -> History:
    return History(run.position, run.orientation, run.velocity, run.angular_velocity)


def _states(history: History) -> Array:
    """Return (k, n, 6)."""
    turning = (history.orientation[..., None], history.angular_velocity[..., None])
    return np.concatenate((history.position, turning[0], history.velocity, turning[1]), axis=-1)
