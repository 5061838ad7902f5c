"""What compiled code is known by: see `tamias2d.kernels.digest`."""

from tamias2d.engine.menu import CONTACT
from tamias2d.kernels.digest import digest_of

SOURCE = '''"""A source."""

LIMIT = 2.0


@njit
def pushed(x, force):
    """Return a place.

    Source: nobody.
    """
    # why
    return x + force / LIMIT  # how
'''


def test_words_do_not_count() -> None:
    """A docstring or comment in other words leaves the compiled code as it is."""
    for old, new in (
        ("Return a place.", "Return where it is."),
        ("    Source: nobody.\n", ""),
        ('"""A source."""', '"""A source\nof two lines.\n"""'),
        ("    # why\n", ""),
        ("  # how", "  # why, then"),
    ):
        assert digest_of(SOURCE.replace(old, new)) == digest_of(SOURCE)


def test_statements_count() -> None:
    """Whatever a source does differently is compiled anew."""
    for old, new in (("2.0", "3.0"), ("x +", "x -"), ("@njit\n", ""), ("pushed", "pulled")):
        assert digest_of(SOURCE.replace(old, new)) != digest_of(SOURCE)


def test_intrinsics_of_the_engine_count() -> None:
    """What the engine's source imports is known by its digest."""
    source = CONTACT.source()
    line = next(line for line in source.splitlines() if line.startswith("LANE_CODE = "))
    assert digest_of(source.replace(line, "LANE_CODE = 'another'")) != digest_of(source)
