"""`tamias2d verify`: a row per comparison, and whether all of them hold."""

from collections.abc import Sequence

from tamias2d.commands.output import error_text, followed, print_json, print_table, say
from tamias2d.verify import FAIL, NOT_RUN, Outcome, verify


def verify_cases(ids: Sequence[str], *, as_json: bool) -> int:
    """Verify the cases with these ids, or all; return the exit code, 1 if one failed."""
    outcomes = verify(ids or None, follow=lambda cases: followed(cases, lambda case: case.id))
    failed = [outcome for outcome in outcomes if outcome.verdict == FAIL]
    if as_json:
        print_json({"cases": [outcome.as_json() for outcome in outcomes]})
        return bool(failed)
    print_table(
        ("case", "quantity", "error", "tolerance", "verdict", ""),
        (
            (
                outcome.id,
                outcome.quantity,
                error_text(outcome.error),
                error_text(outcome.tolerance),
                outcome.verdict,
                outcome.note,
            )
            for outcome in outcomes
        ),
    )
    unrun = [outcome for outcome in outcomes if outcome.verdict == NOT_RUN]
    say(f"\n{len(outcomes)} comparisons, {len(failed)} failed" + _not_run(unrun))
    return bool(failed)


def _not_run(unrun: Sequence[Outcome]) -> str:
    needs = " and ".join(dict.fromkeys(outcome.note for outcome in unrun))
    return f", {len(unrun)} not run: {needs}" if unrun else ""
