"""`tamias2d scenes`: what the catalogue holds."""

from tamias2d.commands.output import figure, print_json, print_table
from tamias2d.scene import catalogue


def list_scenes(*, as_json: bool) -> None:
    """Print name, suggested duration, number of bodies and description of every scene."""
    scenes = {name: catalogue.load(name) for name in catalogue.names()}
    if as_json:
        rows = [
            {
                "name": name,
                "says": scene.says,
                "bodies": len(scene.bodies),
                "duration": scene.duration,
            }
            for name, scene in scenes.items()
        ]
        print_json({"scenes": rows})
        return
    print_table(
        ("scene", "s", "bodies", ""),
        (
            (
                name,
                "-" if scene.duration is None else figure(scene.duration),
                str(len(scene.bodies)),
                scene.says,
            )
            for name, scene in scenes.items()
        ),
    )
