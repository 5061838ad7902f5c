"""Saved simulators: the file, its digest, and what it holds besides the engine's arrays."""

import hashlib
import json
from collections.abc import Mapping
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tamias2d import archive
from tamias2d.engine.reports.contact_events import TouchReport, pairs_of
from tamias2d.engine.reports.contact_report import Contacts, contacts_of
from tamias2d.engine.saving.saved_checks import UnfitError, require
from tamias2d.engine.tables import MOST_LEVEL
from tamias2d.errors import RecordingError, TamiasError, path_text
from tamias2d.recording_file import aside, refuse_missing
from tamias2d.scene import Scene
from tamias2d.scene.reading import read_scene
from tamias2d.scene.rules import checked_count
from tamias2d.simulator.settings import checked_substeps, checked_time_step

Arrays = Mapping[str, NDArray[Any]]
VERSION = 24  # of the saved state: its arrays, and the columns of the engine's
_MARK = "tamias2d simulator"
_ABOUT, _DIGEST = "about", "digest"
_PARTS = [1 << level for level in range(MOST_LEVEL + 1)]


@dataclass(frozen=True, kw_only=True)
class About:
    """What a saved simulator is, besides its arrays."""

    time_step: float
    substeps: int
    steps: int
    parts: int
    """Of the last step, where it was finest: a power of 2."""
    names: Mapping[str, int]
    """Rows of the bodies that have a name, by that."""
    staying: list[int]
    """Rows of the scene's bodies that are still there."""
    scene: str | None
    """The text of a scene whose loads vary."""
    joints: list[dict[str, Any]]
    """As plain data."""
    joint_events: list[Any]
    """What happened to joints in the last call, as plain data."""
    expects_joints: bool
    """Whether some are expected, or there were any: the code for them is loaded."""
    warnings: dict[str, str]
    """What was warned of so far, by the names under which it is told once."""


def write(path: Path, arrays: Arrays) -> None:
    """Write arrays to a file, whole or not at all.

    Raises:
        RecordingError: the file cannot be written.
    """
    if path.suffix != ".npz":
        raise RecordingError(
            f"{path_text(path)}: a simulator is saved as .npz. Give the name this ending, e.g. "
            "game.npz."
        )
    with aside(path) as draft, draft.open("wb") as file:
        np.savez(file, allow_pickle=False, **arrays)


def read(path: Path) -> dict[str, NDArray[Any]]:
    """Return the arrays in a file, of which nothing is known.

    Raises:
        RecordingError: there is no file, or it is none of arrays.
    """
    refuse_missing(path, made_by="`sim.save(path)`")
    return archive.read(path, remedy="Save it again.")


def sealed(about: About, arrays: Arrays) -> dict[str, NDArray[Any]]:
    """Return all arrays of a saved simulator, with its version and digest."""
    content = {
        "mark": np.array(_MARK),
        "version": np.array(VERSION),
        _ABOUT: np.array(json.dumps(asdict(about))),
        **arrays,
    }
    return {**content, _DIGEST: np.array(digest(content))}


def opened(content: Arrays, where: str) -> tuple[About, dict[str, NDArray[Any]]]:
    """Return what `sealed` was given.

    Raises:
        RecordingError: it is damaged, of another kind or of another version.
        UnfitError: it has the right digest, and other than a simulator.
    """
    arrays = dict(content)
    if "header" in arrays and "mark" not in arrays:
        raise RecordingError(
            f"{where}: found a recording of a run: must be a saved simulator. Read it by "
            "Run.load(path), or give a file that sim.save(path) has written."
        )
    mark, version = (str(arrays.pop(name, "nothing")) for name in ("mark", "version"))
    if (mark, version) != (_MARK, str(VERSION)):
        raise RecordingError(
            f"{where}: found '{mark}' of version {version}: must be '{_MARK}' of version "
            f"{VERSION}. Save it again with this version."
        )
    found = str(arrays.pop(_DIGEST, ""))
    if found != digest({name: a for name, a in content.items() if name != _DIGEST}):
        raise RecordingError(
            f"{where}: it is damaged: its digest is not that of what it holds. Save it again."
        )
    return _about(str(arrays.pop(_ABOUT, ""))), arrays


def digest(arrays: Arrays) -> str:
    """Return the SHA-256 of arrays, with their names, types and shapes."""
    total = hashlib.sha256()
    for name, values in sorted(arrays.items()):
        total.update(f"{name} {values.dtype.str} {values.shape}\n".encode())
        total.update(np.ascontiguousarray(values).tobytes())
    return total.hexdigest()


