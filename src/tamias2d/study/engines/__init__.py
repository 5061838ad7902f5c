"""Engines side by side on one scene: this library's, Pymunk's and Box2D's.

Serves: studies and measurements of contacts. Hides: how other engines are told a scene, and asked.
"""
