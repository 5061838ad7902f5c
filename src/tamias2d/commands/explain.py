"""`tamias2d explain`: the physics that a scene needs, and why the rest is left out.

Serves: the command `explain`. Hides: how the reasons are laid out.
"""

from dataclasses import asdict

from tamias2d.commands.names import find_scene
from tamias2d.commands.output import print_json, print_table
from tamias2d.scene import needs


def explain_scene(name: str, *, as_json: bool) -> None:
    """Print every state, term, model and method with the reason for it or against it."""
    entries = needs(find_scene(name)).entries
    if as_json:
        print_json({"scene": name, "entries": [asdict(entry) for entry in entries]})
        return
    print_table(
        ("", "kind", "what", "because"),
        (
            ("needed" if entry.needed else "left out", entry.kind, entry.what, entry.reason)
            for entry in entries
        ),
    )
