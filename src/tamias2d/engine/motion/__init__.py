"""Motion of bodies without contacts, by closed forms, and rotation.

Serves: a step, and whole calls in which no body is near another. Hides: that these go in chunks.
"""
