"""Engines side by side on one scene.

Serves: the measurement of contacts. Hides: how other engines are told a scene, and asked.
"""
