"""Continuous collision: bodies that go far in a step meet other bodies in order of time.

Serves: a step, after its contacts are solved. Hides: how times of impact are found, and what
happens after too many impacts.
"""
