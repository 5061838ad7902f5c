"""The direct solver: tree-like islands, whose contacts are all solved at once."""
