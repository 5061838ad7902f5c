"""No time decides a test: what hypothesis finds is right or wrong, however slow the machine."""

from hypothesis import settings

settings.register_profile("tamias2d", deadline=None)
settings.load_profile("tamias2d")
