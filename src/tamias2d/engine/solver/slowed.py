"""What drag takes of the impulses of contacts that a body carries on through a substep (DD110).

A contact that pushes on is a force, against which drag acts as against others; an impact takes no
time, and is not slowed. Cost: a visit to the propagator of each body that drag slows.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.tables import Bodies
from tamias2d.generated.definitions import coordinate_velocity_slowed


def slow_carried(i: int, bodies: Bodies) -> None:
    """Take from a body, which has just got all that it carries, what drag takes of that."""
    state, motion = bodies.substep_state[i], bodies.motion[i]
    through = bodies.propagators[int(bodies.properties[i, tb.PROPAGATOR])]
    for n in range(3):
        turning = tb.ANGULAR if n == 2 else 0
        left = through[tb.ONE_SUBSTEP + turning + tb.SLOWED]
        motion[n] = coordinate_velocity_slowed(motion[n], left, state[tb.CONTACT_CHANGE + n])
        state[tb.SUBSTEP_START + n] = motion[n]
