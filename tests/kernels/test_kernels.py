"""Kernels: the bits of the general way, for every scheme and every set of terms."""

import platform
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.kernels import Demand, compiled, demand_of, flown, plain, source
from tamias2d.kernels.source import arguments
from tamias2d.motion import (
    ExplicitEuler,
    Method,
    RungeKutta4,
    SemiImplicitEuler,
    VelocityVerlet,
    Yoshida4,
)
from tamias2d.motion.fixed_steps import grid
from tamias2d.scene import Scene, catalogue

METHODS = [ExplicitEuler(), SemiImplicitEuler(), VelocityVerlet(), RungeKutta4(), Yoshida4()]
PULL = ("-3[N/m^3]*x(position)*dot(position, position)", "2[N/s]*time*sqrt(abs(y(position))/1[m])")
TERMS = {
    "gravity": {},
    "constant force": {"force": (3.0, -1.0)},
    "torque": {"torque": 0.5, "inertia": 2.0},
    "linear drag": {"linear_drag": 0.3},
    "quadratic drag": {"quadratic_drag": 0.2},
    "both drags": {"linear_drag": 0.3, "quadratic_drag": 0.2, "force": (0.0, 2.0)},
    "law": {"force": PULL},
    "law of orientation": {
        "torque": "-2[N*m]*orientation",
        "inertia": 1.5,
        "angular_velocity": 1.0,
    },
}


def scene_of(terms: dict[str, object], bodies: int = 3) -> Scene:
    scene = t2.Scene(gravity=(0.5, -9.81))
    generator = np.random.default_rng(5)
    for k in range(bodies):
        x, y, u, v = generator.normal(size=4).tolist()
        scene.add_body(None, mass=1.0 + k, position=(x, y), velocity=(u, v), **terms)  # type: ignore[arg-type]
    return scene


@pytest.mark.parametrize("method", METHODS, ids=str)
@pytest.mark.parametrize("terms", TERMS)
def test_a_kernel_has_the_bits_of_the_general_way(terms: str, method: Method) -> None:
    scene = scene_of(TERMS[terms])
    run = t2.simulate(scene, duration=0.5, method=method, time_step=0.01)  # too short for a kernel
    demand = demand_of(scene, method)
    assert demand is not None
    made = flown(scene, demand, plain(demand), grid(0.5, 0.01), run.times)
    for name, values in made._asdict().items():
        assert np.array_equal(values, getattr(run, name)), name


@pytest.mark.parametrize("terms", ["gravity", "both drags", "law of orientation"])
def test_compiled_and_plain_kernels_have_the_same_bits(terms: str) -> None:
    scene = scene_of(TERMS[terms], bodies=300)  # more than a block
    demand = demand_of(scene, VelocityVerlet())
    assert demand is not None
    times = grid(0.2, 0.01)
    both = [flown(scene, demand, make(demand), times, times) for make in (plain, compiled)]
    for first, second in zip(*both, strict=True):
        assert np.array_equal(first, second)


def test_simulate_takes_the_kernel_and_says_the_same(monkeypatch: pytest.MonkeyPatch) -> None:
    scene = catalogue.load("kepler")
    module = sys.modules["tamias2d.kernels.flight"]
    digests = []
    for worth in (10, 10**9):
        monkeypatch.setattr(module, "_WORTH", worth)
        run = t2.simulate(scene, duration=1.0, method=VelocityVerlet(), time_step=0.01)
        digests.append(run.digest())
    assert digests[0] == digests[1]


def test_samples_between_two_steps_go_the_general_way() -> None:
    scene = scene_of({})
    module = sys.modules["tamias2d.kernels.flight"]
    steps = grid(300.0, 0.01)
    assert module.flight(scene, VelocityVerlet(), steps, np.array([0.005])) is None
    found = module.flight(scene, VelocityVerlet(), steps, np.array([0.0, 0.01, 300.0]))
    assert found is not None
    assert found.position.shape == (3, 3, 2)


@pytest.mark.parametrize("name", ["two-body", "spring-chain"])
def test_bodies_that_act_on_each_other_have_no_kernel(name: str) -> None:
    assert demand_of(catalogue.load(name), VelocityVerlet()) is None


def test_a_law_that_numpy_rounds_in_its_own_way_has_no_kernel() -> None:
    scene = scene_of({"force": ("1[N]*exp(-time/1[s])", "0[N]")})
    assert demand_of(scene, VelocityVerlet()) is None


def test_what_a_scene_does_not_need_is_not_in_its_source() -> None:
    lean = source(Demand("velocity_verlet"))
    assert not re.search("turn|drag|mass|load|time_start", lean)
    everything = source(
        Demand("velocity_verlet", rotation=True, forces=True, linear_drag=True, quadratic_drag=True)
    )
    for word in ("turn", "linear_drag", "quadratic_drag", "masses", "inertias"):
        assert word in everything


def test_a_source_stands_alone() -> None:
    """It holds copies of what it calls: a change elsewhere gives it another name."""
    text = source(Demand("runge_kutta_4", forces=True, quadratic_drag=True))
    assert not re.search("tamias2d", text.split('"""')[2])
    assert "srs/models/drag.md" in text


def test_a_traceback_shows_the_plain_kernel() -> None:
    demand = Demand("velocity_verlet", quadratic_drag=True)
    with pytest.raises(TypeError) as caught:
        plain(demand)(*[None] * len(arguments(demand)))
    assert "len(positions_x)" in str(caught.traceback[-1].statement)


CACHED = """
import sys, time
from tamias2d.kernels import Demand, compiled
kernel = compiled(Demand("semi_implicit_euler"))
import numpy as np
a = [np.zeros(4) for _ in range(4)]
kernel(np.array([0.0, 1.0]), *a, 0.0, -9.81)
print(a[1][0], kernel.stats.cache_hits)
"""


def test_another_process_finds_the_compiled_kernel(tmp_path: Path) -> None:
    environment = {"TAMIAS2D_HOME": str(tmp_path), "PATH": "", "PYTHONPATH": ":".join(sys.path)}
    said = [
        subprocess.run(
            [sys.executable, "-c", CACHED],
            env=environment,
            capture_output=True,
            text=True,
            check=True,
        ).stdout.split()
        for _ in range(2)
    ]
    assert said[0][0] == said[1][0] == "-9.81"
    assert said[1][1] != "{}"


@pytest.mark.skipif(platform.machine() != "x86_64", reason="looks at x86-64 machine code")
def test_the_inner_loop_does_several_bodies_at_once(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("TAMIAS2D_HOME", str(tmp_path))  # cached code cannot be looked at
    compiled.cache_clear()
    demand = Demand("semi_implicit_euler", forces=True, linear_drag=True)
    scene = scene_of({"force": (1.0, 0.0), "linear_drag": 0.1})
    times = grid(0.1, 0.01)
    kernel = compiled(demand)
    flown(scene, demand, kernel, times, times)
    (assembly,) = kernel.inspect_asm().values()  # type: ignore[attr-defined]
    compiled.cache_clear()
    assert re.search(r"\bv?mulpd\b", assembly), "multiplication is not packed"
    assert re.search(r"\bv?addpd\b", assembly), "addition is not packed"
