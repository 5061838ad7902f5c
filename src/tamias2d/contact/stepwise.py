"""Bodies whose impacts cannot be located."""

from tamias2d.contact.refusal import StepwiseError
from tamias2d.scene import Body, Chain, Compound, Scene


def refuse_stepwise(scene: Scene) -> None:
    """Raise `StepwiseError` if the impacts of a body cannot be located (R8)."""
    for body in scene.bodies:
        if what := beyond_location(body):
            raise StepwiseError(
                f"body '{body.name}': {what}: impacts are located only between bodies of one "
                "piece that stand still or move freely (R8). "
                "Step it: method=Stepped(), or none; or Simulator(scene).step()."
            )


def beyond_location(body: Body) -> str | None:
    """Return why the impacts of a body cannot be located, or None."""
    if body.kinematic:
        return "it is kinematic"
    if body.sensor:
        return "it is a sensor"
    if body.surface_speed != 0.0:
        return "its surface runs"
    if isinstance(body.shape, Compound):
        return "it has several parts"
    if isinstance(body.shape, Chain):
        return "it is a chain that is not in pieces"
    return None
