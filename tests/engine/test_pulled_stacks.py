"""What is pulled out of a stack is braked as Coulomb's law says (GD7), seen from its momentum."""

import pytest

import tamias2d as t2

GRAVITY = 9.81
THICK, WIDE = 0.1, 2.0
SLIDES = 0.05  # m/s, at the least: then it does in all substeps


def stack(boards: int, friction: float, rate: int, substeps: int) -> t2.Simulator:
    """Return boards of 2 kg that lie on each other, at rest."""
    sim = t2.Simulator(t2.Scene(gravity=(0.0, -GRAVITY)), time_step=1 / rate, substeps=substeps)
    surface = {"friction": friction, "restitution": 0.0}
    sim.add_static(t2.HalfPlane(normal=(0.0, 1.0), offset=0.0), **surface)
    places = [(0.0, THICK * (k + 0.5)) for k in range(boards)]
    sim.add(t2.Box(width=WIDE, height=THICK), mass=2.0, position=places, **surface)
    sim.step(rate)
    return sim


def slides(sim: t2.Simulator, board: int) -> bool:
    """Return whether a board slides forward on both its neighbours."""
    speed, turn = sim.velocity[:, 0], sim.angular_velocity * THICK / 2
    turn[0] = 0.0
    ahead = [speed[board] + turn[board] - speed[board - 1] + turn[board - 1]]
    if board + 1 < len(sim):
        ahead.append(speed[board] - turn[board] - speed[board + 1] - turn[board + 1])
    return bool(min(ahead) > SLIDES)


@pytest.mark.parametrize("substeps", [4, 8])
@pytest.mark.parametrize("rate", [60, 240])
@pytest.mark.parametrize("friction", [0.1, 0.4])
@pytest.mark.parametrize(("boards", "pulled"), [(2, 1), (5, 1), (8, 4), (10, 5), (10, 1)])
def test_a_board_that_slides_is_braked_by_its_friction(
    boards: int, pulled: int, friction: float, rate: int, substeps: int
) -> None:
    """Its friction is bounded by the impulse that is left when overlaps have been removed.

    In high stacks that shake, what contacts tell is not all left to bodies (IM11): a twentieth.
    """
    sim = stack(boards, friction, rate, substeps)
    pull = 2.5 * friction * GRAVITY * 2.0 * (2 * (boards - pulled) + 1)
    sim.force[pulled] = pull, 0.0
    braked = pressed = 0.0
    while sim.position[pulled, 0] < 0.3 * WIDE:
        before, slid = sim.velocity[pulled, 0], slides(sim, pulled)
        sim.step()
        if slid and slides(sim, pulled):
            braked += pull / rate - 2.0 * (sim.velocity[pulled, 0] - before)
            pressed += sim.touching(pulled).impulse.sum()
    assert pressed > 0.0
    assert braked == pytest.approx(friction * pressed, rel=0.05)
