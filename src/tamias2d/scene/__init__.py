"""Scenes: bodies, shapes, what acts on them, restitution; in Python and in YAML (R1 to R4).

Serves: users, and every part that computes. Hides: which file holds which concept.
"""

from tamias2d.scene import catalogue
from tamias2d.scene.bodies import Body
from tamias2d.scene.fields import ForceField
from tamias2d.scene.needs import Need, Needs, needs
from tamias2d.scene.reading import load
from tamias2d.scene.scene import Scene
from tamias2d.scene.shapes import Box, Disc, HalfPlane, Polygon, Shape
from tamias2d.scene.springs import Spring
from tamias2d.scene.writing import scene_text

__all__ = [
    "Body",
    "Box",
    "Disc",
    "ForceField",
    "HalfPlane",
    "Need",
    "Needs",
    "Polygon",
    "Scene",
    "Shape",
    "Spring",
    "catalogue",
    "load",
    "needs",
    "scene_text",
]
