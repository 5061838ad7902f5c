"""What a certificate states: of positions, of the balance of energy, or of a fault."""

import math
from dataclasses import replace

from tamias2d.certificate import Certificate, hashes, not_claimed
from tamias2d.motion import ClosedForm, Stepped
from tamias2d.motion.law_resolution import LOOKS
from tamias2d.run import Run
from tamias2d.scene.acting import brief_laws
from tamias2d.study.bound import Bound, NoBoundError
from tamias2d.study.error import MEASURE
from tamias2d.study.invariants import energy_drift, energy_rise, energy_rounding
from tamias2d.study.penetration import Penetration, crowded
from tamias2d.study.scale import Length, length_of

_SOLUTION = "the exact solution of the scene's equations"
_LIMIT = "where ever shorter steps lead"
_STEPPED_MEASURE = MEASURE.replace("its exact place", _LIMIT)
_LEFT_OPEN = (
    "that rigid bodies do so where what is struck touches others: steps answer the blow at all "
    "contacts at once, and restitution follows (A18)"
)
_BRIEF = "what a law does for less than {shortest:.3g} s: it is asked a thousand times over the run"
_UNSEEN = "that no body passes through another: of so many it is not looked for"
_BALANCE = "balance of energy, with what impacts take, relative to the largest kinetic energy"
_KEPT = "the balance of energy"
_RISE = "rise of the energy above what it was before"
_RISING = f"{_RISE}, relative to the largest kinetic one, or to what lifts bodies by their radius"


def with_rule(certificate: Certificate, run: Run) -> Certificate:
    """Return a certificate that tells what was decided by rule, and when (A18)."""
    if run.ruled is None:
        return certificate
    told = f"that nature decides as the {run.ruled}"
    return replace(certificate, does_not_claim=(*certificate.does_not_claim, told))


def of_positions(run: Run, found: Bound, known: Length | None = None) -> Certificate:
    """Return the certificate of a bound; raise `NoBoundError` if it is larger than the motion.

    What that is relative to may be known from runs by shorter steps.
    """
    stepped = isinstance(run.method, Stepped)
    relative_to = known or length_of(run)
    length = relative_to.metres
    if found.value > length:
        raise NoBoundError(f"a bound by {found.kind} would be larger than the motion itself")
    until = f"at all samples up to {run.times[-1]:g} s"
    return Certificate(
        kind=found.kind,
        measure=f"{_STEPPED_MEASURE if stepped else MEASURE}, {_told(run, relative_to)}",
        bound=found.value / length,
        how=found.how,
        claims=(f"how far it is from {_LIMIT if stepped else _SOLUTION}, {until}",),
        does_not_claim=(
            *not_claimed(None),
            *_brief(run),
            *((_LEFT_OPEN,) if stepped else ()),
            *((_UNSEEN,) if stepped and crowded(run) else ()),
        ),
        observed_order=found.order,
        predictability_horizon=None,
        hashes=hashes(run.scene),
        basis=found.basis,
    )


def _told(run: Run, length: Length) -> str:
    """Return what a bound is relative to."""
    others = [body for body in run.scene.bodies if not body.dynamic]
    as_told = any(any(body.velocity) or body.angular_velocity for body in others)
    if length.moves:
        of = f"that the farthest {'dynamic ' if as_told else ''}one goes"
    else:
        but = f" but {'as it is told or ' if as_told else ''}by sinking in"
        of = f"taken where nothing moves{but if isinstance(run.method, Stepped) else ''}"
    return f"relative to the {length.metres:.6g} m {of}"


def _brief(run: Run) -> tuple[str, ...]:
    """Return what is not claimed of laws that may do something for a moment."""
    if isinstance(run.method, ClosedForm) or not brief_laws(run.scene):
        return ()
    return (_BRIEF.format(shortest=run.duration / LOOKS),)


def of_penetration(run: Run, fault: Penetration) -> Certificate:
    """Return the certificate of a run that is wrong, whatever else is known of it."""
    first, second = (run.scene.bodies[k].name for k in fault.bodies)
    what = f"overlap by {fault.depth:.3g} m" if fault.depth else "pass through each other"
    return Certificate(
        kind="none",
        measure=MEASURE,
        bound=None,
        how=f"'{first}' and '{second}' {what} at {fault.time:.6g} s",
        claims=(),
        does_not_claim=(*not_claimed(None), "where single bodies are, since solid ones do not"),
        observed_order=None,
        predictability_horizon=None,
        hashes=hashes(run.scene),
    )


def of_energy(run: Run, reason: str, lost_at: float | None) -> Certificate:
    """Return what is left to say: how well the run keeps the balance of energy."""
    stepped = isinstance(run.method, Stepped)
    strayed = energy_rise(run) if stepped else energy_drift(run)
    if strayed is None or not math.isfinite(strayed):
        bound = None
    else:
        bound = strayed + energy_rounding(run)
    return Certificate(
        kind="none" if bound is None else "invariants",
        measure=_RISING if stepped else _BALANCE,
        bound=bound,
        how=reason,
        claims=() if bound is None else (f"{_RISE if stepped else _KEPT} at all samples",),
        does_not_claim=(
            *not_claimed(lost_at),
            "where single bodies are, since " + reason,
            *((_UNSEEN,) if crowded(run) else ()),
        ),
        observed_order=None,
        predictability_horizon=lost_at,
        hashes=hashes(run.scene),
    )
