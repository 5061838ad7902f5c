"""Where equations become code: printed from srs/ by `python -m tools.generate`."""
