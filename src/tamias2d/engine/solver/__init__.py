"""The contact solver: soft constraints in blocks of lanes, solved in substeps."""
