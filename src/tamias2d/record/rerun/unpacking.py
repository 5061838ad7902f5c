"""The header and the exact history of an `.rrd`, written as the `.npz` of the same run.

Serves: reading, which runs this module as a process. Hides: how rows of the file become arrays.
"""

from __future__ import annotations

import sys
import warnings
from collections import defaultdict
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from rerun.chunk import RrdReader

from tamias2d.errors import RecordingError
from tamias2d.record import header as headers, history
from tamias2d.record.rerun import layout
from tamias2d.record.rerun.reading import REFUSED

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
    found = _totals(columns) | _impacts(columns)
    history.check_length("times", found["times"], header.samples, where=str(path))
    return header, found | _bodies(header, columns, where=str(path))


def _columns(path: Path) -> tuple[str | None, Columns]:
    """Gather the exact numbers of all chunks, and the text of the header."""
    header, columns = None, defaultdict(list)
    for chunk in RrdReader(path).stream():
        batch = chunk.to_record_batch()
        for name in batch.schema.names:
            if name.startswith(f"{layout.HEADER}:"):
                header = batch.column(name)[0][0].as_py()
            elif name.startswith("tamias2d."):
                steps = None if chunk.is_static else np.asarray(batch.column(layout.STEP))
                values = _values(batch.column(name))
                part = (np.zeros(len(values), np.int64) if steps is None else steps, values)
                columns[chunk.entity_path, name].append(part)
    return header, columns


def _values(column: Any) -> NDArray[Any]:
    """Rows as numbers (r,) or as vectors (r, 2)."""
    rows = column.flatten()
    is_vector = hasattr(rows.type, "list_size")
    flat = np.asarray(rows.flatten() if is_vector else rows)
    return flat.reshape(-1, rows.type.list_size) if is_vector else flat


def _totals(columns: Columns) -> Arrays:
    return {
        name: _joined(columns, layout.RECORDING, f"{layout.SAMPLE}:{name}")
        for name in ("times", *history.TOTALS)
    }


def _impacts(columns: Columns) -> Arrays:
    """All that there are; a run without impacts has no such columns, and gives arrays of none."""
    arrays = {}
    for name, width in history.OF_IMPACTS.items():
        rows = _joined(columns, layout.IMPACTS, f"{layout.IMPACT}:{name}")
        empty = np.empty((0, width)[:width], np.int64 if name == "bodies" else np.float64)
        arrays[f"impacts.{name}"] = rows if len(rows) else empty
    return arrays


def _bodies(header: Header, columns: Columns, *, where: str) -> Arrays:
    """Arrays (k, n) and (k, n, 2); what does not move has one row for all samples."""
    arrays = {}
    for name in history.OF_BODIES:
        arrays[name] = np.empty(history.shapes_of(header)[name])
        for index, body in enumerate(header.bodies):
            rows = _joined(columns, layout.body_path(body), f"{layout.STATE}:{name}")
            if len(rows) != 1:
                of = f"{name} of body {body!r}"
                history.check_length(of, rows, header.samples, where=where)
            arrays[name][:, index] = rows
    return arrays


def _joined(columns: Columns, entity: str, component: str) -> NDArray[Any]:
    """All rows of a component, in the order of their steps."""
    parts = columns.get((entity, component))
    if not parts:
        return np.empty(0)
    steps = np.concatenate([steps for steps, _ in parts])
    values = np.concatenate([values for _, values in parts])
    return values[np.argsort(steps, kind="stable")]


if __name__ == "__main__":
    main(*sys.argv[1:])
