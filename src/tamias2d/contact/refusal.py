"""The errors of located impacts, each case under a name of its own.

A refusal says when, which bodies and why; its `run` is the history up to that time.
"""

from typing import ClassVar

from tamias2d.errors import SceneError, SimulationError


class Refusal(SimulationError):  # noqa: N818
    """The base of all refusals of located impacts."""

    code: ClassVar[str] = "refused"

    def __init__(self, message: str, *, time: float) -> None:
        super().__init__(message)
        self.time = time


class LastingContactError(Refusal):
    """A contact that lasts while its normal turns, tips or moves: not within the models."""

    code = "lasting-contact"


class FrictionError(Refusal):
    """Coulomb's law of friction allows no motion of rigid bodies, or several."""

    code = "friction"


class JointedContactError(Refusal):
    """What contacts that last and joints that limit, drive or break do together is not found."""

    code = "jointed-contact"


class UndecidedContactError(Refusal):
    """Float64 cannot tell whether bodies part."""

    code = "undecided-contact"


class UnlocatedContactError(Refusal):
    """Bodies meet under a method that knows no contacts."""

    code = "unlocated-contact"


class RangeError(Refusal):
    """A state, or what is summed up from states, is beyond the numbers of float64."""

    code = "out-of-range"


class StepwiseError(SceneError):
    """A body of the scene is one whose impacts cannot be located."""

    code = "stepwise"


class OverlapError(SceneError):
    """Bodies overlap at the start of a run: by a `depth`, m, and `share` of the smaller's size."""

    code = "overlap"

    def __init__(self, bodies: str, depth: float, *, share: float) -> None:
        super().__init__(
            f"{bodies}: they overlap by {depth:.6g} m at the start: bodies must not (R4). Move "
            "them apart."
        )
        self.bodies, self.depth, self.share = bodies, depth, share


def named(*names: str) -> str:
    """Return names as a message lists them."""
    quoted = [f"'{name}'" for name in names]
    return " and ".join(filter(None, [", ".join(quoted[:-1]), quoted[-1]]))
