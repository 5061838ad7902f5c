"""The order in which the bodies of a mechanism are eliminated, and the fill list that follows.

The body with the fewest neighbours is next, and its neighbours become connected (Tinney and Walker
1967). It is found once, as joints come or go; steps only follow the list.

Cost: of a tree a visit to each joint; of a mesh as many as its factors have blocks.
"""

from collections.abc import Iterable, Sequence
from heapq import heapify, heappop, heappush
from typing import NamedTuple


class Elimination(NamedTuple):
    """Pivots and edges of a mechanism; an edge is a pair of nodes in the order of elimination."""

    order: list[int]
    """Nodes as they are eliminated."""
    edges: dict[tuple[int, int], int]
    """Numbers of edges."""
    fill: list[list[int]]
    """For each pivot its edges, and then those that change by it."""
    degree: list[int]
    """For each pivot how many edges it has."""


def eliminated(
    nodes: Sequence[int], pairs: Iterable[tuple[int, int]], most: int
) -> Elimination | None:
    """Return the order of elimination of nodes that some pairs connect.

    None if its fill list had more than so many entries: it is a mesh of many loops.
    """
    around: dict[int, set[int]] = {node: set() for node in nodes}
    for one, other in pairs:
        around[one].add(other)
        around[other].add(one)
    waiting = [(len(around[node]), node) for node in nodes]
    heapify(waiting)
    found = Elimination([], {}, [], [])
    left = set(nodes)
    later: list[list[int]] = []
    size = 0
    while waiting:
        degree, node = heappop(waiting)
        if node not in left or degree != len(around[node]):
            continue
        left.discard(node)
        neighbours = sorted(around.pop(node))
        size += len(neighbours) * (len(neighbours) + 1) // 2
        if size > most:
            return None
        found.order.append(node)
        later.append(neighbours)
        for one in neighbours:
            around[one].update(neighbours)
            around[one] -= {one, node}
        for one in neighbours:
            heappush(waiting, (len(around[one]), one))
    place = {node: k for k, node in enumerate(found.order)}
    for node, neighbours in zip(found.order, later, strict=True):
        own = [found.edges.setdefault((node, one), len(found.edges)) for one in neighbours]
        found.fill.append(own)
        found.degree.append(len(own))
    for own, neighbours in zip(found.fill, later, strict=True):
        for k, one in enumerate(neighbours):
            for other in neighbours[:k]:
                early, late = sorted((one, other), key=place.__getitem__)
                own.append(found.edges[early, late])
    return found
