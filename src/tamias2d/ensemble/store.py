"""Ensembles on disk: a Zarr store to which each worker writes the blocks that it has solved.

Serves: ensembles that memory does not hold, or that may be interrupted. Hides: the store, and how
it is known which blocks are finished. A block is entered in the store's ledger when all of its
chunks are written, and is finished as long as these are what was entered.
"""

import os
import secrets
import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from tamias2d.ensemble.dataset import WORLDS, dataset_of, refuse_other
from tamias2d.ensemble.ledger import Ledger
from tamias2d.ensemble.request import Request
from tamias2d.ensemble.solving import Block
from tamias2d.ensemble.worlds import MadeWorlds, VariedWorlds
from tamias2d.errors import RecordingError, path_text
from tamias2d.record.dataset import extra

_MADE = "made"
"""The ledger's entry of what describes the store, and was written when it was made."""


class Store:
    """The results of an ensemble in a directory."""

    def __init__(self, path: Path) -> None:
        self.path = path.absolute()
        self._ledger = Ledger(self.path)

    def prepare(
        self, worlds: VariedWorlds | MadeWorlds, request: Request, chunk: int
    ) -> list[tuple[int, int]]:
        """Make the store, or go on with it; return the blocks that are not finished.

        Raises:
            RecordingError: it holds something else, is damaged, or cannot be written.
        """
        if "\0" in str(self.path):
            raise RecordingError(f"{path_text(self.path)}: is no name of a file (R8). Rename it.")
        if not os.path.isdir(self.path.parent):
            raise RecordingError(
                f"{self.path}: there is no directory {self.path.parent}. Make it first."
            )
        with self._written():
            if not self.path.exists():
                self._make(worlds, request, chunk)
        self._refuse_damaged()
        group = self._opened("r")
        refuse_other(dict(group.attrs), worlds, request, str(self.path))
        chunk = group["outcome"].chunks[0]
        return [
            (first, min(first + chunk, len(worlds)))
            for first in range(0, len(worlds), chunk)
            if self._ledger.damaged(str(first // chunk))
        ]

    def write(self, block: Block) -> None:
        """Write a block; it counts as finished from the end of this call on.

        Raises:
            RecordingError: it cannot be written, as on a full disk.
        """
        with self._written():
            group = self._opened("r+")
            number = str(block.first // group["outcome"].chunks[0])
            arrays: dict[str, NDArray[Any]] = {"outcome": block.outcome, **block.arrays}
            chunks = [
                f"{name}/{'.'.join([number] + ['0'] * (values.ndim - 1))}"
                for name, values in arrays.items()
            ]
            for chunk in chunks:  # what is damaged cannot be written over
                (self.path / chunk).unlink(missing_ok=True)
            for name, values in reversed(arrays.items()):
                group[name][block.first : block.last] = values
            self._ledger.enter(number, chunks)

    def dataset(self) -> Any:
        """Return the `xarray.Dataset`, of which values are read when they are asked for."""
        with extra():
            from dask import config
            from xarray import open_zarr

        found = open_zarr(self.path, consolidated=False)
        with config.set(scheduler="synchronous"):
            return found.assign_coords({name: found[name].load() for name in found.coords})

    def _make(self, worlds: VariedWorlds | MadeWorlds, request: Request, chunk: int) -> None:
        """Make an empty store beside its place, and put it there whole."""
        draft = self.path.with_name(f".{self.path.name}-draft-{secrets.token_hex(8)}")
        template = _template(worlds, request, chunk)
        sizes: dict[str, dict[str, Any]] = {
            name: {"chunks": (chunk, *variable.shape[1:])}
            for name, variable in template.variables.items()
            if variable.dims and variable.dims[0] == WORLDS
        }
        sizes["outcome"]["_FillValue"] = None
        with extra():
            from dask import config
        try:
            with config.set(scheduler="synchronous"):  # not a client that is gone
                template.to_zarr(
                    draft, compute=False, consolidated=False, zarr_format=2, encoding=sizes
                )
            files = [file for file in draft.rglob("*") if file.is_file()]
            Ledger(draft).enter(_MADE, [file.relative_to(draft).as_posix() for file in files])
            os.rename(draft, self.path)
        finally:
            shutil.rmtree(draft, ignore_errors=True)

    def _refuse_damaged(self) -> None:
        """Raise `RecordingError` if what describes the store is not there as it was made."""
        if _MADE not in self._ledger:
            raise RecordingError(
                f"{self.path}: is no Zarr store of an ensemble, or one of another version of the "
                "program (R8). Give another `out`, or delete it."
            )
        if damaged := self._ledger.damaged(_MADE):
            raise RecordingError(
                f"{self.path}: its file {damaged} is missing, or not as it was written (R8). Bring "
                "it back from a copy, or delete the store, then call again."
            )

    def _opened(self, mode: Literal["r", "r+"]) -> Any:
        with extra():
            from zarr import open_group

        return open_group(self.path, mode=mode, zarr_format=2)

    @contextmanager
    def _written(self) -> Iterator[None]:
        try:
            yield
        except OSError as fault:
            why = fault.strerror or type(fault).__name__
            raise RecordingError(
                f"{self.path}: cannot be written: {why}. Check the disk's space and the "
                "permissions, then call again: what was finished is kept."
            ) from fault


def _template(worlds: VariedWorlds | MadeWorlds, request: Request, chunk: int) -> Any:
    """Return the dataset with arrays that take no memory."""
    with extra():
        from dask.array import zeros

    def array(name: str, shape: tuple[int, ...]) -> Any:
        kind = np.int8 if name == "outcome" else np.float64
        return zeros(shape, dtype=kind, chunks=(max(chunk, 1), *shape[1:]))

    return dataset_of(worlds, request, array)
