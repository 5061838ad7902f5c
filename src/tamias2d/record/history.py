"""The exact history of a run: every float64 of it, as named arrays, and as an `.npz` file.

The file holds plain arrays (never pickles, which could run code) and the header as text.
"""

from __future__ import annotations

import json
import math
from typing import TYPE_CHECKING, Any

import numpy as np

from tamias2d import archive
from tamias2d.certificate import Certificate, from_json
from tamias2d.errors import RecordingError, TamiasError
from tamias2d.motion.joint_events import WORDS, JointEvents, joint_events
from tamias2d.record import header as headers
from tamias2d.recording_file import aside
from tamias2d.run_data import Impacts, RunData
from tamias2d.scene import Scene
from tamias2d.scene.reading import read_scene

if TYPE_CHECKING:
    from collections.abc import Mapping
    from pathlib import Path

    from numpy.typing import NDArray

    Arrays = dict[str, NDArray[Any]]

OF_BODIES = {"position": 2, "orientation": 1, "velocity": 2, "angular_velocity": 1}
"""Quantities of each body at each sample, with their number of components."""
OF_CONTACTS = {"contact_force": 2, "contact_torque": 1}
"""What contacts exert on each body at each sample, in runs that tell it."""
TOTALS = {"energy": 1, "momentum": 2, "angular_momentum": 1}
"""Quantities of the whole scene at each sample."""
OF_IMPACTS = {
    "time": 1, "bodies": 2, "point": 2, "normal": 2, "impulse": 1, "normal_velocity": 1,
}  # fmt: skip
"""Quantities of each impact."""
OF_JOINT_EVENTS = {"time": 1, "joint": 1, "freedom": 1, "what": 1, "value": 1}
"""Quantities of each event of a joint."""
_WHOLE = {"impacts.bodies", *(f"joint_events.{name}" for name in ("joint", "freedom", "what"))}


def arrays_of(run: RunData) -> Arrays:
    """Name all arrays of a run: `times`, `position`, ..., `impacts.time`, ...; shapes as in Run."""
    of_run = {name: getattr(run, name) for name in ("times", *OF_BODIES, *TOTALS)}
    found = of_run | {f"impacts.{name}": getattr(run.impacts, name) for name in OF_IMPACTS}
    if run.contact_force is not None:
        found |= {name: getattr(run, name) for name in OF_CONTACTS}
    if not len(run.joint_events):
        return found
    return found | {
        f"joint_events.{name}": getattr(run.joint_events, name) for name in OF_JOINT_EVENTS
    }


def shapes_of(header: headers.Header) -> dict[str, tuple[int, ...]]:
    """The shape that each array has, by the header."""
    k, n, m = header.samples, len(header.bodies), header.impacts
    shapes: dict[str, tuple[int, ...]] = {"times": (k,)}
    shapes |= {name: (k, n, width)[: 1 + width] for name, width in OF_BODIES.items()}
    parts = [("", k, TOTALS), ("impacts.", m, OF_IMPACTS)]
    if header.joint_events:
        parts.append(("joint_events.", header.joint_events, OF_JOINT_EVENTS))
    for prefix, rows, widths in parts:
        shapes |= {prefix + name: (rows, width)[:width] for name, width in widths.items()}
    return shapes


