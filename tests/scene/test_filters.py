"""Categories, masks and groups, in a scene and where bodies meet."""

import pytest
from hypothesis import given, strategies as st

import tamias2d as t2
from tamias2d.scene.filters import ALL
from tamias2d.scene.reach import pairs_that_can_meet

bits = st.integers(0, ALL) | st.integers(0, 7)
group = st.integers(-3, 3)


def pair(one: dict[str, int], other: dict[str, int], restitution: float = 1.0) -> t2.Scene:
    """Two discs that are bound to meet at 1 s, unless something lets them pass."""
    scene = t2.Scene(gravity=(0, 0))
    disc = t2.Disc(radius=0.5)
    scene.add_body(disc, mass=1, position=(-2, 0), velocity=(1, 0), restitution=restitution, **one)
    scene.add_body(disc, mass=1, position=(0, 0), **other)
    return scene


@given(bits, bits, group, bits, bits, group)
def test_the_rule_is_that_of_box2d(
    category: int, mask: int, one: int, other_category: int, other_mask: int, other: int
) -> None:
    """The rule as Box2D's manual states it, bit for bit; and it does not mind the order."""
    scene = pair(
        {"category": category, "mask": mask, "group": one},
        {"category": other_category, "mask": other_mask, "group": other},
    )
    if one == other and one != 0:
        wanted = one > 0
    else:
        wanted = (category & other_mask) != 0 and (other_category & mask) != 0
    assert scene.collides(0, 1) == scene.collides(1, 0) == wanted
    assert pairs_that_can_meet(scene, 5.0) == ([(0, 1)] if wanted else [])


def test_bodies_that_may_not_touch_pass_through_each_other() -> None:
    apart = pair({"category": 1, "mask": 1}, {"category": 2})
    run = t2.simulate(apart, duration=4.0)
    assert len(run.impacts) == 0
    assert run.position[-1, 0].tolist() == [2.0, 0.0]
    assert len(t2.simulate(pair({}, {}), duration=4.0).impacts) == 1


def test_bodies_that_may_not_touch_may_overlap_at_the_start() -> None:
    scene = t2.Scene(gravity=(0, 0))
    for x in (0.0, 0.1):
        scene.add_body(t2.Disc(radius=1), mass=1, position=(x, 0), group=-1)
    assert len(t2.simulate(scene, duration=1.0).impacts) == 0


@pytest.mark.parametrize(
    ("values", "words"),
    [
        ({"category": 1.0}, "category of body 'body0': found 1.0: must be a whole number"),
        ({"category": -1}, "category -1 of body 'body0': must be from 0 to"),
        ({"mask": 2**63}, "must be from 0 to 9223372036854775807"),
        ({"mask": True}, "mask of body 'body0': found True: must be a whole number"),
        ({"group": "a"}, "group of body 'body0': found 'a'"),
        ({"group": 2**63}, "must be from -9223372036854775808"),
        ({"sensor": 1}, "sensor of body 'body0': found 1: must be True or False"),
    ],
)
def test_bad_filters_are_refused(values: dict[str, object], words: str) -> None:
    scene = t2.Scene(gravity=(0, 0))
    with pytest.raises(t2.InputError, match="R3") as caught:
        scene.add_body(t2.Disc(radius=1), mass=1, position=(0, 0), **values)  # type: ignore[arg-type]
    assert words in str(caught.value)
    assert len(scene) == 0
