"""Each symbol admits the values of its range and no others.

Generated from srs/ by `python -m tools.generate`. Edit the chapter, not this file.
"""

from math import inf, nan

from tamias2d.generated.symbols import SYMBOLS


def test_range_of_time() -> None:
    """srs/symbols.md:18: >= 0."""
    symbol = SYMBOLS["time"]
    assert all(
        symbol.admits(value)
        for value in (
            0.0,
            5e-324,
        )
    )
    assert not any(symbol.admits(value) for value in (inf, -inf, nan, -5e-324))


def test_range_of_time_step() -> None:
    """srs/symbols.md:23: > 0."""
    symbol = SYMBOLS["time_step"]
    assert all(symbol.admits(value) for value in (5e-324,))
    assert not any(symbol.admits(value) for value in (inf, -inf, nan, 0.0, -5e-324))


def test_range_of_time_to_rest() -> None:
    """srs/symbols.md:28: >= 0."""
    symbol = SYMBOLS["time_to_rest"]
    assert all(
        symbol.admits(value)
        for value in (
            0.0,
            5e-324,
        )
    )
    assert not any(symbol.admits(value) for value in (inf, -inf, nan, -5e-324))


def test_range_of_duration() -> None:
    """srs/symbols.md:33: > 0."""
    symbol = SYMBOLS["duration"]
    assert all(symbol.admits(value) for value in (5e-324,))
    assert not any(symbol.admits(value) for value in (inf, -inf, nan, 0.0, -5e-324))


def test_range_of_mass() -> None:
    """srs/symbols.md:47: > 0."""
    symbol = SYMBOLS["mass"]
    assert all(symbol.admits(value) for value in (5e-324,))
    assert not any(symbol.admits(value) for value in (inf, -inf, nan, 0.0, -5e-324))


def test_range_of_inverse_mass() -> None:
    """srs/symbols.md:54: >= 0."""
    symbol = SYMBOLS["inverse_mass"]
    assert all(
        symbol.admits(value)
        for value in (
            0.0,
            5e-324,
        )
    )
    assert not any(symbol.admits(value) for value in (inf, -inf, nan, -5e-324))


def test_range_of_inertia() -> None:
    """srs/symbols.md:59: > 0."""
    symbol = SYMBOLS["inertia"]
    assert all(symbol.admits(value) for value in (5e-324,))
    assert not any(symbol.admits(value) for value in (inf, -inf, nan, 0.0, -5e-324))


def test_range_of_inverse_inertia() -> None:
    """srs/symbols.md:66: >= 0."""
    symbol = SYMBOLS["inverse_inertia"]
    assert all(
        symbol.admits(value)
        for value in (
            0.0,
            5e-324,
        )
    )
    assert not any(symbol.admits(value) for value in (inf, -inf, nan, -5e-324))


def test_range_of_restitution() -> None:
    """srs/symbols.md:71: [0, 1]."""
    symbol = SYMBOLS["restitution"]
    assert all(
        symbol.admits(value)
        for value in (
            0.0,
            5e-324,
            1.0,
            0.9999999999999999,
        )
    )
    assert not any(symbol.admits(value) for value in (inf, -inf, nan, -5e-324, 1.0000000000000002))


def test_range_of_pair_restitution() -> None:
    """srs/symbols.md:80: [0, 1]."""
    symbol = SYMBOLS["pair_restitution"]
    assert all(
        symbol.admits(value)
        for value in (
            0.0,
            5e-324,
            1.0,
            0.9999999999999999,
        )
    )
    assert not any(symbol.admits(value) for value in (inf, -inf, nan, -5e-324, 1.0000000000000002))


def test_range_of_friction() -> None:
    """srs/symbols.md:85: >= 0."""
    symbol = SYMBOLS["friction"]
    assert all(
        symbol.admits(value)
        for value in (
            0.0,
            5e-324,
        )
    )
    assert not any(symbol.admits(value) for value in (inf, -inf, nan, -5e-324))


def test_range_of_pair_friction() -> None:
    """srs/symbols.md:94: >= 0."""
    symbol = SYMBOLS["pair_friction"]
    assert all(
        symbol.admits(value)
        for value in (
            0.0,
            5e-324,
        )
    )
    assert not any(symbol.admits(value) for value in (inf, -inf, nan, -5e-324))


