"""Verification: the cases of srs/verification run and judged.

Serves: `verify`, which gives an outcome for every comparison of every case. Hides: the comparisons,
one small module each. No exact answer comes from the code that it judges.
"""

from tamias2d.verify.outcome import FAIL, MANUAL, NOT_RUN, PASS, Outcome
from tamias2d.verify.suite import cases, verify

__all__ = ["FAIL", "MANUAL", "NOT_RUN", "PASS", "Outcome", "cases", "verify"]
