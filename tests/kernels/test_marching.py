"""Steps by kernels: the bits of the general code, plain and compiled, by all forces and schemes."""

from collections.abc import Callable

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

import tamias2d as t2
from tamias2d.motion import (
    Dop853,
    DormandPrince5,
    ExplicitEuler,
    Method,
    RungeKutta4,
    SemiImplicitEuler,
    VelocityVerlet,
    Yoshida4,
)
from tamias2d.scene import Scene

METHODS: list[tuple[Method, float | None]] = [
    (ExplicitEuler(), 0.02),
    (SemiImplicitEuler(), 0.02),
    (VelocityVerlet(), 0.02),
    (RungeKutta4(), 0.03),
    (Yoshida4(), 0.03),
    (DormandPrince5(1e-5), None),
    (Dop853(1e-7), None),
]
LAWS = (
    "1[N]*sin({a}[rad/s]*time)*exp(-time/{b}[s])",
    "-{a}[N/m]*x(position) + {b}[N]*cos(orientation)",
    "-{a}[kg/s]*y(velocity)*min(1, norm(velocity)/{b}[m/s])",
    "{a}[N]*atan2(y(position), x(position)) - {b}[N*s]*angular_velocity",
    "-{a}[N*m]*mass/1[kg]*abs(x(position))/(dot(position, position) + {b}[m^2])",
    "{a}[N]*log(1 + dot(velocity, velocity)/{b}[m^2/s^2]) + 0.1[N]*tan(0.1*orientation)",
    "{a}[N]*sqrt(abs(y(position))/1[m]) + {b}[N]/(norm(position)/1[m] + 1)**(3/2)",
)
TWISTS = ("-{a}[N*m]*sin(orientation)", "{a}[N*m*s]*max(0, {b}[1/s] - angular_velocity)")


@st.composite
def scenes(draw: st.DrawFn) -> Scene:
    """Particles and boxes under any of the forces that a scene can state."""
    number = st.floats(0.1, 2.0).map(lambda value: round(value, 6))
    signed = st.floats(-2.0, 2.0).map(lambda value: round(value, 6))

    def law(of: tuple[str, ...] = LAWS) -> str:
        return draw(st.sampled_from(of)).format(a=draw(number), b=draw(number))

    def pair() -> tuple[float, float]:
        return draw(signed), draw(signed)

    scene = t2.Scene(gravity=pair())
    count = draw(st.integers(1, 4))
    boxes = draw(st.booleans())
    for k in range(count):
        given: dict[str, object] = {"position": (1.5 * k + 0.3, draw(signed)), "velocity": pair()}
        if draw(st.booleans()):
            given["force"] = (law() if draw(st.booleans()) else draw(signed), law())
        for drag in ("linear_drag", "quadratic_drag"):
            if draw(st.booleans()):
                given[drag] = draw(number)
        if boxes:
            given |= {"orientation": draw(signed), "angular_velocity": draw(signed)}
            if draw(st.booleans()):
                given |= {"torque": law(TWISTS), "angular_drag": draw(number)}
        shape = t2.Box(width=0.2, height=0.1) if boxes else None
        given |= {} if boxes else {"inertia": 1.5}
        scene.add_body(shape, mass=draw(number), mask=0, **given)  # type: ignore[arg-type]
    if draw(st.booleans()):
        anchors = {"anchor": pair(), "other_anchor": pair()} if boxes and count > 1 else {}
        law_of = {"stiffness": draw(number), "rest_length": draw(number), "damping": draw(number)}
        scene.add_spring(0, count - 1 if count > 1 else (5.0, 5.0), **law_of, **anchors)  # type: ignore[arg-type]
        scene.add_spring(0, (-3.0, 4.0), stiffness=draw(number), rest_length=0.0)
    if draw(st.booleans()) and count > 1:
        scene.add_attraction(gravitational_constant=draw(number))
    if draw(st.booleans()):
        scene.add_field(force=(law(), law()))
    return scene


Outcome = list[object] | str


def outcome(scene: Scene, method: Method, step: float | None) -> Outcome:
    """The bits of all states and the cost, or why there are none."""
    try:
        run = t2.simulate(scene, duration=0.3, method=method, time_step=step)
    except (t2.SimulationError, t2.InputError) as fault:
        return str(fault)
    states = (run.position, run.orientation, run.velocity, run.angular_velocity)
    return [run.cost, *(state.tobytes() for state in states)]


