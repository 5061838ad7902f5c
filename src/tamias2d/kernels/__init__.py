"""Compiled code: for exactly what a scene and a method need, and for whole engines.

Serves: stepped histories of scenes in which nothing meets, and the stepped way through contacts,
at the speed of compiled code and with the bits of the plain one. Hides: how the source is made,
cached and compiled.
"""

from tamias2d.kernels.compiled import compiled, plain
from tamias2d.kernels.demand import Demand, demand_of
from tamias2d.kernels.engine import Engine
from tamias2d.kernels.flight import flight, flown
from tamias2d.kernels.source import source

__all__ = ["Demand", "Engine", "compiled", "demand_of", "flight", "flown", "plain", "source"]
