"""Joints and springs as the viewer draws them, and what joints exert as arrows."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import rerun as rr

from tamias2d.record import joint_drawing
from tamias2d.record.rerun import exact, layout

if TYPE_CHECKING:
    from collections.abc import Sequence

    from tamias2d.record.drawing import View
    from tamias2d.record.drawn import Drawn
    from tamias2d.record.rerun.bodies import Times
    from tamias2d.run_data import RunData

_ORDER = 30.0  # above the bodies


def draw(stream: rr.RecordingStream, run: RunData, view: View, times: Times) -> None:
    """Send the lines of all joints and springs at each sample; those alike are one entity."""
    for path, members in sorted(entities(run, view).items()):
        stream.log(path, look(members), static=True)
        send(stream, path, members, times)
    _reactions(stream, run, view, times)


def entities(drawn: Drawn, view: View) -> dict[str, list[joint_drawing.Line]]:
    """Return the lines of all joints and springs by the entities that show them."""
    groups: dict[str, list[joint_drawing.Line]] = {}
    for line in joint_drawing.lines(drawn, view):
        path = f"{layout.JOINTS}/{line.kind}{line.points.shape[1]}"
        groups.setdefault(path, []).append(line)
    return groups


def look(members: Sequence[joint_drawing.Line]) -> rr.LineStrips2D:
    """Return what of lines that are alike does not change from sample to sample."""
    return rr.LineStrips2D.from_fields(
        radii=[-1.0] * len(members),
        colors=[joint_drawing.COLOURS[members[0].kind]] * len(members),
        labels=[line.name for line in members],
        show_labels=False,
        draw_order=_ORDER,
    )


def send(
    stream: rr.RecordingStream, path: str, members: Sequence[joint_drawing.Line], times: Times
) -> None:
    """Send where lines that are alike are at each sample."""
    count, size = members[0].points.shape[:2]
    for part in exact.blocks(count, 16 * size * len(members)):
        seen = np.stack([line.points[part] for line in members], axis=1).astype(np.float32)
        columns = rr.LineStrips2D.columns(strips=seen.reshape(-1, size, 2))
        stream.send_columns(path, times(part), columns.partition([len(members)] * len(seen)))


def _reactions(stream: rr.RecordingStream, run: RunData, view: View, times: Times) -> None:
    found = joint_drawing.reactions(run, view)
    if found is None:
        return
    places, vectors = found
    count = places.shape[1]
    look = rr.Arrows2D.from_fields(
        radii=[-1.0] * count,
        colors=[joint_drawing.REACTION] * count,
        labels=[joint.name for joint in run.scene.joints],
        show_labels=False,
        draw_order=_ORDER + 1,
    )
    stream.log(layout.REACTIONS, look, static=True)
    for part in exact.blocks(len(run.times), 32 * count):
        at, along = (rows[part].astype(np.float32) for rows in (places, vectors))
        columns = rr.Arrows2D.columns(origins=at.reshape(-1, 2), vectors=along.reshape(-1, 2))
        stream.send_columns(layout.REACTIONS, times(part), columns.partition([count] * len(at)))
