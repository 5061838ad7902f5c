"""By how much chance puts the mean of a sample off, also of one that missed what is rare.

The variance of a skewed quantity rises with its mean: a sample with too few of the rare worlds has
too low a mean, and too low a variance as well. So the bound is where the mean would have to be for
the sample to be a rare one, with the variance that it would have there: Wilson's score interval,
which is for shares, with the skewness of the sample in place of that of a share. Student's factor
is for variances that are themselves from few worlds.

Sources: Wilson, Probable inference, the law of succession, and statistical inference, Journal of
the American Statistical Association 22 (1927) 209-212; Johnson, Modified t tests and confidence
intervals for asymmetrical populations, the same 73 (1978) 536-544.
"""

import math

import numpy as np

from tamias2d.generated import definitions
from tamias2d.state import Array

CONFIDENCE = 0.99
"""With which the statistical error is stated."""
QUANTILE = 2.5758293035489004
"""Of a normal distribution: so many standard deviations hold a share of `CONFIDENCE`."""


def variance_for(values: Array, unseen: float) -> float:
    """Return the variance that a bound by chance is to be taken from, at this number of values.

    It makes `QUANTILE * sqrt(variance / len(values))` the end of the score interval. Where all
    values are the same, it is that of a share, in which the others lie `unseen` away.
    """
    count = len(values)
    if is_one_value(values):
        return (QUANTILE * unseen) ** 2 / count
    scale = float(np.ptp(values))  # or else squares of small numbers are 0
    deviations = (values - values.mean()) / scale
    spread = math.sqrt(float(np.sum(deviations**2)) / (count - 1))
    skewness = abs(float(np.mean((deviations / spread) ** 3))) / math.sqrt(count)
    student = 1 + (QUANTILE**2 + 1) / (4 * (count - 1))
    half = student * QUANTILE * skewness / 2
    deviation: float = scale * spread * student * (half + math.hypot(1, half))
    return deviation * deviation


def is_one_value(values: Array) -> bool:
    """Return whether all values are the same."""
    return bool((values == values[0]).all())


def most_others(count: int) -> float:
    """Return the share of worlds that may be otherwise, if so many are all the same (DD115)."""
    return float(definitions.unseen_share(CONFIDENCE, count))
