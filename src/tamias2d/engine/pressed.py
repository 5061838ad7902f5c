"""Bodies that gravity or a load presses together by more than contacts hold.

A contact that yields comes back within some substeps. Where a load moves a body by more than its
width in one of them, it is through before that: such a pair is told, whether or not it is caught.

Cost: a look at each active body in a step, and one at each contact where a load is so strong.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.narrow_phase.thickness import NOT_THIN, half_extent
from tamias2d.engine.tables import Bodies, Constraints, Contacts, Control, Touching
from tamias2d.state import Array


def note_pressed(
    control: Control,
    bodies: Bodies,
    contacts: Contacts,
    touching: Touching,
    constraints: Constraints,
) -> None:
    """Note the first two bodies that are pressed together by more than a width in a substep."""
    if control.counts[tb.PRESSED_A] > 0:
        return
    substep, strong = control.settings[tb.SUBSTEP], False
    for k in range(constraints.counts[tb.ACTIVE]):
        i = touching.active[k]
        gain = bodies.substep_state[i]
        pull = substep * (abs(gain[tb.INCREMENT]) + abs(gain[tb.INCREMENT + 1]))
        strong = strong | (pull > least_width(i, bodies))
    if not strong:
        return
    for k in range(touching.counts[tb.TOUCHING]):
        i, j = touching.body_a[k], touching.body_b[k]
        normal = contacts.manifolds[touching.contact[k]]
        closing = substep * (gain_along(normal, i, bodies) - gain_along(normal, j, bodies))
        if closing > min(least_width(i, bodies), least_width(j, bodies)):
            control.counts[tb.PRESSED_A], control.counts[tb.PRESSED_B] = i + 1, j + 1
            control.counts[tb.LIMITS] += 1
            return


def gain_along(manifold: Array, i: int, bodies: Bodies) -> float:
    """Return which velocity the loads of a body give it in a substep along a normal, m/s."""
    gain = bodies.substep_state[i]
    along = manifold[tb.NX] * gain[tb.INCREMENT] + manifold[tb.NY] * gain[tb.INCREMENT + 1]
    return along if bodies.kind[i] == tb.DYNAMIC else 0.0


def least_width(i: int, bodies: Bodies) -> float:
    """Return the least width of a body that moves freely, m; as good as infinite of any other."""
    return 2.0 * (half_extent(i, bodies) if bodies.kind[i] == tb.DYNAMIC else NOT_THIN)
