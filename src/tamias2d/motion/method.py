"""What every method says of itself, whatever its kind."""

from typing import ClassVar

from tamias2d.generated.schemes import FACTS, Facts


class Method:
    """A way in which a run is made. Whether it needs a time step, and what is proven of it."""

    fixed_step: ClassVar[bool] = False
    """Whether it takes equal steps, of a length that the user chooses."""
    scheme: ClassVar[str | None] = None
    """Its item in the specification, if it has one."""

    @property
    def facts(self) -> Facts | None:
        """Order, symplecticity and limits of stability, as the specification proves them."""
        return FACTS.get(self.scheme or "")
