"""`tamias2d explain`: the physics that a scene needs, and why the rest is left out."""

from collections.abc import Sequence
from dataclasses import asdict, replace

from tamias2d.commands.names import find_method, find_scene, span_of
from tamias2d.commands.output import print_json, print_table, say
from tamias2d.contact import steps_because
from tamias2d.errors import InputError
from tamias2d.scene import Scene, needs
from tamias2d.scene.needs import Need

_STEPS = "steps through contacts (IM10)"


def explain_scene(name: str, *, duration: str | None, as_json: bool) -> None:
    """Print every state, term, model and method with the reason for it or against it."""
    scene = find_scene(name)
    entries = _entries(scene, span_of(scene, name, duration))
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


def _entries(scene: Scene, duration: float) -> Sequence[Need]:
    """What the scene needs within a duration, s; contacts are located or stepped."""
    found = needs(scene, duration)
    reason = steps_because(scene, duration)
    if reason is None:
        why = "taken only where impacts turn out not to be located" if found.pairs else "none meet"
        return [*found.entries, Need(_STEPS, "method", False, why)]
    located = [
        replace(entry, needed=False, reason=f"contacts are stepped: {reason}")
        if entry.what == "location of impacts"
        else entry
        for entry in found.entries
    ]
    steps = [Need(_STEPS, "method", True, reason)]
    if scene.joints:
        held = f"the scene has {len(scene.joints)}"
        steps.append(Need("joints in a substep (IM15)", "model", True, held))
    return [*located, *steps]


def explain_source(name: str, method: str) -> None:
    """Print the kernel that a scene needs for a method of steps.

    Raises InputError where none can be made for it.
    """
    from tamias2d.kernels import demand_of, march_source, source

    scene, chosen = find_scene(name), find_method(method)
    demand = demand_of(scene, chosen)
    text = march_source(scene, chosen) if demand is None else source(demand)
    if text is None:
        raise InputError(
            f"{name} by {method}: no code is made for it (R5): kernels are made for schemes of "
            "slopes, and of kicks and drifts. `run` takes general code. Choose another scene or "
            "--method."
        )
    say(text.rstrip())
