"""Impacts that act on one another, and bodies that move on in contact (A18, DD67, DD68, IM18)."""

import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import tamias2d as t2
from tamias2d.contact.core import Core, cores_of, place
from tamias2d.contact.coupled_island import CoupledIsland
from tamias2d.contact.lemke import lemke
from tamias2d.contact.manifold import manifold, normal_velocity
from tamias2d.contact.pair_friction import PairFriction
from tamias2d.contact.simultaneous_impact import Meeting, apply, simultaneous_impulses
from tamias2d.scene import Shape
from tamias2d.state import State
from tests.contact.meetings import without_joints
from tools.measurements.drops import drop
from tools.measurements.located_drops import ROUNDING, laws

G = 9.81
DISC = t2.Disc(radius=0.5)


def rack(restitution: float, friction: float) -> t2.Scene:
    """A disc that runs into ten others that touch, along their line of symmetry."""
    scene = t2.Scene(gravity=(0, 0))
    surface = {"restitution": restitution, "friction": friction}
    scene.add_body(DISC, mass=1, position=(0, 3), velocity=(0, -1), **surface)
    for row in range(4):
        for k in range(row + 1):
            scene.add_body(DISC, mass=1, position=(k - row / 2, -row * math.sqrt(3) / 2), **surface)
    return scene


@pytest.mark.parametrize("friction", [0.0, 0.4])
@pytest.mark.parametrize("restitution", [0.5, 0.8, 1.0])
def test_a_rack_breaks_symmetrically_to_the_bit(restitution: float, friction: float):
    run = t2.simulate(rack(restitution, friction), duration=5.0)
    assert "ClosedForm" in run.notes[0]
    places = set(map(tuple, run.position[-1].tolist()))
    assert {(-x, y) for x, y in places} == places
    np.testing.assert_allclose(run.momentum[-1], (0, -1), rtol=0, atol=1e-14)
    assert abs(run.angular_momentum[-1]) < 1e-13
    assert run.energy[-1] <= 0.5 * (1 + 1e-14)
    if restitution == 1 and not friction:
        assert run.energy[-1] == pytest.approx(0.5, rel=1e-14)


def test_a_disc_between_two_others_strikes_both_at_once():
    """Conservation alone says what follows: v = -1/5 and 6/5 of it along each normal."""
    scene = t2.Scene(gravity=(0, 0))
    for x in (-0.5, 0.5):
        scene.add_body(DISC, mass=1, position=(x, 0), restitution=1)
    scene.add_body(DISC, mass=1, position=(0, 2), velocity=(0, -1), restitution=1)
    run = t2.simulate(scene, duration=3.0)
    np.testing.assert_allclose(run.velocity[-1, 2], (0, 0.2), rtol=0, atol=1e-15)
    np.testing.assert_allclose(run.velocity[-1, 1], (math.sqrt(3) / 5, -0.6), rtol=0, atol=1e-15)


def test_a_ball_that_falls_on_a_box_without_restitution_rests_there():
    """The rounds have no end: each leaves half of the approach."""
    scene = t2.Scene(gravity=(0, -G))
    scene.add_static(t2.HalfPlane(normal=(0, 1), offset=0), restitution=0, friction=0.5)
    scene.add_body(t2.Box(width=1, height=1), mass=1, position=(0, 0.5), restitution=0)
    scene.add_body(DISC, mass=1, position=(0, 2), restitution=0, friction=0.5)
    run = t2.simulate(scene, duration=2.0)
    assert "ClosedForm" in run.notes[0]
    assert np.abs(run.velocity[-1]).max() == 0
    assert run.impacts.impulse[run.impacts.bodies[:, 0] == 1].sum() == pytest.approx(
        math.sqrt(2 * G * 0.5), rel=1e-9
    )


