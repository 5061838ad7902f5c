"""How materials mix: overrides of a pair are found in either order, and for no other pair."""

import numpy as np
from hypothesis import given, strategies as st

from tamias2d.engine.narrow_phase.material import mixed_material
from tamias2d.engine.tables import FRICTION, RESTITUTION

NUMBER = 9
PAIRS = st.tuples(st.integers(0, NUMBER - 1), st.integers(0, NUMBER - 1)).map(
    lambda pair: (min(pair), max(pair))
)
UNSET = -1.0
VALUES = st.tuples(st.sampled_from([UNSET, 0.0, 0.7]), st.sampled_from([UNSET, 0.0, 0.3]))


@given(st.dictionaries(PAIRS, VALUES))
def test_overrides_of_a_pair_are_found(
    known: dict[tuple[int, int], tuple[float, float]],
) -> None:
    """Elsewhere friction is the root of the product, and restitution as the scene's rules say."""
    material = np.zeros((NUMBER, 4))
    material[:, FRICTION], material[:, RESTITUTION] = np.linspace(0.1, 0.9, NUMBER), 0.5
    rows = [(*pair, *known[pair]) for pair in sorted(known)]
    overrides = np.array(rows, dtype=np.float64).reshape(-1, 4)
    bare = np.zeros((0, 4))
    for s in range(NUMBER):
        for t in range(NUMBER):
            usual = mixed_material(s, t, material, bare)
            np.testing.assert_allclose(
                usual[0] ** 2, material[s, FRICTION] * material[t, FRICTION], rtol=1e-14
            )
            own = known.get((min(s, t), max(s, t)), (UNSET, UNSET))
            wanted = tuple(a if a != UNSET else b for a, b in zip(own, usual, strict=True))
            assert mixed_material(s, t, material, overrides) == wanted
