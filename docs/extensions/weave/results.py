"""The last results of the verification cases, if there are any on this machine.

Serves: the pages of cases. Hides: how an old result is told from a valid one.
"""

from dataclasses import replace

from tamias2d.spec.specification import Specification
from tamias2d.verify import results
from tamias2d.verify.outcome import Outcome


def last_results(spec: Specification) -> dict[str, list[Outcome]]:
    """Results by case; those of an older form of the specification are marked stale."""
    known = {id: found for id, found in results.read().items() if id in spec.items}
    return {
        id: [_judged(outcome, spec.hash(spec.items[id])) for outcome in found]
        for id, found in known.items()
    }


def _judged(outcome: Outcome, now: str) -> Outcome:
    return outcome if outcome.hash == now else replace(outcome, verdict="stale")
