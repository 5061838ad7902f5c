"""Compare the bounds of certificates with exact errors."""

from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np

from tamias2d.simulate import simulate
from tamias2d.verify.case import Case
from tamias2d.verify.exact import answers
from tamias2d.verify.formula import Bodies
from tamias2d.verify.outcome import Outcome


def compare(case: Case, given: Mapping[str, Any]) -> Iterator[Outcome]:
    """For each asked tolerance: the bound as a share of it, the true error as a share of the bound.

    The error is that of positions, over the whole history, relative to how far the farthest body
    goes.
    """
    bodies: Bodies = {
        body: {"position": quantities["position"]}
        for body, quantities in case.data["exact"]["bodies"].items()
    }
    for asked in given["tolerances"]:
        run = simulate(case.scene, duration=case.duration, tolerance=float(asked))
        claimed = run.certificate.bound if run.certificate else None
        bound = float("nan") if claimed is None else claimed
        found = list(answers(run, bodies, slice(None)))
        off = max(float(np.linalg.norm(one.found - one.exact, axis=-1).max()) for one in found)
        size = max(float(np.hypot(*np.ptp(one.exact, axis=0))) for one in found)
        note = f"bound {bound:.2g}, true {off / size:.2g}, {run.method}"
        yield case.outcome(given, f"bound over {asked}", bound / float(asked))
        yield case.outcome(given, f"error over bound, for {asked}", off / size / bound, note)
