"""Bodies that move far in a step meet what is in their way."""
