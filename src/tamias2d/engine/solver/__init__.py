"""The contact solver: soft constraints in blocks of lanes, substep by substep, with less energy."""
