"""What wakes islands, and what bodies touch that may."""

from tamias2d.engine import tables as tb
from tamias2d.engine.tables import Integers

NO_SUPPORT, SUPPORTED_AT_REST, SUPPORTED_IN_MOTION = range(3)  # what a body touches


def wake_pair(i: int, j: int, links: Integers) -> bool:
    """Wake the one of two bodies that may not wake others, if the other may and it sleeps."""
    if links[i, tb.AWAKE] == links[j, tb.AWAKE]:
        return False
    sleep_id = max(links[i, tb.SLEEP_ID], links[j, tb.SLEEP_ID])
    wake_island(sleep_id, links)
    return bool(sleep_id > 0)


def wake_island(sleep_id: int, links: Integers) -> None:
    """Wake all bodies that sleep under an id; 0 is that of bodies awake."""
    if sleep_id == 0:
        return
    for i in range(len(links)):
        if links[i, tb.SLEEP_ID] == sleep_id:
            links[i, tb.SLEEP_ID], links[i, tb.SLOW_STEPS], links[i, tb.AWAKE] = 0, 0, 1
