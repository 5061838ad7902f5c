"""Tolerances that nothing meets, refused with what can be met."""

import math

from tamias2d.errors import SimulationError

LOOSEST = 0.1  # tolerance that can be asked for
_UP = 1.06  # so that two digits are no less


class ToleranceError(SimulationError):
    """No method meets the tolerance; `reachable` is an error that can be met, if one is known.

    Where contacts are stepped, `until` is a duration, s, for which the tolerance can be met, if one
    is known.
    """

    code = "tolerance"

    def __init__(
        self, message: str, reachable: float | None, *, until: float | None = None
    ) -> None:
        super().__init__(message)
        self.reachable = reachable
        self.until = until


def refusal(tolerance: float, reachable: float) -> ToleranceError:
    """Return the error that says what can be reached instead."""
    if not math.isfinite(reachable):
        return ToleranceError(
            f"tolerance {tolerance:g}: no method meets it, and none bounds its error (R5). End the "
            "run before, or run without a tolerance.",
            None,
        )
    if rounded_up(reachable) > LOOSEST:
        return ToleranceError(
            f"tolerance {tolerance:g}: no method meets it: the error can be bounded by "
            f"{rounded_up(reachable):.1e} only, and at most {LOOSEST:g} can be asked for (R5). End "
            "the run before, or bound overlap and energy instead, such as by a quality of 0.01.",
            None,
        )
    return ToleranceError(
        f"tolerance {tolerance:g}: no method meets it: the error can be bounded by "
        f"{rounded_up(reachable):.1e} (R5). Give that or more, or end the run before.",
        reachable,
    )


def rounded_up(value: float) -> float:
    """Return a value of two digits that is no less, and some percent more at most."""
    return float(f"{_UP * value:.1e}")
