"""The broad phase: fat bounds of bodies, a tree over shapes, and the list of contacts."""
