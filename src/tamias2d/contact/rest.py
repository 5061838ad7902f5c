"""Contacts that last: what the pushes of supports make of the motion (GD3).

The pushes are never negative, and vanish where a contact opens. What they make of the
accelerations is unique. A contact can last only while its normal stays as it is, for otherwise the
path is not one that the models give.
"""

import math
from collections.abc import Mapping, Sequence

from tamias2d.contact.complementarity import complementarity
from tamias2d.contact.core import Core, Placed
from tamias2d.contact.manifold import Contact, parting, slip
from tamias2d.contact.refusal import LastingContactError, named
from tamias2d.contact.response import coupling
from tamias2d.generated import definitions, rotation, translation
from tamias2d.state import Acceleration, Hold, State, Vector

_SMALL = 1e-10
"""What counts as none, relative to the largest of its kind. Rounding leaves far less than this."""
_STILL: Acceleration = (0.0, 0.0, 0.0)


class Island:
    """Moving bodies that contacts connect, at one instant. Static bodies connect nothing."""

    def __init__(
        self,
        cores: Sequence[Core],
        placed: Mapping[int, Placed],
        contacts: Sequence[Contact],
        free: Mapping[int, Acceleration],
    ) -> None:
        self._cores = cores
        self.bodies = sorted({i for c in contacts for i in (c.a, c.b) if cores[i].dynamic})
        loads = [opening(contact, placed, free) for contact in contacts]
        matrix = [[coupling(cores, k, m) for m in contacts] for k in contacts]
        pushes = complementarity(matrix, loads)
        self._scale = max(abs(load) for load in loads)
        self.accelerations = self._pushed(contacts, pushes, free)
        self.lasting = [
            contact
            for contact, push in zip(contacts, pushes, strict=True)
            if push > 0 or opening(contact, placed, self.accelerations) <= _SMALL * self._scale
        ]

    def stopped(self, states: Mapping[int, State]) -> dict[int, State]:
        """Return the states of a body on its supports without what parts or closes still."""
        if len(self.bodies) > 1:
            return {i: states[i] for i in self.bodies}
        (body,) = self.bodies
        state = states[body]
        velocity = _without(state.velocity, [contact.normal for contact in self.lasting])
        if self._flat():
            state = state._replace(angular_velocity=0.0)
        return {body: state._replace(velocity=velocity)}

    def holds(self) -> dict[int, Hold]:
        """Return what the lasting contacts make of each body's own acceleration."""
        if len(self.bodies) > 1:
            return {i: _constant(self._rounded(i)) for i in self.bodies}
        normals = [contact.normal for contact in self.lasting]
        return {self.bodies[0]: _projection(normals, turning=not self._angular())}

    def moves_on(self, states: Mapping[int, State]) -> tuple[Contact, str] | None:
        """Return a lasting contact whose normal does not stay, and why; None if all do."""
        for contact in self.lasting:
            if reason := self._turns(contact, states) or self._slides(contact, states):
                return contact, reason
        return None

    def at_rest(self, states: Mapping[int, State]) -> bool:
        """Whether its bodies are in equilibrium, and hardly move."""
        for i in self.bodies:
            speed, spin = math.hypot(*states[i].velocity), states[i].angular_velocity
            size = self._cores[i].size
            if self._rounded(i) != _STILL or speed**2 + (spin * size) ** 2 > (
                _SMALL * self._scale * size
            ):
                return False
        return True

    def refuse_what_moves_on(self, states: Mapping[int, State], time: float) -> None:
        """Raise `LastingContactError` if the normal of a lasting contact does not stay."""
        if found := self.moves_on(states):
            contact, reason = found
            self._refuse([contact.a, contact.b], reason, time)

    def refuse_loads_that_vary(self, time: float) -> None:
        """Raise `LastingContactError` for bodies on each other: what each feels is not fixed."""
        self._refuse(self.bodies, "forces on them vary", time)

    def _refuse(self, bodies: Sequence[int], reason: str, time: float) -> None:
        names = named(*(self._cores[i].name for i in bodies))
        raise LastingContactError(
            f"{names} at {time!r} s: they stay in contact while {reason}, which the located way "
            "does not follow (GD3). End the run before, or change the scene.",
            time=time,
        )

    def _turns(self, contact: Contact, states: Mapping[int, State]) -> str:
        for i in (contact.a, contact.b):
            core = self._cores[i]
            if core.dynamic and len(core.corners) > 1:
                small = _SMALL * self._scale
                spin, turn = states[i].angular_velocity, self.accelerations[i][2]
                size = core.bounding_radius
                if spin**2 * size > small or abs(turn) * size > small:
                    return f"'{core.name}' turns"
        return ""

    def _slides(self, contact: Contact, states: Mapping[int, State]) -> str:
        p = contact.b if contact.axis.swapped else contact.a
        q = contact.a if contact.axis.swapped else contact.b
        still = not self._cores[p].dynamic, not self._cores[q].dynamic
        if contact.axis.side is not None and (still[0] or (still[1] and self._flat())):
            return ""
        (ax, ay, _), (bx, by, _) = (self.accelerations.get(i, _STILL) for i in (p, q))
        ux, uy = contact.axis.direction
        rate = slip(contact, states[contact.a], states[contact.b])
        size = min(self._cores[i].size for i in (p, q) if self._cores[i].dynamic)
        small = _SMALL * self._scale
        if rate**2 > small * size or abs(ux * (by - ay) - uy * (bx - ax)) > small:
            return "one slides on the other"
        return ""

    def _flat(self) -> bool:
        """Whether some pair touches with two contacts."""
        pairs = [(contact.a, contact.b) for contact in self.lasting]
        return len(set(pairs)) < len(pairs)

    def _angular(self) -> bool:
        """Whether the contacts can turn the one body of the island."""
        return len(self._cores[self.bodies[0]].corners) > 1

    def _rounded(self, body: int) -> Acceleration:
        """Return an acceleration without the rounding that pushes leave of an equilibrium."""
        small = 1e-13 * self._scale
        x, y, turn = self.accelerations[body]
        size = self._cores[body].size
        return (
            0.0 if abs(x) <= small else x,
            0.0 if abs(y) <= small else y,
            0.0 if abs(turn) * size <= small else turn,
        )

    def _pushed(
        self,
        contacts: Sequence[Contact],
        pushes: Sequence[float],
        free: Mapping[int, Acceleration],
    ) -> dict[int, Acceleration]:
        result = {i: free[i] for i in self.bodies}
        for contact, push in zip(contacts, pushes, strict=True):
            x, y = contact.normal
            for body, arm, sign in ((contact.a, contact.arm_a, -1), (contact.b, contact.arm_b, 1)):
                if body in result:
                    force = (sign * push * x, sign * push * y)
                    result[body] = _accelerated(self._cores[body], result[body], arm, force)
        return result


