"""Random cases by seed: each is done, or refused by name; anything else is a fault.

Serves: the tests, a few seeds of each kind, and `python -m tools.measure fuzz`, as many as asked.
"""
