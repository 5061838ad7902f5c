"""What a game asks for between two steps, beside Pymunk: the time of each call.

Both hold the same towers of boxes. A step of both comes before each call and is not counted, except
where a frame is asked for: then a body comes, one goes, and a step follows. Calls are taken in
turns, and times are those of the processor.
"""

import time
import warnings
from argparse import ArgumentParser
from collections.abc import Callable
from itertools import count as count_from
from typing import Any

import numpy as np

from tamias2d.errors import StepWarning
from tamias2d.scene import Box, Disc, HalfPlane, Polygon, Scene
from tamias2d.scene.freedoms import JointSpring, Limits, Motor
from tamias2d.scene.joint_kinds import Revolute
from tamias2d.simulator import Simulator
from tools.measurements.columns import Columns
from tools.measurements.progress import TOLD

_STEP = 1 / 60
_HEIGHT = 10  # boxes of a tower
_MANY = 100  # bodies that come at once
_SINGLES = 20  # bodies that come one by one
_SETTLING = 60  # steps
_Call = Callable[[], object]


def options(parser: ArgumentParser) -> None:
    """Add how many boxes, and how often each call is taken."""
    parser.add_argument("--boxes", type=int, nargs="+", default=[100, 1000], help="(100 1000)")
    parser.add_argument("--repeats", type=int, default=200, help="of each call (200)")


def measure(boxes: list[int] | None = None, repeats: int = 200) -> dict[str, Any]:
    """Return a row for each number of boxes and each call."""
    rows: list[dict[str, Any]] = []
    for count in boxes or [100, 1000]:
        own, other = _Own(count), _Chipmunk(count)
        theirs = other.calls()
        for name, call in own.calls().items():
            TOLD.print(f"{count} boxes: {name}", highlight=False)
            taken = _in_turns((own.step, call), (other.step, theirs.get(name)), repeats)
            rows.append({"boxes": count, "call": name, "own": taken[0], "pymunk": taken[1]})
    return {"rows": rows}


COLUMNS: Columns = {
    "boxes": "{boxes}",
    "call": "{call}",
    "Tamias2D, us": "{own:.1f}",
    "Pymunk, us": lambda row: "" if row["pymunk"] is None else f"{row['pymunk']:.1f}",
}


def notes(found: dict[str, Any]) -> list[str]:  # noqa: ARG001
    """Return what the columns mean."""
    return ["medians of processor time; Pymunk tells what began by calls of one's own, in its step"]


def _in_turns(
    own: tuple[_Call, _Call], other: tuple[_Call, _Call | None], repeats: int
) -> tuple[float, float | None]:
    """Return the median times of two calls, us; each after a step of its own."""
    times: tuple[list[float], list[float]] = ([], [])
    for _ in range(repeats + 1):  # the first one loads code
        for (step, call), found in zip((own, other), times, strict=True):
            if call is not None:
                step()
                began = time.process_time()
                call()
                found.append(1e6 * (time.process_time() - began))
    mine, theirs = (float(np.median(found[1:])) if found else None for found in times)
    assert mine is not None
    return mine, theirs


class _Own:
    """Towers of boxes in a simulator."""

    def __init__(self, count: int) -> None:
        scene = Scene(gravity=(0.0, -9.81))
        scene.add_static(HalfPlane(normal=(0.0, 1.0), offset=0.0), friction=0.5)
        box = Box(width=0.5, height=0.5)
        for place in _places(count):
            scene.add_body(box, mass=1.0, position=place, friction=0.5, restitution=0.0)
        self._sim = Simulator(scene, time_step=_STEP)
        self._sim.step(_SETTLING)
        self._disc = Disc(radius=0.05)
        self._other = count_from(1)

    def step(self) -> None:
        """Take a step."""
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", StepWarning)
            self._sim.step()

    def calls(self) -> dict[str, _Call]:
        """Return what is asked, by its name."""
        sim = self._sim
        return {
            "a body comes and goes": lambda: sim.remove(self._comes((-9.0, 5.0))),
            "a frame with that": self._frame,
            "one of a new shape": self._of_new_shape,
            f"{_SINGLES} come and go one by one": self._one_by_one,
            f"{_MANY} come and go at once": lambda: sim.remove(self._come()),
            "what touches": lambda: sim.contacts,
            "what began to touch": lambda: sim.began,
            "a ray": lambda: sim.ray_cast((-9.0, 1.0), (99.0, 1.5)),
            "a point": lambda: sim.at_point((0.1, 0.3)),
            "a box": lambda: sim.in_box((0.0, 0.0), (1.0, 1.0)),
            "an impulse": lambda: sim.apply_impulse(3, (0.0, 1e-6)),
            "all positions": lambda: np.asarray(sim.position).sum(),
            "another filter": lambda: sim.set_filters(3, group=next(self._other)),
            "a frame with that filter": self._frame_filtered,
            "another surface": lambda: sim.set_surface(3, friction=0.5 + 1e-9 * next(self._other)),
            "another mass": lambda: sim.set_mass(3, mass=1.0 + 1e-9 * next(self._other)),
            "another shape": lambda: sim.set_shape(3, Disc(radius=0.05 + 1e-9 * next(self._other))),
            **self._governing(),
        }

    def _governing(self) -> dict[str, _Call]:
        """Return what is set of the hinge of a door, which hangs in a world of its own."""
        swing, other = _door(), self._other
        return {
            "another motor": lambda: swing.set_motor("hinge", Motor(speed=1e-9 * next(other))),
            "other limits": lambda: swing.set_limits(
                "hinge", Limits(lower=-1.0 - 1e-9 * next(other), upper=1.0, restitution=0.0)
            ),
            "another spring": lambda: swing.set_spring(
                "hinge", JointSpring(stiffness=1.0 + 1e-9 * next(other))
            ),
        }

    def _of_new_shape(self) -> None:
        size = 0.1 + 1e-9 * next(self._other)
        corners = [(0.0, 0.0), (size, 0.0), (size, 0.1), (0.0, 0.2)]
        piece = Polygon(vertices=corners)
        self._sim.remove(
            self._sim.add(piece, mass=size, position=(-9.0, 5.0), friction=0.5, restitution=0.0)
        )

    def _one_by_one(self) -> None:
        rows = [self._comes((-9.0, 5.0 + 0.2 * k)) for k in range(_SINGLES)]
        for row in rows:
            self._sim.remove(row)

    def _frame_filtered(self) -> None:
        self._sim.set_filters(3, group=next(self._other))
        self._sim.step()

    def _frame(self) -> None:
        self._sim.remove(self._comes((-9.0, 5.0)))
        self._sim.step()

    def _comes(self, place: object) -> Any:
        return self._sim.add(self._disc, mass=0.01, position=place, friction=0.5, restitution=0.0)

    def _come(self) -> Any:
        return self._comes(np.column_stack((np.full(_MANY, -9.0), 5.0 + 0.2 * np.arange(_MANY))))


