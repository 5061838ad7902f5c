"""What a peer cannot be told, refused by name.

Serves: the peers' worlds. Hides: what every engine but ours lacks.
"""

from types import ModuleType

from tamias2d.errors import SimulationError
from tamias2d.scene import Scene
from tamias2d.scene.acting import varying_loads
from tamias2d.scene.filters import filters


class PeerError(SimulationError):
    """A peer is not there, or cannot do the scene."""


def imported(name: str, package: str) -> ModuleType:
    """Return the module of a peer; raise `PeerError` if it is not installed."""
    from importlib import import_module

    try:
        return import_module(package)
    except ImportError as fault:
        raise PeerError(
            f"{name}: is not installed ({fault}). `pip install {package}` brings it, or leave it "
            "out."
        ) from fault


def refuse_untranslated(scene: Scene, name: str) -> None:
    """Raise `PeerError` if a scene has what a peer is not told of."""
    if scene.joints:
        what = f"joint '{scene.joints[0].name}': its joints are not translated"
    elif varying := varying_loads(scene):
        body, why = next(iter(varying.items()))
        what = f"body '{scene.bodies[body].name}': it is {why}, which is not translated"
    elif pushed := [b for b in scene.bodies if b.dynamic and any((*b.force, b.torque))]:
        what = f"body '{pushed[0].name}': forces are not translated"
    elif odd := [body for body in scene.bodies if body.sensor or filters(body)]:
        what = f"body '{odd[0].name}': sensors and filters are not translated"
    elif belts := [body for body in scene.bodies if body.surface_speed]:
        what = f"body '{belts[0].name}': surfaces that run are not translated"
    else:
        return
    raise PeerError(f"{name}: {what}. Leave {name} out.")
