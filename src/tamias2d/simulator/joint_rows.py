"""The joints of a scene as rows for the engine."""

from collections.abc import Mapping, Sequence

from tamias2d.engine.joints.rows import JointRow
from tamias2d.generated.joint_rows import KINDS
from tamias2d.scene.joints import Joint
from tamias2d.scene.rules import RuleError


def refuse_own_equations(joints: Sequence[Joint]) -> None:
    """Raise `RuleError` where a joint is none of the kinds that steps know."""
    for joint in joints:
        if joint.model not in KINDS:
            raise RuleError(
                f"joint '{joint.name}': steps know {', '.join(KINDS)}, and no equation of one's "
                "own (R13). Take one of these, or simulate(scene, ...) without Stepped(), which "
                "takes any.",
                "joints",
            )


def joint_row(joint: Joint) -> JointRow:
    """Return a joint as a row."""
    given = [joint.given[name] for name in joint.functions.parameters]
    numbers = [x for value in given for x in (value if isinstance(value, tuple) else (value,))]
    return JointRow(joint.model, joint.ends, tuple(numbers), not joint.collide)


def canonical_joints(joints: Sequence[Joint], place: Mapping[int, int]) -> list[int]:
    """Return the numbers of joints by the places of their bodies, whatever order they came in."""

    def key(k: int) -> tuple[object, ...]:
        row = joint_row(joints[k])
        return (
            [-1 if body is None else place[body] for body in row.ends],
            row.kind,
            row.given,
            row.apart,
            k,
        )

    return sorted(range(len(joints)), key=key)
