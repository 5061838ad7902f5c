"""The certificate of a run: a bound on its error, how it was reached, and what it leaves out."""

import hashlib
import json
from dataclasses import asdict, dataclass, fields
from functools import cache
from importlib import resources
from importlib.resources.abc import Traversable
from typing import Any, Literal

from tamias2d.errors import RecordingError
from tamias2d.scene import Scene

BoundKind = Literal["exact", "step doubling", "embedded", "reference", "invariants", "none"]

BasisKind = Literal[
    "usual",
    "error equation",
    "halved steps",
    "companions",
    "looser run",
    "planned steps",
    "quality",
]

_NOT_CLAIMED = (
    "that the models fit the world: rigid bodies, by the assumptions of the SRS",
    "anything about the program of 2018, whose scheme was inconsistent",
)


@dataclass(frozen=True)
class Basis:
    """The computation from which a certificate follows: `replay --check` does it again."""

    kind: BasisKind = "usual"
    """The usual one is that of `certify` where no other kind is named."""
    rtol: float | None = None
    """The tolerance of the looser run, whose companion at a tighter one the run is."""
    time_step: float | None = None
    """The shortest of the planned steps, s."""


USUAL = Basis()


@dataclass(frozen=True, kw_only=True)
class Certificate:
    """A bound on the error of one run."""

    kind: BoundKind
    """How the bound was reached; with "none" there is no bound."""
    measure: str
    """Which error is bounded, and its scale."""
    bound: float | None
    """Dimensionless, as the measure says."""
    how: str
    """The numbers from which the bound follows, in one sentence."""
    claims: tuple[str, ...]
    does_not_claim: tuple[str, ...]
    observed_order: float | None
    """At which the error falls with the step, as it was seen."""
    predictability_horizon: float | None
    """s; from then on a change of 1e-12 of the scale has grown to 1 % of it. None: not in the run.
    """
    hashes: dict[str, str]
    """SHA-256 of the specification, of the scene and of the package's sources."""
    basis: Basis = USUAL
    """From which computation it follows."""

    def __str__(self) -> str:
        horizon = self.predictability_horizon
        until = "" if horizon is None else f"; predictable for {horizon:.3g} s"
        if self.bound is None:
            return f"Certificate: none: {self.how}{until}"
        return f"Certificate: error <= {self.bound:.1e} ({self.kind}): {self.how}{until}"

    @property
    def bounds_positions(self) -> bool:
        """Whether it bounds the error of positions, not of the energy alone, or nothing."""
        return self.kind not in ("invariants", "none")

    def meets(self, tolerance: float) -> bool:
        """Whether it bounds the error of positions, by no more than a tolerance."""
        return self.bounds_positions and self.bound is not None and self.bound <= tolerance

    def as_json(self) -> dict[str, Any]:
        """Return the fields as JSON holds them."""
        lists = {name: list(getattr(self, name)) for name in ("claims", "does_not_claim")}
        return asdict(self) | lists

    def to_json(self) -> str:
        """Print it as one line of JSON, every float with all its digits."""
        return json.dumps(self.as_json(), sort_keys=True, allow_nan=False)


def from_json(text: str) -> Certificate:
    """Read what `to_json` has printed; raise `RecordingError` if it is no certificate."""
    try:
        values = json.loads(text)
        lists = {name: tuple(values[name]) for name in ("claims", "does_not_claim")}
        given = {f.name: values[f.name] for f in fields(Certificate)} | lists
        return Certificate(**given | {"basis": Basis(**values["basis"])})
    except (ValueError, KeyError, TypeError, RecursionError) as fault:
        raise RecordingError(
            "certificate: cannot be read: its fields are not those of a certificate. "
            "Certify the run again."
        ) from fault


def not_claimed(horizon: float | None) -> tuple[str, ...]:
    """Return what no certificate claims."""
    late = () if horizon is None else (f"where single bodies are after {horizon:.6g} s",)
    return (*_NOT_CLAIMED, *late)


def hashes(scene: Scene) -> dict[str, str]:
    """Return the SHA-256 of all that an answer rests on."""
    return {"spec": _of_specification(), "scene": scene.digest(), "code": source_digest()}


@cache
def _of_specification() -> str:
    text = resources.files("tamias2d.generated").joinpath("srs.json").read_bytes()
    return hashlib.sha256(text).hexdigest()


@cache
def source_digest() -> str:
    """Return the SHA-256 of the package's sources."""
    total = hashlib.sha256()
    _add(total, resources.files("tamias2d"), "")
    return total.hexdigest()


def _add(total: "hashlib._Hash", folder: Traversable, path: str) -> None:
    """Add all Python sources of a folder, by name, to a hash."""
    for entry in sorted(folder.iterdir(), key=lambda entry: entry.name):
        name = f"{path}/{entry.name}"
        if entry.is_dir():
            _add(total, entry, name)
        elif name.endswith(".py"):
            total.update(name.encode() + b"\0" + entry.read_bytes() + b"\0")
