"""Equations in which the direction of something stands, as `atan2` tells it: within half a turn.

Serves: constraints, whose values have to be near zero wherever a motion keeps them. Hides: how the
jump by a whole turn is left out, which `atan2` makes where the motion turns on evenly.
"""

from fractions import Fraction

from tamias2d.spec.check import infer
from tamias2d.spec.derivative import differentiate
from tamias2d.spec.evaluate import evaluate
from tamias2d.spec.expression import Binary, Call, Measure, Name, Node, names, rebuilt
from tamias2d.spec.symbols import SymbolTable
from tamias2d.spec.units import ONE, Dimension, Unit

_ROUNDING = 1e-12  # of how often one jump is in another


def without_turns(node: Node, table: SymbolTable) -> Node:
    """An equation, less the whole turns in it, so that it is the nearest to zero that it can be.

    It is as it was where it has no direction, and where its jumps are not all multiples of one, as
    it is not linear in a direction.
    """
    directions: dict[Node, str] = {}
    bare = rebuilt(node, lambda part: _named(part, directions))
    try:
        factors = [differentiate(bare, name) for name in directions.values()]
        jumps = [abs(float(evaluate(factor, {}))) for factor in factors if not names(factor)]
    except (ArithmeticError, ValueError):
        return node
    least = min(filter(None, jumps), default=0.0)
    if not least or len(jumps) < len(factors) or any(map(_is_odd, (j / least for j in jumps))):
        return node
    return _nearest(node, least, infer(node, table).dimension or ONE)


def _named(part: Node, directions: dict[Node, str]) -> Node | None:
    """Return a name for a direction, the same for the same one; None for all else."""
    if not (isinstance(part, Call) and part.function == "atan2"):
        return None
    return Name(directions.setdefault(part, f"direction {len(directions)}"))


def _is_odd(times: float) -> bool:
    return abs(times - round(times)) > _ROUNDING * times


def _nearest(node: Node, radian: float, dimension: Dimension) -> Node:
    """Return an equation less whole turns, given by how much it changes with each rad."""
    scale = Measure(Fraction(radian), Unit(str(dimension), dimension))
    angle = Binary("/", node, scale)
    return Binary("*", scale, Call("atan2", (Call("sin", (angle,)), Call("cos", (angle,)))))