def _door() -> Simulator:
    """Return a door whose hinge has limits, a motor and a spring."""
    scene = Scene(gravity=(0.0, 0.0))
    scene.add_body(Box(width=1.0, height=0.1), mass=1.0, position=(0.5, 0.0))
    hinge = Revolute(
        limits=Limits(lower=-1.0, upper=1.0, restitution=0.0),
        motor=Motor(speed=0.0),
        spring=JointSpring(stiffness=1.0),
    )
    scene.add_joint(hinge, (0.0, 0.0), 0, other_anchor=(-0.5, 0.0), name="hinge")
    swing = Simulator(scene)
    swing.step()
    return swing


class _Chipmunk:
    """The same in Pymunk, whose coefficients of a pair are products."""

    def __init__(self, count: int) -> None:
        import pymunk

        self._pymunk, self._space = pymunk, pymunk.Space()
        self._space.gravity = (0.0, -9.81)
        floor = pymunk.Segment(self._space.static_body, (-1e3, -0.1), (1e3, -0.1), 0.1)
        floor.friction = 0.5**0.5
        self._space.add(floor)
        self._boxes, self._other = [], count_from(1)
        for place in _places(count):
            body = pymunk.Body(1.0, 1.0 / 24.0)
            body.position = place
            shape = pymunk.Poly.create_box(body, (0.5, 0.5))
            shape.friction = 0.5**0.5
            self._space.add(body, shape)
            self._boxes.append(body)
            self._shape = shape
        for _ in range(_SETTLING):
            self.step()

    def step(self) -> None:
        """Take a step."""
        self._space.step(_STEP)

    def calls(self) -> dict[str, _Call]:
        """Return what is asked, by its name."""
        space, anyone = self._space, self._pymunk.ShapeFilter()
        near = self._pymunk.BB(0.0, 0.0, 1.0, 1.0)
        return {
            "a body comes and goes": lambda: space.remove(*self._comes(5.0)),
            "a frame with that": self._frame,
            "one of a new shape": self._of_new_shape,
            f"{_SINGLES} come and go one by one": lambda: self._one_by_one(_SINGLES),
            f"{_MANY} come and go at once": lambda: self._one_by_one(_MANY),
            "a ray": lambda: space.segment_query_first((-9.0, 1.0), (99.0, 1.5), 0.0, anyone),
            "a point": lambda: space.point_query((0.1, 0.3), 0.0, anyone),
            "a box": lambda: space.bb_query(near, anyone),
            "an impulse": lambda: self._boxes[3].apply_impulse_at_world_point((0.0, 1e-6), (0, 0)),
            "all positions": lambda: sum(body.position[0] for body in self._boxes),
            "another filter": self._filter,
            "a frame with that filter": self._frame_filtered,
            "another surface": self._rub,
        }

    def _frame(self) -> None:
        self._space.remove(*self._comes(5.0))
        self.step()

    def _filter(self) -> None:
        self._shape.filter = self._pymunk.ShapeFilter(group=next(self._other))

    def _frame_filtered(self) -> None:
        self._filter()
        self.step()

    def _rub(self) -> None:
        self._shape.friction = 0.5 + 1e-9 * next(self._other)

    def _one_by_one(self, count: int) -> None:
        for found in [self._comes(5.0 + 0.2 * k) for k in range(count)]:
            self._space.remove(*found)

    def _of_new_shape(self) -> None:
        size = 0.1 + 1e-9 * next(self._other)
        corners = [(0.0, 0.0), (size, 0.0), (size, 0.1), (0.0, 0.2)]
        body = self._pymunk.Body(size, self._pymunk.moment_for_poly(size, corners))
        body.position = (-9.0, 5.0)
        shape = self._pymunk.Poly(body, corners)
        shape.friction = 0.5
        self._space.add(body, shape)
        self._space.remove(body, shape)

    def _comes(self, height: float) -> tuple[Any, Any]:
        body = self._pymunk.Body(0.01, 1e-5)
        body.position = (-9.0, height)
        shape = self._pymunk.Circle(body, 0.05)
        shape.friction = 0.5
        self._space.add(body, shape)
        return body, shape


def _places(count: int) -> list[tuple[float, float]]:
    return [(k // _HEIGHT * 1.0, 0.25 + 0.5 * (k % _HEIGHT)) for k in range(count)]
