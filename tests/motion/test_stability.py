"""An unstable step is refused before the run, at the limit that theory gives; no stable one is."""

import math

import pytest

import tamias2d as t2
from tamias2d.motion.methods import Method

# Longest stable steps of a free oscillation, times its angular frequency: from the literature
# (Hairer, Lubich and Wanner; Yoshida's from the trace of its matrix)
LIMITS = {
    t2.SemiImplicitEuler(): 2.0,
    t2.VelocityVerlet(): 2.0,
    t2.ExponentialDrag(): 2.0,
    t2.RungeKutta4(): 2 * math.sqrt(2),
    t2.Yoshida4(): 1.5734,
}


def swinging(stiffness: float = 100.0, **more: float) -> t2.Scene:
    scene = t2.Scene(gravity=(0.0, 0.0))
    scene.add_body(None, mass=1.0, position=(1.0, 0.0), velocity=(0.0, 5.0), name="bob", **more)  # type: ignore[arg-type]
    scene.add_spring("bob", (0.0, 0.0), stiffness=stiffness, rest_length=0.0)
    return scene


@pytest.mark.parametrize(("method", "limit"), LIMITS.items(), ids=str)
def test_oscillation_limit(method: Method, limit: float) -> None:
    critical = limit / 10
    t2.simulate(swinging(), duration=60.0, method=method, time_step=0.999 * critical)
    with pytest.raises(t2.StabilityError, match="it is stable up to") as caught:
        t2.simulate(swinging(), duration=60.0, method=method, time_step=1.01 * critical)
    assert caught.value.critical_step == pytest.approx(critical, rel=1e-3)
    assert caught.value.code == "unstable-step"


@pytest.mark.parametrize(
    ("method", "limit"),
    [(t2.ExplicitEuler(), 2.0), (t2.VelocityVerlet(), 4.0), (t2.RungeKutta4(), 2.7853)],
    ids=str,
)
def test_decay_limit(method: Method, limit: float) -> None:
    scene = t2.Scene(gravity=(0.0, -9.81))
    scene.add_body(
        None, mass=2.0, position=(0.0, 0.0), velocity=(10.0, 0.0), linear_drag=6.0, name="leaf"
    )
    t2.simulate(scene, duration=600.0, method=method, time_step=0.99 * limit / 3)
    with pytest.raises(t2.StabilityError, match="'leaf'") as caught:
        t2.simulate(scene, duration=600.0, method=method, time_step=1.02 * limit / 3)
    assert caught.value.critical_step == pytest.approx(limit / 3, rel=1e-3)
    t2.simulate(scene, duration=600.0, method=t2.ExponentialDrag(), time_step=20.0)


def test_explicit_euler_tells_how_much_it_gains() -> None:
    step = 0.001
    run = t2.simulate(swinging(), duration=1.0, method=t2.ExplicitEuler(), time_step=step)
    gain = math.sqrt(1 + (10 * step) ** 2)
    assert f"by the factor {gain:.4g} in each step, {gain**1000:.3g} in the run" in run.notes[1]
    with pytest.raises(t2.StabilityError, match="at no step") as caught:
        t2.simulate(swinging(), duration=100.0, method=t2.ExplicitEuler(), time_step=0.01)
    assert caught.value.critical_step == 0


def test_what_grows_by_itself_is_not_held_against_a_scheme() -> None:
    scene = t2.Scene(gravity=(0.0, 0.0))
    scene.add_body(None, mass=1.0, position=(1.0, 0.0), name="pencil")
    scene.add_field(force=("4[N/m]*dot(position, vector(1, 0))", "0[N]"))
    run = t2.simulate(scene, duration=2.0, method=t2.VelocityVerlet(), time_step=0.01)
    assert run.position[-1, 0, 0] == pytest.approx(math.cosh(4.0), rel=1e-3)
    assert len(run.notes) == 1


def test_the_stiffest_of_coupled_bodies_decides() -> None:
    scene = t2.Scene(gravity=(0.0, 0.0))
    for k in range(30):  # more than have their matrices made
        scene.add_body(None, mass=1.0, position=(float(k), 0.0), name=f"bead {k}")
    for k in range(29):
        scene.add_spring(k, k + 1, stiffness=100.0, rest_length=1.0)
    highest = 20 * math.sin(math.pi * 29 / 60)  # of a chain with free ends
    with pytest.raises(t2.StabilityError) as caught:
        t2.simulate(scene, duration=1.0, method=t2.VelocityVerlet(), time_step=0.12)
    assert caught.value.critical_step == pytest.approx(2 / highest, rel=0.05)
    t2.simulate(scene, duration=1.0, method=t2.VelocityVerlet(), time_step=0.09)


def test_drag_is_exact_within_a_long_step_too() -> None:
    scene = t2.Scene(gravity=(0.0, -9.81))
    scene.add_body(
        t2.Disc(radius=0.1),
        mass=2.0,
        position=(0.0, 50.0),
        velocity=(10.0, 0.0),
        linear_drag=6.0,
        restitution=0.5,
        name="leaf",
    )
    scene.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=0.0))
    times = [0.1, 1.0, 7.0, 13.0, 17.0]
    exact = t2.simulate(scene, duration=17.0, times=times)
    run = t2.simulate(
        scene, duration=17.0, times=times, method=t2.ExponentialDrag(), time_step=12.0
    )
    assert run.position == pytest.approx(exact.position, rel=1e-12, abs=1e-12)
    assert run.impacts.time == pytest.approx(exact.impacts.time, rel=1e-12)
