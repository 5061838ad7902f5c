"""Force fields: a law of a user's own, for all bodies that move or for some (IM8)."""

from collections.abc import Sequence
from dataclasses import dataclass

from tamias2d.scene.bodies import Body
from tamias2d.scene.law import Law, checked_force, checked_law, first_value, varies
from tamias2d.scene.rules import RuleError
from tamias2d.suggestions import suggests


@suggests
@dataclass(frozen=True, kw_only=True)
class ForceField:
    """One field of a scene, checked; made by `Scene.add_field`."""

    force: tuple[Law, Law] = (0.0, 0.0)
    """On each body, N; numbers, or laws of time and of the body's state and mass."""
    torque: Law = 0.0
    """On each body, N m; likewise. What has no inertia is not turned."""
    bodies: tuple[int, ...] | None = None
    """Those on which it acts; None for all that move."""

    @property
    def constant(self) -> bool:
        """Whether it does to each body the same at all times."""
        return not any(varies(law) for law in (*self.force, self.torque))

    def acts_on(self, body: int) -> bool:
        """Whether it acts on a body that moves, given by its index."""
        return self.bodies is None or body in self.bodies


def checked_field(
    force: object, torque: object, bodies: tuple[int, ...] | None, of: str
) -> ForceField:
    """Return a field with good laws, or raise `RuleError`."""
    if force is None and torque is None:
        raise RuleError(f"{of}: found neither force nor torque (IM8). State one of them.", "force")
    return ForceField(
        force=(0.0, 0.0) if force is None else checked_force(force, of),
        torque=0.0 if torque is None else checked_law(torque, "torque", of, at=("torque",)),
        bodies=bodies,
    )


def refuse_field(field: ForceField, bodies: Sequence[Body], of: str) -> None:
    """Refuse a field of bodies that stand still, or that has no value where a body starts."""
    if field.bodies == ():
        raise RuleError(
            f"bodies of {of}: found none (IM8). Name some, or leave them out.", "bodies"
        )
    for k in field.bodies or ():
        if not bodies[k].dynamic:
            raise RuleError(
                f"bodies of {of}: '{bodies[k].name}' is static (IM8). Name bodies that move.",
                "bodies",
            )
    for k, body in enumerate(bodies):
        if body.dynamic and field.acts_on(k):
            for component, law in enumerate(field.force):
                first_value(law, body.start, at=("force", component))
            first_value(field.torque, body.start, at=("torque",))
