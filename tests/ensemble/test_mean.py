"""Means over worlds are within what they state, and cheaper than plain sampling."""

import math
import re
from dataclasses import dataclass
from typing import Any

import numpy as np
import pytest
from scipy import integrate, stats

import tamias2d as t2
from tamias2d.ensemble.mean import Estimate
from tamias2d.ensemble.sensitivity import _intervals, _shares
from tests.ensemble.scenes import bouncing


class Halving:
    """Levels of steps, each half of the one before; all but the first take two runs."""

    stepped = True

    def time_step(self, level: int) -> float:
        return 0.5**level

    def cost(self, level: int) -> float:
        return 2.0**level * (1.5 if level else 1.0)


@dataclass
class Model(Halving):
    """Worlds whose mean is 0 in exact steps: coarse ones are off in a known way."""

    order: float
    """Of the error of the mean."""
    strong: float
    """Of the spread of the error over the worlds."""
    rare: float
    """The share of worlds that are changed at all, as impacts that are missed change few."""
    seed: int

    def values(self, level: int, first: int, last: int) -> Any:
        stream = np.random.default_rng([self.seed, level])
        share, hit, chance = stream.random((3, last))[:, first:]
        own = stats.norm.ppf(chance)
        changed = (hit < self.rare) / self.rare
        coarse = 2.0 ** (-self.order * level)
        if level == 0:
            return own + 0.2 * changed
        spread = 0.3 * 2.0 ** (-self.strong * level) * (2 * share - 1)
        bias = 0.2 * (coarse - 2.0 ** (-self.order * (level - 1)))
        return changed * (bias + spread / math.sqrt(1 / self.rare))


MODELS = {
    "first order": (1.0, 1.0, 1.0),
    "second order": (2.0, 2.0, 1.0),
    "half order": (0.5, 0.5, 1.0),
    "few worlds are changed": (1.0, 1.0, 0.2),
    "spread that falls slowly": (1.0, 0.5, 1.0),
}


@pytest.mark.parametrize("model", MODELS)
def test_the_error_is_within_its_bound_in_95_percent_of_repetitions(model: str) -> None:
    tolerance = 0.1 if model == "half order" else 0.04
    found = [Estimate(Model(*MODELS[model], seed), tolerance).run() for seed in range(60)]
    within = sum(abs(mean.value) <= mean.bound <= tolerance * (1 + 1e-12) for mean in found)
    assert within >= 57, within
    cheaper = np.median([mean.cost / mean.plain_cost for mean in found])
    assert cheaper <= 1 / 3 or model == "half order", cheaper


@dataclass
class Drawn:
    """Worlds without levels, of a known distribution."""

    distribution: Any
    seed: int
    stepped = False

    def time_step(self, _: int) -> None:
        return None

    def cost(self, _: int) -> float:
        return 1.0

    def values(self, _: int, first: int, last: int) -> Any:
        shares = np.random.default_rng(self.seed).random(last)[first:]
        return np.asarray(self.distribution.ppf(shares), dtype=float)


@pytest.mark.parametrize("worlds", [50, 400])
@pytest.mark.parametrize(
    "distribution",
    [
        *(stats.bernoulli(share) for share in (0.003, 0.01, 0.02, 0.05, 0.5, 0.99)),
        stats.uniform(),
        stats.expon(),
        stats.lognorm(1.0),
    ],
    ids=lambda found: found.dist.name + "".join(f" {each}" for each in found.args),
)
def test_the_error_by_chance_is_within_its_bound_in_99_percent(
    distribution: Any, worlds: int
) -> None:
    """Also of what is rare: at a tolerance for which so many worlds would do, were they normal."""
    tolerance = 2.576 * distribution.std() / math.sqrt(worlds)
    found = [Estimate(Drawn(distribution, seed), tolerance).run() for seed in range(200)]
    within = sum(abs(mean.value - distribution.mean()) <= mean.bound for mean in found)
    assert within >= 194, within  # 3 standard deviations of what 200 show
    assert all(0 < mean.bound <= tolerance * (1 + 1e-12) for mean in found)


@dataclass
class Events(Halving):
    """Worlds in which something happens or not, in some only because the steps are coarse."""

    share: float
    seed: int

    def values(self, level: int, first: int, last: int) -> Any:
        drawn = np.random.default_rng([self.seed, level]).random(last)[first:]
        fine, coarse = (
            (drawn < self.share * (1 + 0.5 ** (each + 1))).astype(float)
            for each in (level, level - 1)
        )
        return fine - coarse if level else fine


@pytest.mark.parametrize("share", [0.01, 0.05, 0.3])
def test_levels_at_which_no_world_is_changed_are_not_taken_to_be_exact(share: float) -> None:
    found = [Estimate(Events(share, seed), 0.05).run() for seed in range(60)]
    assert sum(abs(mean.value - share) <= mean.bound <= 0.05 + 1e-12 for mean in found) >= 58
    assert all(mean.statistical > 0 < mean.discretisation for mean in found)


