"""Compiled code: for exactly what a scene and a method need, and libraries of it.

Serves: smooth motion under all forces and joints, by all generated schemes, and the engine, at the
speed of compiled code and with the bits of the plain one. Hides: how the source is made, cached and
compiled, and when that pays.
"""

from tamias2d.kernels.compiled import compiled, plain
from tamias2d.kernels.demand import Demand, demand_of
from tamias2d.kernels.flight import flight, flown
from tamias2d.kernels.jointing import joint_code
from tamias2d.kernels.library import Library
from tamias2d.kernels.marching import march_by_kernels, march_source
from tamias2d.kernels.source import source

__all__ = [
    "Demand",
    "Library",
    "compiled",
    "demand_of",
    "flight",
    "flown",
    "joint_code",
    "march_by_kernels",
    "march_source",
    "plain",
    "source",
]
