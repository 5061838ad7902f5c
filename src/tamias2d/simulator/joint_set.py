"""The joints of a simulator: which there are, what the engine is told, and what they did.

Serves: the frame loop. Hides: that the engine knows joints by their places, which change as joints
come and go, and in which order it takes them: the same in whatever order they came.
"""

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import asdict, dataclass, replace
from typing import Any, cast

import numpy as np
from numpy.typing import NDArray

from tamias2d.engine import tables as tb
from tamias2d.engine.engine import Engine
from tamias2d.engine.joints.joint_row import JointRow
from tamias2d.engine.joints.placement import PULLED
from tamias2d.engine.joints.rows import mechanism_of, move_anchor
from tamias2d.engine.saved_checks import require
from tamias2d.generated.constraints import CONSTRAINTS
from tamias2d.generated.joint_rows import KINDS, MOST_ROWS
from tamias2d.read_only import read_only
from tamias2d.scene.bodies import Body
from tamias2d.scene.freedoms import Freedom, JointSpring, Limits, Motor
from tamias2d.scene.joint_checks import checked_joint
from tamias2d.scene.joint_kinds import Equation
from tamias2d.scene.joints import OWN_EQUATION, End, Joint
from tamias2d.scene.rules import RuleError, Vector, shown
from tamias2d.scene.springs import arm
from tamias2d.simulator.told_only import REMEDIES
from tamias2d.spec.constraint import ENDS
from tamias2d.state import Array, IntArray

_KEPT = slice(tb.J_STEP_TOTAL, tb.J_SCALE + 1)  # numbers of a joint that a step leaves to the next
_COUNT = _KEPT.stop - _KEPT.start
_PULLED = tb.J_PULLED - tb.J_STEP_TOTAL
STIFFEST = 2.0**29  # of a spring, times the squared step, over mass or inertia
APART = 1e-3
"""Of the size of a joint, or rad: one that is farther apart is told."""


@dataclass(frozen=True, kw_only=True)
class Reactions:
    """What the j joints of a simulator exerted in its last step, and how well they hold.

    Impulses and forces are told as they act on each of the bodies A, B and C; where there is no
    such body, on the plane. Where joints depend on each other, their shares of the load are those
    of equally firm ones.
    """

    names: tuple[str, ...]
    """Of the joints, as they were added."""
    impulse: Array
    """(j, 3, 2), over the step, N s"""
    force: Array
    """(j, 3, 2), the mean over the step, N"""
    torque: Array
    """(j, 3), likewise, about the anchor, N m"""
    separation: Array
    """(j,), by how much the joint is apart now, m"""
    angular_separation: Array
    """(j,), by how much it is turned against what it keeps, rad"""

    def index(self, name: str) -> int:
        """Return the place of a joint; raise `ValueError` if there is none of that name."""
        return self.names.index(name)