def test_two_discs_roll_apart_from_each_other():
    """One lies on another that is free, off its top: a pendulum upside down, against scipy."""
    angle, pull = 0.1, 1.0
    scene = t2.Scene(gravity=(0, 0))
    scene.add_body(DISC, mass=1, position=(0, 0), force=(0, pull), restitution=0)
    above = (math.sin(angle), math.cos(angle))
    scene.add_body(DISC, mass=1, position=above, force=(0, -pull), restitution=0)
    run = t2.simulate(scene, duration=1.5, times=[1.5])
    assert "ClosedForm" in run.notes[0]
    found = solve_ivp(
        lambda _, y: (y[1], 2 * pull * math.sin(y[0])), (0, 1.5), (angle, 0), rtol=1e-12, atol=1e-12
    )
    way = run.position[-1, 1] - run.position[-1, 0]
    assert math.atan2(*way) == pytest.approx(found.y[0, -1], abs=1e-10)
    assert math.hypot(*way) == pytest.approx(1.0, abs=1e-12)


def test_a_stack_slides_down_a_slope_as_one():
    """With half the friction that would hold it: g (sin a - mu cos a)."""
    angle, friction = 0.3, 0.5 * math.tan(0.3)
    scene = t2.Scene(gravity=(G * math.sin(angle), -G * math.cos(angle)))
    scene.add_static(t2.HalfPlane(normal=(0, 1), offset=0), friction=friction, restitution=0)
    for k in range(3):
        slab = t2.Box(width=3, height=0.5)
        scene.add_body(slab, mass=1 + k, position=(0, 0.25 + 0.5 * k), friction=2 * friction)
    scene.set_friction(0, 1, friction)
    run = t2.simulate(scene, duration=2.0, method=t2.ClosedForm())
    way = 0.5 * G * (math.sin(angle) - friction * math.cos(angle)) * 2.0**2
    np.testing.assert_allclose(run.position[-1, 1:, 0], way, rtol=1e-11)


@pytest.mark.parametrize("seed", [108, 113, 120])
def test_ordinary_drops_are_located_to_the_end(seed: int):
    """They were refused where the third body came into contact; energy only falls."""
    run = t2.simulate(drop(seed), duration=3.0)
    assert "ClosedForm" in run.notes[0]
    assert np.diff(run.energy).max() <= 1e-13 * run.energy[0]


@pytest.mark.parametrize(
    ("seed", "duration"),
    [(9300093, 1.0), (9300131, 1.0), (9300031, 1.0), (9300060, 1.4), (9300081, 0.7)],
)
def test_drops_go_on_past_what_lasting_contacts_tremble(seed: int, duration: float):
    """Two jammed, hidden by what was left of bounces; three met again and again at one instant."""
    run = t2.simulate(drop(seed), duration=duration, method=t2.ClosedForm())
    assert max(laws(run).values()) <= ROUNDING


def jammed(friction: float, restitution: float, *bodies: tuple[Shape, float, State]) -> t2.Scene:
    """Bodies of an ordinary drop on its floor, at an instant at which it was refused."""
    surface = {"friction": friction, "restitution": restitution}
    scene = t2.Scene(gravity=(0, -G))
    scene.add_static(t2.HalfPlane(normal=(0, 1), offset=0), **surface)
    for shape, mass, state in bodies:
        scene.add_body(
            shape,
            mass=mass,
            position=state.position,
            orientation=state.orientation,
            velocity=state.velocity,
            angular_velocity=state.angular_velocity,
            **surface,
        )
    return scene


def pentagon(radius: float) -> t2.Polygon:
    turns = [0.4 * math.pi * k for k in range(5)]
    return t2.Polygon(vertices=[(radius * math.cos(a), radius * math.sin(a)) for a in turns])


