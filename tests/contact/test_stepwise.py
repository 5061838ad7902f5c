"""What only stepped runs know is refused by name by all other methods, before anything runs."""

from collections.abc import Callable

import pytest

import tamias2d as t2

DISC = t2.Disc(radius=1)
ADDED: dict[str, Callable[[t2.Scene], object]] = {
    "kinematic": lambda scene: scene.add_kinematic(DISC, position=(5, 0), name="odd"),
    "sensor": lambda scene: scene.add_static(DISC, position=(5, 0), sensor=True, name="odd"),
    "several parts": lambda scene: scene.add_body(
        t2.Compound(parts=[t2.Part(shape=DISC)]), mass=1, position=(5, 0), name="odd"
    ),
}


@pytest.mark.parametrize("what", ADDED)
@pytest.mark.parametrize(
    "method", [t2.ClosedForm(), t2.Reference(), t2.VelocityVerlet(), t2.Legacy2018()]
)
def test_it_is_named(what: str, method: t2.Reference | t2.VelocityVerlet) -> None:
    scene = t2.Scene(gravity=(0, 0))
    scene.add_body(DISC, mass=1, position=(0, 0))
    ADDED[what](scene)
    step = 0.1 if method.fixed_step else None
    with pytest.raises(t2.SceneError, match=rf"body 'odd': it (is a|is|has) {what}.*Simulator"):
        t2.simulate(scene, duration=1.0, method=method, time_step=step)
