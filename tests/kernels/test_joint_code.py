"""Joints by kernels: the reactions of the general way, the bits of plain code, doubt where due."""

import math
from collections.abc import Callable, Iterator

import numpy as np
import pytest

import tamias2d as t2
from tamias2d.kernels import joint_code
from tamias2d.kernels.elimination import elimination, factorised, inverse_size, solve
from tamias2d.motion.joint_events import Mode
from tamias2d.motion.limited_mechanism import LimitedMechanism
from tamias2d.motion.loads import Loads, coordinates, start_states
from tamias2d.motion.mechanism import Mechanism
from tamias2d.scene import Scene, catalogue
from tools.joint_pictures import box, hung, kinds
from tools.measurements.joints import four_bars

Given = tuple[float, np.ndarray, np.ndarray, np.ndarray]


def stated() -> Scene:
    """A trolley that goes to and fro, a pendulum on it, and a bead on a curve, by equations."""
    scene = Scene(gravity=(0.0, -9.81))
    for x, y in ((0.0, 0.0), (0.3, -1.0), (2.0, 1.0)):
        velocity = (0.9, 0.0) if x < 1.0 else (0.1, 0.3)
        scene.add_body(None, mass=1.0, inertia=0.1, position=(x, y), velocity=velocity)
    to_and_fro = "x(point_a) - 0.3[m]*sin(3[rad/s]*time)"
    scene.add_joint(t2.Equation([to_and_fro, "y(point_a)", "orientation_a/2"]), 0)
    length = math.hypot(0.3, 1.0)
    rod = f"(norm(point_b - point_a)/1[m])**3 - {length!r}**3"
    scene.add_joint(t2.Equation(rod), 0, 1)
    curve = "y(position_a)/1[m] - (x(position_a)/1[m] - 1)**2 - exp(x(position_a)/1[m] - 2) + 1"
    scene.add_joint(t2.Equation(f"({curve})*1[m]"), 2)
    return scene


def bounded(most: float) -> Scene:
    """A rod on a hinge with a spring, pulled at its tip to a point, both with a maximum."""
    elbow = t2.JointSpring(stiffness=40.0, damping=3.0, rest=0.5, maximum=most)
    scene = hung(t2.Revolute(spring=elbow), box(0.5), anchor=(-0.5, 0.0))
    pull = t2.Target(spring=t2.JointSpring(stiffness=30.0, damping=2.0, maximum=most))
    scene.add_joint(pull, (0.3, 2.0), "body", other_anchor=(0.5, 0.0))
    return scene


SCENES = {
    "springs at their maximum": bounded(0.1),
    "springs below their maximum": bounded(1e4),
    **kinds(),
    "stated": stated(),
    **{name: catalogue.load(name) for name in ("andrews", "ragdolls", "car", "walker")},
    "four-bars in a row": four_bars(7),
}


def pairs(scene: Scene, sense: int = 0) -> Iterator[tuple[Mechanism, Mechanism, Given]]:
    """Yield each mechanism of a scene: by kernels, generally, and with a state and loads.

    The state is off its joints by so much as a step errs. Motors push in a sense, or keep their
    speed.
    """
    moving = [k for k, body in enumerate(scene.bodies) if body.dynamic]
    position, velocity = coordinates([start_states(scene)[k] for k in moving])
    draw = np.random.default_rng(1).normal
    both = (Loads(scene, joint_code).mechanisms(moving), Loads(scene).mechanisms(moving))
    for (own, one), (_, other) in zip(*both, strict=True):
        shape = (len(own), 3)
        q = position[own] + 1e-7 * draw(size=shape)
        rate = within(other, sense).paced(0.0, q, velocity[own] + draw(size=shape))
        rate += 1e-7 * draw(size=shape)
        yield (
            within(one, sense),
            within(other, sense),
            (0.0, q, rate, draw(size=shape) - (0.0, 9.81, 0.0)),
        )


def within(mechanism: Mechanism | LimitedMechanism, sense: int) -> Mechanism:
    if isinstance(mechanism, LimitedMechanism):
        motors = [of for of, each in mechanism.freedoms.items() if each.motor]
        return mechanism.within(Mode(driven=tuple((of, sense) for of in motors)))
    return mechanism


