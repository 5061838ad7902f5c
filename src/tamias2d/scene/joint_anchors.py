"""The anchors of a joint: as they are given, or by the place of the world that it holds (TM7)."""

from tamias2d.scene.joint_kinds import JointKind
from tamias2d.scene.joints import End
from tamias2d.scene.placed_bodies import PlacedBodies, PlacedBody
from tamias2d.scene.rules import RuleError, Vector, vector
from tamias2d.scene.springs import arm

_CENTRE = (0.0, 0.0)
_KEYS = ("anchor", "other_anchor", "third_anchor")


def anchors_of(
    kind: object,
    ends: tuple[End, End, End],
    anchors: tuple[object, object, object],
    at: object,
    bodies: PlacedBodies,
) -> tuple[object, object, object]:
    """Return where a joint holds its ends: at anchors, at centres of mass, or `at` a place.

    From a place follows where each body has it now; a point of the plane is its own anchor.

    Raises:
        RuleError: anchors are given, too, or the kind holds no single place.
    """
    if at is None or not isinstance(kind, JointKind):  # what is no kind is refused later
        first, second, third = (_CENTRE if anchor is None else anchor for anchor in anchors)
        return first, second, third
    of = f"at of a joint of kind {type(kind).__name__}"
    if kind.no_place is not None:
        raise RuleError(f"{of}: {kind.no_place} (TM7). Give its anchors instead.", "at")
    for key, anchor in zip(_KEYS, anchors, strict=True):
        if anchor is not None:
            raise RuleError(
                f"{of}: found {key}, too: the anchors follow from it (TM7). Leave one out.", "at"
            )
    place = vector(at, "point", "a joint", "Give a point (x, y) of the world in m.", at=("at",))
    first, second = (
        _local(bodies[end], place) if isinstance(end, int) else _CENTRE for end in ends[:2]
    )
    return first, second, _CENTRE


def _local(body: PlacedBody, place: Vector) -> Vector:
    """Return where a body has a place of the world, m, in its own axes from its centre of mass."""
    (x, y), (centre_x, centre_y) = place, body.position
    along, across = arm((x - centre_x, y - centre_y), -body.orientation)
    return float(along), float(across)