def test_what_all_worlds_give_alike_is_not_told_as_exact() -> None:
    found = Estimate(Drawn(stats.bernoulli(1e-9), 1), 0.02).run()
    assert found.value == 0
    assert 0.01 < found.bound <= 0.02
    assert str(found).endswith("0 in all of level 0, which is taken for a share of worlds")
    with pytest.raises(t2.SimulationError, match=r"found 7 in all of 1600 worlds.*0\.29%.*\(R10\)"):
        Estimate(Drawn(stats.randint(7, 8), 1), 0.02).run()


def test_what_no_step_of_its_range_reaches_is_refused() -> None:
    class Stubborn(Model):
        def values(self, level: int, first: int, last: int) -> Any:
            return np.full(last - first, (-1.0) ** level)

    with pytest.raises(t2.SimulationError, match=r"must be within half of the tolerance.*\(R10\)"):
        Estimate(Stubborn(1.0, 1.0, 1.0, 1), 0.05).run()


def swing(run: t2.Run) -> float:
    """Return the height of the bob at the end, m."""
    return float(run.position[-1, 2, 1])


def test_the_mean_of_an_oscillation_is_that_of_its_formula() -> None:
    """Of a mass on a spring of random stiffness, from the solution by hand."""
    vary = {"springs.0.stiffness": stats.uniform(20.0, 20.0)}
    scene = t2.Scene(gravity=(0.0, 0.0))
    scene.add_body(None, mass=2.0, position=(0.0, 1.5), name="bob")
    scene.add_spring("bob", (0.0, 0.0), stiffness=30.0, rest_length=1.0)
    wanted = 1 + integrate.quad(lambda k: 0.5 * math.cos(math.sqrt(k / 2)) / 20, 20, 40)[0]
    found = t2.ensemble_mean(
        scene,
        lambda run: float(run.position[-1, 0, 1]),
        duration=1.0,
        vary=vary,
        tolerance=0.03,
        seed=5,
        method=t2.VelocityVerlet(),
        time_step=0.1,
        workers=1,
    )
    assert abs(found.value - wanted) <= found.bound <= 0.03
    assert found.discretisation > 0 < found.statistical
    assert len(found.levels) >= 3
    assert "by chance (99%)" in str(found)


def test_an_exact_method_has_no_error_but_chance_and_workers_change_nothing() -> None:
    """Of a fall from a random height: the mean is that of the heights, less the fall."""
    scene = t2.Scene(gravity=(0.0, -2.0))
    scene.add_body(None, mass=1.0, position=(0.0, 0.0), name="stone")
    arguments: dict[str, Any] = {
        "duration": 1.0,
        "vary": {"bodies.stone.position.y": stats.norm(5.0, 1.0)},
        "tolerance": 0.15,
        "seed": 1,
    }
    found = t2.ensemble_mean(
        scene, lambda run: float(run.position[-1, 0, 1]), workers=1, **arguments
    )
    assert found.discretisation == 0.0
    assert abs(found.value - 4.0) <= found.statistical <= 0.15
    again = t2.ensemble_mean(
        scene, lambda run: float(run.position[-1, 0, 1]), workers=2, **arguments
    )
    assert again == found


def test_sensitivities_of_a_sum_are_the_shares_of_its_parts() -> None:
    """Of x + v t, the variances of both parts add: 4/5 and 1/5 of the whole, and nothing joint."""
    scene = t2.Scene(gravity=(0.0, 0.0))
    scene.add_body(None, mass=1.0, position=(0.0, 0.0), name="puck")
    found = t2.sensitivities(
        scene,
        lambda run: float(run.position[-1, 0, 0]),
        duration=2.0,
        vary={
            "bodies.puck.velocity.x": stats.uniform(0.0, 1.0),
            "bodies.puck.position.x": stats.uniform(0.0, 1.0),
            "bodies.puck.position.y": stats.uniform(0.0, 1.0),
        },
        worlds=128,
        seed=2,
        workers=1,
    )
    for name in ("first_order", "total_order"):
        for wanted, low, value, high in zip(
            (0.8, 0.2, 0.0),
            *(found[name + suffix].values for suffix in ("_low", "", "_high")),
            strict=True,
        ):
            assert low <= value <= high
            assert low - 0.02 <= wanted <= high + 0.02
    assert found["place"].values.tolist()[0] == "bodies.puck.velocity.x"


@pytest.mark.parametrize("seed", range(4))
def test_the_interval_of_a_rare_event_is_wide(seed: int) -> None:
    """It happens in a tenth of all worlds, for x alone: some of the resamples have none of it."""
    scene = t2.Scene(gravity=(0.0, 0.0))
    scene.add_body(None, mass=1.0, position=(0.0, 0.0), name="puck")
    found = t2.sensitivities(
        scene,
        lambda run: float(run.position[-1, 0, 0] > 0.9),
        duration=0.1,
        vary={f"bodies.puck.position.{axis}": stats.uniform(0.0, 1.0) for axis in "xy"},
        worlds=16,
        seed=seed,
        times=(0.1,),
        workers=1,
    )
    for name in ("first_order", "total_order"):
        low, known, high = (found[name + suffix].values for suffix in ("_low", "", "_high"))
        assert (low <= np.minimum(known, [1.0, 0.0])).all()
        assert (high >= np.maximum(known, [1.0, 0.2])).all()


