"""Rows of a table to lanes and back, and a question to all lanes.

Lanes are numbers side by side, which compiled code takes several of in one instruction. It does so
with loops over two arrays; what is here is not such a loop, and has intrinsics (`lane_code`).
Source: Fog (2024), Optimizing software in C++, transposing in vector registers.
"""

import hashlib
from importlib.resources import files

from tamias2d.kernels.arrays import FloatRows, Floats, Places

LANES = 16
HALF, ROW = 4, 8  # numbers in a half of a row, and in a row
USED = 3  # of each half; the last number is there so that a half is a vector


def load_half(places: Places, first: int, rows: FloatRows, lanes: Floats, to: int) -> None:
    """Load what the first halves of the rows at `places[first:]` use to the columns at `to`."""
    for n in range(USED):
        for m in range(LANES):
            lanes[to + LANES * n + m] = rows[places[first + m], n]


def load_rows(places: Places, first: int, rows: FloatRows, lanes: Floats, to: int) -> None:
    """Load what both halves of the rows at `places[first:]` use to the columns at `to`."""
    for n in range(USED):
        for m in range(LANES):
            lanes[to + LANES * n + m] = rows[places[first + m], n]
            lanes[to + LANES * (USED + n) + m] = rows[places[first + m], HALF + n]


def load_part(
    places: Places, first: int, rows: FloatRows, column: int, lanes: Floats, to: int
) -> None:
    """Load eight numbers of the rows at `places[first:]`, from a column on, to columns at `to`."""
    for n in range(ROW):
        for m in range(LANES):
            lanes[to + LANES * n + m] = rows[places[first + m], column + n]


def store_half(places: Places, first: int, rows: FloatRows, lanes: Floats, to: int) -> None:
    """Store what `load_half` loads, and 0 after it; of a row that is there twice, the last."""
    for m in range(LANES):
        for n in range(USED):
            rows[places[first + m], n] = lanes[to + LANES * n + m]
        rows[places[first + m], USED] = 0.0


def both_above(row: Floats, a: int, least_a: float, b: int, least_b: float) -> bool:
    """Return whether in a lane both `row[a:]` and `row[b:]` are above the least."""
    return any(row[a + m] > least_a and row[b + m] > least_b for m in range(LANES))


INTRINSICS = (load_half, load_rows, load_part, store_half, both_above)
"""What the compiler is given by `lane_code` instead, by the same name."""


def intrinsics_digest() -> str:
    """Return what changes whenever the intrinsics do."""
    text = files("tamias2d.kernels").joinpath("lane_code.py").read_bytes()
    return hashlib.sha256(text).hexdigest()[:16]
