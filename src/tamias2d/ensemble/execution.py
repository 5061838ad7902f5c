"""Where blocks of worlds are computed: in this process, in processes beside it, or on a cluster.

Serves: ensembles. Hides: the executors, and what happens when one of their workers dies. Blocks
come back as they are done; which worker took which one changes no number.
"""

import os
from collections import deque
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import (
    FIRST_COMPLETED,
    BrokenExecutor,
    CancelledError,
    Executor,
    Future,
    ThreadPoolExecutor,
    wait,
)
from typing import Any, Protocol, TypeAlias, TypeVar
from weakref import WeakKeyDictionary

from tamias2d.certificate import source_digest
from tamias2d.errors import SimulationError, TamiasError
from tamias2d.record.dataset import extra
from tamias2d.scene.rules import RuleError, checked_count, shown

_Result = TypeVar("_Result")
Task: TypeAlias = Callable[[], _Result]
_MOST_DEATHS = 3  # of workers, one after the other, without a block being done


class Executors(Protocol):
    """Whoever gives executors."""

    @property
    def hands(self) -> int:
        """How many tasks are computed at a time."""

    @property
    def waiting(self) -> int:
        """How many tasks to hand over before the first of them is done."""

    def executor(self) -> Executor:
        """Return one that works, a new one after one that broke."""


def executors_of(workers: int | None, client: Any, *, threads: bool = False) -> Executors | None:
    """Return where to compute, None for this process alone.

    `threads` are enough where compiled code does most of the work, without Python's lock.

    Raises:
        RuleError: the number of workers is none, or the client is no Dask client.
    """
    if client is not None:
        if workers is not None:
            raise RuleError(
                "workers: found beside a client, whose cluster has its own (R5). Leave one out.",
                "workers",
            )
        return _Cluster(client)
    count = cores() if workers is None else checked_count(workers, "workers", 1)
    if count == 1:
        return None
    return _Threads(count) if threads else _Processes(count)


def done(
    tasks: Sequence[Callable[[], Task[_Result]]], executors: Executors | None
) -> Iterator[_Result]:
    """Yield the results of tasks as they come; each is made when its turn comes.

    Raises:
        SimulationError: workers die again and again, or the cluster is gone.
    """
    if executors is None or len(tasks) == 1:
        for make in tasks:
            yield make()()
        return
    left = deque(tasks)
    deaths = 0
    while left:
        begun: dict[Future[_Result], Callable[[], Task[_Result]]] = {}
        executor = executors.executor()
        try:
            while left or begun:
                most = 1 if deaths else executors.waiting  # alone, a task takes no other with it
                while left and len(begun) < most:
                    make = left.popleft()
                    begun[executor.submit(make())] = make
                for future in wait(begun, return_when=FIRST_COMPLETED).done:
                    result = future.result()
                    begun.pop(future)
                    deaths = 0
                    yield result
        except BrokenExecutor as death:
            deaths += 1
            if deaths == _MOST_DEATHS:
                raise SimulationError(
                    f"ensemble: {deaths} workers died one after the other ({_first_line(death)}): "
                    "memory may be short (R5). Take fewer workers or smaller chunks; what was "
                    "finished is kept where `out` says."
                ) from death
            left.extendleft(reversed(begun.values()))
        except CancelledError as loss:  # the scheduler is gone
            raise _lost(loss) from loss
        except Exception as fault:
            if type(fault).__module__.partition(".")[0] != "distributed":
                raise
            raise _lost(fault) from fault
        finally:
            for future in begun:
                future.cancel()


def cores() -> int:
    """Return how many cores this process may use."""
    try:
        return len(os.sched_getaffinity(0))
    except AttributeError:  # macOS, Windows
        return os.cpu_count() or 1


def _first_line(fault: BaseException) -> str:
    return (str(fault).strip().splitlines() or [type(fault).__name__])[0]


class _Threads:
    """Threads of this process."""

    def __init__(self, count: int) -> None:
        self._executor = ThreadPoolExecutor(count)
        self.hands, self.waiting = count, 2 * count

    def executor(self) -> Executor:
        return self._executor


class _Processes:
    """Processes on this machine, which stay for a while for the next ensemble."""

    def __init__(self, count: int) -> None:
        self.hands, self.waiting = count, 2 * count

    def executor(self) -> Executor:
        with extra():
            from loky import get_reusable_executor

        found: Executor = get_reusable_executor(max_workers=self.hands, timeout=60)
        return found


class _Cluster:
    """The workers of a Dask client."""

    def __init__(self, client: Any) -> None:
        if not (hasattr(client, "get_executor") and hasattr(client, "scheduler_info")):
            raise RuleError(
                f"client: found {shown(client)}: must be a client of dask.distributed (R5). Make "
                "one by Client(address).",
                "client",
            )
        self._client = client
        self.hands = max(sum(_answered(client.nthreads).values()), 1)
        self.waiting = 2 + 2 * self.hands
        _refuse_other_programs(client)

    def executor(self) -> Executor:
        found: Executor = self._client.get_executor(pure=False)
        return found


def _answered(call: Callable[..., Any], *arguments: Any, **options: Any) -> Any:
    """Return what a cluster answers; raise `SimulationError` if it does not."""
    try:
        return call(*arguments, **options)
    except TamiasError:
        raise
    except Exception as fault:
        raise _lost(fault) from fault


def _lost(fault: BaseException) -> SimulationError:
    return SimulationError(
        f"client: the cluster has failed ({type(fault).__name__}: {_first_line(fault)}). Check "
        "that its scheduler and its workers run, and have memory enough, then call again: what "
        "was finished is kept where `out` says."
    )


_alike: WeakKeyDictionary[Any, set[str]] = WeakKeyDictionary()
"""The workers of clients that have been found to have the same Tamias2D."""


def _refuse_other_programs(client: Any) -> None:
    """Refuse workers that have another Tamias2D than this process, or none.

    Each is asked once: one that starts anew has another address.
    """
    here, known = source_digest(), _alike.setdefault(client, set())
    unknown = [worker for worker in _answered(client.nthreads) if worker not in known]
    if not unknown:
        return
    for worker, there in _answered(client.run, _program_text(), workers=unknown).items():
        if there != here:
            what = "no Tamias2D" if there is None else "another version of Tamias2D"
            raise SimulationError(
                f"client: worker {worker} has {what} (R8): all must have the same, or their bits "
                "differ. Install it there."
            )
    known.update(unknown)


def _program_text() -> Callable[[], str | None]:
    """Return a function that knows nothing of this package, which a worker may not have."""
    names: dict[str, Any] = {}
    exec(
        "def program():\n"
        "    try:\n"
        "        from tamias2d.certificate import source_digest\n"
        "        return source_digest()\n"
        "    except ImportError:\n"
        "        return None\n",
        names,
    )
    found: Callable[[], str | None] = names["program"]
    return found
