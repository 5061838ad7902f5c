"""Where equations become code: printed from srs/ by `python -m tools.generate`.

Serves: every part that computes. Hides: nothing: it is there to be read.
"""
