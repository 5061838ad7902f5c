"""Frictionless lasting contacts: the accelerations that their normal forces leave (GD3).

Normal forces are never negative, and vanish where a contact opens. The accelerations under them
are unique. A contact between two moving bodies can last only while its normal does not turn, for
the models give no path otherwise.
"""

import math
from collections.abc import Callable, Mapping, Sequence

from tamias2d.contact.complementarity import complementarity
from tamias2d.contact.constrained_acceleration import (
    Constant,
    Projection,
    TurningConstraint,
    after_force,
    constrained_accelerations,
    opening_acceleration,
    tangential_part,
    without_normal_velocity,
)
from tamias2d.contact.core import Core, Placed
from tamias2d.contact.manifold import Contact, slip_velocity
from tamias2d.contact.refusal import LastingContactError, named
from tamias2d.contact.response import coupling
from tamias2d.state import Acceleration, Constraint, State

_FIXED = 1e-10
"""Of the accelerations: by which a contact that counts as fixed may turn or slide."""
_ROUNDING = 1e-13
"""Of the accelerations: by which rounding alone may open a contact."""
_STILL: Acceleration = (0.0, 0.0, 0.0)


def scale_of(free: Sequence[Acceleration], loads: Sequence[float]) -> float:
    """Return the largest acceleration of bodies without contacts, and of contacts, m/s^2."""
    return max(*(math.hypot(*each[:2]) for each in free), *(abs(load) for load in loads))


def unseen_opening(scale: float, slight: float) -> float:
    """Return what counts as no opening, m/s^2."""
    return max(_ROUNDING * scale, slight)


