"""The process that unpacks an `.rrd` into the `.npz` of the same run."""

from __future__ import annotations

import sys
import warnings
from collections import defaultdict
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from rerun.chunk import RrdReader

from tamias2d.errors import FrameLoopError, RecordingError
from tamias2d.record import header as headers, history
from tamias2d.record.rerun import exact, layout
from tamias2d.record.rerun.reading import FRAME_LOOP, REFUSED

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from tamias2d.record.header import Header
    from tamias2d.record.history import Arrays

    Part = tuple[NDArray[np.int64], NDArray[Any]]  # steps and values of one chunk
    Columns = dict[tuple[str, str], list[Part]]  # by entity and component


def main(source: str, target: str) -> None:
    """Write the history in `source` to `target`, or say in one line why that cannot be done."""
    try:
        header, arrays = unpack(Path(source))
    except FrameLoopError:
        sys.exit(FRAME_LOOP)
    except RecordingError as fault:
        print(fault, end="")
        sys.exit(REFUSED)
    history.store(header, arrays, Path(target))


def unpack(path: Path) -> tuple[Header, Arrays]:
    """Gather header and arrays; raise `RecordingError` if they are not those of a run of ours.

    A damaged file raises anything, or ends the process.
    """
    with warnings.catch_warnings(action="ignore"):  # one that has lost its footer is still good
        text, columns = _columns(path)
    if text is None:
        raise RecordingError(
            f"{path}: a recording of another program: it has no {layout.HEADER} in it. "
            "Give one that `run.save` has written."
        )
    header = headers.loads(text, where=str(path))
    found = _totals(columns) | _impacts(columns) | _joint_events(columns)
    history.check_length("times", found["times"], header.samples, where=str(path))
    return header, found | _bodies(header, columns, where=str(path)) | _contacts(columns)


def _columns(path: Path) -> tuple[str | None, Columns]:
    """Gather the exact numbers of all chunks, and the text of the header."""
    header, columns = None, defaultdict(list)
    for chunk in RrdReader(path).stream():
        batch = chunk.to_record_batch()
        for name in batch.schema.names:
            if name.startswith(f"{layout.FRAME_LOOP}:"):
                raise FrameLoopError(str(path))
            if name.startswith(f"{layout.HEADER}:"):
                header = batch.column(name)[0][0].as_py()
            elif name.startswith("tamias2d."):
                steps = np.zeros(1, np.int64) if chunk.is_static else batch.column(layout.STEP)
                part = (np.asarray(steps), exact.values(batch.column(name)))
                columns[chunk.entity_path, name].append(part)
    return header, columns


def _totals(columns: Columns) -> Arrays:
    return {
        name: _joined(columns, f"{layout.SAMPLE}:{name}") for name in ("times", *history.TOTALS)
    }


def _impacts(columns: Columns) -> Arrays:
    """All that there are; a run without impacts has no such columns, and gives arrays of none."""
    arrays = {}
    for name, width in history.OF_IMPACTS.items():
        rows = _joined(columns, f"{layout.IMPACT}:{name}", layout.IMPACTS)
        empty = np.empty((0, width)[:width], np.int64 if name == "bodies" else np.float64)
        arrays[f"impacts.{name}"] = rows if len(rows) else empty
    return arrays


def _joint_events(columns: Columns) -> Arrays:
    """All that there are, in the order in which they were."""
    rows = {
        name: _joined(columns, f"{layout.JOINT_EVENT}:{name}", layout.JOINT_EVENTS)
        for name in history.OF_JOINT_EVENTS
    }
    return {f"joint_events.{name}": row for name, row in rows.items() if len(row)}


def _bodies(header: Header, columns: Columns, *, where: str) -> Arrays:
    """Arrays (k, n) and (k, n, 2); what does not move has one row for all samples."""
    arrays = {}
    still = _rows(columns, f"{layout.STILL}:bodies").ravel().astype(np.int64)
    moving = np.delete(np.arange(len(header.bodies)), still)
    for name in history.OF_BODIES:
        arrays[name] = np.empty(history.shapes_of(header)[name])
        if len(still):
            arrays[name][:, still] = _rows(columns, f"{layout.STILL}:{name}")
        if len(moving):
            rows = _rows(columns, f"{layout.STATE}:{name}")
            history.check_length(f"{name} of bodies", rows, header.samples, where=where)
            arrays[name][:, moving] = rows
    return arrays


def _contacts(columns: Columns) -> Arrays:
    """What contacts exert, of a run that tells it."""
    rows = {name: _rows(columns, f"{layout.CONTACTS}:{name}") for name in history.OF_CONTACTS}
    return {name: row for name, row in rows.items() if len(row)}


def _joined(columns: Columns, component: str, entity: str = layout.RECORDING) -> NDArray[Any]:
    """Values of a component that has one for each step."""
    rows = _rows(columns, component, entity)
    return rows[:, 0] if len(rows) else rows


def _rows(columns: Columns, component: str, entity: str = layout.RECORDING) -> NDArray[Any]:
    """Values (steps, so many for each) or (..., 2) of a component, in the order of the steps."""
    parts = columns.get((entity, component))
    if not parts:
        return np.empty(0)
    steps = np.concatenate([steps for steps, _ in parts])
    values = np.concatenate([values for _, values in parts])
    rows = values.reshape(len(steps), len(values) // len(steps), *values.shape[1:])
    return rows[np.argsort(steps, kind="stable")]


if __name__ == "__main__":
    main(*sys.argv[1:])