def test_range_of_gravitational_constant() -> None:
    """srs/symbols.md:188: > 0."""
    symbol = SYMBOLS["gravitational_constant"]
    assert all(symbol.admits(value) for value in (5e-324,))
    assert not any(symbol.admits(value) for value in (inf, -inf, nan, 0.0, -5e-324))


def test_range_of_linear_drag() -> None:
    """srs/symbols.md:212: >= 0."""
    symbol = SYMBOLS["linear_drag"]
    assert all(
        symbol.admits(value)
        for value in (
            0.0,
            5e-324,
        )
    )
    assert not any(symbol.admits(value) for value in (inf, -inf, nan, -5e-324))


def test_range_of_quadratic_drag() -> None:
    """srs/symbols.md:218: >= 0."""
    symbol = SYMBOLS["quadratic_drag"]
    assert all(
        symbol.admits(value)
        for value in (
            0.0,
            5e-324,
        )
    )
    assert not any(symbol.admits(value) for value in (inf, -inf, nan, -5e-324))


def test_range_of_angular_drag() -> None:
    """srs/symbols.md:234: >= 0."""
    symbol = SYMBOLS["angular_drag"]
    assert all(
        symbol.admits(value)
        for value in (
            0.0,
            5e-324,
        )
    )
    assert not any(symbol.admits(value) for value in (inf, -inf, nan, -5e-324))


def test_range_of_angular_drag_rate() -> None:
    """srs/symbols.md:244: >= 0."""
    symbol = SYMBOLS["angular_drag_rate"]
    assert all(
        symbol.admits(value)
        for value in (
            0.0,
            5e-324,
        )
    )
    assert not any(symbol.admits(value) for value in (inf, -inf, nan, -5e-324))


def test_range_of_drag_rate() -> None:
    """srs/symbols.md:251: >= 0."""
    symbol = SYMBOLS["drag_rate"]
    assert all(
        symbol.admits(value)
        for value in (
            0.0,
            5e-324,
        )
    )
    assert not any(symbol.admits(value) for value in (inf, -inf, nan, -5e-324))


def test_range_of_speed() -> None:
    """srs/symbols.md:256: >= 0."""
    symbol = SYMBOLS["speed"]
    assert all(
        symbol.admits(value)
        for value in (
            0.0,
            5e-324,
        )
    )
    assert not any(symbol.admits(value) for value in (inf, -inf, nan, -5e-324))


def test_range_of_stiffness() -> None:
    """srs/symbols.md:261: > 0."""
    symbol = SYMBOLS["stiffness"]
    assert all(symbol.admits(value) for value in (5e-324,))
    assert not any(symbol.admits(value) for value in (inf, -inf, nan, 0.0, -5e-324))


def test_range_of_rest_length() -> None:
    """srs/symbols.md:267: >= 0."""
    symbol = SYMBOLS["rest_length"]
    assert all(
        symbol.admits(value)
        for value in (
            0.0,
            5e-324,
        )
    )
    assert not any(symbol.admits(value) for value in (inf, -inf, nan, -5e-324))


def test_range_of_damping() -> None:
    """srs/symbols.md:273: >= 0."""
    symbol = SYMBOLS["damping"]
    assert all(
        symbol.admits(value)
        for value in (
            0.0,
            5e-324,
        )
    )
    assert not any(symbol.admits(value) for value in (inf, -inf, nan, -5e-324))


def test_range_of_distance() -> None:
    """srs/symbols.md:289: >= 0."""
    symbol = SYMBOLS["distance"]
    assert all(
        symbol.admits(value)
        for value in (
            0.0,
            5e-324,
        )
    )
    assert not any(symbol.admits(value) for value in (inf, -inf, nan, -5e-324))


def test_range_of_spring_energy() -> None:
    """srs/symbols.md:316: >= 0."""
    symbol = SYMBOLS["spring_energy"]
    assert all(
        symbol.admits(value)
        for value in (
            0.0,
            5e-324,
        )
    )
    assert not any(symbol.admits(value) for value in (inf, -inf, nan, -5e-324))


def test_range_of_angular_frequency() -> None:
    """srs/symbols.md:321: > 0."""
    symbol = SYMBOLS["angular_frequency"]
    assert all(symbol.admits(value) for value in (5e-324,))
    assert not any(symbol.admits(value) for value in (inf, -inf, nan, 0.0, -5e-324))


