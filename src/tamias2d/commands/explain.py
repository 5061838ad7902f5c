"""`tamias2d explain`: the physics that a scene needs, and why the rest is left out.

Serves: the command `explain`. Hides: how the reasons are laid out.
"""

from dataclasses import asdict

from tamias2d.commands.names import find_method, find_scene
from tamias2d.commands.output import print_json, print_table, say
from tamias2d.errors import InputError
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


def explain_source(name: str, method: str) -> None:
    """Print the kernel that a scene needs for a stepped method.

    Raises InputError where none can be made for it.
    """
    from tamias2d.kernels import demand_of, source

    demand = demand_of(find_scene(name), find_method(method))
    if demand is None:
        raise InputError(
            f"{name} by {method}: no code is made for it (R5): kernels are made for methods with a "
            "fixed step, and for bodies that do not act on each other. `run` takes the general "
            "way. Choose another scene or --method."
        )
    say(source(demand).rstrip())