JAMS = {
    "a pentagon between discs: its turning presses": jammed(
        0.7202108163216341,
        0.2650537483644674,
        (
            t2.Disc(radius=0.18371014922241927),
            0.5380459472555404,
            State(
                (-0.1823615212133085, 0.18371014922241927),
                4.1621880590393925,
                (0.21807574533547322, 0.0),
                -1.1870642218653213,
            ),
        ),
        (
            t2.Disc(radius=0.15990302263822082),
            0.9594800631695037,
            State(
                (0.17508605758857024, 0.15990302263822082),
                1.002162104717317,
                (0.18616927898513738, 1.5101331908458552e-26),
                -1.164263663772909,
            ),
        ),
        (
            pentagon(0.1338338970019956),
            2.824992856136071,
            State(
                (0.026732226165510437, 0.3881978630994321),
                5.743488802105895,
                (0.23413227561964545, -0.05714858707420818),
                1.5187924180916335,
            ),
        ),
    ),
    "a heap: one contact sticks but for rounding": jammed(
        0.7924472417262629,
        0.2519474177039749,
        (
            t2.Box(width=0.4043394665482869, height=0.4043394665482869),
            2.9670861059809726,
            State(
                (0.31980952245875144, 0.27068481174936687),
                4.254817318345418,
                (0.13993002546730665, 0.047589945545840576),
                -0.5169481972888482,
            ),
        ),
        (
            t2.Box(width=0.3149255916025241, height=0.3149255916025241),
            4.902668331855874,
            State(
                (0.7386684004163607, 0.5263664839439142),
                6.3036386168767535,
                (0.04441461157759694, 0.04962262213207564),
                0.9003515770607828,
            ),
        ),
        (
            pentagon(0.24586800607529452),
            4.0958936013048906,
            State(
                (0.7355801153100192, 0.8827520559786586),
                2.847886697927981,
                (-0.2764558172673752, 0.04684076969160462),
                0.9003422473244087,
            ),
        ),
    ),
    "a heap: what one contact does as it settles holds for the islands of others": jammed(
        0.4744621605696147,
        0.13066723661549073,
        (
            t2.Box(width=0.3639922677347308, height=0.3639922677347308),
            1.719470028252207,
            State(
                (0.02321569775006516, 0.18199818194770093),
                4.712377726893659,
                (1.2730726866716946e-13, 3.9181191447533196e-13),
                -2.1528826765472623e-12,
            ),
        ),
        (
            t2.Box(width=0.20684440990483147, height=0.20684440990483147),
            4.007078779338905,
            State(
                (-0.04410770380459394, 0.4674178502338356),
                6.283168524638337,
                (0.003706587581367087, 0.0014771734357941926),
                -0.014283425070861638,
            ),
        ),
        (
            t2.Disc(radius=0.12289834725385293),
            2.26489304105717,
            State((0.32810951381113346, 0.12289834725385293), 8.060920270385783, (0.0, 0.0), 0.0),
        ),
        (
            t2.Box(width=0.3424540556778612, height=0.3424540556778612),
            2.1540569619158516,
            State(
                (0.35244559472658393, 0.5344300669709515),
                -0.005377214038315977,
                (1.2333705922171454, -1.054523941519302),
                -7.161877891691293,
            ),
        ),
        (
            pentagon(0.11553767428451459),
            2.6769611609776884,
            State((0.5445036235998837, 0.10981861041873472), 10.054891032597892, (0.0, 0.0), 0.0),
        ),
    ),
    "boxes side by side: no friction where others keep them from sliding": jammed(
        0.16474750807743233,
        0.07753367419806356,
        (
            t2.Box(width=0.4542528171197245, height=0.4542528171197245),
            1.8568412787529276,
            State(
                (0.6510870104902858, 0.22712640855986246),
                6.283185307179587,
                (-0.21164604139638882, -8.828461599841326e-21),
                -1.299860619157448e-19,
            ),
        ),
        (
            t2.Box(width=0.3746882721759556, height=0.3746882721759556),
            1.378370440443729,
            State(
                (1.2958285530650304, 0.1873441360879777),
                3.141592653589793,
                (-0.21164716134897296, 1.6543612251060553e-24),
                0.0,
            ),
        ),
        (
            t2.Box(width=0.4497624542537042, height=0.4497624542537042),
            3.872335558900323,
            State(
                (0.811585501127517, 0.6791385240742798),
                4.712321751516724,
                (-0.012972986307175473, -0.00039798858820580063),
                0.005771526065523371,
            ),
        ),
        (
            t2.Box(width=0.23027099792268427, height=0.23027099792268427),
            4.251270677918753,
            State(
                (0.9933489180114905, 0.11513549896134213),
                9.42477796076938,
                (-0.21164604139638882, 3.685967607732868e-21),
                9.441677696108184e-21,
            ),
        ),
        (
            t2.Disc(radius=0.2407584345024451),
            3.269554906194667,
            State(
                (1.723931123655453, 0.24086041212258477),
                5.231111916566562,
                (-0.211647161348973, -0.025601695799957646),
                1.7899665544986816,
            ),
        ),
    ),
}


