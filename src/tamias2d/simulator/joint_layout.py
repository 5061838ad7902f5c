"""Where the rows of joints are in the arrays of an engine.

Serves: the joints of a simulator. Hides: that the engine knows joints by their places, which change
as joints come and go, and in which order it takes them: the same in whatever order they came.
"""

import math
from collections.abc import Sequence
from itertools import chain
from typing import Any

import numpy as np

from tamias2d.engine import tables as tb
from tamias2d.engine.engine import Engine
from tamias2d.engine.joints.joint_row import JointRow
from tamias2d.engine.joints.placement import PULLED, UNTIL_BACK
from tamias2d.engine.joints.row_changes import mechanism_of, move_anchor, set_law
from tamias2d.generated.joint_rows import MOST_ROWS
from tamias2d.scene.joints import Joint
from tamias2d.scene.rules import Vector
from tamias2d.simulator.joint_columns import JointColumns, with_plane
from tamias2d.simulator.joint_rows import (
    joint_rows,
    laws_of,
    place_of_row,
    row_count,
    units_of_row,
)
from tamias2d.simulator.joint_separations import arm_of_joint, separations, size_of_joint
from tamias2d.simulator.moved_limits import NEARLY_ALONG, Passed
from tamias2d.spec.constraint import ENDS
from tamias2d.state import Array, IntArray

_SLOPES = tb.J_ROW + np.array([1, 2, 4, 5])  # of the first row, which tell by how much it turns
# numbers of a joint that a step leaves to the next
_KEPT = np.concatenate((np.arange(tb.J_STEP_TOTAL, tb.J_GAINED + 1), _SLOPES))
KEPT_COUNT = len(_KEPT)
TOTAL_COUNT = tb.J_PUSHED + 1 - tb.J_STEP_TOTAL
"""The first of these, which tell what a row gave."""
_PULLED = tb.J_PULLED - tb.J_STEP_TOTAL
APART = 1e-3
"""Of the size of a joint, or rad: one that is farther apart is told."""