class JointSet:
    """Joints by their names."""

    def __init__(self, joints: Iterable[Joint] = ()) -> None:
        """Hold the joints of a scene, or those that were saved."""
        self._joints = {joint.name: joint for joint in joints}
        refuse_unknown(self._joints.values())
        self._places = np.zeros(0, dtype=np.int64)  # of rows in the arrays, as joints were added
        self._owner = np.zeros(0, dtype=np.int64)  # of each row its joint
        self._rows_of: dict[str, list[tuple[int, JointRow]]] = {}  # with their places
        self._alike: set[str] = set()  # of those whose order their anchors decide
        self._are_lengths = np.zeros((0, MOST_ROWS), dtype=bool)
        self._sizes = np.ones(0)
        self._saved: Array | None = None  # impulses of the last step, as long as it is from a file
        self._restored = False
        self.new = bool(self._joints)
        """Whether the engine has to be told of them."""

    def __len__(self) -> int:
        return len(self._joints)

    @property
    def names(self) -> tuple[str, ...]:
        """Of all joints, as they were added."""
        return tuple(self._joints)

    def add(
        self,
        kind: object,
        ends: tuple[End, End, End],
        anchors: tuple[object, object, object],
        name: str | None,
        collide: object,
        bodies: Sequence[Body],
    ) -> Joint:
        """Add a joint that fits the places of its bodies; what moves is made to fit by a step.

        Raises:
            RuleError: it breaks a rule, or its name is taken.
        """
        name = self._free_name(name)
        if isinstance(kind, Equation):
            raise _beyond_steps(name, "equation", OWN_EQUATION)
        joint = checked_joint(kind, name, ends, anchors, collide, bodies, at_rest=True)
        refuse_unknown([joint])
        self._joints[name] = joint
        self._change()
        return joint

    def remove(self, name: object) -> Joint:
        """Take a joint out, and return it; raise `RuleError` if there is none of that name."""
        joint = self._named(name)
        self._change()
        return self._joints.pop(joint.name)

    def _named(self, name: object) -> Joint:
        if not isinstance(name, str) or name not in self._joints:
            raise RuleError(
                f"joint {shown(name)}: the simulator has none such (R13). Name one of "
                f"{shown(list(self._joints))}.",
                "name",
            )
        return self._joints[name]

    def set_target(self, name: object, point: Vector, engine: Engine) -> Joint:
        """Move the point of the plane that a joint holds, m, and return it.

        Raises:
            RuleError: there is none of that name, or it holds no point of the plane, or two.
        """
        joint = self._named(name)
        held = [
            k
            for k, end in enumerate(ENDS)
            if joint.ends[k] is None and f"anchor_{end}" in joint.functions.parameters
        ]
        if len(held) != 1:
            raise RuleError(
                f"joint '{joint.name}' ({joint.kind}): it holds no point of the plane that could "
                "be moved (TM7). Name one that does, such as a Target().",
                "name",
            )
        anchors = list(joint.anchors)
        anchors[held[0]] = point
        self._joints[joint.name] = replace(joint, anchors=(anchors[0], anchors[1], anchors[2]))
        if joint.name in self._alike:
            self._change()
        if not self.new:
            joints = engine.world.joints
            for place, row in self._rows_of[joint.name]:
                move_anchor(engine, place, row.kind, ENDS[held[0]], point)
                if row.law != tb.SPRING:
                    first = joints.mechanisms[mechanism_of(engine, place), tb.M_JOINT]
                    joints.numbers[first, tb.J_PULLED] = PULLED
        return joint

    def drop_bodies(self, gone: set[int]) -> list[int]:
        """Take out the joints of bodies that leave; return the other bodies that these held."""
        left = [joint for joint in self._joints.values() if gone & set(joint.bodies)]
        for joint in left:
            del self._joints[joint.name]
        if left:
            self._change()
        return [body for joint in left for body in joint.bodies if body not in gone]

    def settle(self, engine: Engine) -> None:
        """Tell the engine which joints there are."""
        joints, rank = list(self._joints.values()), engine.rank
        rows = [(k, row) for k, joint in enumerate(joints) for row in joint_rows(joint)]
        order = sorted(range(len(rows)), key=lambda n: _place(rows[n][1], rank))
        places = engine.set_joints([rows[n][1] for n in order], restored=self._restored)
        self._owner = np.array([k for k, _ in rows], dtype=np.int64)
        self._places = np.zeros(len(rows), dtype=np.int64)
        self._places[order] = places
        self._rows_of = {}
        held: dict[tuple[Any, ...], set[str]] = {}
        for (k, row), place in zip(rows, self._places.tolist(), strict=True):
            self._rows_of.setdefault(joints[k].name, []).append((place, row))
            held.setdefault((row.ends, row.law, row.kind), set()).add(joints[k].name)
        self._alike = {name for own in held.values() if len(own) > 1 for name in own}
        sizes = np.array([_size(joint, engine) for joint in joints])
        units = np.array([_units(row) for _, row in rows]).reshape(-1, MOST_ROWS)
        self._are_lengths, self._sizes = units == "m", sizes[self._owner]
        size = np.where(self._are_lengths, self._sizes[:, None], 1.0)
        slight = slice(tb.J_SLIGHT, tb.J_SLIGHT + MOST_ROWS)
        engine.world.joints.numbers[self._places, slight] = APART / math.sqrt(MOST_ROWS) * size
        numbers = engine.world.joints.numbers
        if self._saved is not None and self._restored:
            numbers[self._places, _KEPT] = self._saved
        else:
            numbers[self._places, tb.J_PULLED] = self._pulled_apart(engine)[self._owner]
        firsts = engine.world.joints.mechanisms[self._mechanisms(engine), tb.M_JOINT]
        pulled = np.zeros(len(numbers))
        np.maximum.at(pulled, firsts, numbers[self._places, tb.J_PULLED])
        numbers[:, tb.J_PULLED] = pulled
        self.new = self._restored = False

    def _mechanisms(self, engine: Engine) -> IntArray:
        """Return the mechanism of each row."""
        joints = engine.world.joints
        starts = joints.mechanisms[: joints.counts[tb.MECHANISMS], tb.M_JOINT]
        return np.searchsorted(starts, self._places, side="right") - 1

    def _pulled_apart(self, engine: Engine) -> Array:
        """Return for how many substeps joints (j,) pull together what was moved since they came."""
        joints = list(self._joints.values())
        lengths, angles = _separations(joints, engine.pose)
        sizes = np.array([_size(joint, engine) for joint in joints])
        return np.where(np.maximum(lengths / sizes, angles) > APART, PULLED, 0.0)

    def _pulled_since(self, engine: Engine) -> Array:
        """Return for how many substeps rows follow what nothing pushes, moved since the step."""
        joints = engine.world.joints
        places, body = joints.places[:, tb.PLACE_X : tb.PLACE_ANGLE + 1], joints.members
        moved = (places != engine.pose[body[:, tb.JOINED_BODY]]).any(axis=1)
        moved[0] = False  # the plane
        ends = joints.joints[self._places]
        tied = ends[:, tb.J_NODE : tb.J_NODE + len(ENDS)] == tb.NOT_PUSHED
        members = ends[:, tb.J_MEMBER : tb.J_MEMBER + len(ENDS)]
        placed = joints.counts[tb.PLACED] == 1
        return np.where(placed & (tied & moved[members]).any(axis=1), PULLED, 0.0)

    def too_stiff(self, engine: Engine, time_step: float) -> tuple[Joint, float] | None:
        """Return a joint whose spring is too stiff for a step, s, and its stiffness; or None.

        Rounding, as many times as a step is long beside its swing, squared, is left of it.
        """
        for joint in self._joints.values():
            bodies = list(joint.bodies)
            for row in joint_rows(joint):
                long = _units(row)[0] == "m"
                inverse = (engine.inverse_mass if long else engine.inverse_inertia)[bodies]
                if (
                    row.law == tb.SPRING
                    and row.numbers[2] * time_step**2 * inverse.max() > STIFFEST
                ):
                    return joint, row.numbers[2]
        return None

    def apart(self, engine: Engine) -> tuple[Joint, float, bool] | None:
        """Return a joint that was far apart within the last steps, and by how much; or None.

        It is said, too, whether what it holds was moved by hand.
        """
        counts, numbers = engine.world.joints.counts, engine.world.joints.numbers
        if not counts[tb.JOINTS_APART]:
            return None
        counts[tb.JOINTS_APART] = 0
        found = numbers[self._places, tb.J_APART : tb.J_APART + MOST_ROWS]
        numbers[:, tb.J_APART : tb.J_APART + MOST_ROWS] = 0.0
        lengths = np.linalg.norm(np.where(self._are_lengths, found, 0.0), axis=1)
        angles = np.linalg.norm(np.where(self._are_lengths, 0.0, found), axis=1)
        shares = np.maximum(lengths / self._sizes, angles)
        worst = int(np.argmax(shares))
        if not shares[worst] > APART:
            return None
        is_length = lengths[worst] / self._sizes[worst] > angles[worst]
        far = lengths[worst] if is_length else angles[worst]
        first = engine.world.joints.mechanisms[self._mechanisms(engine)[worst], tb.M_JOINT]
        pulled = bool(numbers[first, tb.J_PULLED] > 0)
        return list(self._joints.values())[self._owner[worst]], float(far), pulled

    def turned(self, engine: Engine) -> Joint | None:
        """Return a joint that turned too far in a substep of the last steps; or None."""
        return self._worst_lately(engine, tb.JOINTS_TURNED, tb.J_TURNED)

    def gained(self, engine: Engine) -> Joint | None:
        """Return the first joint of what got energy, with what touches it, lately; or None."""
        return self._worst_lately(engine, tb.JOINTS_GAINED, tb.J_GAINED)

    def _worst_lately(self, engine: Engine, count: int, column: int) -> Joint | None:
        """Return the joint with the largest number in a column since it was asked, if any has."""
        counts, numbers = engine.world.joints.counts, engine.world.joints.numbers
        if not counts[count]:
            return None
        counts[count] = 0
        worst = int(self._owner[np.argmax(numbers[self._places, column])])
        numbers[:, column] = 0.0
        return list(self._joints.values())[worst]

    def forget_report(self) -> None:
        """Note that a step is taken."""
        self._saved = None

    def totals(self, engine: Engine) -> Array:
        """Return what the last step left of each row: first the impulses on A, B and C.

        These are three numbers each, N s, N s and N m s.
        """
        if self._saved is not None:
            return self._saved
        if self.new:
            joints = list(self._joints.values())
            owner = [k for k, joint in enumerate(joints) for _ in joint_rows(joint)]
            totals = np.zeros((len(owner), _COUNT))
            totals[:, _PULLED] = self._pulled_apart(engine)[owner]
            return totals
        totals = engine.world.joints.numbers[self._places, _KEPT]
        totals[:, _PULLED] = np.maximum(totals[:, _PULLED], self._pulled_since(engine))
        return totals

    def reactions(self, engine: Engine, time_step: float) -> Reactions:
        """Return what joints exerted in the last step, and how well they hold now."""
        joints = list(self._joints.values())
        owner = [k for k, joint in enumerate(joints) for _ in joint_rows(joint)]
        totals = np.zeros((len(joints), len(ENDS), 3))
        of_rows = self.totals(engine)[:, : 3 * len(ENDS)].reshape(-1, len(ENDS), 3)
        np.add.at(totals, owner, of_rows)
        torque = totals[:, :, 2] / time_step
        force = totals[:, :, :2] / time_step
        for k, joint in enumerate(joints):
            for i, (body, anchor) in enumerate(zip(joint.ends, joint.anchors, strict=True)):
                x, y = arm(anchor, 0.0 if body is None else float(engine.pose[body, 2]))
                torque[k, i] -= x * force[k, i, 1] - y * force[k, i, 0]
        lengths, angles = _separations(joints, engine.pose)
        told = {
            "impulse": totals[:, :, :2].copy(),
            "force": force,
            "torque": torque,
            "separation": lengths,
            "angular_separation": angles,
        }
        return Reactions(
            names=self.names,
            **{
                name: read_only(values, f"{name} of the reactions", REMEDIES["reactions"])
                for name, values in told.items()
            },
        )

    # -- keeping

    def saved(self) -> list[dict[str, Any]]:
        """Return the joints as plain data."""
        return [asdict(joint) for joint in self._joints.values()]

    @classmethod
    def restored(
        cls, data: Sequence[Mapping[str, Any]], totals: NDArray[Any] | None, kind: NDArray[np.int8]
    ) -> "JointSet":
        """Return the joints of plain data, with the impulses of the last step.

        Raises:
            UnfitError: they are no joints of bodies of these kinds (n,).
        """
        name = "joints"
        try:
            joints = [_joint_of(one) for one in data]
            refuse_unknown(joints)
            rows = [row for joint in joints for row in joint_rows(joint)]
        except (TypeError, ValueError, KeyError, AttributeError, RuleError):
            require(False, name, "are no joints")
        require(len({joint.name for joint in joints}) == len(joints), name, "have one name")
        for row in rows:
            held = [body for body in row.ends if body is not None]
            fits = len(set(held)) == len(held) and all(0 <= body < len(kind) for body in held)
            require(fits and np.isfinite(row.given).all(), name, "must be of bodies, and numbers")
            kinds = kind[held]
            fits = bool((kinds == tb.DYNAMIC).any()) and tb.ABSENT not in kinds
            require(fits, name, "must hold a body that moves")
        own = cls(joints)
        if joints:
            fits = totals is not None and totals.dtype == np.float64
            require(fits and totals.shape == (len(rows), _COUNT), name, "have no impulses")  # type: ignore[union-attr]
            require(np.isfinite(cast(Array, totals)), name, "must be numbers")
            own._saved, own._restored = cast(Array, totals).copy(), True
        return own

    def _change(self) -> None:
        self.new, self._saved, self._restored = True, None, False

    def _free_name(self, name: object) -> str:
        if name is None:
            k = len(self._joints)
            while f"joint{k}" in self._joints:
                k += 1
            return f"joint{k}"
        if not isinstance(name, str) or not name or name in self._joints:
            raise RuleError(
                f"name {shown(name)} of a joint: must be a text of its own (R1). Give another, or "
                "none.",
                "name",
            )
        return name


