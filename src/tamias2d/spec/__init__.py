"""The language of srs/ and of scene files: expressions, units, items, their reader and printers."""
