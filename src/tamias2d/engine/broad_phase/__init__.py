"""Which shapes may touch soon: boxes with margins, a tree over them, and the list of contacts."""
