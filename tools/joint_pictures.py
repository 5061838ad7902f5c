"""The picture of all kinds of joints: `python -m tools.joint_pictures` makes it anew."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import tamias2d as t2
from tamias2d.record.plot import draw_world, figure_for, save_figure
from tools.pictures import PICTURES

if TYPE_CHECKING:
    from tamias2d.scene.joint_kinds import JointKind

PICTURE = PICTURES / "joints.png"
COLUMNS = 4
DURATION = 0.5  # s


def kinds() -> dict[str, t2.Scene]:
    """Return a scene of one joint for each kind."""
    stops = t2.Limits(lower=-0.8, upper=0.8, restitution=0.3)
    spring = t2.JointSpring(stiffness=40.0, damping=1.0)
    motor = t2.Motor(speed=4.0, maximum=5.0)
    return {
        "Revolute()": hung(t2.Revolute(), box(0.5), anchor=(-0.5, 0.0)),
        "Revolute(limits=...)": hung(t2.Revolute(limits=stops), box(0.5), anchor=(-0.5, 0.0)),
        "Distance()": hung(t2.Distance(), disc(0.8, -0.3)),
        "Distance(limits=...): a rope": hung(
            t2.Distance(limits=t2.Limits(upper=1.0, restitution=0.3)), disc(0.4, -0.3)
        ),
        "Distance(spring=...)": hung(t2.Distance(spring=spring), disc(0.3, -0.8)),
        "Weld()": two(t2.Weld(), anchor=(0.5, 0.0), other_anchor=(-0.5, 0.0)),
        "Prismatic(limits=...)": hung(
            t2.Prismatic(axis=(1.0, -0.6), limits=t2.Limits(lower=0, upper=0.9, restitution=0.3)),
            box(0.0, width=0.3),
        ),
        "Groove()": hung(t2.Groove(axis=(1.0, -0.6)), disc(0.2, -0.12)),
        "Wheel(spring=..., motor=...)": hung(
            t2.Wheel(axis=(0.0, 1.0), spring=spring, limits=stops, motor=motor), disc(0.0, -0.5)
        ),
        "Rotary(spring=...)": two(t2.Rotary(spring=t2.JointSpring(stiffness=8.0, rest=0.0))),
        "Ratchet(pitch=...)": ratchet(),
        "Gear(ratio=-1)": geared(),
        "Pulley(posts=...)": pulley(),
        "Equation('y - x**2')": bead(),
        "break_force=...": hung(t2.Distance(), disc(1.0, 0.0), bears=9.0),
        "add_spring(...)": sprung(),
    }


def scene() -> t2.Scene:
    """Return an empty scene with gravity."""
    return t2.Scene(gravity=(0.0, -9.81))


def box(x: float, *, width: float = 1.0) -> dict[str, Any]:
    """Return a box as `add_body` takes it."""
    return {"shape": t2.Box(width=width, height=0.15), "position": (x, 0.0)}


def disc(x: float, y: float) -> dict[str, Any]:
    """Return a disc as `add_body` takes it."""
    return {"shape": t2.Disc(radius=0.2), "position": (x, y), "angular_velocity": 0.0}


def hung(
    kind: JointKind,
    body: dict[str, Any],
    *,
    anchor: tuple[float, float] = (0.0, 0.0),
    bears: float | None = None,
) -> t2.Scene:
    """Return a body that a joint holds at the origin."""
    made = scene()
    made.add_body(body.pop("shape"), mass=1.0, name="body", **body)
    made.add_joint(kind, (0.0, 0.0), "body", other_anchor=anchor, break_force=bears)
    return made


def two(
    kind: JointKind,
    *,
    anchor: tuple[float, float] = (0.0, 0.0),
    other_anchor: tuple[float, float] = (0.0, 0.0),
) -> t2.Scene:
    """Return two boxes that a joint holds to each other."""
    made = scene()
    for name, x in (("one", 0.0), ("other", 1.0)):
        made.add_body(t2.Box(width=1.0, height=0.15), mass=1.0, position=(x, 0.0), name=name)
    made.add_joint(t2.Revolute(), (-0.5, 0.0), "one", other_anchor=(-0.5, 0.0))
    made.add_joint(kind, "one", "other", anchor=anchor, other_anchor=other_anchor)
    return made


def ratchet() -> t2.Scene:
    """Return an arm that is thrown up and falls back to the last tooth."""
    made = scene()
    made.add_body(
        t2.Box(width=1.0, height=0.15),
        mass=1.0,
        position=(0.5, 0.0),
        velocity=(0.0, 2.0),
        angular_velocity=4.0,
        name="arm",
    )
    made.add_joint(t2.Revolute(), (0.0, 0.0), "arm", other_anchor=(-0.5, 0.0))
    made.add_joint(t2.Ratchet(pitch=0.2, restitution=0.0), (0.0, 0.0), "arm")
    return made


def geared() -> t2.Scene:
    """Return two wheels of which one drives the other."""
    made = scene()
    for name, x, torque in (("driving", 0.0, 1.0), ("driven", 0.8, 0.0)):
        made.add_body(t2.Disc(radius=0.4), mass=1.0, position=(x, 0.0), torque=torque, name=name)
        made.add_joint(t2.Revolute(), (x, 0.0), name)
    made.add_joint(t2.Gear(ratio=-1.0), "driving", "driven")
    return made


def pulley() -> t2.Scene:
    """Return two discs on a rope."""
    made = scene()
    for name, x, mass in (("heavy", 0.0, 2.0), ("light", 1.0, 1.0)):
        made.add_body(t2.Disc(radius=0.2), mass=mass, position=(x, -1.0), name=name)
    made.add_joint(t2.Pulley(posts=[(0.0, 0.3), (1.0, 0.3)]), "heavy", "light")
    return made


def bead() -> t2.Scene:
    """Return a bead on a wire that is stated by its equation."""
    made = scene()
    made.add_body(t2.Disc(radius=0.05), mass=1.0, position=(0.8, 0.64), name="bead")
    made.add_joint(t2.Equation("y(position_a)*1[m] - x(position_a)**2"), "bead")
    return made


def sprung() -> t2.Scene:
    """Return a disc on a spring of the scene."""
    made = scene()
    made.add_body(t2.Disc(radius=0.2), mass=1.0, position=(0.3, -0.8), name="body")
    made.add_spring("body", (0.0, 0.0), stiffness=40.0, rest_length=0.6)
    return made


def main() -> None:
    """Make the picture."""
    found = kinds()
    figure = figure_for(PICTURE)
    rows = -(-len(found) // COLUMNS)
    figure.set_size_inches(11, 2.6 * rows)
    for k, (words, made) in enumerate(found.items(), start=1):
        axes = figure.add_subplot(rows, COLUMNS, k)
        draw_world(axes, t2.simulate(made, duration=DURATION))
        axes.set(title=words, xlabel="", ylabel="", xticks=[], yticks=[])
    save_figure(figure, PICTURE)


if __name__ == "__main__":
    main()