@pytest.mark.parametrize("name", list(SCENES))
def test_reactions_and_places_are_those_of_the_general_way(name: str) -> None:
    for one, other, (time, q, rate, free) in pairs(SCENES[name]):
        assert one.code is not None
        placed = one.code.fit(time, q, rate)
        assert placed is not None
        q, rate = placed
        before = other.fitted(time, q, rate)
        assert q == pytest.approx(before[0], rel=1e-12, abs=1e-12)
        assert rate == pytest.approx(before[1], rel=1e-10, abs=1e-10)
        found = one.code.react(time, q, rate, free)
        assert found is not None
        wanted = other.accelerations(time, q, rate, free)
        assert found[0] == pytest.approx(wanted, rel=1e-9, abs=1e-9 * np.abs(wanted).max())
        shares = other.multipliers(time, q, rate, free)
        assert found[1] == pytest.approx(shares, rel=1e-8, abs=1e-8 * np.abs(shares).max(initial=0))


@pytest.mark.parametrize("name", list(SCENES))
def test_drifts_end_where_the_general_way_ends_them(name: str) -> None:
    for one, other, (time, q, rate, _) in pairs(SCENES[name]):
        assert one.code is not None
        q, rate = other.fitted(time, q, rate)
        found = one.code.drift(time, 0.01, q, 3 * rate)
        assert found is not None
        after, along = other.drifted(time, 0.01, q, 3 * rate)
        assert found[0] == pytest.approx(after, rel=1e-12, abs=1e-12)
        assert found[1] == pytest.approx(along, rel=1e-9, abs=1e-9 * np.abs(along).max())
        assert found[0] == pytest.approx(q + 0.01 * found[1], rel=1e-13, abs=1e-13)


def lying(count: int, above: float, rate: float) -> Given:
    """A row of four-bars whose cranks turn clockwise, rad/s, by an angle above the ground."""
    c, s = math.sin(above), math.cos(above)
    turned, still = above - math.pi / 2, 0.0
    cranks = [(k + 0.5 * s, 0.5 * c, turned) for k in range(count + 1)]
    couplers = [(k + 0.5 + s, c, still) for k in range(count)]
    of_crank, of_coupler = (0.5 * c * rate, -0.5 * s * rate, -rate), (c * rate, -s * rate, still)
    q, speeds = cranks + couplers, [of_crank] * (count + 1) + [of_coupler] * count
    return 0.0, np.array(q), np.array(speeds), np.full((len(q), 3), (0.0, -9.81, 0.0))


@pytest.mark.parametrize(("rate", "fades"), [(5.0, True), (2.0, False), (0.0, False)])
def test_reactions_fade_where_motion_passes_what_joints_depend_on(rate: float, fades: bool) -> None:
    """What loads could hold there is left to the general factors (GD19)."""
    one = next(pairs(four_bars(7)))[0]
    assert one.code is not None
    assert one.code.react(*lying(7, 0.3, 1.0)) is not None
    found = one.code.react(*lying(7, 1e-4, rate))
    assert (found is not None) == fades
    assert found is None or found[1] is None


@pytest.mark.parametrize("sense", [-1, 0, 1])
def test_springs_and_motors_push_or_keep_their_speed(sense: int) -> None:
    turned = t2.Revolute(spring=t2.JointSpring(stiffness=40.0, damping=3.0, rest=0.5))
    slid = t2.Prismatic(
        axis=(1.0, -0.6),
        motor=t2.Motor(speed=50.0, maximum=2.0),
        spring=t2.JointSpring(stiffness=10.0, damping=2.0, rest=0.3),
    )
    for scene in (
        hung(turned, box(0.5), anchor=(-0.5, 0.0)),
        hung(slid, {"shape": t2.Disc(radius=0.2), "position": (0.2, -0.12)}),
    ):
        for one, other, (time, q, rate, free) in pairs(scene, sense):
            assert one.code is not None
            placed = one.code.fit(time, q, rate)
            assert placed is not None
            q, rate = other.fitted(time, q, rate)
            assert placed[0] == pytest.approx(q, abs=1e-12)
            assert placed[1] == pytest.approx(rate, rel=1e-10)
            found = one.code.react(time, q, rate, free)
            assert found is not None
            assert found[0] == pytest.approx(other.accelerations(time, q, rate, free), rel=1e-10)


@pytest.mark.parametrize("name", ["ragdolls", "andrews", "stated", "springs at their maximum"])
def test_compiled_code_has_the_bits_of_plain_code(
    name: str, at_price: Callable[[float], None]
) -> None:
    found = []
    for price in (math.inf, -math.inf):
        at_price(price)
        mechanism, _, (time, q, rate, free) = next(pairs(SCENES[name]))
        assert mechanism.code is not None
        placed = mechanism.code.fit(time, q, rate)
        assert placed is not None
        reacted = mechanism.code.react(time, *placed, free)
        assert reacted is not None
        drifted = mechanism.code.drift(time, 0.01, *placed)
        assert drifted is not None
        found.append([part.tobytes() for part in (*placed, *reacted, *drifted)])
    assert found[0] == found[1]


