"""How wrong runs are, and what that costs: errors, work and precision, other engines, long runs.

Serves: users who trade speed for accuracy. Hides: which file measures what.
"""
