"""Bodies that come, go and change: their rows, their order, and their contacts."""
