"""Verification: the cases of srs/verification run and judged.

Service: `verify` gives an outcome for every comparison of every case. Secret: the ways of
comparing, one small module each. No exact answer comes from the code that it judges.
"""

from tamias2d.verify.engine import cases, verify
from tamias2d.verify.outcome import FAIL, MANUAL, PASS, Outcome

__all__ = ["FAIL", "MANUAL", "PASS", "Outcome", "cases", "verify"]
