"""Queries: ray casting, and the shapes at a point or in a box.

Serves: the simulator. Hides: the tree, and how each kind of shape is entered.
"""