def refuse_unknown(joints: Iterable[Joint]) -> None:
    """Raise `RuleError` where a joint has what steps do not know."""
    for joint in joints:
        if what := joint.beyond_steps:
            raise _beyond_steps(joint.name, joint.kind, what)


def _beyond_steps(name: str, kind: str, what: str) -> RuleError:
    return RuleError(
        f"joint '{name}' ({kind}): steps know no {what} (R13). Leave it out, or take "
        "simulate(scene, ...) without Stepped(), which knows it.",
        "joints",
    )


def joint_rows(joint: Joint) -> list[JointRow]:
    """Return a joint as the engine takes it: what it keeps, then what governs its freedoms."""
    kept = [_row(joint)] if joint.rigid else []
    return [*kept, *(row for each in joint.freedoms for row in _governed(joint, each))]


def _governed(joint: Joint, freedom: Freedom) -> Iterable[JointRow]:
    limits, motor, spring = freedom.limits, freedom.motor, freedom.spring
    if limits and limits.lower is not None:
        yield _row(joint.measured(freedom, limits.lower), tb.LOWER_LIMIT)
    if limits and limits.upper is not None:
        yield _row(joint.measured(freedom, limits.upper), tb.UPPER_LIMIT)
    if motor:
        most = math.inf if motor.maximum is None else motor.maximum
        yield _row(joint.measured(freedom, 0.0), tb.MOTOR, (motor.speed, most, 0.0, 0.0))
    if spring:
        rest = cast(float, spring.rest)
        numbers = (0.0, 0.0, spring.stiffness, spring.damping)
        yield _row(joint.measured(freedom, rest), tb.SPRING, numbers)