def test_an_interval_holds_something_that_a_share_can_be() -> None:
    """By worlds that are spread evenly, the share of all is estimated beyond 1 in all resamples."""
    f_a = np.zeros((1, 64))
    f_b = np.zeros((1, 64))
    f_a[0, 5:12] = f_b[0, 40:48] = 1.0
    samples = (f_a, f_b, np.stack([f_b, f_a]))
    seeds = np.random.default_rng(1)
    low, high = _intervals(np.concatenate(_shares(*samples)), samples, 0.95, seeds)
    assert low[1, 0] == 1.0 < high[1, 0]
    assert low[:, 1].tolist() == [0.0, 0.0]
    assert high[:, 1] == pytest.approx((1 - 0.05 ** (1 / 64)) / 2 / np.var([f_a, f_b]))


def test_sensitivities_follow_from_the_seed_alone_and_take_either_kind_of_distribution() -> None:
    scene = t2.Scene(gravity=(0.0, 0.0))
    scene.add_body(None, mass=1.0, position=(0.0, 0.0), name="puck")
    one, other = (
        t2.sensitivities(
            scene,
            lambda run: float(run.position[-1, 0, 0]),
            duration=2.0,
            vary={"bodies.puck.velocity.x": speed, "bodies.puck.position.x": stats.uniform()},
            worlds=8,
            seed=2,
            workers=1,
        )
        for speed in (stats.norm(1.0, 0.5), stats.Normal(mu=1.0, sigma=0.5))
    )
    assert np.allclose(one.to_array(), other.to_array(), rtol=1e-9)


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda **k: t2.ensemble_mean(**k, tolerance=0.0), "tolerance 0.0 of the mean: must be"),
        (lambda **k: t2.ensemble_mean(**k, tolerance="1"), "tolerance '1' of the mean: must be"),
        (
            lambda **k: t2.ensemble_mean(**{**k, "vary": {"gravity.y": [1.0]}}, tolerance=1.0),
            "a mean is over worlds that are drawn",
        ),
        (lambda **k: t2.sensitivities(**k, worlds=100), r"worlds 100: must be a power of 2.*128"),
        (lambda **k: t2.sensitivities(**k, worlds=4, confidence=1.0), "confidence 1.0: must lie"),
        (lambda **k: t2.sensitivities(**k, worlds=4, confidence="a"), "confidence 'a': must lie"),
        (
            lambda **k: t2.sensitivities(**k, worlds=4),
            "vary: found .*gravity.y.*must name two places",
        ),
        (lambda **k: t2.ensemble_mean(**k, tolerance=True), "tolerance True of the mean: must be"),
        (
            lambda **k: t2.sensitivities(
                **{**k, "vary": {"gravity.x": [1.0], "gravity.y": [1.0]}}, worlds=4
            ),
            "must be a distribution, of which the shares",
        ),
    ],
)
def test_what_cannot_be_asked_is_refused(call: Any, message: str) -> None:
    vary = {"gravity.y": stats.uniform(-10, 1)}
    with pytest.raises(t2.InputError, match=message):
        call(scene=bouncing(), quantity=swing, duration=0.1, vary=vary, seed=1, workers=1)


def test_a_world_that_is_refused_has_no_mean() -> None:
    vary = {"bodies.ball.position.y": stats.uniform(0.0, 1.0)}  # some are in the floor
    with pytest.raises(t2.SceneError, match=r"world .* of the ensemble"):
        t2.ensemble_mean(
            bouncing(), swing, duration=0.1, vary=vary, seed=1, tolerance=0.1, workers=1
        )
    with pytest.raises(t2.SimulationError, match="worlds were refused"):
        t2.sensitivities(
            bouncing(),
            swing,
            duration=0.1,
            vary={**vary, "gravity.y": stats.uniform(-10, 1)},
            seed=1,
            worlds=4,
            workers=1,
        )


@pytest.mark.parametrize("number", [math.nan, math.inf, 1e200])
def test_a_quantity_that_is_no_number_to_reckon_with_has_no_mean(number: float) -> None:
    vary = {"gravity.y": stats.uniform(-10, 1), "gravity.x": stats.uniform(0, 1)}
    arguments: dict[str, Any] = {"duration": 0.1, "vary": vary, "seed": 1, "workers": 1}
    message = rf"is {re.escape(f'{number:g}')} in the world of gravity\.y -9\..*\(R10\)"
    with pytest.raises(t2.SimulationError, match=f"mean: the quantity {message}"):
        t2.ensemble_mean(bouncing(), lambda _: number, tolerance=0.1, **arguments)
    with pytest.raises(t2.SimulationError, match=f"sensitivities: the quantity {message}"):
        t2.sensitivities(bouncing(), lambda _: number, worlds=4, **arguments)
