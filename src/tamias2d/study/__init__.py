"""How wrong runs are, and what that costs: errors, work and precision, other engines, long runs."""
