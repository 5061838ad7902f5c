"""Tolerances of methods that studies choose are rounded: plans and notes are read by people."""


def two_digits(tolerance: float) -> float:
    """Return a tolerance rounded to two digits."""
    return float(f"{tolerance:.1e}")