def run_of(header: headers.Header, arrays: Mapping[str, NDArray[Any]], *, where: str) -> RunData:
    """Put a run together from its header and arrays; raise `RecordingError` if they do not fit."""
    for name, shape in shapes_of(header).items():
        _check_array(name, arrays.get(name), shape, where)
    pairs = arrays["impacts.bodies"]
    scene = _scene(header, where)
    if pairs.size and not 0 <= pairs.min() <= pairs.max() < len(scene.bodies):
        raise RecordingError(
            f"{where}: impacts.bodies: found index {pairs.max()} of {len(scene.bodies)} bodies. "
            "Record the run again."
        )
    stored: dict[str, Any] = {name: arrays[name] for name in ("times", *OF_BODIES, *TOTALS)}
    if not arrays.keys().isdisjoint(OF_CONTACTS):
        for name, width in OF_CONTACTS.items():
            shape = (header.samples, len(header.bodies), width)[: 1 + width]
            _check_array(name, arrays.get(name), shape, where)
            stored[name] = arrays[name]
    return RunData(
        scene=scene,
        method=headers.method_of(header, where=where),
        duration=header.duration,
        time_step=header.time_step,
        notes=header.notes,
        stepped_because=header.stepped_because,
        ruled=header.ruled,
        unresolved=header.unresolved,
        certificate=_certificate(header, where),
        impacts=Impacts(**{name: arrays[f"impacts.{name}"] for name in OF_IMPACTS}),
        joint_events=_joint_events(arrays, scene, where) if header.joint_events else joint_events(),
        **stored,
    )


def _joint_events(arrays: Mapping[str, NDArray[Any]], scene: Scene, where: str) -> JointEvents:
    found = JointEvents(**{name: arrays[f"joint_events.{name}"] for name in OF_JOINT_EVENTS})
    for event in found:
        known = 0 <= event.joint < len(scene.joints) and 0 <= event.what < len(WORDS)
        if not known or not 0 <= event.freedom <= len(scene.joints[event.joint].freedoms):
            raise RecordingError(
                f"{where}: joint_events: found joint {event.joint} and event {event.what}, which "
                "the scene in it does not have. Record the run again."
            )
    return found


def check_length(what: str, rows: NDArray[Any], length: int, *, where: str) -> None:
    """Raise `RecordingError` if a history is not as long as the header says."""
    if len(rows) != length:
        raise RecordingError(
            f"{where}: {what}: found {len(rows)} of {length} samples: the recording is "
            "incomplete. Record the run again."
        )


def _check_array(name: str, found: NDArray[Any] | None, shape: tuple[int, ...], where: str) -> None:
    kind = np.int64 if name in _WHOLE else np.float64
    if found is None or found.shape != shape or found.dtype != kind:
        what = "nothing" if found is None else f"{found.dtype} {found.shape}"
        raise RecordingError(
            f"{where}: {name}: found {what}: must be {np.dtype(kind)} {shape} by its header. "
            "Record the run again."
        )


def _certificate(header: headers.Header, where: str) -> Certificate | None:
    if header.certificate is None:
        return None
    try:
        return from_json(json.dumps(header.certificate))
    except RecordingError as fault:
        raise RecordingError(f"{where}: {fault}") from fault


def _scene(header: headers.Header, where: str) -> Scene:
    try:
        scene = read_scene(header.scene, file="scene", longest=math.inf)
    except TamiasError as fault:
        raise RecordingError(f"{where}: the scene in it: {fault}") from fault
    names = tuple(body.name for body in scene.bodies)
    if names != header.bodies:
        raise RecordingError(
            f"{where}: the scene in it has bodies {names}, its history {header.bodies}. "
            "Record the run again."
        )
    return scene


def write(run: RunData, path: Path) -> None:
    """Write a run as `.npz`; raise `RecordingError` if that cannot be done."""
    store(headers.header_of(run), arrays_of(run), path)


def store(header: headers.Header, arrays: dict[str, Any], path: Path) -> None:
    """Write a header and the arrays of a run as `.npz`; raises as `write` does."""
    with aside(path) as draft, draft.open("wb") as file:
        np.savez(file, header=np.array(header.dumps()), **arrays)


def read(path: Path) -> tuple[headers.Header, Arrays]:
    """Read header and arrays of an `.npz`; raise `RecordingError` if it is not one of ours."""
    stored = archive.read(path, remedy="Record the run again.")
    if "mark" in stored and "header" not in stored:
        raise RecordingError(
            f"{path}: found a saved simulator: must be a recording of a run. Read it by "
            "Simulator.restore(path), or give a file that run.save(path) has written."
        )
    text = str(stored.pop("header", ""))
    return headers.loads(text, where=str(path)), stored