class Island:
    """Moving bodies that contacts connect, at one instant. Static bodies do not connect."""

    def __init__(
        self,
        cores: Sequence[Core],
        placed: Mapping[int, Placed],
        contacts: Sequence[Contact],
        free: Mapping[int, Acceleration],
        slight: float,
    ) -> None:
        """Take contacts without normal velocity; an opening by less than `slight` is not seen."""
        self._cores = cores
        self._placed = placed
        self.senses: dict[tuple[int, int], int] = {}
        """Of pairs with friction: 0 if they stick, else the sense in which they slide."""
        self.stopped: set[tuple[int, int]] = set()
        """Pairs whose sliding friction ends as they settle."""
        self.bodies = self._reached(contacts)
        loads = [opening_acceleration(contact, placed, free) for contact in contacts]
        matrix = self._couplings(contacts)
        normal_forces = complementarity(matrix, loads)
        scale = self._scale = scale_of([free[i] for i in self.bodies], loads)
        self._small = _FIXED * scale + slight
        self._pressed = [
            c for c, normal_force in zip(contacts, normal_forces, strict=True) if normal_force > 0
        ]
        if len(self.bodies) > 1 and not any(cores[i].jointed for i in self.bodies):
            self.accelerations = constrained_accelerations(cores, self.bodies, self._pressed, free)
        else:
            self.accelerations = self._with_forces(contacts, normal_forces, free)
        self._unseen = unseen_opening(scale, slight)
        self.lasting = [
            contact
            for contact, normal_force in zip(contacts, normal_forces, strict=True)
            if normal_force > 0
            or opening_acceleration(contact, placed, self.accelerations) <= self._unseen
        ]

    def _reached(self, contacts: Sequence[Contact]) -> list[int]:
        """Return the moving bodies that forces at the contacts accelerate."""
        return sorted({i for c in contacts for i in (c.a, c.b) if self._cores[i].dynamic})

    def _couplings(self, contacts: Sequence[Contact]) -> list[list[float]]:
        return [[coupling(self._cores, k, m) for m in contacts] for k in contacts]

    def crept(
        self,
        states: Mapping[int, State],
        restitution: Callable[[int, int], float],  # noqa: ARG002
    ) -> Mapping[int, State]:
        """Return the states where the bounces that are left have brought what sticks (DD78)."""
        return states

    def projected(self, states: Mapping[int, State]) -> dict[int, State]:
        """Return the states without the remaining normal velocities."""
        if len(self.bodies) > 1:
            settled = without_normal_velocity(self._cores, self.lasting, states)
            return {i: settled[i] for i in self.bodies}
        (body,) = self.bodies
        state = states[body]
        if not self._flat() and self._angular():
            return {body: without_normal_velocity(self._cores, self.lasting, states)[body]}
        velocity = tangential_part(state.velocity, [contact.normal for contact in self.lasting])
        if self._flat():
            state = state._replace(angular_velocity=0.0)
        return {body: state._replace(velocity=velocity)}

    def constraints(self, states: Mapping[int, State], time: float) -> dict[int, Constraint]:
        """Return the constraint of each body by its lasting contacts.

        Raises:
            LastingContactError: several bodies move on while their contacts last.
        """
        moving = self._moves_on(states)
        if len(self.bodies) > 1:
            if moving:
                raise LastingContactError(
                    f"{moving} at {time!r} s: two moving bodies stay in contact and its normal "
                    "turns, which located contacts do not cover (GD3). End the run before, take "
                    "method=Stepped(), or change the scene.",
                    time=time,
                )
            return {i: Constant(self.accelerations[i]) for i in self.bodies}
        (body,) = self.bodies
        if moving:
            self._refuse_coupled(body, moving, time)
            placed = {i: self._placed[i] for c in self.lasting for i in (c.a, c.b)}
            return {body: TurningConstraint(self._cores, body, self.lasting, placed)}
        normals = [contact.normal for contact in self.lasting]
        return {body: Projection(normals, turning=not self._angular())}

    def _refuse_coupled(self, body: int, pair: str, time: float) -> None:
        """Refuse a body that tips or rolls off while others pull it (IM5, IM7)."""
        if len(self._cores[body].group) > 1:
            raise LastingContactError(
                f"{pair} at {time!r} s: the normal of a lasting contact turns while other bodies "
                f"pull '{self._cores[body].name}', which located contacts do not cover (GD3). "
                "End the run before, take method=Stepped(), or change the scene.",
                time=time,
            )

    def _steady(self, states: Mapping[int, State]) -> bool:
        """Whether neither loads vary nor a support may end."""
        cores = [self._cores[i] for c in self.lasting for i in (c.a, c.b)]
        ending = any(not core.dynamic and not core.endless for core in cores)
        moving = any(
            states[i].velocity != (0, 0) or self.accelerations[i][:2] != (0, 0) for i in self.bodies
        )
        turning = any(states[i].angular_velocity or self.accelerations[i][2] for i in self.bodies)
        resting = set() if moving or turning else set(self.bodies)
        steady = all(
            core.steady or (not core.timed and core.group <= resting)
            for core in cores
            if core.dynamic
        )
        return steady and not (ending and moving)

    def _moves_on(self, states: Mapping[int, State]) -> str:
        """Return the names of a pair whose normal turns, or nothing."""
        for contact in self.lasting:
            slides = contact in self._pressed and self._slides(contact, states)
            if self._turns(contact, states) or slides:
                return named(self._cores[contact.a].name, self._cores[contact.b].name)
        return ""

    def _turns(self, contact: Contact, states: Mapping[int, State]) -> bool:
        for i in (contact.a, contact.b):
            core = self._cores[i]
            if core.dynamic and len(core.corners) > 1:
                spin, turn = states[i].angular_velocity, self.accelerations[i][2]
                size = core.bounding_radius
                if max(spin**2, abs(turn)) * size > self._small:
                    return True
        return False

    def _slides(self, contact: Contact, states: Mapping[int, State]) -> bool:
        p = contact.b if contact.axis.swapped else contact.a
        q = contact.a if contact.axis.swapped else contact.b
        still = not self._cores[p].dynamic, not self._cores[q].dynamic
        if contact.axis.side is not None and (still[0] or (still[1] and self._flat())):
            return False
        (ax, ay, _), (bx, by, _) = (self.accelerations.get(i, _STILL) for i in (p, q))
        ux, uy = contact.axis.direction
        rate = slip_velocity(contact, states[contact.a], states[contact.b])
        size = min(self._cores[i].size for i in (p, q) if self._cores[i].dynamic)
        change = abs(ux * (by - ay) - uy * (bx - ax))
        return max(rate**2 / size, change) > self._small

    def _flat(self) -> bool:
        """Whether some pair touches with two contacts."""
        pairs = [(contact.a, contact.b) for contact in self.lasting]
        return len(set(pairs)) < len(pairs)

    def _angular(self) -> bool:
        """Whether the contacts can turn the one body of the island."""
        return len(self._cores[self.bodies[0]].corners) > 1

    def _with_forces(
        self,
        contacts: Sequence[Contact],
        normal_forces: Sequence[float],
        free: Mapping[int, Acceleration],
    ) -> dict[int, Acceleration]:
        result = {i: free[i] for i in self.bodies}
        for contact, normal_force in zip(contacts, normal_forces, strict=True):
            x, y = contact.normal
            for body, arm, sign in ((contact.a, contact.arm_a, -1), (contact.b, contact.arm_b, 1)):
                if body in result:
                    force = (sign * normal_force * x, sign * normal_force * y)
                    result[body] = after_force(self._cores[body], result[body], arm, force)
        return result