def test_range_of_inverse_effective_mass() -> None:
    """srs/symbols.md:392: > 0."""
    symbol = SYMBOLS["inverse_effective_mass"]
    assert all(symbol.admits(value) for value in (5e-324,))
    assert not any(symbol.admits(value) for value in (inf, -inf, nan, 0.0, -5e-324))


def test_range_of_impulse() -> None:
    """srs/symbols.md:403: >= 0."""
    symbol = SYMBOLS["impulse"]
    assert all(
        symbol.admits(value)
        for value in (
            0.0,
            5e-324,
        )
    )
    assert not any(symbol.admits(value) for value in (inf, -inf, nan, -5e-324))


def test_range_of_inverse_tangential_mass() -> None:
    """srs/symbols.md:418: > 0."""
    symbol = SYMBOLS["inverse_tangential_mass"]
    assert all(symbol.admits(value) for value in (5e-324,))
    assert not any(symbol.admits(value) for value in (inf, -inf, nan, 0.0, -5e-324))


def test_range_of_inverse_sliding_mass() -> None:
    """srs/symbols.md:423: > 0."""
    symbol = SYMBOLS["inverse_sliding_mass"]
    assert all(symbol.admits(value) for value in (5e-324,))
    assert not any(symbol.admits(value) for value in (inf, -inf, nan, 0.0, -5e-324))


def test_range_of_normal_impulse() -> None:
    """srs/symbols.md:444: >= 0."""
    symbol = SYMBOLS["normal_impulse"]
    assert all(
        symbol.admits(value)
        for value in (
            0.0,
            5e-324,
        )
    )
    assert not any(symbol.admits(value) for value in (inf, -inf, nan, -5e-324))


def test_range_of_share() -> None:
    """srs/symbols.md:449: [0, 1]."""
    symbol = SYMBOLS["share"]
    assert all(
        symbol.admits(value)
        for value in (
            0.0,
            5e-324,
            1.0,
            0.9999999999999999,
        )
    )
    assert not any(symbol.admits(value) for value in (inf, -inf, nan, -5e-324, 1.0000000000000002))


def test_range_of_sense() -> None:
    """srs/symbols.md:456: [-1, 1]."""
    symbol = SYMBOLS["sense"]
    assert all(
        symbol.admits(value)
        for value in (
            -1.0,
            -0.9999999999999999,
            1.0,
            0.9999999999999999,
        )
    )
    assert not any(
        symbol.admits(value) for value in (inf, -inf, nan, -1.0000000000000002, 1.0000000000000002)
    )


def test_range_of_contact_force() -> None:
    """srs/symbols.md:468: >= 0."""
    symbol = SYMBOLS["contact_force"]
    assert all(
        symbol.admits(value)
        for value in (
            0.0,
            5e-324,
        )
    )
    assert not any(symbol.admits(value) for value in (inf, -inf, nan, -5e-324))


def test_range_of_row_mass() -> None:
    """srs/symbols.md:507: > 0."""
    symbol = SYMBOLS["row_mass"]
    assert all(symbol.admits(value) for value in (5e-324,))
    assert not any(symbol.admits(value) for value in (inf, -inf, nan, 0.0, -5e-324))


def test_range_of_push() -> None:
    """srs/symbols.md:516: >= 0."""
    symbol = SYMBOLS["push"]
    assert all(
        symbol.admits(value)
        for value in (
            0.0,
            5e-324,
        )
    )
    assert not any(symbol.admits(value) for value in (inf, -inf, nan, -5e-324))


def test_range_of_soft_push() -> None:
    """srs/symbols.md:521: >= 0."""
    symbol = SYMBOLS["soft_push"]
    assert all(
        symbol.admits(value)
        for value in (
            0.0,
            5e-324,
        )
    )
    assert not any(symbol.admits(value) for value in (inf, -inf, nan, -5e-324))


def test_range_of_bouncing_push() -> None:
    """srs/symbols.md:526: >= 0."""
    symbol = SYMBOLS["bouncing_push"]
    assert all(
        symbol.admits(value)
        for value in (
            0.0,
            5e-324,
        )
    )
    assert not any(symbol.admits(value) for value in (inf, -inf, nan, -5e-324))


