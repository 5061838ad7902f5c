"""How surfaces mix: what was set for a pair is found whichever way round, and for no other."""

import numpy as np
from hypothesis import given, strategies as st

from tamias2d.stepped.surfaces import surfaces_of

NUMBER = 9
PAIRS = st.tuples(st.integers(0, NUMBER - 1), st.integers(0, NUMBER - 1)).map(
    lambda pair: (min(pair), max(pair))
)
UNSET = -1.0
VALUES = st.tuples(st.sampled_from([UNSET, 0.0, 0.7]), st.sampled_from([UNSET, 0.0, 0.3]))


@given(st.dictionaries(PAIRS, VALUES))
def test_what_was_set_for_a_pair_is_found(
    known: dict[tuple[int, int], tuple[float, float]],
) -> None:
    """Elsewhere friction is the root of the product, and restitution as the scene's rules say."""
    surface = np.zeros((NUMBER, 4))
    surface[:, 0], surface[:, 1] = np.linspace(0.1, 0.9, NUMBER), 0.5
    rows = [(*pair, *known[pair]) for pair in sorted(known)]
    mixed = np.array(rows, dtype=np.float64).reshape(-1, 4)
    bare = np.zeros((0, 4))
    for s in range(NUMBER):
        for t in range(NUMBER):
            usual = surfaces_of(s, t, surface, bare)
            np.testing.assert_allclose(usual[0] ** 2, surface[s, 0] * surface[t, 0], rtol=1e-14)
            own = known.get((min(s, t), max(s, t)), (UNSET, UNSET))
            wanted = tuple(a if a != UNSET else b for a, b in zip(own, usual, strict=True))
            assert surfaces_of(s, t, surface, mixed) == wanted
