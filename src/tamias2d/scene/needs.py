"""The needs of a scene: states, terms, models and methods, each with the reason for or against it.

A scene pays only for the physics that it needs, and can say why.
"""

from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Literal

from tamias2d.scene.acting import groups, varying_laws, varying_loads
from tamias2d.scene.bodies import Body
from tamias2d.scene.exact import closed_forms
from tamias2d.scene.joints import Joint
from tamias2d.scene.reach import pairs_that_can_meet
from tamias2d.scene.rules import number
from tamias2d.scene.scene import Scene
from tamias2d.scene.scene_data import checked_scene
from tamias2d.scene.shapes import Disc
from tamias2d.scene.surfaces import surface_values
from tamias2d.suggestions import suggests

_TURNED = {"orientation", "angular_velocity"}
_SMOOTH = "no body states friction (A6)"

NeedKind = Literal["state", "term", "model", "method"]


@dataclass(frozen=True)
class Need:
    """One thing that physics offers, and why a scene needs it or does not."""

    what: str
    kind: NeedKind
    needed: bool
    reason: str


@dataclass(frozen=True)
class Needs:
    """All that a scene was asked about, and the pairs of bodies whose bounds can meet."""

    entries: tuple[Need, ...]
    pairs: tuple[tuple[int, int], ...]

    def __contains__(self, what: object) -> bool:
        """Whether something is needed, by its name: ``"rotation (IM2)" in needs(scene)``."""
        return any(entry.what == what and entry.needed for entry in self.entries)


@suggests
def needs(scene: Scene, duration: float | None = None) -> Needs:
    """Return what a scene needs within a duration in s (the scene's own unless given).

    Raises:
        InputError: neither states a duration.
    """
    remedy = "Give a positive duration in s."
    span = checked_scene(scene).duration if duration is None else duration
    span = number(span, "duration", "the scene", remedy, at=("duration",))
    pairs = tuple(pairs_that_can_meet(scene, span))
    return Needs(tuple(_Inquiry(scene, span, pairs).entries()), pairs)


