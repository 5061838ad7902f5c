"""The header of a recording: all that it takes to compute its run once more.

The header is one line of JSON, the same in every kind of recording. Floats are printed so that
they read back to the same bits.
"""

from __future__ import annotations

import hashlib
import json
import platform
from dataclasses import asdict, dataclass, fields, replace
from importlib import metadata, resources
from typing import TYPE_CHECKING, Any

from tamias2d import motion
from tamias2d.errors import RecordingError
from tamias2d.method_names import METHOD_NAMES
from tamias2d.scene import scene_text

if TYPE_CHECKING:
    from tamias2d.run_data import RunData

FORMAT = 3
_TYPES: dict[str, Any] = {
    "scene": str,
    "method": dict,
    "duration": float,
    "time_step": float | None,
    "samples": int,
    "impacts": int,
    "bodies": list,
    "notes": list,
    "stepped_because": str | None,
    "ruled": str | None,
    "unresolved": str | None,
    "digest": str,
    "versions": dict,
    "certificate": dict | None,
    "joint_events": int,
}
"""What JSON makes of each entry."""


@dataclass(frozen=True)
class Header:
    """The inputs of a run as text and numbers, and what it takes to trust the stored answer."""

    scene: str
    method: dict[str, Any]
    duration: float
    time_step: float | None
    samples: int
    impacts: int
    bodies: tuple[str, ...]
    notes: tuple[str, ...]
    digest: str
    versions: dict[str, str]
    stepped_because: str | None
    ruled: str | None
    unresolved: str | None
    certificate: dict[str, Any] | None
    """As JSON."""
    joint_events: int
    format: int = FORMAT

    def dumps(self) -> str:
        """Print the header as one line of JSON."""
        return json.dumps(asdict(self), sort_keys=True)


def header_of(run: RunData) -> Header:
    """Describe a run: its inputs, its size, the programs that made it, and its digest."""
    header = Header(
        scene=scene_text(run.scene),
        method={"name": type(run.method).__name__, **vars(run.method)},
        duration=float(run.duration),
        time_step=None if run.time_step is None else float(run.time_step),
        samples=len(run.times),
        impacts=len(run.impacts.time),
        bodies=tuple(body.name for body in run.scene.bodies),
        notes=tuple(run.notes),
        stepped_because=run.stepped_because,
        ruled=run.ruled,
        unresolved=run.unresolved,
        digest="",
        versions=versions(),
        joint_events=len(run.joint_events),
        certificate=None if run.certificate is None else run.certificate.as_json(),
    )
    return replace(header, digest=digest(header, run))


def digest(header: Header, run: RunData) -> str:
    """Return the SHA-256 of a header and of all numbers of its run."""
    text = replace(header, digest=run.digest()).dumps()
    return hashlib.sha256(text.encode()).hexdigest()


def loads(text: str, *, where: str) -> Header:
    """Read a header; raise `RecordingError` that begins with `where` if it is not one of ours."""
    try:
        values = json.loads(text)
        if values["format"] != FORMAT:
            raise RecordingError(
                f"{where}: format {values['format']}: this version reads format {FORMAT}. "
                f"Open it with tamias2d {values['versions']['tamias2d']}."
            )
        return _header(values)
    except (ValueError, KeyError, TypeError, RecursionError) as fault:
        raise RecordingError(
            f"{where}: its header cannot be read. Record the run again."
        ) from fault


def _header(values: dict[str, Any]) -> Header:
    """Build a header from JSON; raise one of the errors of a wrong key or type."""
    for name, kind in _TYPES.items():
        if not isinstance(values[name], kind):
            raise TypeError(name)
    words = [*values["bodies"], *values["notes"], *values["versions"].values()]
    if not all(isinstance(word, str) for word in words) or values["samples"] < 1:
        raise ValueError
    lists = {name: tuple(values[name]) for name in ("bodies", "notes")}
    return Header(**{field.name: values[field.name] for field in fields(Header)} | lists)


def method_of(header: Header, *, where: str) -> Any:
    """Build the method that the header names, with its options."""
    options = dict(header.method)
    name = str(options.pop("name", ""))
    if name not in METHOD_NAMES.values():
        raise RecordingError(
            f"{where}: method {name!r} is none of {', '.join(METHOD_NAMES.values())}. "
            f"Open it with tamias2d {header.versions.get('tamias2d')}."
        )
    try:
        return getattr(motion, name)(**options)
    except (TypeError, ValueError) as fault:
        raise RecordingError(f"{where}: options of the method {name}: {fault}.") from fault


def versions() -> dict[str, str]:
    """What the bits of a run depend on: the specification, the programs and the machine."""
    return {
        "tamias2d": metadata.version("tamias2d"),
        "specification": _specification_hash(),
        "numpy": metadata.version("numpy"),
        "scipy": metadata.version("scipy"),
        "python": platform.python_version(),
        "machine": f"{platform.system()} {platform.machine()}",
    }


def _specification_hash() -> str:
    text = resources.files("tamias2d.generated").joinpath("srs.json").read_bytes()
    return hashlib.sha256(text).hexdigest()[:16]