def test_range_of_damping_ratio() -> None:
    """srs/symbols.md:539: >= 0."""
    symbol = SYMBOLS["damping_ratio"]
    assert all(
        symbol.admits(value)
        for value in (
            0.0,
            5e-324,
        )
    )
    assert not any(symbol.admits(value) for value in (inf, -inf, nan, -5e-324))


def test_range_of_bias_rate() -> None:
    """srs/symbols.md:544: > 0."""
    symbol = SYMBOLS["bias_rate"]
    assert all(symbol.admits(value) for value in (5e-324,))
    assert not any(symbol.admits(value) for value in (inf, -inf, nan, 0.0, -5e-324))


def test_range_of_mass_share() -> None:
    """srs/symbols.md:553: [0, 1]."""
    symbol = SYMBOLS["mass_share"]
    assert all(
        symbol.admits(value)
        for value in (
            0.0,
            5e-324,
            1.0,
            0.9999999999999999,
        )
    )
    assert not any(symbol.admits(value) for value in (inf, -inf, nan, -5e-324, 1.0000000000000002))


def test_range_of_impulse_share() -> None:
    """srs/symbols.md:558: [0, 1]."""
    symbol = SYMBOLS["impulse_share"]
    assert all(
        symbol.admits(value)
        for value in (
            0.0,
            5e-324,
            1.0,
            0.9999999999999999,
        )
    )
    assert not any(symbol.admits(value) for value in (inf, -inf, nan, -5e-324, 1.0000000000000002))


def test_range_of_overlap_share() -> None:
    """srs/symbols.md:563: > 0."""
    symbol = SYMBOLS["overlap_share"]
    assert all(symbol.admits(value) for value in (5e-324,))
    assert not any(symbol.admits(value) for value in (inf, -inf, nan, 0.0, -5e-324))


def test_range_of_removal_share() -> None:
    """srs/symbols.md:570: >= 0."""
    symbol = SYMBOLS["removal_share"]
    assert all(
        symbol.admits(value)
        for value in (
            0.0,
            5e-324,
        )
    )
    assert not any(symbol.admits(value) for value in (inf, -inf, nan, -5e-324))


def test_range_of_extent() -> None:
    """srs/symbols.md:577: > 0."""
    symbol = SYMBOLS["extent"]
    assert all(symbol.admits(value) for value in (5e-324,))
    assert not any(symbol.admits(value) for value in (inf, -inf, nan, 0.0, -5e-324))


def test_range_of_firmest() -> None:
    """srs/symbols.md:584: >= 1."""
    symbol = SYMBOLS["firmest"]
    assert all(
        symbol.admits(value)
        for value in (
            1.0,
            1.0000000000000002,
        )
    )
    assert not any(symbol.admits(value) for value in (inf, -inf, nan, 0.9999999999999999))


def test_range_of_preload() -> None:
    """srs/symbols.md:589: >= 0."""
    symbol = SYMBOLS["preload"]
    assert all(
        symbol.admits(value)
        for value in (
            0.0,
            5e-324,
        )
    )
    assert not any(symbol.admits(value) for value in (inf, -inf, nan, -5e-324))


def test_range_of_preload_later() -> None:
    """srs/symbols.md:594: >= 0."""
    symbol = SYMBOLS["preload_later"]
    assert all(
        symbol.admits(value)
        for value in (
            0.0,
            5e-324,
        )
    )
    assert not any(symbol.admits(value) for value in (inf, -inf, nan, -5e-324))


def test_range_of_preload_share() -> None:
    """srs/symbols.md:599: [0, 1]."""
    symbol = SYMBOLS["preload_share"]
    assert all(
        symbol.admits(value)
        for value in (
            0.0,
            5e-324,
            1.0,
            0.9999999999999999,
        )
    )
    assert not any(symbol.admits(value) for value in (inf, -inf, nan, -5e-324, 1.0000000000000002))


def test_range_of_overlap_allowed() -> None:
    """srs/symbols.md:604: >= 0."""
    symbol = SYMBOLS["overlap_allowed"]
    assert all(
        symbol.admits(value)
        for value in (
            0.0,
            5e-324,
        )
    )
    assert not any(symbol.admits(value) for value in (inf, -inf, nan, -5e-324))


