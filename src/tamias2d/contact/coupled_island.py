"""Several moving bodies in lasting contact: which contacts press, stick, slide or open (IM18)."""

import math
from collections.abc import Callable, Mapping, Sequence

import numpy as np

from tamias2d.contact.constrained_acceleration import Constant, contact_acceleration
from tamias2d.contact.core import Placed
from tamias2d.contact.coupled_constraint import CoupledConstraint, Resting, least_forces
from tamias2d.contact.force_problem import ForceProblem
from tamias2d.contact.inelastic_impact import JammedError
from tamias2d.contact.lasting_contact import Island
from tamias2d.contact.manifold import Contact, tangent_of, tangential_velocity
from tamias2d.contact.mobility import Mobility, inverse_masses, rows_of
from tamias2d.contact.modes import (
    Mode,
    Part,
    Patch,
    closed,
    closed_directions,
    cone_edges,
    force_directions,
    forces,
)
from tamias2d.contact.pair_friction import PairFriction
from tamias2d.contact.refusal import LastingContactError, named
from tamias2d.generated import friction
from tamias2d.state import Acceleration, Array, Constraint, State

_MOST = 12
"""The most moving bodies in contact that go on together: the work grows as their cube."""
_PRESSED = 1e-10
"""Of the largest force: one that is none."""
_HELD = 1e-10
"""Of a direction: what is left of it where others hold it."""
_UNSEEN = 1e-9
"""Of the accelerations: by which contacts open for rounding where joints may hold them, too."""
_STILL: Acceleration = (0.0, 0.0, 0.0)


