"""The energy of islands: measured from what bears them, and taken where it is too much."""