def test_a_run_has_the_same_bits_compiled_or_not(at_price: Callable[[float], None]) -> None:
    digests = []
    for price in (math.inf, -math.inf):
        at_price(price)
        digests.append(t2.simulate(SCENES["Revolute(limits=...)"], duration=1.0).digest())
    assert digests[0] == digests[1]


def test_rows_that_depend_on_each_other_are_left_to_the_general_way() -> None:
    twice = hung(t2.Revolute(), box(0.5), anchor=(-0.5, 0.0))
    twice.add_joint(t2.Weld(), (0.5, 0.0), "body")
    for one, other, (time, q, rate, free) in pairs(twice):
        assert one.code is not None
        assert one.code.react(time, q, rate, free) is None
        assert one.code.fit(time, q, rate) is None
        q, rate = other.fitted(time, q, rate)
        wanted = other.accelerations(time, q, rate, free)
        assert one.accelerations(time, q, rate, free).tobytes() == wanted.tobytes()


@pytest.mark.parametrize(("above", "left"), [(0.0, True), (1e-6, True), (1e-3, False)])
def test_four_bars_that_lie_as_good_as_flat_are_left_to_the_general_way(
    above: float, left: bool
) -> None:
    """At 5e-6 of the largest the rule of GD19 takes combinations of rows for none."""
    for one, other, (time, q, rate, free) in pairs(four_bars(2)):
        flat = q.copy()
        tip = np.array((math.cos(above), math.sin(above)))
        for k in range(3):
            flat[k] = k + tip[0] / 2, tip[1] / 2, above - math.pi / 2
        for k in range(2):
            flat[3 + k] = k + 0.5 + tip[0], tip[1], 0.0
        assert one.code is not None
        found = one.code.react(time, flat, rate, free)
        assert (found is None) == left
        if found is not None:
            wanted = other.accelerations(time, flat, rate, free)
            assert found[0] == pytest.approx(wanted, rel=1e-8, abs=1e-8 * np.abs(wanted).max())


def test_equations_of_ones_own_are_followed_with_the_same_bits(
    at_price: Callable[[float], None],
) -> None:
    digests = []
    for price in (math.inf, -math.inf):
        at_price(price)
        digests.append(t2.simulate(stated(), duration=0.5).digest())
    assert digests[0] == digests[1]


def test_what_is_not_finite_is_told_by_the_general_way(at_price: Callable[[float], None]) -> None:
    for price in (math.inf, -math.inf):
        at_price(price)
        one, _, (time, q, rate, free) = next(pairs(SCENES["Revolute(limits=...)"]))
        assert one.code is not None
        assert one.code.react(time, q, rate, free * math.inf) is None
        assert one.code.fit(time, q + math.inf, rate) is None
        with pytest.raises(t2.SimulationError, match="no finite"):
            one.accelerations(time, q, rate, free * math.inf)


def test_elimination_solves_any_rows_and_knows_their_inverse() -> None:
    draw = np.random.default_rng(2)
    for _ in range(100):
        count = int(draw.integers(1, 14))
        columns = [{k, *draw.integers(0, count + 4, 2).tolist()} for k in range(count)]
        rows = np.zeros((count, count + 4))
        for row, own in zip(rows, columns, strict=True):
            row[list(own)] = draw.normal(size=len(own))
        full = rows @ rows.T
        if np.linalg.cond(full) > 1e8:
            continue
        found = elimination(columns, 10**6)
        assert found is not None
        order = found.order
        diagonal = [full[k, k] for k in order]
        own = list(diagonal)
        lower = [
            full[order[found.below_rows[p]], order[k]]
            for k in range(count)
            for p in range(found.below[k], found.below[k + 1])
        ]
        places = found.below, found.below_rows
        assert factorised(diagonal, lower, *places, found.targets)  # type: ignore[arg-type]
        wanted = draw.normal(size=count)
        solution = wanted.tolist()
        solve(diagonal, lower, *places, order, solution)  # type: ignore[arg-type]
        assert full @ solution == pytest.approx(wanted, abs=1e-6)
        trace = inverse_size(diagonal, lower, *places, found.targets, own, [0.0] * len(lower))  # type: ignore[arg-type]
        assert trace == pytest.approx(np.trace(np.diag(np.diag(full)) @ np.linalg.inv(full)))


def test_a_chain_is_eliminated_without_new_entries() -> None:
    """Each row of a chain shares bodies with the one before and the one after it."""
    found = elimination([{k, k + 1} for k in range(50)], 10**6)
    assert found is not None
    assert len(found.below_rows) == 49
    assert not found.targets


def test_rows_that_all_share_a_body_are_refused_where_they_are_many() -> None:
    assert elimination([{0, k} for k in range(1, 30)], 1000) is None