def test_range_of_preload_largest() -> None:
    """srs/symbols.md:609: >= 0."""
    symbol = SYMBOLS["preload_largest"]
    assert all(
        symbol.admits(value)
        for value in (
            0.0,
            5e-324,
        )
    )
    assert not any(symbol.admits(value) for value in (inf, -inf, nan, -5e-324))


def test_range_of_flow_decay() -> None:
    """srs/symbols.md:634: [0, 1]."""
    symbol = SYMBOLS["flow_decay"]
    assert all(
        symbol.admits(value)
        for value in (
            0.0,
            5e-324,
            1.0,
            0.9999999999999999,
        )
    )
    assert not any(symbol.admits(value) for value in (inf, -inf, nan, -5e-324, 1.0000000000000002))


def test_range_of_flow_gain() -> None:
    """srs/symbols.md:639: >= 0."""
    symbol = SYMBOLS["flow_gain"]
    assert all(
        symbol.admits(value)
        for value in (
            0.0,
            5e-324,
        )
    )
    assert not any(symbol.admits(value) for value in (inf, -inf, nan, -5e-324))


def test_range_of_flow_lift() -> None:
    """srs/symbols.md:644: >= 0."""
    symbol = SYMBOLS["flow_lift"]
    assert all(
        symbol.admits(value)
        for value in (
            0.0,
            5e-324,
        )
    )
    assert not any(symbol.admits(value) for value in (inf, -inf, nan, -5e-324))


def test_range_of_firmness() -> None:
    """srs/symbols.md:658: > 0."""
    symbol = SYMBOLS["firmness"]
    assert all(symbol.admits(value) for value in (5e-324,))
    assert not any(symbol.admits(value) for value in (inf, -inf, nan, 0.0, -5e-324))


def test_range_of_push_share() -> None:
    """srs/symbols.md:665: [0, 1]."""
    symbol = SYMBOLS["push_share"]
    assert all(
        symbol.admits(value)
        for value in (
            0.0,
            5e-324,
            1.0,
            0.9999999999999999,
        )
    )
    assert not any(symbol.admits(value) for value in (inf, -inf, nan, -5e-324, 1.0000000000000002))


def test_range_of_fraction() -> None:
    """srs/symbols.md:710: [0, 1]."""
    symbol = SYMBOLS["fraction"]
    assert all(
        symbol.admits(value)
        for value in (
            0.0,
            5e-324,
            1.0,
            0.9999999999999999,
        )
    )
    assert not any(symbol.admits(value) for value in (inf, -inf, nan, -5e-324, 1.0000000000000002))


def test_range_of_motion_bound() -> None:
    """srs/symbols.md:715: >= 0."""
    symbol = SYMBOLS["motion_bound"]
    assert all(
        symbol.admits(value)
        for value in (
            0.0,
            5e-324,
        )
    )
    assert not any(symbol.admits(value) for value in (inf, -inf, nan, -5e-324))


def test_range_of_distance_bound() -> None:
    """srs/symbols.md:720: >= 0."""
    symbol = SYMBOLS["distance_bound"]
    assert all(
        symbol.admits(value)
        for value in (
            0.0,
            5e-324,
        )
    )
    assert not any(symbol.admits(value) for value in (inf, -inf, nan, -5e-324))


def test_range_of_half_interval() -> None:
    """srs/symbols.md:729: >= 0."""
    symbol = SYMBOLS["half_interval"]
    assert all(
        symbol.admits(value)
        for value in (
            0.0,
            5e-324,
        )
    )
    assert not any(symbol.admits(value) for value in (inf, -inf, nan, -5e-324))


def test_range_of_advance() -> None:
    """srs/symbols.md:734: >= 0."""
    symbol = SYMBOLS["advance"]
    assert all(
        symbol.admits(value)
        for value in (
            0.0,
            5e-324,
        )
    )
    assert not any(symbol.admits(value) for value in (inf, -inf, nan, -5e-324))


def test_range_of_circling() -> None:
    """srs/symbols.md:762: >= 0."""
    symbol = SYMBOLS["circling"]
    assert all(
        symbol.admits(value)
        for value in (
            0.0,
            5e-324,
        )
    )
    assert not any(symbol.admits(value) for value in (inf, -inf, nan, -5e-324))


