"""Where two shapes touch: a normal, and up to two points with their gaps."""