@dataclass(frozen=True)
class _Inquiry:
    scene: Scene
    duration: float
    pairs: tuple[tuple[int, int], ...]

    def entries(self) -> Iterator[Need]:
        yield from self.states()
        yield from self.terms()
        yield from self.models()
        yield from self.methods()

    def states(self) -> Iterator[Need]:
        yield Need("position, velocity", "state", *self.moves())
        yield Need("orientation, angular velocity", "state", *self.turns())

    def terms(self) -> Iterator[Need]:
        """The forces that act, and those that do not."""
        gravity = self.scene.gravity != (0, 0)
        felt = gravity and bool(self.moving)
        why = "no body moves" if gravity else "the scene has no gravity"
        x, y = self.scene.gravity
        yield Need("gravity (GD2)", "term", felt, f"({x:g}, {y:g}) m/s^2 acts" if felt else why)
        pushed = [body for body in self.moving if body.force != (0, 0)]
        yield _about("applied force", "term", pushed, "pushed", "no force is applied to any body")
        twisted = [body for body in self.moving if body.torque != 0]
        yield _about(
            "applied torque", "term", twisted, "twisted", "no torque is applied to any body"
        )
        yield from self.acting()

    def acting(self) -> Iterator[Need]:
        """Yield what acts on bodies by a law: attraction, drag, springs and fields."""
        yield Need("attraction between bodies (IM5)", "term", *self.attracts())
        for key in ("linear_drag", "quadratic_drag", "angular_drag"):
            words = key.replace("_", " ")
            slowed = [body for body in self.moving if getattr(body, key)]
            article = "an" if key == "angular_drag" else "a"
            yield _about(
                f"{words} (IM6)", "term", slowed, "slowed", f"no body has {article} {words}"
            )
        held = self._bodies({k for spring in self.scene.springs for k in spring.bodies})
        yield _about("springs and dampers (IM7)", "term", held, "held", "the scene has no spring")
        tied = self._bodies({k for joint in self.scene.joints for k in joint.bodies})
        yield _about("joints (TM7, GD17)", "term", tied, "tied", "the scene has no joint")
        reached = self._bodies(
            {k for k in range(len(self.scene)) for f in self.scene.fields if f.acts_on(k)}
        )
        yield _about("force fields (IM8)", "term", reached, "in a field", "the scene has no field")

    def models(self) -> Iterator[Need]:
        """Yield the models that motion, joints and contacts ask for."""
        yield Need("translation (IM1)", "model", *self.moves())
        yield Need("rotation (IM2)", "model", *self.turns())
        solid = [body for body in self.scene.bodies if body.shape is not None]
        compared = len(solid) > 1 and any(body.dynamic for body in solid)
        for word, own in self.tied().items():
            yield Need(f"{word} joint (R13)", "model", True, f"{_named(own)} tied by it")
        if self.scene.joints:
            yield from self.governed()
        yield Need("detection (IM4)", "model", compared, self.compared(len(solid)))
        yield Need("impact (IM3)", "model", bool(self.pairs), self.meeting())
        yield Need("impacts that act together (A18)", "model", *self.acts_together())
        yield Need("resting contact (GD3)", "model", *self.rests())
        yield Need("friction (IM9, GD8)", "model", *self.rubs())
        running = [body for body in self.scene.bodies if body.surface_speed]
        if running:
            yield Need("surfaces that run (DD97)", "model", True, f"{_named(running)} a belt")

    def methods(self) -> Iterator[Need]:
        yield Need("closed form", "method", *self.solved())
        yield Need("integration of the equations of motion", "method", *self.integrated())
        yield Need("integration of bodies together", "method", *self.coupled())
        yield Need("location of impacts", "method", bool(self.pairs), self.meeting())

    @property
    def moving(self) -> list[Body]:
        return [body for body in self.scene.bodies if body.dynamic]

    def _bodies(self, chosen: set[int]) -> list[Body]:
        return [body for k, body in enumerate(self.scene.bodies) if k in chosen and body.dynamic]

    @property
    def unsolvable(self) -> dict[int, str]:
        """Why there is no closed form, for each body that has none."""
        solved = closed_forms(self.scene)
        return {k: why for k, why in varying_loads(self.scene).items() if k not in solved}

    def solved(self) -> tuple[bool, str]:
        if not self.moving:
            return False, "no body moves"
        if self.unsolvable:
            return False, self.unsolved()
        forms = dict.fromkeys(closed_forms(self.scene).values())
        if list(forms) == ["constant loads"]:
            return True, "every force and torque is constant"
        return True, f"every body has one: {', '.join(forms)}"

    def integrated(self) -> tuple[bool, str]:
        return bool(self.unsolvable), self.unsolved() if self.unsolvable else self.solved()[1]

    def unsolved(self) -> str:
        first, *others = self.unsolvable.items()
        more = f", and {len(others)} more have no closed form" if others else ""
        return f"'{self.scene.bodies[first[0]].name}' is {first[1]}{more}"

    def coupled(self) -> tuple[bool, str]:
        groups_ = [group for group in groups(self.scene) if len(group) > 1]
        if not groups_:
            return False, "nothing but contact acts between bodies"
        names = " and ".join(f"'{self.scene.bodies[k].name}'" for k in groups_[0][:2])
        return True, f"{names} act on each other, in a group of {len(groups_[0])}"

    def attracts(self) -> tuple[bool, str]:
        constant = self.scene.attraction
        if constant is None:
            return False, "the scene states no attraction"
        if len(self.moving) < 2:
            return False, "there is no second body that moves"
        return True, f"{len(self.moving)} bodies attract each other, G = {constant:g} m^3/(kg s^2)"

    def moves(self) -> tuple[bool, str]:
        count = len(self.moving)
        return count > 0, f"{count} of {len(self.scene)} bodies can move"

    def turns(self) -> tuple[bool, str]:
        """Whether anything can turn a body, and what."""
        twisted = {k for s in self.scene.springs for k, anchor in s.ends if anchor != (0, 0)}
        twisted |= {k for joint in self.scene.joints for k in joint.bodies}
        for field in self.scene.fields:
            if field.torque != 0:
                twisted |= {k for k in range(len(self.scene)) if field.acts_on(k)}
        pulled = [body for body in self._bodies(twisted) if body.inverse_inertia]
        spun = [body for body in self.moving if body.angular_velocity != 0 or body.torque != 0]
        spun += [body for body in pulled if body not in spun]
        if spun:
            return True, f"{_named(spun)} spun or twisted from the start"
        cornered = [
            body
            for body in self.moving
            if body.inverse_inertia and not isinstance(body.shape, Disc)
        ]
        if self.pairs and cornered:
            return True, f"{_named(cornered)} turned when hit beside the centre of mass"
        if self.pairs and self.rough and any(body.inverse_inertia for body in self.moving):
            return True, f"{_named(self.rough)} rough, and friction turns what touches"
        asked = {k for laws in self.laws() if laws[1] & _TURNED for k in laws[0]}
        if asked:
            return True, f"{_named(self._bodies(asked))} under a law of how it is turned"
        idle = "no body has a torque or a spin"
        if not self.pairs:
            return False, f"{idle}, and none can be hit"
        return False, f"{idle}, and a disc is hit through its centre (no friction, A6)"

    def tied(self) -> dict[str, list[Body]]:
        """Return the bodies that joints of each kind hold."""
        found: dict[str, set[int]] = {}
        for joint in self.scene.joints:
            found.setdefault(joint.kind, set()).update(joint.bodies)
        return {word: self._bodies(held) for word, held in found.items()}

    def governed(self) -> Iterator[Need]:
        """What joints do besides keeping what they keep."""
        joints = self.scene.joints
        for what, verb, own in (
            ("limits of joints (GD21)", "limited", [j for j in joints if _has(j, "limits")]),
            ("motors of joints (GD22)", "driven", [j for j in joints if _has(j, "motor")]),
            ("springs in joints (DD64, DD65)", "sprung", [j for j in joints if _has(j, "spring")]),
            ("breaking of joints (GD23)", "able to break", [j for j in joints if j.breaks]),
        ):
            first = f"joint '{own[0].name}'" if own else ""
            others = "is" if len(own) == 1 else f"and {len(own) - 1} more are"
            found = f"{first} {others} {verb}" if own else f"no joint is {verb}"
            yield Need(what, "model", bool(own), found)

    @property
    def rough(self) -> list[Body]:
        """The bodies with friction, of their own or as one of a pair; static ones too."""
        paired = {k for pair, value in self.scene.friction_of_pairs.items() if value for k in pair}
        return [
            body
            for k, body in enumerate(self.scene.bodies)
            if k in paired or any(surface_values(body, "friction"))
        ]

    def rubs(self) -> tuple[bool, str]:
        if not self.pairs:
            return False, self.meeting()
        return bool(self.rough), f"{_named(self.rough)} rough" if self.rough else _SMOOTH

    def laws(self) -> list[tuple[list[int], frozenset[str]]]:
        """Return the bodies that share a law that varies, and the names in it, for each law."""
        moving = [k for k, body in enumerate(self.scene.bodies) if body.dynamic]
        return [
            ([moving[row] for row in rows], law.names)
            for (_, law), rows in varying_laws(self.scene, moving).items()
        ]

    def compared(self, solid: int) -> str:
        if solid < 2:
            return f"{solid} body has a shape: there is no pair" if solid else "no body has a shape"
        return f"{solid} bodies have shapes"

    def meeting(self) -> str:
        if not self.pairs:
            return f"no two bounds meet within {self.duration:g} s"
        i, j = self.pairs[0]
        names = f"'{self.scene.bodies[i].name}' and '{self.scene.bodies[j].name}'"
        others = len(self.pairs) - 1
        more = f", and of {others} more pair{'s' * (others > 1)}," if others else ""
        return f"the bounds of {names}{more} meet within {self.duration:g} s"

    def acts_together(self) -> tuple[bool, str]:
        """Return whether one that is struck may touch another: the rule that decides then."""
        if not self.pairs:
            return False, self.meeting()
        partners = Counter(k for pair in self.pairs for k in pair if self.scene.bodies[k].dynamic)
        shared = next((k for k, count in partners.items() if count > 1), None)
        if shared is None:
            return False, "no body can meet two others"
        name = self.scene.bodies[shared].name
        return True, f"'{name}' may be struck while it touches another: then a rule decides"

    def rests(self) -> tuple[bool, str]:
        scene = self.scene
        acts = bool(scene.springs or scene.fields or scene.attraction)
        pushed = any(body.force != (0, 0) for body in self.moving)
        loaded = scene.gravity != (0, 0) or pushed or acts
        if not self.pairs:
            return False, self.meeting()
        if not loaded:
            return False, "nothing presses bodies together: those that touch exert no force"
        return True, "bodies that can meet are pressed together by gravity or a force"


def _has(joint: Joint, part: str) -> bool:
    return any(getattr(freedom, part) is not None for freedom in joint.freedoms)


def _about(what: str, kind: NeedKind, bodies: list[Body], verb: str, otherwise: str) -> Need:
    return Need(what, kind, bool(bodies), f"{_named(bodies)} {verb}" if bodies else otherwise)


def _named(bodies: list[Body]) -> str:
    """Name one body, count the others, and add the verb: ``'crate' and 3 more are``."""
    first = f"'{bodies[0].name}'"
    return f"{first} is" if len(bodies) == 1 else f"{first} and {len(bodies) - 1} more are"