def test_range_of_acceleration_size() -> None:
    """srs/symbols.md:773: >= 0."""
    symbol = SYMBOLS["acceleration_size"]
    assert all(
        symbol.admits(value)
        for value in (
            0.0,
            5e-324,
        )
    )
    assert not any(symbol.admits(value) for value in (inf, -inf, nan, -5e-324))


def test_range_of_deviation() -> None:
    """srs/symbols.md:778: >= 0."""
    symbol = SYMBOLS["deviation"]
    assert all(
        symbol.admits(value)
        for value in (
            0.0,
            5e-324,
        )
    )
    assert not any(symbol.admits(value) for value in (inf, -inf, nan, -5e-324))


def test_range_of_angular_speed() -> None:
    """srs/symbols.md:783: >= 0."""
    symbol = SYMBOLS["angular_speed"]
    assert all(
        symbol.admits(value)
        for value in (
            0.0,
            5e-324,
        )
    )
    assert not any(symbol.admits(value) for value in (inf, -inf, nan, -5e-324))


def test_range_of_arc_bend() -> None:
    """srs/symbols.md:792: >= 0."""
    symbol = SYMBOLS["arc_bend"]
    assert all(
        symbol.admits(value)
        for value in (
            0.0,
            5e-324,
        )
    )
    assert not any(symbol.admits(value) for value in (inf, -inf, nan, -5e-324))


def test_range_of_arc() -> None:
    """srs/symbols.md:807: >= 0."""
    symbol = SYMBOLS["arc"]
    assert all(
        symbol.admits(value)
        for value in (
            0.0,
            5e-324,
        )
    )
    assert not any(symbol.admits(value) for value in (inf, -inf, nan, -5e-324))


def test_range_of_inward_share() -> None:
    """srs/symbols.md:812: >= 0."""
    symbol = SYMBOLS["inward_share"]
    assert all(
        symbol.admits(value)
        for value in (
            0.0,
            5e-324,
        )
    )
    assert not any(symbol.admits(value) for value in (inf, -inf, nan, -5e-324))


def test_range_of_motion_square() -> None:
    """srs/symbols.md:830: >= 0."""
    symbol = SYMBOLS["motion_square"]
    assert all(
        symbol.admits(value)
        for value in (
            0.0,
            5e-324,
        )
    )
    assert not any(symbol.admits(value) for value in (inf, -inf, nan, -5e-324))


def test_range_of_way_square() -> None:
    """srs/symbols.md:835: >= 0."""
    symbol = SYMBOLS["way_square"]
    assert all(
        symbol.admits(value)
        for value in (
            0.0,
            5e-324,
        )
    )
    assert not any(symbol.admits(value) for value in (inf, -inf, nan, -5e-324))


def test_range_of_quiet_square() -> None:
    """srs/symbols.md:840: >= 0."""
    symbol = SYMBOLS["quiet_square"]
    assert all(
        symbol.admits(value)
        for value in (
            0.0,
            5e-324,
        )
    )
    assert not any(symbol.admits(value) for value in (inf, -inf, nan, -5e-324))


def test_range_of_quiet_share() -> None:
    """srs/symbols.md:845: [0, 1]."""
    symbol = SYMBOLS["quiet_share"]
    assert all(
        symbol.admits(value)
        for value in (
            0.0,
            5e-324,
            1.0,
            0.9999999999999999,
        )
    )
    assert not any(symbol.admits(value) for value in (inf, -inf, nan, -5e-324, 1.0000000000000002))


def test_range_of_gravity_size() -> None:
    """srs/symbols.md:850: >= 0."""
    symbol = SYMBOLS["gravity_size"]
    assert all(
        symbol.admits(value)
        for value in (
            0.0,
            5e-324,
        )
    )
    assert not any(symbol.admits(value) for value in (inf, -inf, nan, -5e-324))


def test_range_of_kinetic_energy() -> None:
    """srs/symbols.md:873: >= 0."""
    symbol = SYMBOLS["kinetic_energy"]
    assert all(
        symbol.admits(value)
        for value in (
            0.0,
            5e-324,
        )
    )
    assert not any(symbol.admits(value) for value in (inf, -inf, nan, -5e-324))


