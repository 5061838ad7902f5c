"""Events of joints as the viewer shows them: a line of text each; and their exact numbers."""

from __future__ import annotations

from typing import TYPE_CHECKING

import rerun as rr

from tamias2d.record import document, history
from tamias2d.record.rerun import exact, layout

if TYPE_CHECKING:
    from tamias2d.run_data import RunData


def draw(stream: rr.RecordingStream, run: RunData, times: list[rr.TimeColumn]) -> None:
    """Send a line of text for each event of a joint, and its numbers."""
    events = run.joint_events
    joints = run.scene.joints
    texts = [document.joint_line(joints[event.joint].name, event) for event in events]
    stream.send_columns(layout.JOINT_LOG, times, rr.TextLog.columns(text=texts))
    numbers = {name: exact.column(getattr(events, name)) for name in history.OF_JOINT_EVENTS}
    columns = rr.DynamicArchetype.columns(layout.JOINT_EVENT, components=numbers)
    stream.send_columns(layout.JOINT_EVENTS, times, columns)
