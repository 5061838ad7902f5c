"""Shapes: which rows hold them, and how rows and shapes are made of each other."""