def _row(
    joint: Joint, law: int = tb.KEPT, numbers: tuple[float, float, float, float] = (0.0,) * 4
) -> JointRow:
    given = [joint.given[name] for name in joint.functions.parameters]
    parts = [x for value in given for x in (value if isinstance(value, tuple) else (value,))]
    apart = not joint.collide
    return JointRow(joint.model, joint.ends, tuple(map(float, parts)), apart, law, numbers)


def _size(joint: Joint, engine: Engine) -> float:
    """Return how large a joint and the bodies that it holds are, m; infinite if they are points."""
    held = zip(joint.anchors, joint.ends, strict=True)
    lengths = [math.hypot(*anchor) for anchor, body in held if body is not None]
    lengths += [float(engine.world.state.properties[k, tb.BOUNDING_RADIUS]) for k in joint.bodies]
    lengths += [value for value in (joint.given.get("joint_length"),) if isinstance(value, float)]
    return max(lengths) or math.inf


def _place(row: JointRow, rank: IntArray) -> tuple[Any, ...]:
    """Return by what rows are ordered: their bodies in canonical order, then what they are."""
    bodies = [-1 if body is None else int(rank[body]) for body in row.ends]
    return bodies, row.law, row.kind, row.given, row.numbers, row.apart


def _units(row: JointRow) -> list[str]:
    """Return the units of the rows of a joint, of as many as there may be."""
    units = CONSTRAINTS[row.kind].units
    return [*units, *["1"] * (MOST_ROWS - len(units))]


