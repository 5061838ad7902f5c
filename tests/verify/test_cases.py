"""Each case of the specification passes."""

import re

import pytest

from tamias2d.verify import FAIL, PASS, verify
from tamias2d.verify.items import items

CASES = [
    pytest.param(id, id=f"{id}-{re.sub(r'[^a-z0-9]+', '-', item['title'].lower()).strip('-')}")
    for id, item in items().items()
    if item["kind"] == "case"
]


@pytest.mark.parametrize("case", CASES)
def test_a_case_passes(case: str) -> None:
    outcomes = verify([case])
    assert outcomes, f"{case} compares nothing"
    failed = [str(outcome) for outcome in outcomes if outcome.verdict == FAIL]
    assert not failed, "\n".join(failed)
    if all(outcome.verdict != PASS for outcome in outcomes):
        pytest.skip(f"{case} is judged by people: {outcomes[0].verdict}")
