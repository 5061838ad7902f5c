"""Scenes: bodies, shapes, what acts on them, restitution; in Python and in YAML (R1 to R4).

Serves: users, and every part that computes. Hides: which file holds which concept.
"""

from tamias2d.scene import catalogue
from tamias2d.scene.bodies import Body
from tamias2d.scene.chain import Chain
from tamias2d.scene.chains_in_pieces import in_pieces, owners
from tamias2d.scene.compound import Compound, Part, Shape, pieces_of
from tamias2d.scene.fields import ForceField
from tamias2d.scene.freedoms import Freedom, JointSpring, Limits, Motor
from tamias2d.scene.joint_kinds import (
    Distance,
    Equation,
    Gear,
    Groove,
    Prismatic,
    Pulley,
    Ratchet,
    Revolute,
    Rotary,
    Target,
    Weld,
    Wheel,
)
from tamias2d.scene.joints import Joint
from tamias2d.scene.needs import Need, Needs, needs
from tamias2d.scene.reading import load
from tamias2d.scene.scene import Scene
from tamias2d.scene.shapes import Box, Capsule, Disc, HalfPlane, Polygon, Segment
from tamias2d.scene.springs import Spring
from tamias2d.scene.writing import scene_text

__all__ = [
    "Body",
    "Box",
    "Capsule",
    "Chain",
    "Compound",
    "Disc",
    "Distance",
    "Equation",
    "ForceField",
    "Freedom",
    "Gear",
    "Groove",
    "HalfPlane",
    "Joint",
    "JointSpring",
    "Limits",
    "Motor",
    "Need",
    "Needs",
    "Part",
    "Polygon",
    "Prismatic",
    "Pulley",
    "Ratchet",
    "Revolute",
    "Rotary",
    "Scene",
    "Segment",
    "Shape",
    "Spring",
    "Target",
    "Weld",
    "Wheel",
    "catalogue",
    "in_pieces",
    "load",
    "needs",
    "owners",
    "pieces_of",
    "scene_text",
]