@pytest.mark.parametrize("scene", JAMS.values(), ids=JAMS)
def test_sliding_that_jams_or_settles_ends(scene: t2.Scene):
    """Those contacts are told that loads press, with what turning adds to them (DD68, DD75)."""
    run = t2.simulate(scene, duration=0.01, method=t2.ClosedForm())
    assert max(laws(run).values()) <= ROUNDING


def test_what_is_left_of_an_approach_rubs_within_coulombs_bound():
    """The floor alone pushes: sideways by no more than friction times upwards."""
    run = t2.simulate(drop(9000016), duration=1.5)
    assert "ClosedForm" in run.notes[0]
    assert any(note.startswith("rule: ") for note in run.notes)
    friction = run.scene.bodies[0].friction
    mass = sum(body.mass for body in run.scene.bodies if body.dynamic)
    side, up = np.diff(run.momentum, axis=0).T
    push = up + mass * G * np.diff(run.times)
    assert friction is not None
    assert (np.abs(side) <= friction * push + 1e-12 * mass * G).all()


def test_contacts_that_change_too_often_are_stepped(monkeypatch: pytest.MonkeyPatch):
    """Unless the method was asked for: then what is asked is done."""
    monkeypatch.setattr("tamias2d.solve.located.MOST_RULED", 2)
    run = t2.simulate(drop(113), duration=3.0)
    assert isinstance(run.method, t2.Stepped)
    assert "have changed 2 times since a rule" in run.notes[0]
    asked = t2.simulate(drop(113), duration=3.0, method=t2.ClosedForm())
    assert "ClosedForm" in asked.notes[0]


def test_a_tolerance_is_met_by_steps_where_a_rule_bounds_nothing():
    """Dominoes lean on one another: past the first impacts only steps tell how wrong they are."""
    scene = t2.catalogue.load("dominoes")
    with pytest.raises(t2.ToleranceError, match=r"by a rule \(A18\)") as refused:
        t2.simulate(scene, duration=0.6, tolerance=1e-2)
    assert refused.value.until is not None
    assert t2.recommend(scene, duration=0.2, tolerance=1e-2).choice.method == t2.ClosedForm()


def row_of_boxes(seed: int) -> tuple[list[Core], list[Meeting], dict[int, State]]:
    """Two to four boxes that stand flat on a floor and side by side, as they all meet."""
    chance = np.random.default_rng(seed)
    scene, place_of, states = t2.Scene(gravity=(0, 0)), 0.0, {0: State((0, 0), 0, (0, 0), 0)}
    scene.add_static(t2.HalfPlane(normal=(0, 1), offset=0))
    count = int(chance.integers(2, 5))
    for k in range(1, count + 1):
        size, mass = chance.uniform((0.5, 0.5), (1.5, 5.0)).tolist()
        at = place_of + size / 2, size / 2
        scene.add_body(t2.Box(width=size, height=size), mass=mass, position=at)
        along, spin, fall = (*chance.normal(size=2), chance.uniform())
        states[k] = State(at, 0.0, (float(along), -float(fall)), float(spin))
        place_of += size
    cores = cores_of(scene)
    placed = {i: place(core, states[i]) for i, core in enumerate(cores)}
    meetings = []
    for i, j in [(0, k) for k in range(1, count + 1)] + [(k, k + 1) for k in range(1, count)]:
        found = manifold(placed[i], placed[j], 1e-14, 1.0)
        closing = [c for c in found if normal_velocity(c, states[i], states[j]) <= 0]
        if closing:
            meetings.append(Meeting(closing, 0.5, 0.4))
    return cores, meetings, states


