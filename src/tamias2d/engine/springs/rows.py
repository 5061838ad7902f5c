"""Springs as rows of the engine's arrays: which bodies they hold, and how these form networks."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from tamias2d.engine import tables as tb
from tamias2d.engine.arrays.store import Store
from tamias2d.state import Vector


class SpringRow(NamedTuple):
    """A spring between two bodies, given by rows, or between a body and a point of the plane."""

    first: int
    second: int | None
    stiffness: float
    """N/m"""
    rest_length: float
    """m"""
    damping: float
    """kg/s"""
    anchor: Vector
    """m, in the axes of the first body"""
    other_anchor: Vector
    """m, in the axes of the second body; or the point"""


def set_springs(store: Store, rows: Sequence[SpringRow]) -> None:
    """Let springs act, and no others; they act in their order."""
    networks = _networks(store, rows)
    members = [_members(network) for network in networks]
    store.resize(
        springs=len(rows),
        members=sum(len(found) for found in members),
        networks=len(networks) + 1,
    )
    springs = store.world.springs
    springs.counts[[tb.SPRINGS, tb.NETWORKS]] = len(rows), len(networks)
    springs.networks[:] = 0
    springs.members[:, tb.TURNED] = 0.0
    springs.networks[1:, tb.N_MEMBER] = np.cumsum([len(found) for found in members])
    springs.networks[1:, tb.N_SPRING] = np.cumsum([len(network) for network in networks])
    s = 0
    for first, network, found in zip(
        springs.networks[:, tb.N_MEMBER], networks, members, strict=False
    ):
        place = {body: first + k for k, body in enumerate(found)}
        springs.body[first : first + len(found)] = found
        for row in network:
            springs.ends[s] = place[row.first], -1 if row.second is None else place[row.second]
            springs.springs[s, [tb.STIFFNESS, tb.REST_LENGTH, tb.DAMPER]] = row[2:5]
            springs.springs[s, tb.ANCHOR_A : tb.ANCHOR_A + 2] = row.anchor
            springs.springs[s, tb.ANCHOR_B : tb.ANCHOR_B + 2] = row.other_anchor
            for end, anchor in zip(springs.ends[s], (row.anchor, row.other_anchor), strict=True):
                if end >= 0 and any(anchor):
                    springs.members[end, tb.TURNED] = 1.0
            s += 1
    store.world.touching.counts[tb.ARRANGED] = 0


def _networks(store: Store, rows: Sequence[SpringRow]) -> list[list[SpringRow]]:
    """Return the springs of each network, networks in the order of their first springs."""
    kind = store.world.state.kind
    network_of: dict[int, list[SpringRow]] = {}
    for row in rows:
        free = [body for body in (row.first, row.second) if body is not None]
        free = [body for body in free if kind[body] == tb.DYNAMIC]
        network = network_of.get(free[0], [])
        for body in free:
            other = network_of.get(body, network)
            if other is not network:
                network += other
                network_of.update((k, network) for k, known in network_of.items() if known is other)
            network_of[body] = network
        network.append(row)
    order = {id(row): k for k, row in enumerate(rows)}
    found = {id(network): network for network in network_of.values()}.values()
    for network in found:
        network.sort(key=lambda row: order[id(row)])
    return sorted(found, key=lambda network: order[id(network[0])])


def _members(network: Sequence[SpringRow]) -> list[int]:
    bodies = (body for row in network for body in (row.first, row.second) if body is not None)
    return list(dict.fromkeys(bodies))
