"""Half a substep of forces on bodies that joints hold and no contact touches (kick and drift)."""

from tamias2d.engine import tables as tb
from tamias2d.engine.tables import Bodies, Joints
from tamias2d.generated.joint_step import (
    half_decay,
    half_gain,
    kick_velocity_later,
    kick_velocity_start,
)
from tamias2d.kernels.assembled import inlined
from tamias2d.state import Array


def kick_half(n: int, ahead: bool, bodies: Bodies, joints: Joints) -> None:
    """Take the velocities of a mechanism half a substep ahead of the forces, or behind them."""
    for node in range(joints.sparse[n, tb.I_NODE], joints.sparse[n + 1, tb.I_NODE]):
        i = joints.sparse[node, tb.N_BODY]
        now, state = bodies.motion[i], bodies.substep_state[i]
        drag, turning = state[tb.DRAG_FACTOR], state[tb.DRAG_FACTOR + 2]
        if drag == 1.0 and turning == 1.0:  # without roots and quotients
            kick_body(ahead, 1.0, 1.0, now, state)
        else:
            kick_body(ahead, half_decay(drag), half_decay(turning), now, state)


@inlined
def kick_body(ahead: bool, decay: float, turning_decay: float, now: Array, state: Array) -> None:
    """Take a body's velocities half a substep ahead, or behind, with their factors by drag."""
    for k in range(3):
        factor = turning_decay if k == 2 else decay
        gain = half_gain(state[tb.INCREMENT + k], factor)
        later = kick_velocity_later(now[k], factor, gain)
        now[k] = later if ahead else kick_velocity_start(now[k], factor, gain)
        state[tb.SUBSTEP_START + k] = now[k]
