"""What a ray meets first, and what lies at a point or in a box."""
