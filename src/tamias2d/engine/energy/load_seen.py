"""The load on a body as seen from a support that moves: its own, and drag by that motion (DD109).

Cost: a visit to the propagator of each body that drag slows.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.energy.step_energy import mass_and_inertia
from tamias2d.engine.tables import Bodies
from tamias2d.generated.island_energy import drag_rate, force_seen, torque_seen
from tamias2d.state import Vector


def load_seen(i: int, velocity: Vector, spin: float, bodies: Bodies) -> tuple[Vector, float]:
    """Return force, N, and torque, N m, on a body as seen from a support: drag of the rest takes.

    The support has a velocity at the body, m/s, and a spin, rad/s.
    """
    load, state = bodies.load[i], bodies.substep_state[i]
    force, torque = (load[0], load[1]), load[2]
    if state[tb.DRAG_FACTOR] == 1.0 and state[tb.DRAG_FACTOR + 2] == 1.0:
        return force, torque
    through = bodies.propagators[int(bodies.properties[i, tb.PROPAGATOR])]
    mass, inertia = mass_and_inertia(i, bodies.properties)
    at = tb.ONE_SUBSTEP
    rate = drag_rate(through[at + tb.DECAY], through[at + tb.GAIN])
    at += tb.ANGULAR
    turning = drag_rate(through[at + tb.DECAY], through[at + tb.GAIN])
    return force_seen(force, mass, rate, velocity), torque_seen(torque, inertia, turning, spin)
