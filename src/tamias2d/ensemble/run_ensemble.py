"""`tamias2d.ensemble`: many worlds, on all cores or many machines, as one dataset."""

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from tamias2d.ensemble.dataset import dataset_of, refuse_bad_names
from tamias2d.ensemble.execution import done, executors_of
from tamias2d.ensemble.followed import share_followed
from tamias2d.ensemble.request import STATE, Quantity, Request, request_of
from tamias2d.ensemble.sampling import Design
from tamias2d.ensemble.solving import REFUSED, Block, solved_block
from tamias2d.ensemble.stepped import mostly_stepped
from tamias2d.ensemble.store import Store
from tamias2d.ensemble.worlds import MadeWorlds, Maker, VariedWorlds, Worlds, worlds_of
from tamias2d.motion import Method
from tamias2d.record.dataset import refuse_missing_extra
from tamias2d.scene import Scene
from tamias2d.scene.rules import checked_count
from tamias2d.suggestions import suggests
from tamias2d.work_limit import WORK_LIMIT

if TYPE_CHECKING:
    from xarray import Dataset

Told = Callable[[int, int], None]
"""Hears how many worlds are finished, and how many there are."""

_LONGEST = 1024  # worlds of a chunk
_LONGEST_QUICK = 32_768  # of worlds that take microseconds each: to hand over fewer takes as long
_LARGEST = 2**24  # bytes of a chunk that is stored; half of one that stays in memory
_BODY = 200  # bytes in the tables from which compiled code follows, or steps, it
_EACH = 4  # chunks for each worker, so that none waits long for the last one
_EACH_QUICK = 2  # the same on a cluster, which needs milliseconds for a chunk
_MOSTLY = 0.98  # of the worlds; one that is not followed takes as long as a thousand others


@suggests
def ensemble(
    scene: Scene | Maker,
    *,
    duration: float,
    vary: Mapping[str, Any] | None = None,
    worlds: int | None = None,
    seed: int | None = None,
    design: Design | None = None,
    method: Method | None = None,
    time_step: float | None = None,
    tolerance: float | None = None,
    times: Iterable[float] | None = None,
    keep: Sequence[str] = STATE,
    bodies: Sequence[int | str] | None = None,
    quantities: Mapping[str, Quantity] | None = None,
    work_limit: int = WORK_LIMIT,
    out: str | Path | None = None,
    chunk: int | None = None,
    workers: int | None = None,
    client: Any = None,
    progress: bool | Told = False,
) -> "Dataset":
    """Simulate a scene in many worlds, and return what is kept as an `xarray.Dataset`.

    `vary` says what differs, by its place in the scene: ``"bodies.ball.restitution"``,
    ``"gravity.y"``, ``"restitution_of_pairs.ball.floor"``, ``"springs.0.stiffness"``. Each has a
    value for each world, a `Grid`, or a distribution of `scipy.stats`, from which `worlds` values
    are drawn with a `seed`, spread by a `design` such as `scipy.stats.qmc.Sobol` if one is given.
    Instead, the scene may be a function of the number of a world and of a `numpy` generator that
    returns its scene. World k is the same whatever the number of worlds (but for designs).

    Each world has the bits that `simulate` gives for it alone, wherever and in whatever order it
    is computed. `duration`, `method`, `time_step`, `tolerance`, `times` and `work_limit` are those
    of `simulate`; without `times` the end alone is kept. `keep` names values of a run, `bodies`
    those bodies that are kept (without it all that move), and `quantities` are functions from a
    run to a number. The run that they see has the samples at `times`, and without these all that
    `simulate` gives: for those that look at the end alone, ``times=(duration,)`` saves time.
    `outcome` tells which worlds were located, stepped, or refused as `simulate` would: their
    values are NaN.

    With `out` the results go to a Zarr store in chunks of `chunk` worlds, and the same call goes
    on where an interrupted one was. Worlds are computed by `workers` processes on this machine,
    as many as it has cores unless stated, or by a `client` of Dask. `progress` shows a bar, or is
    a function that hears how many worlds are finished, and how many there are.

    Raises:
        InputError: an argument breaks a rule, or a value that of its symbol.
        SceneError, SimulationError: all worlds of the first chunk that is done are refused, each
            as `simulate` refuses it; or workers died again and again.
        RecordingError: `out` cannot be written or holds something else, or xarray is missing.
    """
    refuse_missing_extra()
    described = worlds_of(scene, vary, worlds, seed, design)
    request = request_of(
        described.scene(0),
        duration=duration,
        method=method,
        time_step=time_step,
        tolerance=tolerance,
        times=times,
        keep=keep,
        bodies=bodies,
        quantities=quantities,
        work_limit=work_limit,
    )
    refuse_bad_names(described, request)
    found: Dataset
    with _told(progress) as told:
        found = _computed(described, request, out, chunk, workers, client, told)
    return found


