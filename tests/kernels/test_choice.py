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
