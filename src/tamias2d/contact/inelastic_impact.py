"""Impulses after which contacts that press no longer approach, nor slide where they stick (DD68).

They take what is left when impacts have answered one another, and end the sliding of contacts that
jam: where no forces obey Coulomb's law, an impulse does.
"""

import math
from collections.abc import Mapping, Sequence

import numpy as np

from tamias2d.contact.core import Placed
from tamias2d.contact.coupled_constraint import least_forces
from tamias2d.contact.force_problem import ForceProblem
from tamias2d.contact.manifold import Contact
from tamias2d.contact.mobility import Mobility, rows_of
from tamias2d.contact.modes import Mode, Part, Patch, closed, closed_directions, force_directions
from tamias2d.contact.refusal import LastingContactError
from tamias2d.contact.touching import PairOf
from tamias2d.generated import friction
from tamias2d.state import Acceleration, Array, State

_SEED = 1e-6
"""Of the sliding: what loads add, so that the contacts that they press are told."""
_AT_BOUND = 1e-9
"""Of the largest impulse, or of Coulomb's bound: what is as good as there."""


class JammedError(LastingContactError):
    """No forces at the contacts of an island obey Coulomb's law."""

    def __init__(
        self,
        names: str,
        patches: Sequence[Patch],
        placed: Mapping[int, Placed],
        free: Mapping[int, Acceleration],
        *,
        time: float,
    ) -> None:
        """Take the patches of the island, and the accelerations of its bodies by loads alone.

        `placed` are its bodies, and those on which they lie.
        """
        super().__init__(
            f"{names} at {time!r} s: no forces between them were found that obey Coulomb's law "
            "(IM18), as where friction presses what it brakes. End the run before, take "
            "method=Stepped(), or change the scene.",
            time=time,
        )
        self.patches = patches
        self.placed = placed
        self.free = free


def jam_impulses(
    mobility: Mobility, jam: JammedError
) -> tuple[list[tuple[Contact, float, float]], set[PairOf]]:
    """Return contacts with the impulses along normal and tangent, N s, that end their sliding.

    None are returned where nothing slides. A little of the loads tells which contacts they press.
    What is left of velocities that count as none, if more than that, would hide it. Also returned
    are the pairs that do not slide any more, in the sense in which they did.
    """
    bodies = sorted(jam.free)
    states = {i: jam.placed[i].state for i in bodies}
    problem = ForceProblem(mobility, bodies, _loose(jam.patches))
    slides = [bool(patch.sense) for patch in jam.patches if patch.coefficient]
    seen = [False] * problem.count + slides
    rates = np.where(seen, problem.rows @ _velocities(bodies, states).ravel(), 0.0)
    loads = problem.loads(jam.placed, jam.free)
    sliding = np.abs(rates[problem.count :]).max(initial=0.0)
    pull = np.abs(loads).max()
    if not (sliding and pull):
        return [], set()
    told = problem.solved(rates + _SEED * sliding / pull * loads)
    if told is None:
        return [], set()
    stopped = {
        (part.pressed[0].a, part.pressed[0].b)
        for part, before in zip(_mode(problem, *told), jam.patches, strict=True)
        if part.pressed and not part.sense == before.sense != 0
    }
    return _impulses(mobility, bodies, problem, states, told), stopped


def closing_impulses(
    mobility: Mobility, patches: Sequence[Patch], states: Mapping[int, State]
) -> list[tuple[Contact, float, float]]:
    """Return contacts with the impulses, N s, that take what is left of their approach."""
    bodies = mobility.reached(contact for patch in patches for contact in patch.contacts)
    problem = ForceProblem(mobility, bodies, _loose(patches))
    rates = problem.rows @ _velocities(bodies, states).ravel()
    told = problem.solved(rates)
    return [] if told is None else _impulses(mobility, bodies, problem, states, told)


def without_rates(
    mobility: Mobility, directions: Sequence[Contact], states: Mapping[int, State]
) -> dict[int, State]:
    """Return the states after the least impulses that leave no velocity along some normals."""
    bodies = mobility.reached(directions)
    rows, before = rows_of(directions, bodies), _velocities(bodies, states)
    moved = mobility.moved(rows, bodies)
    found = least_forces(
        rows, moved, mobility.sizes(rows, bodies), rows @ before.ravel(), mobility.redundant(bodies)
    )
    after = before + (found @ moved).reshape(-1, 3)
    return {
        i: states[i]._replace(velocity=(x, y), angular_velocity=spin)
        for i, (x, y, spin) in zip(bodies, after.tolist(), strict=True)
    }


