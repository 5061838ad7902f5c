"""What a simulation gives back: its numbers, which can be saved to a file and loaded again."""

from pathlib import Path

from tamias2d import record
from tamias2d.run_data import Impacts, RunData

__all__ = ["Impacts", "Run", "load"]


class Run(RunData):
    """The history of n bodies, static ones too and in the scene's order, at k times. SI units."""

    def save(self, path: str | Path) -> None:
        """Write the run as a recording (.rrd) or as plain arrays (.npz).

        Raises:
            InputError: the name ends in neither.
            RecordingError: it cannot be written.
        """
        record.save(self, path)


def load(path: str | Path) -> Run:
    """Read a run back, to the last bit, from a recording of either kind.

    Raises:
        InputError: the name ends in neither .rrd nor .npz.
        RecordingError: no such file, or it is cut, damaged or of another program.
    """
    return Run(**vars(record.load(path)))
