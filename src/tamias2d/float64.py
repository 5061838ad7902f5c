"""What float64 is: the numbers in which all of this is computed."""

EPSILON = 2.0**-52
"""The distance from 1 to the next number: twice the largest relative error of a rounding."""