def opening(
    contact: Contact, placed: Mapping[int, Placed], by: Mapping[int, Acceleration]
) -> float:
    """Return the second derivative of a gap, m/s^2; who has no acceleration in `by` has none."""
    a, b = contact.a, contact.b
    return parting(contact, placed[a], placed[b], by.get(a, _STILL), by.get(b, _STILL))


def _without(vector: Vector, normals: Sequence[Vector]) -> Vector:
    """Return what of a vector is left along all of some surfaces, given by their normals."""
    (nx, ny), *others = normals
    if any(abs(nx * y - ny * x) > _SMALL for x, y in others):
        return 0.0, 0.0
    along = ny * vector[0] - nx * vector[1]
    return along * ny + 0.0, -along * nx + 0.0  # no negative zero


def _projection(normals: Sequence[Vector], *, turning: bool) -> Hold:
    def hold(acceleration: Acceleration) -> Acceleration:
        x, y, turn = acceleration
        return (*_without((x, y), normals), turn if turning else 0.0)

    return hold


def _constant(acceleration: Acceleration) -> Hold:
    return lambda _: acceleration


def _accelerated(core: Core, by: Acceleration, arm: Vector, force: Vector) -> Acceleration:
    """Return the acceleration of a body after one more force at an arm (IM1, IM2)."""
    x, y = translation.acceleration(by[:2], force, 1 / core.inverse_mass)
    inertia = 1 / core.inverse_inertia if core.inverse_inertia else math.inf
    turn = rotation.angular_acceleration(definitions.torque(arm, force), inertia)
    return float(x), float(y), by[2] + float(turn)
