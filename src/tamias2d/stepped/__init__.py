"""The stepped way through contacts: soft steps with substeps, for piles and stacks.

Serves: the simulator, by `world`. Hides: arrays, blocks of lanes, and the order in which contacts
are found and solved.
"""
