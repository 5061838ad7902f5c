"""Mechanisms in the frame loop: their scenes, and how each program steps them.

Serves: the measurement of joints in the loop. Hides: how other engines are told joints.
"""
