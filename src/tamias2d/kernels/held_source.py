"""The source of the accelerations of bodies that joints hold, and of their return to the joints.

Serves: the maker of steps. Hides: how the reactions of mechanisms are put among the forces on all
bodies of a group. Mechanisms of one demand share their functions; each has tables of its own.
"""

from dataclasses import dataclass

from tamias2d.kernels.force_demand import ForceDemand
from tamias2d.kernels.force_source import arguments as tables_of_forces, source as forces
from tamias2d.kernels.joint_source import (
    DOUBTED,
    JointDemand,
    functions,
    tables_of as tables_of_joints,
)

STATE = ("columns", "place", "speed", "pull", "multipliers")
"""Tables of each mechanism before its own: the columns of its bodies among those of all, rows to
work on, and the multipliers."""
_HELD = '''def gather(columns, row, part):
    """Set a part of a row."""
    for j in range(len(columns)):
        part[j] = row[columns[j]]


def scatter(columns, part, row):
    """Set a row where a part of it stands."""
    for j in range(len(columns)):
        row[columns[j]] = part[j]


def reacted(time, position, velocity, rate, {state}, {joints}):
    """Add what joints give to the accelerations of all bodies; return whether that is known."""
    gather(columns, position, place)
    gather(columns, velocity, speed)
    gather(columns, rate, pull)
    known = react(time, place, speed, pull, multipliers, {joints}) != {doubted}
    scatter(columns, pull, rate)
    return known


def returned(time, position, velocity, {state}, {joints}):
    """Move bodies to where joints hold them; return whether that is known."""
    gather(columns, position, place)
    gather(columns, velocity, speed)
    known = fit(time, place, speed, multipliers, {joints}) != {doubted}
    scatter(columns, place, position)
    scatter(columns, speed, velocity)
    return known


def held_accelerations(time, position, velocity, rate, {tables}):
    """Fill accelerations by forces and joints; return whether all of them are known."""
    known = accelerations(time, position, velocity, rate, {forces})
{reactions}
    return known


def fitted(time, position, velocity, {held}):
    """Move all bodies to where joints hold them; return whether that is known."""
    known = True
{returns}
    return known'''
_DRIFTED = '''def drifted(time, duration, position, velocity, {held}):
    """Move bodies along velocities to where joints hold them; return whether that is known."""
    known = True
{gathered}
    for j in range(len(position)):
        position[j] = position[j] + duration * velocity[j]
{drifts}
    return known'''


@dataclass(frozen=True)
class HeldDemand:
    """What acts on some bodies, and some mechanisms of one kind that hold them."""

    forces: ForceDemand
    joints: JointDemand
    mechanisms: int

    def __str__(self) -> str:
        """What acts, in words."""
        return f"{self.forces}; {self.mechanisms} times joints: {self.joints}"


def held_tables(demand: HeldDemand) -> list[str]:
    """Return the names of the tables of all mechanisms, in order."""
    each = (*STATE, *tables_of_joints(demand.joints))
    return [f"held_{m}_{name}" for m in range(demand.mechanisms) for name in each]


def source(demand: HeldDemand, *, drifting: bool) -> tuple[list[str], list[str]]:
    """Return the functions of forces and joints, those for all bodies last, and their imports."""
    count = range(demand.mechanisms)
    joints = tables_of_joints(demand.joints)
    own = [", ".join(f"held_{m}_{name}" for name in (*STATE, *joints)) for m in count]
    tables = [", ".join(f"held_{m}_{name}" for name in joints) for m in count]
    parts = [[f"held_{m}_{name}" for name in STATE] for m in count]
    known = "    known = known and"
    react, back = "reacted(time, position, velocity, rate,", "returned(time, position, velocity,"
    names = {
        "state": ", ".join(STATE),
        "joints": ", ".join(joints),
        "forces": ", ".join(tables_of_forces(demand.forces)),
        "held": ", ".join(held_tables(demand)),
        "tables": ", ".join([*tables_of_forces(demand.forces), *held_tables(demand)]),
        "doubted": DOUBTED,
        "reactions": "\n".join(f"{known} {react} {each})" for each in own),
        "returns": "\n".join(f"{known} {back} {each})" for each in own),
        "gathered": "\n".join(
            f"    gather({at}, position, {place})\n    gather({at}, velocity, {speed})"
            for at, place, speed, *_ in parts
        ),
        "drifts": "\n".join(
            f"{known} drift(time, duration, {place}, {speed}, {shares}, {each}) != {DOUBTED}\n"
            f"    scatter({at}, {place}, position)\n    scatter({at}, {speed}, velocity)"
            for (at, place, speed, _, shares), each in zip(parts, tables, strict=True)
        ),
    }
    acting, first = forces(demand.forces)
    holding, second = functions(demand.joints, drifting=drifting)
    templates = [*_HELD.split("\n\n\n"), *([_DRIFTED] if drifting else [])]
    made = [template.format(**names) for template in templates]
    return list(dict.fromkeys([*acting, *holding, *made])), [*first, *second]
