"""Springs wake what sleeps, where they pull it otherwise than as it fell asleep (DD50).

Cost: a visit to each body that a spring holds, where sleeping is wanted.
"""

from tamias2d.engine import tables as tb
from tamias2d.engine.sleep import NOT_NOTED, count_sleeping, extent_of_body, usual_acceleration
from tamias2d.engine.tables import World
from tamias2d.engine.waking import wake_island
from tamias2d.generated.definitions import acceleration, angular_acceleration
from tamias2d.state import Array

SAME_PULL = 2.0**-10  # of gravity: by what pulls may change the acceleration of a body that sleeps


def wake_pulled(world: World) -> None:
    """Wake islands of which springs pull a body otherwise; of what fell asleep, note the pulls."""
    bodies, springs, islands = world.bodies, world.springs, world.islands
    woken = False
    for k in range(len(springs.members)):
        i, row = springs.slot[k], springs.members[k]
        rest, sleep_id = islands.rest[i], islands.links[i, tb.SLEEP_ID]
        if sleep_id > 0 and rest[tb.REST_PULL] == NOT_NOTED:
            for n in range(3):
                rest[tb.REST_PULL + n] = row[tb.PULL + n]
        elif sleep_id > 0 and pull_changed(world.control.settings, row, rest, bodies.properties[i]):
            wake_island(sleep_id, islands.links)
            woken = True
    if woken:
        count_sleeping(bodies, islands)


def pull_changed(settings: Array, row: Array, rest: Array, properties: Array) -> bool:
    """Return whether springs accelerate a body otherwise than as it fell asleep."""
    pull, before, reach = row[tb.PULL :], rest[tb.REST_PULL :], extent_of_body(properties)
    x, y = acceleration(
        (0.0, 0.0), (pull[0] - before[0], pull[1] - before[1]), properties[tb.INVERSE_MASS]
    )
    spin = angular_acceleration(pull[2] - before[2], properties[tb.INVERSE_INERTIA])
    return bool(
        abs(x) + abs(y) + abs(spin) * reach > SAME_PULL * usual_acceleration(settings, reach)
    )
