"""Instants that were decided by rule (A18), and how long a run goes on after them."""

from collections.abc import Sequence

from tamias2d.contact.core import Core
from tamias2d.contact.coupled_constraint import CoupledConstraint
from tamias2d.contact.instant import Instant
from tamias2d.contact.refusal import LastingContactError, named

MOST_RULED = 500
"""Instants at which contacts last, after a rule decided something, of a run whose method was not
asked for: they take some seconds, and steps through contacts far less."""


class RuledInstants:
    """The instants of a run at which a rule decided what rigid bodies leave open."""

    def __init__(self, cores: Sequence[Core], most: float) -> None:
        """Contacts may last at so many more instants, once a rule decided something."""
        self._cores = cores
        self._most, self._lasting_since = most, 0
        self._ruled: list[tuple[float, frozenset[int]]] = []

    def update(self, instant: Instant) -> None:
        """Note an instant; refuse to go on through more of them than are worth it."""
        if instant.ruled:
            self._ruled.append((instant.time, frozenset(instant.ruled)))
        coupled = any(isinstance(each, CoupledConstraint) for each in instant.constraints.values())
        lasts = any(touch.staying for touch in instant.touching_pairs.values())
        if self._ruled or self._lasting_since or coupled:
            self._lasting_since += lasts
        if self._lasting_since > self._most:
            names = named(*(self._cores[i].name for i in sorted(instant.changed)))
            raise LastingContactError(
                f"{names} at {instant.time!r} s: contacts have changed {self._most} times "
                "since a rule decided them (A18). End the run before, take method=ClosedForm(), "
                "which goes on, or method=Stepped(), which is quick.",
                time=instant.time,
            )

    @property
    def note(self) -> str | None:
        """What was decided by rule, if anything."""
        if not self._ruled:
            return None
        (first, bodies), (last, _) = self._ruled[0], self._ruled[-1]
        names = named(*(self._cores[i].name for i in sorted(bodies)))
        when = f"at {first!r} s, {names}" if first == last else f"at {first!r} s first, {names}"
        until = "" if first == last else f", and at {last!r} s last"
        return (
            f"rule: {len(self._ruled)} instants at which impacts acted on one another were "
            f"decided by A18: {when}{until}"
        )