def _separations(joints: Sequence[Joint], pose: Array) -> tuple[Array, Array]:
    """Return by how much joints (j,) are apart, m, and turned, rad, at poses (n, 3)."""
    lengths, angles = np.zeros(len(joints)), np.zeros(len(joints))
    of_model: dict[str, list[int]] = {}
    for k, joint in enumerate(joints):
        if joint.rigid:
            of_model.setdefault(joint.model, []).append(k)
    poses = np.vstack((pose, np.zeros((1, 3))))  # the last one is the plane's
    for model, own in of_model.items():
        values: dict[str, Any] = {}
        for name in CONSTRAINTS[model].parameters:
            given = np.array([joints[k].given[name] for k in own])
            values[name] = tuple(given.T) if given.ndim == 2 else given
        for i, end in enumerate(ENDS):
            bodies = [joints[k].ends[i] for k in own]
            x, y, turn = poses[[-1 if body is None else body for body in bodies]].T
            values[f"position_{end}"], values[f"orientation_{end}"] = (x, y), turn
        with np.errstate(all="ignore"):
            rows = np.array(CONSTRAINTS[model].constraint(values))
        kinds = np.array(CONSTRAINTS[model].units)
        lengths[own] = np.linalg.norm(rows[kinds == "m"], axis=0)
        angles[own] = np.linalg.norm(rows[kinds == "1"], axis=0)
    return lengths, angles


