"""Cholesky factors of the matrix of a tree-like island, in place, and their solution.

The block of a node becomes its triangular factor with inverse diagonal, that of an edge the product
with it. Cost: some blocks for each edge of the fill list.
Source: George and Liu (1981).
"""

from math import sqrt

from tamias2d.engine import tables as tb
from tamias2d.engine.tables import Integers
from tamias2d.kernels.assembled import inlined
from tamias2d.state import Array


def factor(n: int, sparse: Integers, factors: Array) -> bool:
    """Eliminate the nodes of an island in order; False if rounding leaves no positive pivot."""
    for pivot in range(sparse[n, tb.I_NODE], sparse[n + 1, tb.I_NODE]):
        start, count = sparse[pivot, tb.PIVOT_FIRST], sparse[pivot, tb.PIVOT_COUNT]
        block = factors[sparse[pivot, tb.PIVOT_NODE]]
        if not factor_block(block):
            return False
        for k in range(start, start + count):
            edge = sparse[k, tb.FILL]
            factor_edge(factors[edge], block, factors[sparse[edge, tb.E_NODE_B]])
        fill_in(start, count, sparse, factors)
    return True


@inlined
def factor_block(d: Array) -> bool:
    """Factor the block of a node; return False if a pivot is not positive."""
    if not d[0] > 0.0:
        return False
    a = 1.0 / sqrt(d[0])
    p, q = d[1] * a, d[3] * a
    second = d[2] - p * p
    if not second > 0.0:
        return False
    b = 1.0 / sqrt(second)
    r = (d[4] - q * p) * b
    third = d[5] - q * q - r * r
    if not third > 0.0:
        return False
    d[0], d[1], d[2], d[3], d[4], d[5] = a, p, b, q, r, 1.0 / sqrt(third)
    return True


@inlined
def factor_edge(e: Array, d: Array, later: Array) -> None:
    """Multiply the block of an edge by the inverse factor of its earlier node; update the later."""
    a, p, b, q, r, c = d[0], d[1], d[2], d[3], d[4], d[5]
    for m in range(3):
        at = tb.OFF_DIAGONAL + 3 * m
        u = e[at] * a
        v = (e[at + 1] - u * p) * b
        e[at], e[at + 1], e[at + 2] = u, v, (e[at + 2] - u * q - v * r) * c
    later[0] -= dot3(e, 0, e, 0)
    later[1] -= dot3(e, 1, e, 0)
    later[2] -= dot3(e, 1, e, 1)
    later[3] -= dot3(e, 2, e, 0)
    later[4] -= dot3(e, 2, e, 1)
    later[5] -= dot3(e, 2, e, 2)


@inlined
def fill_in(start: int, count: int, sparse: Integers, factors: Array) -> None:
    """Update the edges between the neighbours of a node that was eliminated."""
    at = start + count
    for k in range(count):
        for m in range(k):
            one, other = sparse[start + k, tb.FILL], sparse[start + m, tb.FILL]
            edge = sparse[at, tb.FILL]
            if sparse[edge, tb.E_NODE_A] == sparse[one, tb.E_NODE_B]:
                one, other = other, one
            f, g, e = factors[one], factors[other], factors[edge]
            for i in range(3):
                for j in range(3):
                    e[tb.OFF_DIAGONAL + 3 * i + j] -= dot3(f, i, g, j)
            at += 1


def dot3(one: Array, i: int, other: Array, j: int) -> float:
    """Multiply a row of the block of one edge with a row of another's."""
    i, j = tb.OFF_DIAGONAL + 3 * i, tb.OFF_DIAGONAL + 3 * j
    return one[i] * other[j] + one[i + 1] * other[j + 1] + one[i + 2] * other[j + 2]


def substitute(n: int, sparse: Integers, factors: Array) -> None:
    """Solve the factored equations of an island: the column CHANGE holds both sides."""
    for pivot in range(sparse[n, tb.I_NODE], sparse[n + 1, tb.I_NODE]):
        substitute_forward(pivot, sparse, factors)
    for pivot in range(sparse[n + 1, tb.I_NODE] - 1, sparse[n, tb.I_NODE] - 1, -1):
        substitute_back(pivot, sparse, factors)


@inlined
def substitute_forward(pivot: int, sparse: Integers, factors: Array) -> None:
    """Solve for a node by its lower triangle, and take it out of the later ones."""
    start = sparse[pivot, tb.PIVOT_FIRST]
    d = factors[sparse[pivot, tb.PIVOT_NODE]]
    x = d[tb.CHANGE] * d[0]
    y = (d[tb.CHANGE + 1] - d[1] * x) * d[2]
    z = (d[tb.CHANGE + 2] - d[3] * x - d[4] * y) * d[5]
    d[tb.CHANGE], d[tb.CHANGE + 1], d[tb.CHANGE + 2] = x, y, z
    for k in range(start, start + sparse[pivot, tb.PIVOT_COUNT]):
        e, later = factors[sparse[k, tb.FILL]], factors[sparse[sparse[k, tb.FILL], tb.E_NODE_B]]
        for m in range(3):
            at = tb.OFF_DIAGONAL + 3 * m
            later[tb.CHANGE + m] -= e[at] * x + e[at + 1] * y + e[at + 2] * z


@inlined
def substitute_back(pivot: int, sparse: Integers, factors: Array) -> None:
    """Take the later nodes out of a node, and solve for it by its upper triangle."""
    start = sparse[pivot, tb.PIVOT_FIRST]
    d = factors[sparse[pivot, tb.PIVOT_NODE]]
    x, y, z = d[tb.CHANGE], d[tb.CHANGE + 1], d[tb.CHANGE + 2]
    for k in range(start, start + sparse[pivot, tb.PIVOT_COUNT]):
        e, later = factors[sparse[k, tb.FILL]], factors[sparse[sparse[k, tb.FILL], tb.E_NODE_B]]
        for m in range(3):
            at, known = tb.OFF_DIAGONAL + 3 * m, later[tb.CHANGE + m]
            x -= e[at] * known
            y -= e[at + 1] * known
            z -= e[at + 2] * known
    z = z * d[5]
    y = (y - d[4] * z) * d[2]
    x = (x - d[1] * y - d[3] * z) * d[0]
    d[tb.CHANGE], d[tb.CHANGE + 1], d[tb.CHANGE + 2] = x, y, z
