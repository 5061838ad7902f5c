"""Steps of jointed bodies at once: the bits and the cost of single ones, plain and compiled."""

from collections.abc import Callable

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.generated.constraints import CONSTRAINTS
from tamias2d.kernels.force_demand import ForceDemand
from tamias2d.kernels.held_source import HeldDemand
from tamias2d.kernels.joint_source import JointDemand
from tamias2d.kernels.march_source import march
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
from tamias2d.motion.jointed_steps import JointedSteps
from tamias2d.motion.loads import Loads
from tamias2d.motion.step_batch import StepBatch
from tamias2d.scene import Scene
from tamias2d.solve.solution import solve_with_error
from tools.measurements.joints import four_bars

METHODS: list[tuple[Method, float | None]] = [
    (ExplicitEuler(), 0.01),
    (SemiImplicitEuler(), 0.01),
    (VelocityVerlet(), 0.01),
    (RungeKutta4(), 0.01),
    (Yoshida4(), 0.01),
    (DormandPrince5(1e-5), None),
    (Dop853(1e-7), None),
]
Outcome = list[object] | str
Alone = Callable[[Scene, Method, float | None], Outcome]


def hang(scene: Scene, at: tuple[float, float], count: int, **given: object) -> None:
    """Add a chain of rods that begins at a point and goes to the right."""
    before: int | None = None
    for k in range(count):
        place = (at[0] + k + 0.5, at[1])
        rod = t2.Box(width=1.0, height=0.1)
        number = scene.add_body(rod, mass=1.0 + k, position=place, mask=0, **given)  # type: ignore[arg-type]
        if before is None:
            scene.add_joint(t2.Revolute(), number, at, anchor=(-0.5, 0.0))
        else:
            ends = {"anchor": (0.5, 0.0), "other_anchor": (-0.5, 0.0)}
            scene.add_joint(t2.Revolute(), before, number, **ends)
        before = number


def chains() -> Scene:
    """Two chains, one after a particle under a law and under drag, all of one demand."""
    scene = Scene(gravity=(0.3, -9.81))
    law = "-3[N/m]*x(position) + 1[N]*sin(5[rad/s]*time)"
    scene.add_body(None, mass=0.7, position=(9.0, 0.3), velocity=(0.2, 1.0), force=(law, 0.0))
    hang(scene, (0.0, 0.0), 2, linear_drag=0.1)
    hang(scene, (5.0, 1.0), 1)
    scene.add_spring(0, 1, stiffness=2.0, rest_length=1.0, damping=0.1)
    return scene


def alone() -> Scene:
    """A chain under gravity alone: velocities change nothing but what joints exert."""
    scene = Scene(gravity=(0.0, -9.81))
    hang(scene, (0.0, 0.0), 2)
    return scene


def driven() -> Scene:
    """A motor that keeps its speed whatever it takes, and a spring in the joint after it."""
    scene = Scene(gravity=(0.0, -9.81))
    for k in range(2):
        rod = t2.Box(width=1.0, height=0.1)
        scene.add_body(rod, mass=1.0, position=(k + 0.5, 0.0), mask=0)
    motor = t2.Motor(speed=2.0)
    scene.add_joint(t2.Revolute(motor=motor), 0, (0.0, 0.0), anchor=(-0.5, 0.0))
    spring = t2.JointSpring(stiffness=30.0, damping=0.4)
    ends = {"anchor": (0.5, 0.0), "other_anchor": (-0.5, 0.0)}
    scene.add_joint(t2.Revolute(spring=spring), 0, 1, **ends)
    return scene


def limited() -> Scene:
    """A pendulum that bounces between its limits."""
    scene = Scene(gravity=(0.0, -9.81))
    scene.add_body(t2.Box(width=1.0, height=0.1), mass=1.0, position=(0.5, 0.0), mask=0)
    limits = t2.Limits(lower=-0.3, upper=0.3, restitution=0.5)
    scene.add_joint(t2.Revolute(limits=limits), 0, (0.0, 0.0), anchor=(-0.5, 0.0))
    return scene


def slipping() -> Scene:
    """A motor that slips until it has its speed, and two limits."""
    scene = Scene(gravity=(0.0, -1.0))
    scene.add_body(t2.Box(width=1.0, height=0.1), mass=1.0, position=(0.5, 0.0), mask=0)
    motor, limits = (
        t2.Motor(speed=3.0, maximum=3.0),
        t2.Limits(lower=-0.3, upper=0.6, restitution=0.0),
    )
    joint = t2.Revolute(limits=limits, motor=motor)
    scene.add_joint(joint, 0, (0.0, 0.0), anchor=(-0.5, 0.0))
    return scene


SCENES = {
    "chains": chains(),
    "alone": alone(),
    "driven": driven(),
    "limited": limited(),
    "slipping": slipping(),
    "fading": four_bars(7),
}


def outcome(scene: Scene, method: Method, step: float | None) -> Outcome:
    """The bits of all states and the cost, or why there are none."""
    try:
        run = t2.simulate(scene, duration=0.5, method=method, time_step=step)
    except (t2.SimulationError, t2.InputError) as fault:
        return str(fault)
    states = [run.position, run.orientation, run.velocity, run.angular_velocity]
    states += [run.joint_events.time, run.joint_events.what, run.joint_events.value]
    return [run.cost, *(state.tobytes() for state in states)]


