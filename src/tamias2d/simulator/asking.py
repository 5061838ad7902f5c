"""What happened in the last step, and what is where."""

import numpy as np

from tamias2d.engine.reports.contact_report import Contacts
from tamias2d.scene import Body
from tamias2d.scene.compound import Shape
from tamias2d.simulator.body_contacts import bodies_inside, contacts_of_body
from tamias2d.simulator.body_now import body_now
from tamias2d.simulator.body_points import BodyPoints
from tamias2d.simulator.exclusive import exclusive
from tamias2d.simulator.queries import (
    Hits,
    bodies_at_point,
    bodies_in_box,
    bodies_in_shape,
    cast_rays,
    cast_shape,
)
from tamias2d.simulator.selection import Bodies
from tamias2d.simulator.stepping import Stepping
from tamias2d.simulator.told_only import refuses_assignment
from tamias2d.state import Array, IntArray
from tamias2d.suggestions import suggests


@suggests
@refuses_assignment
class Asking(Stepping):
    """Contacts that were, and queries about places."""

    __slots__ = ()

    @property
    @exclusive
    def contacts(self) -> Contacts:
        """All points at which bodies pushed each other in the last step."""
        return self._report().contacts

    @property
    @exclusive
    def began(self) -> Contacts:
        """The pairs that began to touch in the last call of `step`, each with its strongest point.

        Those of its first step come first; a pair that begins again after it has ended is told
        again. The impulse is that of all points of the pair over the step in which it began; that
        of a sensor is 0. A call of no steps has none.
        """
        return self._report().began

    @property
    @exclusive
    def ended(self) -> IntArray:
        """The pairs (k, 2) that ceased to touch in the last call of `step`, as in `began`.

        What began and ended within the call is in both. What was removed is in none of them.
        """
        return self._report().ended

    @exclusive
    def touching(self, body: int | str, *, mask: int | None = None) -> Contacts:
        """Return the `contacts` of a body in the last step, with that body as A in all of them.

        So normals point away from it, and impulses are what it gave to the others. What was
        removed since is left out and, if a `mask` is given, what shares no bit of its category with
        it. It takes some 50 microseconds.

        Raises:
            InputError: the body is not there, or a value breaks a rule (R3).
        """
        row = self._row(body)
        return contacts_of_body(self._engine, self._report().contacts, row, mask)

    @exclusive
    def inside(self, sensor: int | str, *, mask: int | None = None) -> IntArray:
        """Return the bodies (k,) that overlapped a sensor as the last step, or a part of it, began.

        So are those that passed right through it in flight. They are what `began` told of and
        `ended` did not. What was removed since is left out; `mask` is as in `touching`.

        Raises:
            InputError: the body is not there or no sensor, or a value breaks a rule (R3).
        """
        row = self._row(sensor)
        self._settle_between()
        return bodies_inside(self._engine, row, self._name_of(row), mask)

    @exclusive
    def body(self, body: int | str) -> Body:
        """Return what a body is made of, where it is and how it moves now, by index or name.

        It is a copy, of which `add` could make another one; a polygon is given about its centre,
        to rounding. A body without a name has that of its row. Forces of laws, fields and springs
        are not in its `force`.

        Raises:
            InputError: the body is not there.
        """
        row = self._row(body)
        return body_now(self._engine, row, self._names.of_row.get(row, f"body {row}"))

    @exclusive
    def to_world(self, bodies: Bodies, points: object) -> Array:
        """Return where points of bodies, (2,) or (k, 2), m, in their own axes, are in the world, m.

        These axes begin at the centre of mass. One body may have any number of points; the result
        is (2,) for one point of one body, else (k, 2).

        Raises:
            InputError: a body is not there, or a value breaks a rule (R4).
        """
        return self._points(bodies, points).in_world()

    @exclusive
    def to_local(self, bodies: Bodies, points: object) -> Array:
        """Return where points of the world, m, are in the axes of bodies, m; as `to_world`."""
        return self._points(bodies, points).in_body()

    @exclusive
    def velocity_at(self, bodies: Bodies, points: object) -> Array:
        """Return how bodies move at points of the world, m, in m/s (DD9); as `to_world`."""
        return self._points(bodies, points).velocity()

    def _points(self, bodies: Bodies, points: object) -> BodyPoints:
        one = isinstance(bodies, str) or np.ndim(bodies) == 0
        return BodyPoints(self._engine, self._rows(bodies), points, one=one)

    @exclusive
    def ray_cast(self, start: object, end: object, *, mask: int | None = None) -> Hits:
        """Return what rays meet first, from points to points, (2,) or (k, 2) each, m.

        It meets no body in or on which it starts, no sensor, and, if a `mask` is given, none whose
        category shares no bit with it. A line that it runs along is met at its end, with the
        normal against the ray. A chain that is one-sided is met from its solid side alone.

        Raises:
            InputError: a ray has no length, or a value breaks a rule (R4).
        """
        self._settle_between()
        return cast_rays(self._engine, start, end, mask)

    @exclusive
    def shape_cast(
        self,
        shape: Shape,
        start: object,
        end: object,
        *,
        orientation: object = 0.0,
        ignoring: Bodies = (),
        mask: int | None = None,
    ) -> Hits:
        """Return what a shape meets first as its position goes from points to points, m.

        They are (2,) or (k, 2) each; it is turned by rad, and no body. Where it touches a body at
        the start, or reaches into it, it meets that at once if it would go deeper, and not if it
        slides along or leaves. It meets no sensor, none of the bodies that it is `ignoring`, and,
        if a `mask` is given, none whose category shares no bit with it. A chain that is one-sided
        is met where bodies meet it: from its solid side, and at its ends.

        Raises:
            InputError: it is a half-plane, a way has no length, or a value breaks a rule (R4).
        """
        self._settle_between()
        ignored = self._rows(ignoring)
        return cast_shape(self._engine, shape, start, end, orientation, ignored, mask)

    @exclusive
    def at_point(self, point: object, *, mask: int | None = None) -> IntArray:
        """Return the bodies (k,) at a point (2,), m, but for sensors; `mask` as in `ray_cast`."""
        self._settle_between()
        return bodies_at_point(self._engine, point, mask)

    @exclusive
    def in_shape(
        self,
        shape: Shape,
        *,
        position: object,
        orientation: object = 0.0,
        mask: int | None = None,
    ) -> IntArray:
        """Return the bodies (k,) that reach into a shape at a position, m, turned by rad.

        The shape is no body: a disc for an explosion, a box for a blow, a capsule for where one
        might stand. Sensors are not among them; `mask` is as in `ray_cast`.

        Raises:
            InputError: it is a half-plane, or a value breaks a rule (R4).
        """
        self._settle_between()
        return bodies_in_shape(self._engine, shape, position, orientation, mask)

    @exclusive
    def in_box(self, low: object, high: object, *, mask: int | None = None) -> IntArray:
        """Return the bodies (k,) that reach into a box between two corners (2,), m.

        Sensors are not among them; `mask` is as in `ray_cast`.

        Raises:
            InputError: `low` is beyond `high`, or a value breaks a rule (R4).
        """
        self._settle_between()
        return bodies_in_box(self._engine, low, high, mask)
