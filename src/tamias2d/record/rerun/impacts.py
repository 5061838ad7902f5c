"""Impacts as the viewer shows them: an arrow each, and a line of text."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import rerun as rr

from tamias2d.record import document, history
from tamias2d.record.rerun import exact, layout

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from tamias2d.record.drawing import Colour, View
    from tamias2d.run_data import RunData

COLOUR: Colour = (235, 200, 60)
LONGEST = 0.25
"""Of the largest impulse, at most, as a part of the view's reach."""
ARM = 2.0
"""Of the largest impulse, at most, in radii of a body: else arrows hide a crowd."""


def draw(stream: rr.RecordingStream, run: RunData, view: View, times: list[rr.TimeColumn]) -> None:
    """Send an arrow for each impact, from where the bodies meet along the impulse.

    It is the impulse on body B or, where that is static, its opposite on body A.
    """
    impacts = run.impacts
    texts = [document.impact_line(run, k) for k in range(len(impacts))]
    stream.send_columns(layout.IMPACT_LOG, times, rr.TextLog.columns(text=texts))
    look = rr.Arrows2D.from_fields(
        radii=rr.Radius.ui_points(1.5), colors=[COLOUR], draw_order=40.0, show_labels=False
    )
    stream.log(layout.IMPACTS, look, static=True)
    numbers = {name: exact.column(getattr(impacts, name)) for name in history.OF_IMPACTS}
    arrows = rr.Arrows2D.columns(origins=impacts.point, vectors=_vectors(run, view))
    columns = rr.DynamicArchetype.columns(layout.IMPACT, components=numbers)
    stream.send_columns(layout.IMPACTS, times, [*arrows, *columns])


def _vectors(run: RunData, view: View) -> NDArray[np.float64]:
    impacts = run.impacts
    largest = float(impacts.impulse.max()) or 1.0
    moved = np.array([body.dynamic for body in run.scene.bodies])[impacts.bodies[:, 1]]
    share = np.where(moved, 1, -1) * impacts.impulse / largest
    return np.asarray(impacts.normal * (share * _longest(run, view))[:, None])


def _longest(run: RunData, view: View) -> float:
    """The length of the longest arrow, m."""
    shapes = [body.shape for body in run.scene.bodies if body.dynamic and body.shape]
    if not shapes:
        return LONGEST * view.reach
    radius = float(np.median([shape.bounding_radius for shape in shapes]))
    return min(LONGEST * view.reach, ARM * radius)
