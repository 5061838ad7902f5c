"""Whether the contacts of a scene are located or stepped through."""

from tamias2d.contact.event_driven_scenes import is_event_driven
from tamias2d.contact.stepwise import beyond_location
from tamias2d.scene import Scene, in_pieces
from tamias2d.scene.reach import pairs_that_can_meet

MANY = 100
"""The most moving bodies that can meet and whose impacts are located."""
MOST_HELD = 400
"""The most moving bodies that joints hold and that are solved exactly if nothing else is asked."""
MEANT_TO_TOUCH = 1e-6
"""Bodies that overlap by a smaller part of their size at the start are meant to touch there."""


def steps_because(scene: Scene, duration: float, *, within: bool = False) -> str | None:
    """Return why a scene is stepped through its contacts for a duration in s, or None (R12).

    A scene is stepped where impacts cannot be located at all, and where more than a hundred moving
    bodies can meet, unless compiled code follows them (`is_event_driven`) and they do not settle.
    One with joints is stepped where these hold what may rub or rest on something, or too much to be
    solved exactly. To stay `within` a tolerance it is located wherever it can be.
    """
    for body in in_pieces(scene).bodies:
        if what := beyond_location(body):
            return f"body '{body.name}': {what}"
    if scene.joints and (why := _too_much_for_joints(scene, duration, within=within)):
        return why
    if sum(body.dynamic and body.shape is not None for body in scene.bodies) <= MANY:
        return None
    if is_event_driven(scene) and not _settles(scene):
        return None
    meeting = {k for pair in pairs_that_can_meet(scene, duration) for k in pair}
    count = sum(scene.bodies[k].dynamic for k in meeting)
    return f"{count} moving bodies can meet, more than {MANY}" if count > MANY else None


def _too_much_for_joints(scene: Scene, duration: float, *, within: bool) -> str | None:
    """Return why joints, or what they hold, cannot be solved exactly, or None."""
    held = {k for joint in scene.joints for k in joint.bodies if scene.bodies[k].dynamic}
    if len(held) > MOST_HELD:
        return f"joints hold {len(held)} moving bodies, more than {MOST_HELD}"
    if within and not any(joint.may_switch for joint in scene.joints):
        return None
    for pair in pairs_that_can_meet(scene, duration):
        tied = next((k for k in pair if k in held), None)
        if tied is not None and (scene.friction(*pair) or scene.restitution(*pair) == 0):
            name = scene.bodies[tied].name
            return f"a joint holds '{name}', which may rub or rest on what it meets"
    return None


def _settles(scene: Scene) -> bool:
    """Whether bodies come to rest on each other: something pulls them, and impacts take energy."""
    pulled = any(scene.gravity) or any(body.constant and any(body.force) for body in scene.bodies)
    stated = [body.restitution for body in scene.bodies if body.shape is not None]
    stated += scene.restitution_of_pairs.values()
    return pulled and any(value is not None and value < 1 for value in stated)
