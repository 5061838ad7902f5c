"""The loads on each body, those that vary, and the groups of bodies that act on each other."""

from collections.abc import Iterable, Iterator, Sequence
from itertools import pairwise
from typing import TypeAlias

from tamias2d.scene.law import Law, StateLaw, value_at, varies
from tamias2d.scene.scene_data import SceneData

_VELOCITIES = {"velocity", "angular_velocity"}
_JOINTED = "held by a joint"
_DRAG = "drag"

Load: TypeAlias = tuple[float, float, float]
"""Both components of a force, N, and a torque, N m."""


def steady_load(scene: SceneData, k: int) -> Load:
    """Return the sum of all forces and torques on a body that stay as they are, without weight."""
    total = [0.0, 0.0, 0.0]
    for component, law in _laws_on(scene, k):
        if not varies(law):
            total[component] += value_at(law, scene.bodies[k].start)
    return total[0], total[1], total[2]


def feels_mass(scene: SceneData) -> bool:
    """Return whether a load that stays as it is depends on the mass of its body."""
    laws = (law for k in range(len(scene)) for _, law in _laws_on(scene, k))
    return any(isinstance(law, StateLaw) and not law.varies for law in laws)


def varying_laws(scene: SceneData, bodies: Sequence[int]) -> dict[tuple[int, StateLaw], list[int]]:
    """Return all laws that vary, each with its component of the load, and the bodies that share it.

    Components are counted as in a `Load`, bodies as the places in `bodies`.
    """
    found: dict[tuple[int, StateLaw], list[int]] = {}
    for place, k in enumerate(bodies):
        for component, law in _laws_on(scene, k):
            if isinstance(law, StateLaw) and law.varies:
                found.setdefault((component, law), []).append(place)
    return found


def _laws_on(scene: SceneData, k: int) -> Iterator[tuple[int, Law]]:
    body = scene.bodies[k]
    yield from enumerate((*body.force, body.torque))
    for field in scene.fields:
        if field.acts_on(k) and body.dynamic:
            yield from enumerate((*field.force, field.torque))


def varying_loads(scene: SceneData) -> dict[int, str]:
    """Return why the loads of a body vary, all reasons, for each body whose loads do."""
    moving = [k for k, body in enumerate(scene.bodies) if body.dynamic]
    found: dict[int, dict[str, None]] = {}
    for k, why in _variations(scene, moving):
        found.setdefault(k, {})[why] = None
    return {k: " and ".join(found[k]) for k in moving if k in found}


def varying_beside_joints(scene: SceneData) -> set[int]:
    """Return the bodies whose loads vary by more than what joints exert."""
    moving = [k for k, body in enumerate(scene.bodies) if body.dynamic]
    return {k for k, why in _variations(scene, moving) if why != _JOINTED}


def only_slowed(scene: SceneData) -> bool:
    """Return whether no load of any body varies but by drag."""
    moving = [k for k, body in enumerate(scene.bodies) if body.dynamic]
    return all(why.endswith(_DRAG) for _, why in _variations(scene, moving))


def kinked(scene: SceneData) -> bool:
    """Return whether some force has a kink: a scheme of high order has none of it across that.

    The spring of a joint has one where it comes to exert its maximum.
    """
    if any(
        each.spring and each.spring.maximum for joint in scene.joints for each in joint.freedoms
    ):
        return True
    moving = [k for k, body in enumerate(scene.bodies) if body.dynamic]
    return any(law.kinked for _, law in varying_laws(scene, moving))


def brief_laws(scene: SceneData) -> bool:
    """Return whether some law may do something for a moment."""
    moving = [k for k, body in enumerate(scene.bodies) if body.dynamic]
    return any(law.brief for _, law in varying_laws(scene, moving))


def timed_loads(scene: SceneData) -> set[int]:
    """Return the bodies on which some law acts that depends on time, whatever their state."""
    moving = [k for k, body in enumerate(scene.bodies) if body.dynamic]
    laws = varying_laws(scene, moving)
    return {moving[row] for (_, law), rows in laws.items() if "time" in law.names for row in rows}


def _variations(scene: SceneData, moving: Sequence[int]) -> Iterator[tuple[int, str]]:
    for k in moving:
        body = scene.bodies[k]
        if not body.constant:
            yield k, "under a force or torque that varies with time or state"
        if body.quadratic_drag:
            yield k, f"under quadratic {_DRAG}"
        if body.linear_drag:
            yield k, f"under linear {_DRAG}"
        if body.angular_drag:
            yield k, f"under angular {_DRAG}"
    for spring in scene.springs:
        yield from ((k, "held by a spring") for k in spring.bodies)
    for joint in scene.joints:
        yield from ((k, _JOINTED) for k in joint.bodies)
    if scene.attraction is not None and len(moving) > 1:
        yield from ((k, "attracted by other bodies") for k in moving)
    for field in scene.fields:
        if not field.constant:
            yield from (
                (k, "in a field that varies with time or state") for k in moving if field.acts_on(k)
            )


def felt_velocity(scene: SceneData) -> bool:
    """Return whether a load of any body, or what a joint exerts, depends on a velocity."""
    return bool(scene.joints) or loads_feel_velocity(scene)


def loads_feel_velocity(scene: SceneData) -> bool:
    """Return whether a load of any body depends on a velocity, springs of joints among them."""
    freedoms = (each for joint in scene.joints for each in joint.freedoms)
    laws = (law for k in range(len(scene)) for _, law in _laws_on(scene, k))
    return (
        any(each.spring and each.spring.damping for each in freedoms)
        or any(b.linear_drag or b.quadratic_drag or b.angular_drag for b in scene.bodies)
        or any(spring.damping for spring in scene.springs)
        or any(isinstance(law, StateLaw) and law.names & _VELOCITIES for law in laws)
    )


def groups(scene: SceneData) -> list[list[int]]:
    """Return the bodies that move in groups: between different groups, nothing acts but contact."""
    moving = [k for k, body in enumerate(scene.bodies) if body.dynamic]
    if scene.attraction is not None and moving:
        return [moving]
    pairs = [*(s.bodies for s in scene.springs), *(j.bodies for j in scene.joints)]
    return _connected(moving, pairs)


def welded(scene: SceneData) -> list[list[int]]:
    """Return the bodies that move in groups: those of one are welded to each other for good."""
    moving = [k for k, body in enumerate(scene.bodies) if body.dynamic]
    welds = [j.bodies for j in scene.joints if j.model == "weld" and not j.breaks]
    return _connected(moving, welds)


def _connected(moving: Sequence[int], connections: Iterable[Sequence[int]]) -> list[list[int]]:
    """Return the groups of bodies that connections make of those that move."""
    group_of = {k: [k] for k in moving}
    for bodies in connections:
        held = [k for k in bodies if k in group_of]
        for one, other in pairwise(held):
            if group_of[one] is not group_of[other]:
                joined = group_of[other]
                group_of[one].extend(joined)
                group_of.update(dict.fromkeys(joined, group_of[one]))
    return [sorted(group) for group in {id(group): group for group in group_of.values()}.values()]
