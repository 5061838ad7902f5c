"""Where the members of mechanisms are placed, and which were moved by hand since."""

from tamias2d.engine import tables as tb
from tamias2d.engine.joints.linearise import place_members, turn_members
from tamias2d.engine.tables import Bodies, Joints, World

PULLED = 100.0  # substeps: of what is moved by hand a joint that follows lets 2e-10 be left by then
UNTIL_BACK = 2.0**100  # substeps, of which no step takes any off: until it is within its limits


def note_places(world: World) -> None:
    """Note which slots the members of mechanisms have, as a batch of steps begins."""
    joints = world.joints
    if joints.counts[tb.JOINTS] == 0:
        return
    joints.members[0, tb.JOINED_SLOT] = len(world.bodies.kind) - 1  # the plane is the idle body
    for m in range(1, len(joints.members)):
        joints.members[m, tb.JOINED_SLOT] = world.state.slot_of_body[
            joints.members[m, tb.JOINED_BODY]
        ]


def place_moved(anew: bool, bodies: Bodies, joints: Joints) -> None:
    """Place all members anew, or where one is not where it was; rows of such have to be new."""
    last = joints.sparse[joints.counts[tb.MECHANISMS], tb.I_NODE] + 1
    anew = anew or have_moved(0, 1, bodies, joints)
    anew = anew or have_moved(last, len(joints.members), bodies, joints)
    moved = anew
    for n in range(joints.counts[tb.MECHANISMS]):
        first, last = joints.sparse[n, tb.I_NODE] + 1, joints.sparse[n + 1, tb.I_NODE] + 1
        if anew or have_moved(first, last, bodies, joints):
            joints.mechanisms[n, tb.M_WRITTEN], moved = 0, True
    if moved:
        place_members(0, len(joints.members), 0.0, bodies, joints)
    else:
        turn_members(0, len(joints.members), joints)


def pull_after_moved(bodies: Bodies, joints: Joints) -> None:
    """Note which mechanisms follow what they are tied to, as it was moved by hand since a step."""
    last = joints.sparse[joints.counts[tb.MECHANISMS], tb.I_NODE] + 1
    if not have_moved(last, len(joints.members), bodies, joints):
        return
    for n in range(joints.counts[tb.MECHANISMS]):
        for j in range(joints.mechanisms[n, tb.M_JOINT], joints.mechanisms[n + 1, tb.M_JOINT]):
            for end in range(tb.ENDS_OF_JOINT):
                m = joints.joints[j, tb.J_MEMBER + end]
                tied = joints.joints[j, tb.J_NODE + end] == tb.NOT_PUSHED
                if tied and have_moved(m, m + 1, bodies, joints):
                    whole = joints.numbers[joints.mechanisms[n, tb.M_JOINT]]
                    whole[tb.J_PULLED] = max(whole[tb.J_PULLED], PULLED)


def have_moved(first: int, last: int, bodies: Bodies, joints: Joints) -> bool:
    """Return whether members are not where they were placed last."""
    moved = False
    for m in range(first, last):
        pose, place = bodies.pose[joints.members[m, tb.JOINED_SLOT]], joints.places[m]
        same = (place[tb.PLACE_X] == pose[tb.X]) & (place[tb.PLACE_Y] == pose[tb.Y])
        moved = moved | (not (same & (place[tb.PLACE_ANGLE] == pose[tb.ANGLE])))
    return bool(moved)