def _computed(
    worlds: VariedWorlds | MadeWorlds,
    request: Request,
    out: str | Path | None,
    chunk: int | None,
    workers: int | None,
    client: Any,
    told: Told,
) -> Any:
    """Return the dataset of all worlds, computed where they are to be."""
    followed = share_followed(worlds, request)
    brief = followed == 1.0 or mostly_stepped(worlds, request)
    quick = brief or followed > _MOSTLY
    executors = executors_of(workers, client, threads=brief and client is None)
    hands = 1 if executors is None else executors.hands
    pieces = hands * (_EACH_QUICK if brief and client is not None else _EACH)
    longest = _LONGEST_QUICK if quick else _LONGEST
    size = _chunk(chunk, len(worlds), pieces, longest, _longest_of(request, stored=out is not None))
    if out is None:
        return _in_memory(worlds, request, size, executors, told)
    return _stored(worlds, request, size, executors, told, Store(Path(out)))


def _in_memory(
    worlds: VariedWorlds | MadeWorlds, request: Request, size: int, executors: Any, told: Told
) -> Any:
    count = len(worlds)
    arrays = {name: np.full((count, *request.shape(name)), np.nan) for name in request.kept}
    arrays["outcome"] = np.zeros(count, dtype=np.int8)
    blocks = [(first, min(first + size, count)) for first in range(0, count, size)]
    tasks = [partial(_task, worlds, request, first, last) for first, last in blocks]
    finished = 0
    for block in _watched(done(tasks, executors)):
        rows = slice(block.first, block.last)
        for name, values in {**block.arrays, "outcome": block.outcome}.items():
            arrays[name][rows] = values
        finished += len(block.outcome)
        told(finished, count)
    return dataset_of(worlds, request, lambda name, _: arrays[name])


def _stored(
    worlds: VariedWorlds | MadeWorlds,
    request: Request,
    size: int,
    executors: Any,
    told: Told,
    store: Store,
) -> Any:
    blocks = store.prepare(worlds, request, size)
    finished = len(worlds) - sum(last - first for first, last in blocks)
    told(finished, len(worlds))
    tasks = [partial(_task, worlds, request, first, last, store) for first, last in blocks]
    for block in _watched(done(tasks, executors)):
        finished += len(block.outcome)
        told(finished, len(worlds))
    return store.dataset()


def _task(
    worlds: VariedWorlds | MadeWorlds,
    request: Request,
    first: int,
    last: int,
    store: Store | None = None,
) -> Callable[[], Block]:
    """Return a block's work with no more than it needs, to be sent to a worker."""
    return partial(_worked, worlds.part(first, last), request, first, last, store)


def _worked(worlds: Worlds, request: Request, first: int, last: int, store: Store | None) -> Block:
    block = solved_block(worlds, request, first, last)
    if store is None:
        return block
    store.write(block)
    return Block(first, {}, block.outcome, block.refusal)


def _watched(blocks: Iterator[Block]) -> Iterator[Block]:
    """Yield blocks; raise the refusal of the first one if none of its worlds has an answer."""
    for k, block in enumerate(blocks):
        if k == 0 and block.refusal is not None and (block.outcome == REFUSED).all():
            raise block.refusal
        yield block


def _chunk(asked: int | None, count: int, pieces: int, *longest: int) -> int:
    """Return how many worlds are computed, and stored, together."""
    return min(-(-count // pieces), *longest) if asked is None else checked_count(asked, "chunk", 1)


def _longest_of(request: Request, *, stored: bool) -> int:
    """Return of how many worlds memory holds what is kept, and the tables, beside all others."""
    most = _LARGEST if stored else 2 * _LARGEST
    return max(most // (request.size + _BODY * len(request.names)), 1)


@contextmanager
def _told(progress: bool | Told) -> Iterator[Told]:
    """Give a function that shows how far the ensemble is."""
    if callable(progress):
        yield progress
    elif not progress:
        yield lambda finished, count: None  # noqa: ARG005
    else:
        from rich.console import Console
        from rich.progress import MofNCompleteColumn, Progress

        columns = (*Progress.get_default_columns(), MofNCompleteColumn())
        with Progress(*columns, console=Console(stderr=True), transient=True) as bar:
            task = bar.add_task("worlds", total=None)
            yield lambda finished, count: bar.update(task, completed=finished, total=count)