def test_range_of_linear_energy() -> None:
    """srs/symbols.md:886: >= 0."""
    symbol = SYMBOLS["linear_energy"]
    assert all(
        symbol.admits(value)
        for value in (
            0.0,
            5e-324,
        )
    )
    assert not any(symbol.admits(value) for value in (inf, -inf, nan, -5e-324))


def test_range_of_turning_energy() -> None:
    """srs/symbols.md:891: >= 0."""
    symbol = SYMBOLS["turning_energy"]
    assert all(
        symbol.admits(value)
        for value in (
            0.0,
            5e-324,
        )
    )
    assert not any(symbol.admits(value) for value in (inf, -inf, nan, -5e-324))


def test_range_of_bias_energy() -> None:
    """srs/symbols.md:896: >= 0."""
    symbol = SYMBOLS["bias_energy"]
    assert all(
        symbol.admits(value)
        for value in (
            0.0,
            5e-324,
        )
    )
    assert not any(symbol.admits(value) for value in (inf, -inf, nan, -5e-324))


def test_range_of_change_energy() -> None:
    """srs/symbols.md:905: >= 0."""
    symbol = SYMBOLS["change_energy"]
    assert all(
        symbol.admits(value)
        for value in (
            0.0,
            5e-324,
        )
    )
    assert not any(symbol.admits(value) for value in (inf, -inf, nan, -5e-324))


def test_range_of_energy_room() -> None:
    """srs/symbols.md:914: >= 0."""
    symbol = SYMBOLS["energy_room"]
    assert all(
        symbol.admits(value)
        for value in (
            0.0,
            5e-324,
        )
    )
    assert not any(symbol.admits(value) for value in (inf, -inf, nan, -5e-324))


def test_range_of_energy_root() -> None:
    """srs/symbols.md:924: >= 0."""
    symbol = SYMBOLS["energy_root"]
    assert all(
        symbol.admits(value)
        for value in (
            0.0,
            5e-324,
        )
    )
    assert not any(symbol.admits(value) for value in (inf, -inf, nan, -5e-324))


def test_range_of_kept_share() -> None:
    """srs/symbols.md:929: [0, 1]."""
    symbol = SYMBOLS["kept_share"]
    assert all(
        symbol.admits(value)
        for value in (
            0.0,
            5e-324,
            1.0,
            0.9999999999999999,
        )
    )
    assert not any(symbol.admits(value) for value in (inf, -inf, nan, -5e-324, 1.0000000000000002))


def test_range_of_calm_share() -> None:
    """srs/symbols.md:934: [0, 1]."""
    symbol = SYMBOLS["calm_share"]
    assert all(
        symbol.admits(value)
        for value in (
            0.0,
            5e-324,
            1.0,
            0.9999999999999999,
        )
    )
    assert not any(symbol.admits(value) for value in (inf, -inf, nan, -5e-324, 1.0000000000000002))


def test_range_of_radius() -> None:
    """srs/symbols.md:955: > 0."""
    symbol = SYMBOLS["radius"]
    assert all(symbol.admits(value) for value in (5e-324,))
    assert not any(symbol.admits(value) for value in (inf, -inf, nan, 0.0, -5e-324))


def test_range_of_length() -> None:
    """srs/symbols.md:960: > 0."""
    symbol = SYMBOLS["length"]
    assert all(symbol.admits(value) for value in (5e-324,))
    assert not any(symbol.admits(value) for value in (inf, -inf, nan, 0.0, -5e-324))


def test_range_of_width() -> None:
    """srs/symbols.md:967: > 0."""
    symbol = SYMBOLS["width"]
    assert all(symbol.admits(value) for value in (5e-324,))
    assert not any(symbol.admits(value) for value in (inf, -inf, nan, 0.0, -5e-324))


def test_range_of_height() -> None:
    """srs/symbols.md:972: > 0."""
    symbol = SYMBOLS["height"]
    assert all(symbol.admits(value) for value in (5e-324,))
    assert not any(symbol.admits(value) for value in (inf, -inf, nan, 0.0, -5e-324))


def test_range_of_area() -> None:
    """srs/symbols.md:991: > 0."""
    symbol = SYMBOLS["area"]
    assert all(symbol.admits(value) for value in (5e-324,))
    assert not any(symbol.admits(value) for value in (inf, -inf, nan, 0.0, -5e-324))