@pytest.fixture(autouse=True)
def _whether_stable_or_not(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("tamias2d.motion.methods.check", lambda *_, **__: ())


@pytest.fixture
def generally(monkeypatch: pytest.MonkeyPatch) -> Callable[..., Outcome]:
    """Simulate without kernels."""

    def run(scene: Scene, method: Method, step: float | None) -> Outcome:
        with monkeypatch.context() as patch:
            patch.setattr("tamias2d.solve.located.march_by_kernels", lambda *_: None)
            return outcome(scene, method, step)

    return run


@pytest.mark.parametrize(("method", "step"), METHODS, ids=str)
def test_plain_kernels_have_the_bits_of_the_general_way(
    method: Method,
    step: float | None,
    at_price: Callable[[float], None],
    generally: Callable[..., Outcome],
) -> None:
    at_price(np.inf)

    @settings(max_examples=25, deadline=None, database=None)
    @given(scenes())
    def look(scene: Scene) -> None:
        assert outcome(scene, method, step) == generally(scene, method, step)

    look()


def everything(seed: int) -> Scene:
    """Boxes under all kinds of forces, of one demand; the numbers follow from the seed."""
    draw = np.random.default_rng(seed).uniform
    scene = t2.Scene(gravity=draw(-2, 2, 2))
    for k in range(3):
        a, b = draw(0.1, 2.0, 2).tolist()
        scene.add_body(
            t2.Box(width=3.0, height=2.0),
            mass=draw(0.5, 2.0),
            mask=0,
            position=(1.5 * k, draw(-1, 1)),
            velocity=draw(-1, 1, 2),
            orientation=draw(-2, 2),
            angular_velocity=draw(-2, 2),
            force=(LAWS[2 * k].format(a=a, b=b), LAWS[2 * k + 1].format(a=b, b=a)),
            torque=TWISTS[k % 2].format(a=a, b=b),
            linear_drag=draw(0, 1),
            quadratic_drag=draw(0, 1),
            angular_drag=draw(0, 1),
        )
    law = {"stiffness": 2.0, "rest_length": draw(0.1, 1.0), "damping": 0.1}
    scene.add_spring(0, 1, anchor=draw(-1, 1, 2), other_anchor=draw(-1, 1, 2), **law)
    scene.add_spring(2, (1.0, 1.0), **law)
    scene.add_attraction(gravitational_constant=0.3)
    scene.add_field(force=(LAWS[6].format(a=0.3, b=0.4), "0[N]"))
    return scene


@pytest.mark.parametrize(("method", "step"), METHODS, ids=str)
def test_compiled_kernels_have_the_bits_of_plain_ones(
    method: Method, step: float | None, at_price: Callable[[float], None]
) -> None:
    for seed in range(5):
        at_price(np.inf)
        plain = outcome(everything(seed), method, step)
        at_price(-np.inf)
        assert outcome(everything(seed), method, step) == plain
        assert not isinstance(plain, str)


def pushes(seed: int) -> Scene:
    """A body that a spring holds, and that is pushed for a moment now and then."""
    draw = np.random.default_rng(seed).uniform
    at, width = draw(0, 3, 3).tolist(), (3 * 10 ** draw(-2.8, -1.3, 3)).tolist()
    law = "+".join(f"9[N]*exp(-((time-{t}[s])/{w}[s])**2)" for t, w in zip(at, width, strict=True))
    scene = t2.Scene(gravity=(0.0, 0.0))
    scene.add_body(None, mass=1.0, position=(1.0, 0.0), force=(f"{law}-x(position)*2[N/m]", 0.0))
    return scene


@pytest.mark.parametrize("method", [t2.Dop853(1e-7), t2.DormandPrince5(1e-5, halved=True)], ids=str)
def test_short_pushes_have_the_same_bits_and_cost_in_all_ways(
    method: Method, at_price: Callable[[float], None], generally: Callable[..., Outcome]
) -> None:
    for seed in range(8):
        at_price(np.inf)
        plain = outcome(pushes(seed), method, None)
        assert generally(pushes(seed), method, None) == plain
        at_price(-np.inf)
        assert outcome(pushes(seed), method, None) == plain
        assert not isinstance(plain, str)


@pytest.mark.parametrize(("method", "step"), METHODS[-2:], ids=str)
def test_a_first_step_as_long_as_its_trial_costs_the_same_in_all_ways(
    method: Method,
    step: float | None,
    at_price: Callable[[float], None],
    generally: Callable[..., Outcome],
) -> None:
    at_price(np.inf)
    scene = t2.Scene(gravity=(0.0, 0.0))  # so slow that the trial goes to the end, as the step does
    scene.add_body(None, mass=1.0, position=(2.0, 0.0), velocity=(0.0078125, 0.0), linear_drag=0.0)
    scene.add_body(None, mass=1.0, position=(4.0, 0.0), force=("0[N/m]*x(position)", 0.0))
    assert outcome(scene, method, step) == generally(scene, method, step)


def test_a_law_missed_soon_after_the_first_step_costs_the_same_in_all_ways(
    at_price: Callable[[float], None], generally: Callable[..., Outcome]
) -> None:
    """The acceleration at the start, known from the first step's length, is not counted again."""
    at_price(np.inf)
    for at in (0.04, 0.05, 0.06, 0.07, 0.08):
        scene = t2.Scene(gravity=(0.0, 0.0))
        law = f"1[N] + 9[N]*exp(-((time-{at}[s])/0.004[s])**2)"
        scene.add_body(None, mass=1.0, position=(1.0, 0.0), force=(law, 0.0))
        found = outcome(scene, DormandPrince5(1e-5), None)
        assert found == generally(scene, DormandPrince5(1e-5), None)
        assert not isinstance(found, str)
