"""Ensembles on a cluster of Dask: the same bits, also when a worker is killed."""

import os
import signal
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from distributed import Client, LocalCluster

import tamias2d as t2
from tamias2d.ensemble import execution
from tests.ensemble.scenes import bouncing
from tests.ensemble.test_store import ARGUMENTS, in_memory


@pytest.fixture
def client() -> Iterator[Client]:
    cluster = LocalCluster(
        n_workers=2, threads_per_worker=1, processes=True, dashboard_address=None
    )
    with cluster, Client(cluster, set_as_default=False) as client:
        yield client


def test_a_cluster_gives_the_same_bits_and_a_killed_worker_loses_nothing(
    client: Client, tmp_path: Path
) -> None:
    trap, parent = tmp_path / "trap", os.getpid()

    def deadly(run: t2.Run) -> float:
        if run.position[0, 1, 1] > 1.0 and not trap.exists():
            trap.touch()
            assert os.getpid() != parent
            os.kill(os.getpid(), signal.SIGKILL)
        return float(run.energy[-1])

    assert t2.ensemble(bouncing(), client=client, chunk=5, **ARGUMENTS).identical(in_memory())
    arguments: dict[str, Any] = ARGUMENTS | {"quantities": {"deadly": deadly}}
    out = tmp_path / "e.zarr"
    stored = t2.ensemble(bouncing(), client=client, out=out, chunk=2, **arguments)
    assert trap.exists()
    assert stored.load().drop_vars("deadly").drop_attrs().identical(in_memory().drop_attrs())
    np.testing.assert_array_equal(stored.deadly, stored.energy[:, -1])


def test_a_cluster_that_has_another_program_or_is_gone_is_refused(
    client: Client, monkeypatch: pytest.MonkeyPatch
) -> None:
    with monkeypatch.context() as patch:
        patch.setattr(execution, "source_digest", lambda: "another")
        with pytest.raises(t2.SimulationError, match=r"has another version of Tamias2D \(R8\)"):
            t2.ensemble(bouncing(), client=client, **ARGUMENTS)
    client.close()
    with pytest.raises(t2.SimulationError, match=r"^client: the cluster has failed \("):
        t2.ensemble(bouncing(), client=client, **ARGUMENTS)
