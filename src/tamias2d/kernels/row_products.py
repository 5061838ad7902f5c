"""Rows of joints times vectors, and times each other: loops that are copied into kernels.

Serves: the source of reactions. Hides: how rows are kept. `entries` holds nine numbers for each
row, its slopes by x, y and orientation of bodies A, B and C. Those of bodies that move stand at
`row_entries`, by the coordinates `row_columns`, from `row_starts` of each row on.
"""

from math import sqrt

from tamias2d.kernels.arrays import Floats, Ranks


def along(
    entries: Floats,
    row_starts: Ranks,
    row_entries: Ranks,
    row_columns: Ranks,
    vector: Floats,
    total: Floats,
) -> None:
    """Set each row times a vector."""
    for i in range(len(total)):
        value = 0.0
        for p in range(row_starts[i], row_starts[i + 1]):
            value = value + entries[row_entries[p]] * vector[row_columns[p]]
        total[i] = value


def across(
    entries: Floats,
    row_starts: Ranks,
    row_entries: Ranks,
    row_columns: Ranks,
    shares: Floats,
    total: Floats,
) -> None:
    """Set the sum of rows, each as often as its share."""
    for j in range(len(total)):
        total[j] = 0.0
    for i in range(len(shares)):
        share = shares[i]
        for p in range(row_starts[i], row_starts[i + 1]):
            j = row_columns[p]
            total[j] = total[j] + entries[row_entries[p]] * share


def squares(
    entries: Floats,
    row_starts: Ranks,
    row_entries: Ranks,
    row_columns: Ranks,
    weights: Floats,
    order: Ranks,
    diagonal: Floats,
) -> None:
    """Set the products of rows with themselves, each column weighed, in their order."""
    for k in range(len(order)):
        i = order[k]
        value = 0.0
        for p in range(row_starts[i], row_starts[i + 1]):
            slope = entries[row_entries[p]]
            value = value + slope * slope * weights[row_columns[p]]
        diagonal[k] = value


def multiply(
    entries: Floats,
    row_entries: Ranks,
    row_columns: Ranks,
    inverse: Floats,
    pairs: Ranks,
    lower: Floats,
) -> None:
    """Set the products of rows with each other, over mass and inertia.

    `pairs` holds three numbers for each of them: the place in `lower`, then those in `row_entries`.
    """
    for p in range(len(lower)):
        lower[p] = 0.0
    for q in range(len(pairs) // 3):
        a, b = pairs[3 * q + 1], pairs[3 * q + 2]
        weight = inverse[row_columns[a]]
        product = entries[row_entries[a]] * entries[row_entries[b]] * weight
        lower[pairs[3 * q]] = lower[pairs[3 * q]] + product


def largest(own: Floats, order: Ranks, found: Floats) -> float:
    """Return the largest number of rows of length one; `own` has squares of lengths, in order."""
    most = 0.0
    for k in range(len(order)):
        most = max(most, found[order[k]] * found[order[k]] / own[k])
    return sqrt(most)


def place_of(body: int, position: Floats, still: Floats) -> tuple[float, float, float]:
    """Return x, y and orientation of a body; those that stand still follow the others."""
    count = len(position) // 3
    if body < count:
        return position[body], position[count + body], position[2 * count + body]
    at = 3 * (body - count)
    return still[at], still[at + 1], still[at + 2]


def rates_of(body: int, velocity: Floats) -> tuple[float, float, float]:
    """Return the rates of these."""
    count = len(velocity) // 3
    if body < count:
        return velocity[body], velocity[count + body], velocity[2 * count + body]
    return 0.0, 0.0, 0.0


def push_along(
    body: int, push: float, slopes: tuple[float, float, float], inverse: Floats, rate: Floats
) -> None:
    """Add what a push along the slopes of a row gives to the accelerations of a body."""
    count = len(rate) // 3
    if body < count:
        x, y, turn = slopes
        rate[body] = rate[body] + inverse[body] * push * x
        j = count + body
        rate[j] = rate[j] + inverse[j] * push * y
        j = 2 * count + body
        rate[j] = rate[j] + inverse[j] * push * turn


def length_of(position: Floats, fixed: Floats, reach: float, rounding: float) -> float:
    """Return a length that is not small, m: of bodies and fixed places, or else where they are."""
    count, others = len(position) // 3, len(fixed) // 2
    far, spread = 0.0, 0.0
    for axis in range(2):
        first = position[axis * count]
        low, high = first, first
        for i in range(count):
            low = min(low, position[axis * count + i])
            high = max(high, position[axis * count + i])
        for i in range(others):
            low = min(low, fixed[2 * i + axis])
            high = max(high, fixed[2 * i + axis])
        spread = max(spread, high - low)
        far = max(far, high, -low)
    length = max(spread, reach, rounding * far)
    if length > 0:
        return length
    return far if far > 0 else 1.0
