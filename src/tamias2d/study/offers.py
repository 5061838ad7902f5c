"""Offers of a refusal, which are tried before they are made: what is offered is not refused."""

from collections.abc import Callable

from tamias2d.errors import SceneError, SimulationError
from tamias2d.study.refusal import ToleranceError

_TRIES = 2  # of an offer: each is what the refusal of the one before offers


def holding(
    refused: ToleranceError, duration: float, meet: Callable[[float | None, float], object]
) -> ToleranceError:
    """Return a refusal whose offers hold.

    `meet` does what was asked for at another tolerance, or at the same if it is None, and for a
    duration in s; it raises `ToleranceError` if it cannot.
    """
    reachable = _held(refused.reachable, lambda it: meet(it, duration), lambda it: it.reachable)
    until = _held(refused.until, lambda it: meet(None, it), lambda it: it.until)
    return refused.offering(reachable, until)


def _held(
    offer: float | None,
    tried: Callable[[float], object],
    instead: Callable[[ToleranceError], float | None],
) -> float | None:
    """Return the first offer that holds; None if some do not."""
    for _ in range(_TRIES):
        if offer is None:
            break
        try:
            tried(offer)
        except ToleranceError as again:
            offer = instead(again)
        except (SimulationError, SceneError):
            break
        else:
            return offer
    return None
