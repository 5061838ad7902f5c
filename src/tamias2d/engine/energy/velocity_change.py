"""What is taken from a body along a change of its velocities that gave it energy (DD88)."""

from tamias2d.engine import tables as tb
from tamias2d.engine.energy.step_energy import mass_and_inertia
from tamias2d.generated.island_energy import (
    angular_velocity_reduced,
    angular_velocity_seen,
    given_product,
    velocity_reduced,
    velocity_seen,
)
from tamias2d.state import Array, Vector


def product_with_motion(
    i: int,
    given: Vector,
    turned: float,
    support: Vector,
    spin: float,
    motion: Array,
    properties: Array,
) -> float:
    """Return the product of a change with the motion of a body as seen from its support, J.

    The change is of its velocity, m/s, and of its spin, rad/s.
    """
    mass, inertia = mass_and_inertia(i, properties)
    return given_product(
        mass,
        velocity_seen((motion[i, tb.VX], motion[i, tb.VY]), support),
        given,
        inertia,
        angular_velocity_seen(motion[i, tb.SPIN], spin),
        turned,
    )


def reduce_along(
    given: Vector, turned: float, share: float, product: float, change: float, now: Array
) -> None:
    """Leave the motion of a body a share along a change, of this product and energy, J."""
    now[tb.VX], now[tb.VY] = velocity_reduced(
        (now[tb.VX], now[tb.VY]), given, share, product, change
    )
    now[tb.SPIN] = angular_velocity_reduced(now[tb.SPIN], turned, share, product, change)
