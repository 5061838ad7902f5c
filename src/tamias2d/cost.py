"""The cost of a run, in numbers that are the same on every machine."""

from dataclasses import dataclass


@dataclass(frozen=True, kw_only=True)
class Cost:
    """The work of one run; all of it is 0 for the closed form, but for the impacts."""

    steps: int
    """Steps of a scheme that were taken, those between two impacts within a step among them."""
    rejected: int
    """Steps of an adaptive scheme that were taken again, shorter."""
    force_evaluations: int
    """How often the accelerations were computed, of however many bodies at once."""
    impacts: int
    """Meetings, one for each pair and instant."""
    contacts: int = 0
    """Contact points with an impulse, summed over all steps of a stepped run."""