def _loose(patches: Sequence[Patch]) -> list[Patch]:
    """Return patches of which it is open how they slide afterwards."""
    return [patch._replace(sense=0) for patch in patches]


def _velocities(bodies: Sequence[int], states: Mapping[int, State]) -> Array:
    return np.array([(*states[i].velocity, states[i].angular_velocity) for i in bodies])


def _impulses(
    mobility: Mobility,
    bodies: Sequence[int],
    problem: ForceProblem,
    states: Mapping[int, State],
    told: tuple[Array, Array],
) -> list[tuple[Contact, float, float]]:
    """Return the impulses of the mode that a problem's solution has.

    Where rounding told that one sticks which slides, those that told it are taken: they obey
    Coulomb's law.
    """
    mode = _mode(problem, *told)
    rows = rows_of(closed_directions(closed(mode)), bodies)
    effect = mobility.moved(rows_of(force_directions(mode), bodies), bodies)
    left = rows @ _velocities(bodies, states).ravel()
    size = mobility.sizes(rows, bodies)
    found = _of_contacts(
        mode, least_forces(rows, effect, size, left, mobility.redundant(bodies)).tolist()
    )
    return found if _obey_coulomb(mode, found) else _as_told(problem, *told)


def _mode(problem: ForceProblem, pushes: Array, drags: Array) -> Mode:
    """Return which contacts press, stick and slide after impulses."""
    least = _AT_BOUND * float(pushes.max(initial=0.0))
    parts, place, drag_of = [], 0, iter(drags.tolist())
    for patch in problem.patches:
        own = pushes[place : place + len(patch.contacts)].tolist()
        place += len(patch.contacts)
        drag = next(drag_of) if patch.coefficient else 0.0
        pressed = tuple(c for c, push in zip(patch.contacts, own, strict=True) if push > least)
        bound = float(friction.friction_force_most(math.fsum(own), patch.coefficient))
        slides = pressed and patch.coefficient and abs(drag) >= bound * (1 - _AT_BOUND)
        parts.append(Part(patch, pressed, -int(math.copysign(1, drag)) if slides else 0))
    return tuple(parts)


def _obey_coulomb(mode: Mode, impulses: Sequence[tuple[Contact, float, float]]) -> bool:
    """Return whether impulses push, and rub no more than friction may."""
    left = iter(impulses)
    unseen = _AT_BOUND * max((abs(push) for _, push, _ in impulses), default=0.0)
    for part in mode:
        own = [next(left) for _ in part.pressed]
        push, drag = math.fsum(n for _, n, _ in own), math.fsum(t for *_, t in own)
        most = float(friction.friction_force_most(push, part.patch.coefficient))
        if min((each[1] for each in own), default=0.0) < -unseen or abs(drag) > most + unseen:
            return False
    return True


def _as_told(
    problem: ForceProblem, pushes: Array, drags: Array
) -> list[tuple[Contact, float, float]]:
    """Return contacts with the impulses of a problem along normals and tangents."""
    found, push_of, drag_of = [], iter(pushes.tolist()), iter(drags.tolist())
    for patch in problem.patches:
        own = [next(push_of) for _ in patch.contacts]
        whole = next(drag_of) if patch.coefficient else 0.0
        total = math.fsum(own)
        for contact, push in zip(patch.contacts, own, strict=True):
            found.append((contact, push, whole * push / total if total else 0.0))
    return found


def _of_contacts(mode: Mode, impulses: Sequence[float]) -> list[tuple[Contact, float, float]]:
    """Return the impulses of a mode along normals and tangents."""
    along = iter(impulses[sum(len(part.pressed) for part in mode) :])
    across = iter(impulses)
    found = []
    for part in mode:
        slope = friction.friction_force(part.sense, part.patch.coefficient, 1.0)
        for k, contact in enumerate(part.pressed):
            push = next(across) / (1 + abs(slope))
            sticking = next(along) if part.sticks and k == 0 else 0.0
            found.append((contact, push, slope * push + sticking))
    return found