class CoupledIsland(Island):
    """Several moving bodies that contacts connect, with friction or without."""

    def __init__(
        self,
        mobility: Mobility,
        placed: Mapping[int, Placed],
        contacts: Sequence[Contact],
        free: Mapping[int, Acceleration],
        slight: float,
        pair_friction: PairFriction,
    ) -> None:
        """Take contacts without normal velocity.

        Raises:
            LastingContactError: no forces obey Coulomb's law.
        """
        self._mobility = mobility
        super().__init__(mobility.cores, placed, contacts, free, slight)
        if self._jointed:
            self._unseen = max(self._unseen, _UNSEEN * self._scale)
        self._free = free
        self._time = pair_friction.time
        self._states = {i: body.state for i, body in placed.items()}
        self._mode: Mode = ()
        self._rests = False
        self._unseen_speed = pair_friction.unseen_speed(free)
        self._patches = pair_friction.patches(contacts, placed, free)
        if self._stands(pair_friction.noise):
            self._rest()
        if self._goes_on(contacts):
            self._rests = False
            self._decide()
            while stopped := self._turned_round():
                self.stopped |= stopped
                self._patches = [
                    patch._replace(sense=0) if _pair(patch.contacts) in stopped else patch
                    for patch in self._patches
                ]
                self._decide()
        self.senses.update(_senses(self._mode))

    def _goes_on(self, contacts: Sequence[Contact]) -> bool:
        """Whether accelerations change from here on while contacts last."""
        moves = self._jointed or self._moves_on(self._states) or self._rubs()
        if self._rests or not moves:
            return len(self.lasting) == len(contacts) and not self._steady(self._states)
        return True

    @property
    def _jointed(self) -> bool:
        """Whether joints hold some of the bodies."""
        return any(self._cores[i].jointed for i in self.bodies)

    def _reached(self, contacts: Sequence[Contact]) -> list[int]:
        return self._mobility.reached(contacts)

    def _couplings(self, contacts: Sequence[Contact]) -> list[list[float]]:
        found: list[list[float]] = self._mobility.couplings(contacts, contacts).tolist()
        return found

    def _with_forces(
        self,
        contacts: Sequence[Contact],
        normal_forces: Sequence[float],
        free: Mapping[int, Acceleration],
    ) -> dict[int, Acceleration]:
        if not self._jointed:
            return super()._with_forces(contacts, normal_forces, free)
        pushes = self._mobility.moved(rows_of(contacts, self.bodies), self.bodies)
        by = np.array([free[i] for i in self.bodies])
        by += (np.array(normal_forces) @ pushes).reshape(-1, 3)
        return {i: (x, y, turn) for i, (x, y, turn) in zip(self.bodies, by.tolist(), strict=True)}

    def _rubs(self) -> bool:
        """Whether something presses, so that friction may act."""
        return bool(self._pressed) and any(patch.coefficient for patch in self._patches)

    @property
    def _constant(self) -> bool:
        """Whether nothing turns, rubs or varies, so that the accelerations stay what they are."""
        return not self._mode

    def projected(self, states: Mapping[int, State]) -> dict[int, State]:
        """Return the states with the velocities that the closed contacts allow."""
        if self._rests:
            return {
                i: states[i]._replace(velocity=(0.0, 0.0), angular_velocity=0.0)
                for i in self.bodies
            }
        if self._constant:
            return super().projected(states)
        return self._settled(states)

    def _settled(self, states: Mapping[int, State]) -> dict[int, State]:
        """Return the states without what is left of velocities that count as none (DD75)."""
        mode = tuple(part._replace(sense=part.patch.sense) for part in self._mode)
        rows = rows_of(closed_directions(closed(mode)), self.bodies)
        velocities = np.array(
            [(*states[i].velocity, states[i].angular_velocity) for i in self.bodies]
        )
        pushes = self._mobility.moved(rows_of(force_directions(mode), self.bodies), self.bodies)
        size = self._mobility.sizes(rows, self.bodies)
        found = least_forces(
            rows, pushes, size, rows @ velocities.ravel(), self._mobility.redundant(self.bodies)
        )
        after = velocities + (found @ pushes).reshape(-1, 3)
        return {
            i: states[i]._replace(velocity=(x, y), angular_velocity=spin)
            for i, (x, y, spin) in zip(self.bodies, after.tolist(), strict=True)
        }

    def _turned_round(self) -> set[tuple[int, int]]:
        """Return the pairs whose sliding friction would turn round as they settle: it ends it."""
        after = {**self._states, **self._settled(self._states)}
        found = set()
        for part in self._mode:
            if part.pressed and part.patch.coefficient and part.patch.sense:
                pair = _pair(part.pressed)
                a, b = (after[i] for i in pair)
                if part.patch.sense * tangential_velocity(part.pressed[0], a, b) < 0:
                    found.add(pair)
        return found

    def constraints(self, states: Mapping[int, State], time: float) -> dict[int, Constraint]:
        """Return the constraint of each body by its lasting contacts.

        Raises:
            LastingContactError: what is not in contact pulls bodies that move on.
        """
        if self._rests and not self._jointed:
            return {i: Constant(_STILL) for i in self.bodies}
        if self._constant:
            return super().constraints(states, time)
        constraint = CoupledConstraint(self._mobility, self.bodies, self._mode, self._placed)
        if self._rests:
            return dict.fromkeys(self.bodies, Resting(_STILL, constraint))
        self._refuse_pulled(time)
        return dict.fromkeys(self.bodies, constraint)

    def _refuse_pulled(self, time: float) -> None:
        outside = [i for i in self.bodies if not self._cores[i].group <= set(self.bodies)]
        if outside:
            raise LastingContactError(
                f"'{self._cores[outside[0]].name}' at {time!r} s: it moves in contact with other "
                "moving bodies while one that is not in contact pulls it, which located contacts "
                "do not cover (IM18). End the run before, take method=Stepped(), or change the "
                "scene.",
                time=time,
            )

    def _stands(self, noise: Callable[[Contact], float]) -> bool:
        """Whether nothing moves, and forces within the friction cones keep it so."""
        if not any(patch.coefficient for patch in self._patches):
            return False
        contacts = [contact for patch in self._patches for contact in patch.contacts]
        unseen = max(noise(contact) for contact in contacts) + self._unseen_speed
        for i in self.bodies:
            state = self._states[i]
            turning = state.angular_velocity * self._cores[i].size
            if max(map(abs, (*state.velocity, turning))) > unseen:
                return False
        edges = rows_of(cone_edges(self._sticking()), self.bodies)
        size = np.array([(1.0, 1.0, self._cores[i].size) for i in self.bodies]).ravel()
        pushes = self._mobility.moved(edges, self.bodies) * size
        loads = np.array([self._free[i] for i in self.bodies]).ravel() * size
        return forces(pushes.T, loads) is not None

    def _sticking(self) -> Mode:
        return tuple(Part(patch, patch.contacts, patch.sense) for patch in self._patches)

    def _rest(self) -> None:
        self._rests = True
        self._mode = self._sticking()
        self.accelerations = dict.fromkeys(self.bodies, _STILL)
        self._pressed = [contact for patch in self._patches for contact in patch.contacts]
        self.lasting = self._pressed

    def _refuse_many(self) -> None:
        if len(self.bodies) > _MOST:
            raise LastingContactError(
                f"{named(*(self._cores[i].name for i in self.bodies[:2]))} and others at "
                f"{self._time!r} s: {len(self.bodies)} moving bodies in contact go on together, "
                f"more than {_MOST} (IM18). End the run before, take method=Stepped(), or change "
                "the scene.",
                time=self._time,
            )

    def _decide(self) -> None:
        """Find forces that obey Coulomb's law, and what they leave of the accelerations."""
        self._refuse_many()
        found = self._forces()
        if found is None:
            names = named(*(self._cores[i].name for i in self.bodies))
            raise JammedError(names, self._patches, self._placed, self._free, time=self._time)
        mode = tuple(
            self._part(patch, pushes, drag)
            for patch, (pushes, drag) in zip(self._patches, found, strict=True)
        )
        mode = self._held_by_others(mode, [drag for _, drag in found])
        by = self._accelerated(mode)
        closed_parts = [self._with_unpressed(part, by) for part in mode]
        self._mode = tuple(part for part in closed_parts if part.pressed)
        self.accelerations = by
        self._pressed = self.lasting = [c for part in self._mode for c in part.pressed]

    def _part(self, patch: Patch, pushes: Array, drag: float) -> Part:
        """Return what a patch does by the forces on it: a drag at its bound is that of sliding."""
        least = _PRESSED * self._largest
        pressed = tuple(c for c, push in zip(patch.contacts, pushes, strict=True) if push > least)
        sense = patch.sense
        if pressed and not sense and patch.coefficient:
            bound = float(friction.friction_force_most(pushes.sum(), patch.coefficient))
            if abs(drag) >= bound * (1 - _PRESSED) - least:
                sense = -int(math.copysign(1, drag))
        return Part(patch, pressed, sense)

    def _held_by_others(self, mode: Mode, drags: Sequence[float]) -> Mode:
        """Return a mode without the friction of pairs that need none, as others hold them.

        As where boxes touch beside a floor: any drag would go with it, and another motion with
        each, for what slides elsewhere is pressed by it.
        """
        for k, drag in enumerate(drags):
            part = mode[k]
            if part.sticks and abs(drag) <= _PRESSED * self._largest:
                smooth = part._replace(patch=part.patch._replace(coefficient=0.0))
                others = (*mode[:k], smooth, *mode[k + 1 :])
                if self._holds(others, tangent_of(part.pressed[0])):
                    mode = others
        return mode

    def _holds(self, mode: Mode, tangent: Contact) -> bool:
        """Return whether bodies cannot move along a tangent where contacts stay closed."""
        rows = self._weighted(closed_directions(closed(mode)))
        (row,) = self._weighted([tangent])
        left = row - np.linalg.lstsq(rows.T, row)[0] @ rows
        return bool(np.abs(left).max() <= _HELD * np.abs(row).max())

    def _weighted(self, directions: Sequence[Contact]) -> Array:
        """Return rows with weights with which light and heavy bodies count alike."""
        rows = rows_of(directions, self.bodies)
        weights = np.sqrt(inverse_masses(self._cores, self.bodies))
        if not self._jointed:
            return rows * weights
        moved = self._mobility.moved(rows, self.bodies)  # without what the joints hold
        return np.divide(moved, weights, out=np.zeros_like(moved), where=weights > 0)

    def _with_unpressed(self, part: Part, by: Mapping[int, Acceleration]) -> Part:
        """Return a part with the contacts that neither press nor open; those rub on nothing."""
        staying = tuple(
            contact
            for contact in part.patch.contacts
            if contact in part.pressed
            or contact_acceleration(contact, False, self._placed, by) <= self._unseen
        )
        patch = part.patch if part.pressed else part.patch._replace(coefficient=0.0)
        return part._replace(patch=patch, pressed=staying)

    def _accelerated(self, mode: Mode) -> dict[int, Acceleration]:
        rows = closed(mode)
        jacobian = rows_of(closed_directions(rows), self.bodies)
        pushes = self._mobility.moved(rows_of(force_directions(mode), self.bodies), self.bodies)
        loads = np.array(
            [contact_acceleration(c, along, self._placed, self._free) for c, along in rows]
        )
        free = np.array([self._free[i] for i in self.bodies])
        size = self._mobility.sizes(jacobian, self.bodies)
        found = least_forces(jacobian, pushes, size, loads, self._mobility.redundant(self.bodies))
        after = free + (found @ pushes).reshape(-1, 3)
        return {
            i: (x, y, turn) for i, (x, y, turn) in zip(self.bodies, after.tolist(), strict=True)
        }

    def _forces(self) -> list[tuple[Array, float]] | None:
        """Return the pushes at the contacts of each patch, N, and the drag along its tangent.

        It is the complementarity of pushes with normal accelerations, and of drags within
        Coulomb's bound with tangential ones, where a patch sticks or may begin to slide.
        """
        problem = ForceProblem(self._mobility, self.bodies, self._patches)
        found = problem.solved(problem.loads(self._placed, self._free))
        if found is None:
            return None
        pushes, drags = found
        self._largest = float(np.abs(pushes).max(initial=0.0))
        result, place = [], 0
        for patch in self._patches:
            count = len(patch.contacts)
            drag = drags[problem.sticking.index(patch)] if patch in problem.sticking else 0.0
            result.append((pushes[place : place + count], float(drag)))
            place += count
        return result


def _pair(contacts: Sequence[Contact]) -> tuple[int, int]:
    return contacts[0].a, contacts[0].b


def _senses(mode: Mode) -> dict[tuple[int, int], int]:
    rough = [part for part in mode if part.pressed and part.patch.coefficient]
    return {(part.pressed[0].a, part.pressed[0].b): part.sense for part in rough}
