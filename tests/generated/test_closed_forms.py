"""Each closed form agrees with scipy's solution.

Generated from srs/ by `python -m tools.generate`. Edit the chapter, not this file.
"""

from hypothesis import given

from tamias2d.generated import rotation, translation
from tests.support import Value, close, only, solve, values


@given(
    orientation_start=values("orientation_start"),
    angular_velocity_start=values("angular_velocity_start"),
    angular_acceleration=values("angular_acceleration"),
    time=values("time"),
)
def test_im2_closed_form_solves_its_equations(**given: Value) -> None:
    """IM2, srs/models/rotation.md:27."""
    solution = solve(
        {"orientation": "angular_velocity", "angular_velocity": "angular_acceleration"}, given
    )
    close(rotation.orientation(**only(given, rotation.orientation)), solution["orientation"])
    close(
        rotation.angular_velocity(**only(given, rotation.angular_velocity)),
        solution["angular_velocity"],
    )


@given(
    position_start=values("position_start"),
    velocity_start=values("velocity_start"),
    acceleration=values("acceleration"),
    time=values("time"),
)
def test_im1_closed_form_solves_its_equations(**given: Value) -> None:
    """IM1, srs/models/translation.md:22."""
    solution = solve({"position": "velocity", "velocity": "acceleration"}, given)
    close(translation.position(**only(given, translation.position)), solution["position"])
    close(translation.velocity(**only(given, translation.velocity)), solution["velocity"])
