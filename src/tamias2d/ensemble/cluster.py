"""Clients of running Dask clusters, by the address of their scheduler."""

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

from tamias2d.errors import SimulationError
from tamias2d.record.dataset import extra


@contextmanager
def client_at(address: str | None) -> Iterator[Any]:
    """Give a client of the cluster whose scheduler has an address, None without one.

    Raises:
        SimulationError: nobody answers there.
    """
    if address is None:
        yield None
        return
    with extra():
        from distributed import Client
    try:
        client = Client(address, timeout=10, set_as_default=False)  # type: ignore[no-untyped-call]
    except (OSError, ValueError) as fault:
        raise SimulationError(
            f"scheduler {address!r}: does not answer ({type(fault).__name__}). Give the address of "
            "a running one, such as tcp://10.0.0.1:8786."
        ) from fault
    with client:
        yield client
