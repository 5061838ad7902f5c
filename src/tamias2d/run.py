"""What a simulation gives back: its numbers, which can be saved to a file and loaded again."""

from pathlib import Path
from typing import TYPE_CHECKING

from tamias2d import record
from tamias2d.run_data import Impacts, RunData
from tamias2d.suggestions import suggests

if TYPE_CHECKING:
    from pandas import DataFrame
    from xarray import Dataset

__all__ = ["Impacts", "Run"]


@suggests
class Run(RunData):
    """The history of n bodies, static ones too and in the scene's order, at k times. SI units."""

    def save(self, path: str | Path) -> None:
        """Write the run as a recording (.rrd) or as plain arrays (.npz).

        Raises:
            InputError: the name ends in neither.
            RecordingError: it cannot be written.
        """
        record.save(self, path)

    @classmethod
    def load(cls, path: str | Path) -> "Run":
        """Read a run back, to the last bit, from a recording of either kind.

        Raises:
            InputError: the name ends in neither .rrd nor .npz.
            RecordingError: no such file, or it is cut, damaged or of another program.
        """
        return cls(**vars(record.load(path)))

    def plot(self, path: str | Path) -> None:
        """Draw the paths of all bodies, their heights and the energy (.png, .svg, .pdf).

        A picture in .gif moves: 25 times a second it shows where the bodies are.

        Raises:
            InputError: no kind of picture has this ending.
            RecordingError: it cannot be written, or matplotlib is not installed
                (`pip install "tamias2d[plot]"`).
        """
        from tamias2d.record.plot import plot

        plot(self, path)

    def to_xarray(self) -> "Dataset":
        """Return the run as an `xarray.Dataset` over time, body and axis, units in `attrs`.

        Raises:
            RecordingError: xarray is not installed (`pip install "tamias2d[ensemble]"`).
        """
        found: Dataset = record.to_xarray(self)
        return found

    def to_dataframe(self) -> "DataFrame":
        """Return the run as a `pandas.DataFrame`: a row for each time and body.

        Columns are `position_x`, `position_y`, `orientation` and so on; units are in `attrs`.

        Raises:
            RecordingError: pandas is not installed (`pip install "tamias2d[ensemble]"`).
        """
        found: DataFrame = record.to_dataframe(self)
        return found
