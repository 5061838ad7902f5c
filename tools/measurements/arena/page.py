"""What was found, for people: a table, sentences, and the part of the docs that holds both.

Serves: the measurement of contacts. Hides: how numbers are written.
"""

import json
from collections.abc import Iterator
from datetime import date
from itertools import pairwise
from pathlib import Path
from platform import machine, python_version
from typing import Any

from tamias2d.storage import write_aside
from tools.measurements.columns import Table

_HEADS = ("scene", "engine", "ms/step", "ratio", "sag, m", "overlap, m", "of radius", "speed, m/s")
_THROUGH = 10.0  # radii: what is deeper does not overlap any more, it went through and falls


def table(found: dict[str, Any]) -> Table:
    """Return heads and rows: each scene, and each engine on it; ratios are to this library."""
    return _HEADS, list(_rows(found))


def _rows(found: dict[str, Any]) -> Iterator[tuple[str, ...]]:
    for scene, engines in found["engines"].items():
        ratios = {
            peer: found["scenes"][scene][f"ratio_to_{peer.lower()}"] for peer in found["peers"]
        }
        for k, (name, row) in enumerate(engines.items()):
            yield (
                "" if k else scene,
                name,
                f"{row['seconds'] * 1e3:.3g}",
                f"{ratios.get(name, 1.0):.2f}",
                "" if row["sag"] is None else f"{row['sag']:.3f}",
                *_overlap(row["penetration"], row["relative_penetration"]),
                f"{row['speed_at_end']:.1e}",
            )


def _overlap(depth: float, share: float) -> tuple[str, str]:
    return ("through", "through") if share > _THROUGH else (f"{depth:.1e}", f"{share:.2%}")


def notes(found: dict[str, Any]) -> list[str]:
    """Return what was found besides, a sentence each."""
    return [line for part in (_reading, _towers, _growth, _memory, _start) for line in part(found)]


def _reading(found: dict[str, Any]) -> Iterator[str]:
    for scene, shares in found.get("reading", {}).items():
        each = ", ".join(f"{name} {share:.1%}" for name, share in shares.items())
        yield f"Reading all positions of {scene}, as a share of a step: {each}."


def _towers(found: dict[str, Any]) -> Iterator[str]:
    for tower, substeps in found.get("towers", {}).items():
        yield f"{tower} stand with {substeps} substeps." if substeps else f"{tower} do not stand."


def _growth(found: dict[str, Any]) -> Iterator[str]:
    rows = found.get("growth", [])
    for row in rows:
        each = ", ".join(f"{name} {1e3 * time:.3g}" for name, time in row["seconds"].items())
        yield f"{row['bodies']} falling discs, ms of a step: {each}."
    for name in rows[0]["seconds"] if rows else ():
        times = [row["seconds"][name] for row in rows]
        ratios = ", ".join(f"{after / before:.2f}" for before, after in pairwise(times))
        yield f"Time of twice as many over that of half, {name}: {ratios}."


def _memory(found: dict[str, Any]) -> Iterator[str]:
    taken = {k: v for k, v in found.get("bytes_of_a_body", {}).items() if v is not None}
    if taken:
        each = ", ".join(f"{name} {size:.0f}" for name, size in taken.items())
        yield f"Bytes of memory for each falling disc, contacts included: {each}."


def _start(found: dict[str, Any]) -> Iterator[str]:
    if "start" in found:
        start = found["start"]
        yield (
            f"From the start of Python to the end of the first step: {start['cached']:.2f} s, or "
            f"{start['empty']:.1f} s where nothing was compiled before; `tamias2d warm` takes "
            f"{start['menu']:.1f} s to compile all there is."
        )


def write(found: dict[str, Any], folder: Path) -> None:
    """Write `contacts.txt`, which the docs include, and `contacts.json` beside it.

    Raises:
        OSError: a file cannot be written.
    """
    heads, rows = table(found)
    lines = [heads, ["---"] * len(heads), *rows]
    text = "\n".join(f"| {' | '.join(cells)} |" for cells in lines)
    peers = " and ".join(f"{name} {number}" for name, number in found["peers"].items())
    beside = "\n".join(f"* {note}" for note in notes(found))
    made = f"{date.today():%d %B %Y}, Python {python_version()} on {machine()}, beside {peers}"
    text = f"{made}; medians of {found['repeats']}.\n\n{text}\n\n{beside}\n"
    folder.mkdir(parents=True, exist_ok=True)
    write_aside(folder / "contacts.txt", text.encode())
    write_aside(folder / "contacts.json", (json.dumps(found, indent=1) + "\n").encode())