def _about(text: str) -> About:
    try:
        about = About(**json.loads(text))
        checked_time_step(about.time_step)
        checked_substeps(about.substeps)
        checked_count(about.steps, "steps", 0)
        checked_count(about.parts, "parts", 1)
        rows = [*about.staying, *about.names.values()]
        fits = all(isinstance(row, int) and not isinstance(row, bool) and row >= 0 for row in rows)
        fits = fits and isinstance(about.time_step, float) and isinstance(about.substeps, int)
        fits = fits and about.parts in _PARTS
        fits = fits and isinstance(about.names, dict) and isinstance(about.staying, list)
        fits = fits and isinstance(about.joints, list) and isinstance(about.warnings, dict)
        fits = fits and isinstance(about.joint_events, list)
        fits = fits and isinstance(about.expects_joints, bool)
        fits = fits and all(isinstance(text, str) for text in about.warnings.values())
    except (TypeError, ValueError, AttributeError, RecursionError) as error:
        raise UnfitError(f"{_ABOUT}: {error}") from error
    require(fits, _ABOUT, "must be numbers, rows and names")
    return about


def scene_of(about: About, kind: NDArray[np.int8], *, dynamic: int, where: str) -> Scene | None:
    """Return the scene whose loads vary, if there is one; its bodies fit the kinds of rows (n,).

    Raises:
        UnfitError: they do not, or it is no scene.
    """
    named, staying = set(about.names.values()), set(about.staying)
    rows = staying | named
    once = len(staying) == len(about.staying) and len(named) == len(about.names)
    require(once, _ABOUT, "names a body twice")
    require(all(row < len(kind) and kind[row] for row in rows), _ABOUT, "names a body not there")
    require(staying <= named, _ABOUT, "names other bodies")
    if about.scene is None:
        return None
    try:
        scene = read_scene(about.scene, file=where)
    except (TamiasError, TypeError) as error:
        raise UnfitError(f"{_ABOUT}: {error}") from error
    fits = all(
        row < len(scene) and scene.bodies[row].dynamic == (kind[row] == dynamic)
        for row in about.staying
    )
    require(fits, _ABOUT, "has a scene of other bodies")
    return scene


def touching_arrays(told: TouchReport) -> dict[str, NDArray[Any]]:
    """Return a contact report as arrays by name."""
    reports = {"contacts": told.contacts, "began": told.began}
    return {"ended": told.ended} | {
        f"{which}.{name}": values
        for which, r in reports.items()
        for name, values in vars(r).items()
    }


def touching_of(arrays: Arrays, size: int) -> TouchReport:
    """Return the contact report of arrays, about `size` bodies.

    Raises:
        UnfitError: they are none.
    """
    contacts, began = (
        contacts_of(
            _report_array(arrays, f"{which}.{name}", size, width) for name, width in _WIDTH.items()
        )
        for which in ("contacts", "began")
    )
    for report in (contacts, began):
        same = {len(values) for values in vars(report).values()}
        require(len(same) == 1, "touching", "its columns must have one length")
    return TouchReport(
        contacts=contacts, began=began, ended=pairs_of(_report_array(arrays, "ended", size, 2))
    )


def parted_of(arrays: Arrays, size: int) -> list[tuple[int, int]]:
    """Return the pairs of bodies, of `size`, of which the next step tells that they ended.

    Raises:
        UnfitError: they are none.
    """
    if "parted" not in arrays:
        return []
    return [(one, other) for one, other in _report_array(arrays, "parted", size, 2).tolist()]


_WIDTH = {
    "bodies": 2,
    "point": 2,
    "normal": 2,
    "impulse": 0,
    "friction_impulse": 2,
    "separation": 0,
}
"""Columns of the fields of `Contacts`, 0 for a number for each."""
assert tuple(_WIDTH) == tuple(Contacts.__dataclass_fields__)


def _report_array(arrays: Arrays, name: str, size: int, width: int) -> NDArray[Any]:
    values = arrays.get(name, np.zeros(()))
    rows = name.endswith(("bodies", "ended", "parted"))
    fits = values.shape[1:] == ((width,) if width else ()) and values.ndim == 1 + bool(width)
    require(fits, name, "is missing, or of another shape")
    require(values.dtype == (np.int64 if rows else np.float64), name, "is of another type")
    require(np.isfinite(values), name, "must be numbers")
    if rows:
        require((values >= 0) & (values < size), name, "names a body that is not there")
    return values.copy()


def rows_of(arrays: Arrays, name: str, size: int) -> NDArray[np.float64] | None:
    """Return three numbers for each of the first k bodies (k, 3), if there are any.

    Raises:
        UnfitError: they are none of `size` bodies.
    """
    rows = arrays.get(name)
    if rows is None:
        return None
    fits = rows.dtype == np.float64 and rows.ndim == 2 and rows.shape[1] == 3
    require(fits and len(rows) <= size, name, "must be float64 of shape (k, 3)")
    require(np.isfinite(rows), name, "must be numbers")
    return rows.copy()


def part(arrays: Arrays, name: str) -> dict[str, NDArray[Any]]:
    """Return the arrays of one part, by their names in it."""
    return {key.partition(".")[2]: a for key, a in arrays.items() if key.startswith(f"{name}.")}
