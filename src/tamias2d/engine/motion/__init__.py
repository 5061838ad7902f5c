"""Bodies that touch nothing: closed forms, and rotation."""
