"""Each closed form agrees with scipy's solution.

Generated from srs/ by `python -m tools.generate`. Edit the chapter, not this file.
"""

from hypothesis import given

from tamias2d.generated import drag, rotation, spring, translation
from tests.support import Value, close, only, solve, values


@given(
    position_start=values("position_start"),
    velocity_start=values("velocity_start"),
    acceleration=values("acceleration"),
    drag_rate=values("drag_rate"),
    time=values("time"),
    orientation_start=values("orientation_start"),
    angular_velocity_start=values("angular_velocity_start"),
    angular_acceleration=values("angular_acceleration"),
    angular_drag_rate=values("angular_drag_rate"),
)
def test_im6_closed_form_solves_its_equations(**given: Value) -> None:
    """IM6, srs/models/drag.md:18."""
    solution = solve(
        {
            "position": "velocity",
            "velocity": "acceleration - drag_rate*velocity",
            "orientation": "angular_velocity",
            "angular_velocity": "angular_acceleration - angular_drag_rate*angular_velocity",
        },
        given,
    )
    close(drag.position(**only(given, drag.position)), solution["position"])
    close(drag.velocity(**only(given, drag.velocity)), solution["velocity"])
    close(drag.orientation(**only(given, drag.orientation)), solution["orientation"])
    close(drag.angular_velocity(**only(given, drag.angular_velocity)), solution["angular_velocity"])


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
    equilibrium=values("equilibrium"),
    position_start=values("position_start"),
    velocity_start=values("velocity_start"),
    angular_frequency=values("angular_frequency"),
    time=values("time"),
)
def test_im7_closed_form_solves_its_equations(**given: Value) -> None:
    """IM7, srs/models/spring.md:30."""
    solution = solve(
        {"position": "velocity", "velocity": "angular_frequency**2*(equilibrium - position)"}, given
    )
    close(spring.position(**only(given, spring.position)), solution["position"])
    close(spring.velocity(**only(given, spring.velocity)), solution["velocity"])


@given(
    position_start=values("position_start"),
    velocity_start=values("velocity_start"),
    acceleration=values("acceleration"),
    time=values("time"),
)
def test_im1_closed_form_solves_its_equations(**given: Value) -> None:
    """IM1, srs/models/translation.md:24."""
    solution = solve({"position": "velocity", "velocity": "acceleration"}, given)
    close(translation.position(**only(given, translation.position)), solution["position"])
    close(translation.velocity(**only(given, translation.velocity)), solution["velocity"])
