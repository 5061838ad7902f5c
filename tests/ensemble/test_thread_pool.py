"""Threads on which worlds step: in a process that was forked, and where Ctrl-C is heard."""

import multiprocessing
import os
import signal
import threading
from collections.abc import Callable

import numpy as np
import pytest

import tamias2d as t2
from tests.ensemble.scenes import stack
from tests.ensemble.test_world_reports import weights

WORLDS = 17  # so many that two threads take them
SCENES = {"boxes": lambda _world, _random: stack(), "joints that are watched": weights}


def worlds(name: str) -> t2.Simulators:
    sims = t2.Simulators(SCENES[name], worlds=WORLDS, seed=1, threads=2)
    sims.step()
    return sims


@pytest.mark.skipif(not hasattr(os, "fork"), reason="there are no forks")
@pytest.mark.filterwarnings("ignore:.*fork:DeprecationWarning")
def test_worlds_that_have_stepped_step_in_a_process_that_is_forked() -> None:
    sims = worlds("boxes")
    sims.step()
    child = multiprocessing.get_context("fork").Process(target=sims.step)
    child.start()
    child.join(60)
    ended = child.exitcode
    child.kill()
    assert ended == 0
    sims.step()


@pytest.mark.skipif(not hasattr(signal, "pthread_kill"), reason="signals choose their thread")
@pytest.mark.parametrize("name", SCENES)
def test_all_threads_end_between_two_steps_at_ctrl_c(name: str) -> None:
    sims = worlds(name)
    main = threading.main_thread().ident
    assert main is not None
    ctrl_c = threading.Timer(0.2, lambda: signal.pthread_kill(main, signal.SIGINT))
    asked = 2_000_000
    ctrl_c.start()
    with pytest.raises(KeyboardInterrupt):
        sims.step(asked)
    ended = sims.time
    assert ended.max() * 60 < asked / 2
    assert ended.min() == 1 / 60  # some had not begun
    sims.step()
    np.testing.assert_allclose(sims.time, ended + 1 / 60)
    sims.reset()
    sims.step(30)
    fresh = worlds(name)
    fresh.step(29)
    np.testing.assert_array_equal(sims.position, fresh.position)


def test_a_fault_on_a_thread_is_raised(monkeypatch: pytest.MonkeyPatch) -> None:
    sims = worlds("boxes")

    def fails(*_: object, **__: object) -> Callable[[], None]:
        raise MemoryError

    monkeypatch.setattr(sims._sims[WORLDS - 1]._engine, "begin_together", fails)
    with pytest.raises(MemoryError):
        sims.step()
