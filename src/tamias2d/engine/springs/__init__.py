"""Springs between bodies: networks held through a step, or solved in the substeps of contacts."""
