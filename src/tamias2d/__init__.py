"""Tamias2D: 2D rigid-body physics, generated from its requirements specification."""
