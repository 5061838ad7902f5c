"""The Pareto front: the points that no other beats in both error and cost."""

from collections.abc import Sequence


def front(pairs: Sequence[tuple[float, float]]) -> list[int]:
    """Return the places of (cost, error) pairs on the front, from cheap to dear.

    Of equal pairs the first stands for all.
    """
    best = float("inf")
    found = []
    for place in sorted(range(len(pairs)), key=lambda k: (pairs[k], k)):
        error = pairs[place][1]
        if error < best:
            found.append(place)
            best = error
    return found
