"""The narrow phase: the manifold of two shapes, with a normal and up to two points and their gaps.

Serves: a step, for all contacts at its start, and continuous collision, for shapes on their paths.
Hides: the kinds of shapes, and the cached axis.
"""
