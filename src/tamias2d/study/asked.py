"""A run that is asked for within a tolerance, and how its tries are made."""

from typing import Any, NamedTuple

import numpy as np

from tamias2d.motion import Dop853, DormandPrince5
from tamias2d.motion.error_equation import Watch
from tamias2d.motion.halved import Halving
from tamias2d.run import Run
from tamias2d.scene import Scene
from tamias2d.solve import sampled_at, solve, solve_halved, solve_with_error
from tamias2d.state import Array
from tamias2d.study.looks import with_looks
from tamias2d.study.pilot import Estimate


class Asked(NamedTuple):
    """What is asked for."""

    scene: Scene
    duration: float
    tolerance: float
    times: Array
    progress: bool
    work_limit: int

    def at(self, tolerance: float | None, duration: float) -> "Asked":
        """Return what is asked for at another tolerance, if one is given, and up to a time, s."""
        times = self.times
        if duration < self.duration:
            times = np.append(times[times < duration], duration)
        return self._replace(
            tolerance=tolerance or self.tolerance, duration=duration, times=times, progress=False
        )

    def looked_at(self) -> "Asked":
        """Return what is asked for with samples also when a run is looked at."""
        return self._replace(times=with_looks(self.times, self.duration))

    def sampled(self, run: Run) -> Run:
        """Return a run with those samples only that are asked for."""
        found = sampled_at(run, self.times)
        assert found is not None
        return found

    def run(self, estimate: Estimate) -> Run:
        """Return the run that was estimated."""
        return solve(
            self.scene, method=estimate.method, time_step=estimate.time_step, **self._given()
        )

    def halved(self, method: Dop853 | DormandPrince5) -> tuple[Run, Halving | None]:
        """Return the run of a method by halved steps, as `solve_halved`."""
        return solve_halved(self.scene, method=method, **self._given())

    def with_error(
        self, method: Dop853 | DormandPrince5, watch: Watch | None = None
    ) -> tuple[Run, Array | None]:
        """Return the run of a method with the largest error of its path, as `solve_with_error`."""
        watched: dict[str, Any] = {} if watch is None else {"watch": watch}
        return solve_with_error(self.scene, method=method, **self._given(), **watched)

    def _given(self) -> dict[str, Any]:
        """Return what all solvers take alike."""
        return {
            "duration": self.duration,
            "times": self.times,
            "progress": self.progress,
            "work_limit": self.work_limit,
        }

    def is_met(self, run: Run) -> bool:
        """Return whether the certificate of a run is within the tolerance."""
        return run.certificate is not None and run.certificate.meets(self.tolerance)
