"""Bodies that joints keep from touching: their pairs are no candidates for contacts."""

from tamias2d.engine import tables as tb
from tamias2d.engine.tables import BodyState, BroadPhase, Joints


def without_kept_apart(
    total: int, state: BodyState, broad_phase: BroadPhase, joints: Joints
) -> int:
    """Leave out the candidates whose bodies joints keep apart; return how many there are left."""
    if joints.counts[tb.JOINTS] == 0 or total > len(broad_phase.candidates):
        return total
    candidates, shape_of_rank = broad_phase.candidates, broad_phase.canonical[tb.SHAPE_OF_RANK]
    left = 0
    for p in range(total):
        a, b = candidates[p, 0], candidates[p, 1]
        one = state.body_of_shape[shape_of_rank[a]]
        other = state.body_of_shape[shape_of_rank[b]]
        if not are_kept_apart(min(one, other), max(one, other), joints):
            candidates[left, 0], candidates[left, 1] = a, b
            left += 1
    return left


def are_kept_apart(low: int, high: int, joints: Joints) -> bool:
    """Return whether joints keep two bodies apart, by their rows, the lower one first."""
    if low + 1 >= len(joints.apart_first):
        return False
    apart = False
    for k in range(joints.apart_first[low], joints.apart_first[low + 1]):
        apart = apart | (joints.apart[k] == high)
    return apart