@pytest.fixture(autouse=True)
def _however_short_or_stable(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("tamias2d.motion.methods.check", lambda *_, **__: ())
    monkeypatch.setattr("tamias2d.kernels.held_marching._FEW", 0)  # runs are short here


@pytest.fixture
def one_by_one(monkeypatch: pytest.MonkeyPatch) -> Alone:
    """Simulate without what takes several steps at once."""

    def run(scene: Scene, method: Method, step: float | None) -> Outcome:
        with monkeypatch.context() as patch:
            patch.setattr(JointedSteps, "_batch", lambda *_: None)
            return outcome(scene, method, step)

    return run


@pytest.fixture
def at_once(monkeypatch: pytest.MonkeyPatch) -> list[int]:
    """How many steps were taken at once."""
    found: list[int] = []
    batch = JointedSteps._batch

    def noted(*given: object) -> StepBatch | None:
        steps = batch(*given)  # type: ignore[arg-type]
        if steps is not None:
            found.append(len(steps.times) - 1)
        return steps

    monkeypatch.setattr(JointedSteps, "_batch", noted)
    return found


@pytest.mark.parametrize("name", list(SCENES))
@pytest.mark.parametrize(("method", "step"), METHODS, ids=str)
def test_plain_steps_at_once_have_the_bits_of_single_ones(
    name: str,
    method: Method,
    step: float | None,
    at_price: Callable[[float], None],
    one_by_one: Alone,
    at_once: list[int],
) -> None:
    at_price(np.inf)
    found = outcome(SCENES[name], method, step)
    assert bool(at_once) == (name not in ("driven", "slipping") or not splits(method))
    assert found == one_by_one(SCENES[name], method, step)
    assert not isinstance(found, str)


def splits(method: Method) -> bool:
    return isinstance(method, SemiImplicitEuler | VelocityVerlet | Yoshida4)


@pytest.mark.parametrize(("method", "step"), [METHODS[2], METHODS[6]], ids=str)
def test_compiled_steps_at_once_have_the_bits_of_plain_ones(
    method: Method,
    step: float | None,
    at_price: Callable[[float], None],
    one_by_one: Alone,
    at_once: list[int],
) -> None:
    at_price(np.inf)
    plain = outcome(SCENES["chains"], method, step)
    at_price(-np.inf)
    assert outcome(SCENES["chains"], method, step) == plain
    assert at_once
    assert one_by_one(SCENES["chains"], method, step) == plain
    assert not isinstance(plain, str)


def test_where_no_reactions_are_known_steps_go_on_one_by_one(
    at_price: Callable[[float], None], one_by_one: Alone, at_once: list[int]
) -> None:
    """A bar on three cranks in parallel, of which any two say all (GD19)."""
    at_price(np.inf)
    scene = Scene(gravity=(0.0, -9.81))
    scene.add_body(None, mass=1.0, inertia=0.5, position=(1.0, 0.0))
    for x in (-1.0, 0.0, 1.0):
        scene.add_joint(t2.Distance(), 0, (1.5 + x, 1.0), anchor=(x, 0.0))
    found = outcome(scene, RungeKutta4(), 0.01)
    assert not at_once
    assert found == one_by_one(scene, RungeKutta4(), 0.01)
    assert not isinstance(found, str)


def test_mechanisms_that_roll_leave_no_bodies_to_step_at_once(
    at_price: Callable[[float], None], one_by_one: Alone
) -> None:
    """Two discs on one axle of a bar, on a floor with friction."""
    at_price(np.inf)
    scene = Scene(gravity=(0.0, -9.81))
    scene.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=0.0), friction=0.5)
    for x in (0.0, 1.0):
        rolls = {"position": (x, 0.2), "velocity": (1.0, 0.0), "angular_velocity": -5.0}
        scene.add_body(t2.Disc(radius=0.2), mass=1.0, friction=0.5, restitution=0.0, **rolls)
    scene.add_joint(t2.Distance(), 1, 2)
    found = outcome(scene, RungeKutta4(), 0.01)
    assert found == one_by_one(scene, RungeKutta4(), 0.01)
    assert not isinstance(found, str)


@pytest.mark.parametrize(
    ("name", "price"),
    [("chains", np.inf), ("driven", np.inf), ("fading", np.inf), ("alone", -np.inf)],
)
def test_the_error_of_steps_at_once_is_that_of_single_ones(
    name: str,
    price: float,
    at_price: Callable[[float], None],
    at_once: list[int],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    def errors() -> object:
        run, found = solve_with_error(SCENES[name], duration=0.5, method=Dop853(1e-6))
        assert found is not None
        return found.tobytes(), run.cost

    at_price(price)
    found = errors()
    assert at_once
    monkeypatch.setattr(JointedSteps, "_batch", lambda *_: None)
    monkeypatch.setattr(Loads, "marching", lambda *_: None)
    assert errors() == found


@pytest.mark.parametrize("scheme", ["runge_kutta_4", "dop853", "yoshida_4"])
def test_functions_of_forces_and_of_joints_have_names_of_their_own(scheme: str) -> None:
    forces = ForceDemand(
        rotation=True, linear_drag=True, quadratic_drag=True, angular_drag=True,
        springs=True, anchors=True, attraction=True,
    )  # fmt: skip
    kinds, pushed = tuple(sorted(CONSTRAINTS)), ("angle", "travel")
    for joints in (JointDemand(kinds), JointDemand(kinds, pushed)):
        made = march(scheme, HeldDemand(forces, joints, 2))
        if made is None:
            assert joints.pushed
            continue
        names = [line.split("(")[0] for line in made.plain.splitlines() if line[:4] == "def "]
        assert len(names) == len(set(names))
