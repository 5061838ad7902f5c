"""Joints in the substeps: mechanisms, each solved as a whole (IM15)."""
