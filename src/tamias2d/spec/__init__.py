"""The language of srs/ and of scene files: expressions, units, items, their reader and printers.

Serves: generator, scenes, docs, verification. Hides: how text becomes trees, numbers, code and
formulas.
"""
