"""Rings of names that lead back to themselves.

Serves: checks of equations and of links, where what rests on itself says nothing. Hides: how
rings are found without a deep recursion.
"""

from collections.abc import Iterator, Mapping, Sequence


def rings(steps: Mapping[str, Sequence[str]]) -> Iterator[list[str]]:
    """Rings among names, each from its first name back to it; no name is in two of them."""
    left = _in_or_before_a_ring(steps)
    while left:
        ring = _ring(left)
        yield [*ring, ring[0]]
        left = _in_or_before_a_ring({name: left[name] for name in left if name not in ring})


def _in_or_before_a_ring(steps: Mapping[str, Sequence[str]]) -> dict[str, list[str]]:
    """Names whose steps never end, with those steps."""
    left = {name: list(targets) for name, targets in steps.items()}
    while True:
        going = {name: [t for t in targets if t in left] for name, targets in left.items()}
        if all(going.values()):
            return going
        left = {name: targets for name, targets in going.items() if targets}


def _ring(left: Mapping[str, Sequence[str]]) -> list[str]:
    """A ring among names of which each has a step, from that of its names that comes first."""
    path = [next(iter(left))]
    while (following := left[path[-1]][0]) not in path:
        path.append(following)
    ring = path[path.index(following) :]
    first = ring.index(next(name for name in left if name in ring))
    return ring[first:] + ring[:first]
