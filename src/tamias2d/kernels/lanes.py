"""Rows of a table to lanes and back, and a question to all lanes.

Lanes are numbers side by side, which compiled code takes several of in one instruction. It does so
with loops over two arrays; what is here is not such a loop, and has intrinsics (`lane_code`).
Source: Fog (2024), Optimizing software in C++, transposing in vector registers.
"""

import hashlib
from importlib.resources import files

from tamias2d.kernels.arrays import FloatRows, Floats, Places

LANES = 16
FEW, ALL = 4, 8  # columns of a row of eight that are moved: the first ones, or all


def load_few(places: Places, first: int, rows: FloatRows, lanes: Floats, to: int) -> None:
    """Load the first columns of the rows at `places[first:]`, column by column, to `lanes[to:]`."""
    for n in range(FEW):
        for m in range(LANES):
            lanes[to + LANES * n + m] = rows[places[first + m], n]


def load_all(places: Places, first: int, rows: FloatRows, lanes: Floats, to: int) -> None:
    """Load the rows at `places[first:]`, column by column, to `lanes[to:]`."""
    for n in range(ALL):
        for m in range(LANES):
            lanes[to + LANES * n + m] = rows[places[first + m], n]


def store_few(places: Places, first: int, rows: FloatRows, lanes: Floats, to: int) -> None:
    """Store what `load_few` has loaded; of a place that is there twice, the last lane's."""
    for m in range(LANES):
        for n in range(FEW):
            rows[places[first + m], n] = lanes[to + LANES * n + m]


def both_above(row: Floats, a: int, least_a: float, b: int, least_b: float) -> bool:
    """Return whether in a lane both `row[a:]` and `row[b:]` are above the least."""
    return any(row[a + m] > least_a and row[b + m] > least_b for m in range(LANES))


INTRINSICS = (load_few, load_all, store_few, both_above)
"""What the compiler is given by `lane_code` instead, by the same name."""


def intrinsics_digest() -> str:
    """Return what changes whenever the intrinsics do."""
    text = files("tamias2d.kernels").joinpath("lane_code.py").read_bytes()
    return hashlib.sha256(text).hexdigest()[:16]
