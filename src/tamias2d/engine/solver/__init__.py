"""What contacts do to velocities: soft constraints in blocks of lanes, substep by substep."""
