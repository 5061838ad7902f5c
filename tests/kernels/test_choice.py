"""Whether a kernel is compiled is decided at little cost."""

import pytest

from tamias2d.kernels import choice

TEXT = "def add(a, b):\n    return a + b\n"


def test_the_disk_is_asked_once_whether_a_kernel_is_kept(monkeypatch: pytest.MonkeyPatch) -> None:
    asked = []
    monkeypatch.setattr(choice, "is_kept", lambda text: asked.append(text))
    kernel = choice.Kernel(TEXT, TEXT, "add")
    kernel.otherwise(1, 0.2)  # long enough to ask what compiling costs, too short to compile
    for _ in range(3):
        assert kernel.compiled(0.0) is None
    assert len(asked) == 1


def test_reading_a_kernel_is_no_cost_of_its_calls(monkeypatch: pytest.MonkeyPatch) -> None:
    """It is read once: as the cost of one call, it made a compiler of ten seconds pay for all."""
    now = [0.0]

    def read(_: str) -> dict[str, object]:
        now[0] += 60.0  # s
        return {"add": lambda: 1}

    monkeypatch.setattr(choice, "plainly", read)
    monkeypatch.setattr(choice, "perf_counter", lambda: now[0])
    kernel = choice.Kernel(TEXT, TEXT, "add")
    assert kernel.plain() == 1
    assert kernel.compiled(1000) is None


def test_one_slow_call_says_nothing_of_those_to_come(monkeypatch: pytest.MonkeyPatch) -> None:
    """The processor may have done something else."""
    monkeypatch.setattr(choice, "is_kept", lambda _: False)
    kernel = choice.Kernel(TEXT, TEXT, "add")
    kernel.otherwise(1, 0.006)
    assert kernel.compiled(500) is None
    kernel.otherwise(1, 0.001)
    assert kernel.compiled(500) is None
    assert kernel.compiled(100_000) is not None
