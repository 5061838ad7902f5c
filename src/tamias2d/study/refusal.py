"""Tolerances that nothing meets, refused with what can be met."""

import math

from tamias2d.errors import SimulationError
from tamias2d.study.perturbed import LOST, MOVED

LOOSEST = 0.1  # tolerance that can be asked for
BOUND_LESS = "bound overlap and energy instead, for example by a quality of 0.01"
_SOONER = 0.9
_UP = 1.06  # so that two digits are no less


class ToleranceError(SimulationError):
    """No method meets the tolerance; `reachable` is one that can be met, if one is known.

    `until` is a duration, s, for which the tolerance can be met, if one is known. The message says
    what was found, and then what to do: to take one of these or, without end, `otherwise`.
    """

    code = "tolerance"

    def __init__(
        self,
        found: str,
        reachable: float | None = None,
        *,
        until: float | None = None,
        otherwise: str = "",
        of: str = "tolerance",
        too_short: bool = False,
    ) -> None:
        end = "before" if until is None else f"at {until:g} s"
        remedies = ["Let the run last longer" if too_short else f"End the run {end}"]
        if reachable is not None:
            remedies.append(f"give a {of} of {reachable:.2g} or more")
        super().__init__(f"{found} {', or '.join([*remedies, otherwise])}." if otherwise else found)
        self.reachable = reachable
        self.until = until
        self._found, self._otherwise, self._of = found, otherwise, of
        self._too_short = too_short

    def offering(self, reachable: float | None, until: float | None) -> "ToleranceError":
        """Return the error with other offers."""
        return type(self)(
            self._found,
            reachable,
            until=until,
            otherwise=self._otherwise,
            of=self._of,
            too_short=self._too_short,
        )


class ChaosError(ToleranceError):
    """Small changes grow so large before the end that no way certifies a run."""


def chaotic(tolerance: float, lost_at: float, reached: float) -> ChaosError:
    """Return the error that tells when a change is lost, s, and offers what was reached before."""
    return ChaosError(
        f"tolerance {tolerance:g}: no method meets it: a change of {MOVED:g} of the scale grows to "
        f"{LOST:.0%} of it in {lost_at:.2g} s (R5).",
        rounded_up(reached) if _UP * reached < LOOSEST else None,
        until=sooner(lost_at),
        otherwise="run without a tolerance",
    )


def refusal(
    tolerance: float, reachable: float, *, until: float | None = None, too_short: bool = False
) -> ToleranceError:
    """Return the error that says what can be reached instead, and until when, s, if it is known."""
    found = f"tolerance {tolerance:g}: no method meets it"
    if not math.isfinite(reachable):
        return ToleranceError(
            f"{found}, and none bounds its error (R5).",
            until=until,
            otherwise="run without a tolerance",
        )
    offer = rounded_up(reachable)
    if offer > LOOSEST:
        return ToleranceError(
            f"{found}: the error is up to {offer:.1e}, and at most {LOOSEST:g} can be asked for "
            "(R5).",
            until=until,
            otherwise=BOUND_LESS,
            too_short=too_short,
        )
    return ToleranceError(
        f"{found} (R5).",
        offer,
        until=until,
        otherwise="run without a tolerance",
        too_short=too_short,
    )


def sooner(time: float) -> float:
    """Return a time of two digits, s, somewhat before one from which on nothing is known."""
    return float(f"{_SOONER * time:.1e}")


def rounded_up(value: float) -> float:
    """Return a value of two digits that is no less, and some percent more at most."""
    return float(f"{_UP * value:.1e}")