def _joint_of(data: Mapping[str, Any]) -> Joint:
    """Return a joint of plain data, in which tuples are lists."""
    parameters = tuple(
        (str(name), (float(value[0]), float(value[1])) if isinstance(value, list) else float(value))
        for name, value in data["parameters"]
    )
    freedoms = tuple(_freedom_of(each) for each in data["freedoms"])
    joint = Joint(**{**data, "parameters": parameters, "equations": (), "freedoms": freedoms})
    anchors = tuple((float(x), float(y)) for x, y in joint.anchors)
    ends = tuple(None if body is None else int(body) for body in joint.ends)
    if len(anchors) != len(ENDS) or len(ends) != len(ENDS) or joint.model not in KINDS:
        raise ValueError(joint.model)
    if not isinstance(joint.name, str) or not isinstance(joint.collide, bool):
        raise TypeError(joint.name)
    return replace(
        joint,
        ends=(ends[0], ends[1], ends[2]),
        anchors=(anchors[0], anchors[1], anchors[2]),
    )


def _freedom_of(data: Mapping[str, Any]) -> Freedom:
    """Return what a joint leaves free, of plain data."""
    kinds: dict[str, Any] = {"limits": Limits, "motor": Motor, "spring": JointSpring}
    parts = {key: None if data[key] is None else kind(**data[key]) for key, kind in kinds.items()}
    return Freedom(**{**data, **parts})


@dataclass(frozen=True)
class _Shape:
    bounding_radius: float


@dataclass(frozen=True)
class _Standing:
    """A body as the checks of a joint look at it."""

    name: str
    position: tuple[float, float]
    orientation: float
    velocity: tuple[float, float]
    angular_velocity: float
    dynamic: bool
    kinematic: bool
    inertia: float
    shape: _Shape


class Standing:
    """The bodies of an engine, by their rows, as the checks of a joint look at them."""

    def __init__(self, engine: Engine, names: Mapping[str, int]) -> None:
        self._engine = engine
        self._names = {row: name for name, row in names.items()}

    def __getitem__(self, row: int) -> _Standing:
        engine = self._engine
        x, y, turn = engine.pose[row].tolist()
        u, v, spin = engine.velocity[row].tolist()
        inverse = float(engine.inverse_inertia[row])
        radius = float(engine.world.state.properties[row, tb.BOUNDING_RADIUS])
        return _Standing(
            name=self._names.get(row, str(row)),
            position=(x, y),
            orientation=turn,
            velocity=(u, v),
            angular_velocity=spin,
            dynamic=bool(engine.kind[row] == tb.DYNAMIC),
            kinematic=bool(engine.kind[row] == tb.KINEMATIC),
            inertia=1 / inverse if inverse > 0 else np.inf,
            shape=_Shape(radius),
        )
