"""The stepped way through contacts: soft steps with substeps, for piles and stacks."""