@pytest.mark.parametrize("seed", range(50))
def test_boxes_side_by_side_that_meet_a_floor_rub_within_coulombs_bound(seed: int):
    """They hold each other, so that some friction could do nothing: what there is takes energy."""
    cores, meetings, before = row_of_boxes(seed)

    def energy(states: dict[int, State]) -> float:
        moving = [(core, states[core.index]) for core in cores if core.dynamic]
        return sum(
            math.hypot(*state.velocity) ** 2 / core.inverse_mass / 2
            + state.angular_velocity**2 / core.inverse_inertia / 2
            for core, state in moving
        )

    smooth, rough = dict(before), dict(before)
    bare = [meeting._replace(coefficient=0.0) for meeting in meetings]
    mobility = without_joints(cores)
    apply(mobility, simultaneous_impulses(mobility, bare, before), smooth)
    found = simultaneous_impulses(mobility, meetings, before)
    apply(mobility, found, rough)
    assert energy(rough) < (1 - 1e-9) * energy(smooth) < energy(before)
    impulses = iter(found)
    for meeting in meetings:
        own = [next(impulses) for _ in meeting.contacts]
        push, drag = sum(n for _, n, _ in own), sum(t for *_, t in own)
        assert min(n for _, n, _ in own) >= 0
        assert abs(drag) <= 0.4 * push + 1e-13


def test_lemke_solves_what_it_is_given():
    rng = np.random.default_rng(7)
    for _ in range(50):
        root = rng.normal(size=(6, 4))
        matrix, vector = root @ root.T, root @ rng.normal(size=4)
        found = lemke(matrix, vector)
        assert found is not None
        slack = matrix @ found + vector
        assert min(found.min(), slack.min()) > -1e-10
        assert abs(found @ slack) < 1e-9


def test_lemke_tells_faint_pushes_beside_fast_sliding():
    """Coulomb's bounds on two drags, N s, of contacts that slide at about 1 m/s (DD67)."""
    faint, friction = 1e-7, 0.03
    for seed in range(500):
        rng = np.random.default_rng(seed)
        jacobian = rng.normal(size=(4, 6))  # two normals, two tangents
        matrix = jacobian @ jacobian.T
        across = np.linalg.inv(matrix[:2, :2]) @ matrix[:2, 2:]
        effect = np.linalg.inv(matrix[2:, 2:] - matrix[2:, :2] @ across)
        both = friction * across
        limits = np.vstack([across, both + np.eye(2), both - np.eye(2)])
        pushes = faint * rng.uniform(size=2)
        most = np.concatenate([pushes, friction * pushes, friction * pushes])
        coupled = limits @ effect @ limits.T
        size = np.sqrt(np.diag(coupled))
        problem = coupled / np.outer(size, size)
        vector = (most + limits @ effect @ rng.normal(size=2)) / size
        found = lemke(problem, vector)
        assert found is not None
        assert (problem @ found + vector).min() > -1e-11  # what counts as a tie


def test_friction_ends_sliding_where_contacts_settle_and_does_not_turn_it_round():
    """Two boxes, one on the other, are left with more approach than it takes to stop them."""
    slow, approach = 1e-9, -1e-8
    scene = t2.Scene(gravity=(0, -G))
    scene.add_static(t2.HalfPlane(normal=(0, 1), offset=0))
    for height in (0.5, 1.5):
        scene.add_body(t2.Box(width=1, height=1), mass=1, position=(0, height))
    cores = cores_of(scene)
    states = {k: State((0, k - 0.5), 0.0, (slow, approach), 0.0) for k in (1, 2)}
    states[0] = State((0, 0), 0.0, (0, 0), 0.0)
    placed = {k: place(core, states[k]) for k, core in enumerate(cores)}
    contacts = [
        contact
        for i, j in ((0, 1), (1, 2))
        for contact in manifold(placed[i], placed[j], 1e-14, 1.0)
    ]
    weight = {1: (0.0, -G, 0.0), 2: (0.0, -G, 0.0)}
    rough = PairFriction(1.0, lambda *_: 0.5, lambda _: 1e-14)
    mobility = without_joints(cores)
    after = CoupledIsland(mobility, placed, contacts, weight, 0.0, rough).projected(states)
    for state in after.values():
        np.testing.assert_allclose((*state.velocity, state.angular_velocity), 0, atol=1e-22)


def test_no_closed_form_is_recommended_whose_places_have_no_bound():
    """A bound of the energy alone is none of a tolerance."""
    with pytest.raises(t2.ToleranceError, match="decided by a rule"):
        t2.recommend(rack(1.0, 0.0), duration=5.0, tolerance=1e-3)
