"""A spring at a joint that is too stiff for float64 in a step is told of (R13)."""

import warnings

import pytest

import tamias2d as t2


def told(
    kind: t2.Revolute | t2.Distance, time_step: float = 1 / 60, at: float = -0.5
) -> tuple[str, ...]:
    """Return what the first step warns of: a link of 1 kg is tied beside its centre, m."""
    scene = t2.Scene(gravity=(0.0, -10.0))
    scene.add_body(t2.Capsule(length=0.8, radius=0.1), mass=1.0, position=(0.5, 0.0))
    scene.add_joint(kind, (0.0, 0.0), 0, other_anchor=(at, 0.0), name="tie")
    sim = t2.Simulator(scene, time_step=time_step, compiled=False)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", t2.StepWarning)
        sim.step()
    return sim.warnings


@pytest.mark.parametrize(("stiffness", "count"), [(1e11, 0), (3e11, 1)])
def test_a_spring_at_a_hinge_is_told_from_where_it_gains_energy(
    stiffness: float, count: int
) -> None:
    """Chains of such links gain none at 1e11 N m/rad, and 3e4 J at 3e11."""
    texts = told(t2.Revolute(spring=t2.JointSpring(stiffness=stiffness)))
    assert len([text for text in texts if "'tie'" in text and "rounding" in text]) == count


def test_a_shorter_step_needs_no_warning() -> None:
    """What counts is the stiffness times the squared step."""
    assert told(t2.Revolute(spring=t2.JointSpring(stiffness=3e11)), time_step=1 / 240) == ()


def test_a_spring_along_a_rod_counts_by_the_mass() -> None:
    """At 1e12 N/m a link of 1 kg is light, but not yet too light."""
    spring = t2.JointSpring(stiffness=1e12, rest=0.5)
    assert not any("rounding" in text for text in told(t2.Distance(spring=spring), at=0.0))