class JointLayout:
    """Joints (j,) of an engine, and their rows (r,) in its arrays."""

    def __init__(
        self, engine: Engine, joints: Sequence[Joint], kept: Array, *, restored: bool
    ) -> None:
        """Tell the engine which joints there are, with what a step left of their rows.

        An engine that was restored with them knows which pairs these keep apart.
        """
        self.joints = joints
        self._engine = engine
        rows = [(k, row) for k, joint in enumerate(joints) for row in joint_rows(joint)]
        order = sorted(range(len(rows)), key=lambda n: place_of_row(rows[n][1], engine.rank))
        places = engine.set_joints([rows[n][1] for n in order], restored=restored)
        self.owner = np.array([k for k, _ in rows], dtype=np.int64)
        """(r,), of each row its joint"""
        self.places = np.zeros(len(rows), dtype=np.int64)
        """(r,), in the arrays, as joints were added"""
        self.places[order] = places
        self._rows_of: dict[str, list[tuple[int, JointRow]]] = {}
        held: dict[tuple[Any, ...], set[str]] = {}
        for (k, row), place in zip(rows, self.places.tolist(), strict=True):
            self._rows_of.setdefault(joints[k].name, []).append((place, row))
            held.setdefault((row.ends, row.law, row.kind), set()).add(joints[k].name)
        self.alike = {name for own in held.values() if len(own) > 1 for name in own}
        """The names of joints whose order their anchors decide."""
        sizes = np.array([size_of_joint(joint, engine) for joint in joints])
        units = np.array([units_of_row(row) for _, row in rows]).reshape(-1, MOST_ROWS)
        self.are_lengths, self.sizes = units == "m", sizes[self.owner]
        """(r, 3), which numbers of rows are lengths; (r,), the sizes of their joints, m"""
        self.per_unit = np.array([[row.per_unit] for _, row in rows]).reshape(-1, 1)
        """(r, 1), by how much a value changes for a m, or for a rad"""
        self._begin(kept)

    def _begin(self, kept: Array) -> None:
        """Give the rows what a step left of them."""
        numbers = self.numbers
        size = np.broadcast_to(self.sizes[:, None], self.are_lengths.shape)
        slight = slice(tb.J_SLIGHT, tb.J_SLIGHT + MOST_ROWS)
        numbers[self.places, slight] = (
            APART / math.sqrt(MOST_ROWS) * np.where(self.are_lengths, size, 1.0) * self.per_unit
        )
        self._note_arms()
        numbers[self.places[:, None], _KEPT] = kept
        for column in (tb.J_PULLED, tb.J_OPENED):
            most = np.zeros(len(numbers))
            np.maximum.at(most, self.first_rows, numbers[self.places, column])
            numbers[:, column] = most
        firmest = slice(tb.J_FIRMEST, tb.J_FIRMEST + MOST_ROWS)
        least = np.full(len(numbers), np.inf)
        np.minimum.at(least, self.first_rows, numbers[self.places, tb.J_FIRMEST])
        numbers[self.places[least[self.first_rows] == 0.0], firmest] = 0.0  # a joint has come

    def _note_arms(self) -> None:
        """Tell at which arms turns count as ways."""
        arm = np.array([arm_of_joint(joint, self._engine) for joint in self.joints])
        arms = slice(tb.J_ARM, tb.J_ARM + MOST_ROWS)
        self.numbers[self.places, arms] = (
            np.where(self.are_lengths, 1.0, arm[self.owner][:, None]) / self.per_unit
        )

    def note_masses(self) -> None:
        """Hear that bodies weigh other numbers, from which the arms of points follow."""
        if np.isinf(self.sizes).any():
            self._note_arms()

    @property
    def counts(self) -> IntArray:
        """What the engine counts of joints."""
        return self._engine.world.joints.counts

    @property
    def numbers(self) -> Array:
        """The numbers of all rows, by their places."""
        return self._engine.world.joints.numbers

    @property
    def first_rows(self) -> IntArray:
        """(r,), the place of the first row of the mechanism of each row."""
        joints = self._engine.world.joints
        starts = joints.mechanisms[: joints.counts[tb.MECHANISMS], tb.M_JOINT]
        return starts[np.searchsorted(starts, self.places, side="right") - 1]

    def kept(self) -> Array:
        """Return what the last step left of each row: first the impulses on A, B and C.

        These are three numbers each, N s, N s and N m s.
        """
        kept: Array = self.numbers[self.places[:, None], _KEPT]
        if not len(kept):
            return kept
        kept[:, _PULLED] = np.maximum(kept[:, _PULLED], self._pulled_since())
        return kept

    def totals(self) -> Array:
        """Return what the last step gave in each row, as `kept` begins, of those that it knows."""
        totals: Array = self.numbers[self.places, tb.J_STEP_TOTAL : tb.J_STEP_TOTAL + TOTAL_COUNT]
        return totals

    def _pulled_since(self) -> Array:
        """Return for how many substeps rows follow what nothing pushes, moved since the step."""
        joints = self._engine.world.joints
        places, body = joints.places[:, tb.PLACE_X : tb.PLACE_ANGLE + 1], joints.members
        moved = (places != self._engine.pose[body[:, tb.JOINED_BODY]]).any(axis=1)
        moved[0] = False  # the plane
        ends = joints.joints[self.places]
        tied = ends[:, tb.J_NODE : tb.J_NODE + len(ENDS)] == tb.NOT_PUSHED
        members = ends[:, tb.J_MEMBER : tb.J_MEMBER + len(ENDS)]
        placed = joints.counts[tb.PLACED] == 1
        return np.where(placed & (tied & moved[members]).any(axis=1), PULLED, 0.0)

    def move_anchor(self, name: str, end: str, point: Vector) -> None:
        """Move the point of the plane, m, that a joint holds; what it ties follows."""
        for place, row in self._rows_of[name]:
            move_anchor(self._engine, place, row.kind, end, point)
        self.follow(name)

    def follow(self, name: str) -> None:
        """Let a joint follow its point of the plane, which was moved; springs do so anyway."""
        for place, row in self._rows_of[name]:
            if row.law != tb.SPRING:
                self._pull(place)

    def pull(self, name: str, passed: Sequence[Passed]) -> None:
        """Let a joint follow limits that were moved past it, or come back without any speed.

        One that comes back does so until it is within its limits; limits that move on meanwhile
        take it along once it is hardly behind them.
        """
        place = self._rows_of[name][0][0]
        back = self.numbers[self._first_row(place), tb.J_PULLED] == UNTIL_BACK
        behind = any(each.beyond > NEARLY_ALONG * each.moved for each in passed)
        jumps = behind if back else any(each.jumps for each in passed)
        self._pull(place, UNTIL_BACK if jumps else PULLED)

    def is_pulled(self, joint: Joint) -> bool:
        """Return whether a joint is pulled together with energy for it."""
        return bool(self.numbers[self._first_row(self._rows_of[joint.name][0][0]), tb.J_PULLED])

    def _pull(self, place: int, substeps: float = PULLED) -> None:
        self.numbers[self._first_row(place), tb.J_PULLED] = substeps

    def _first_row(self, place: int) -> int:
        """Return the place of the first row of the mechanism of a row."""
        mechanisms = self._engine.world.joints.mechanisms
        return int(mechanisms[mechanism_of(self._engine, place), tb.M_JOINT])

    def govern(self, joint: Joint, before: Joint) -> None:
        """Let what governs a joint have the numbers that it has now, and had not before."""
        rows = self._rows_of[joint.name][1 if joint.rigid else 0 :]
        laws, known = (chain.from_iterable(map(laws_of, j.freedoms)) for j in (joint, before))
        for (place, row), new, old in zip(rows, laws, known, strict=True):
            if new != old:
                set_law(self._engine, place, row.kind, *new[1:])


def by_joint(joints: Sequence[Joint], kept: Array) -> dict[str, Array]:
    """Return what `JointLayout.kept` told of joints, by their names."""
    ends = np.cumsum([row_count(joint) for joint in joints])
    parts = np.split(kept, ends[:-1]) if joints else []
    return {joint.name: part for joint, part in zip(joints, parts, strict=True)}


def kept_of_new(joints: Sequence[Joint], engine: Engine, left: Array) -> Array:
    """Return what `JointLayout.kept` would of joints of which the engine was not told yet.

    The last step left bodies at poses (n, 3).
    """
    owner = [k for k, joint in enumerate(joints) for _ in joint_rows(joint)]
    kept = np.zeros((len(owner), KEPT_COUNT))
    kept[:, _PULLED] = _pulled_apart(joints, engine, left)[owner]
    return kept


def _pulled_apart(joints: Sequence[Joint], engine: Engine, left: Array) -> Array:
    """Return for how many substeps joints (j,) follow what nothing pushes, moved since the step.

    What has come since then may have been moved, too.
    """
    times = np.full(len(joints), engine.time)
    lengths, angles = separations(JointColumns(joints), with_plane(engine.pose), times)
    sizes = np.array([size_of_joint(joint, engine) for joint in joints])
    apart = np.maximum(lengths / sizes, angles) > APART
    moved, known = engine.kind != tb.DYNAMIC, min(len(left), engine.size)
    moved[:known] &= (engine.pose[:known] != left[:known]).any(axis=1)
    tied = np.array([moved[list(joint.bodies)].any() for joint in joints], dtype=bool)
    return np.where(apart & tied, PULLED, 0.0)
