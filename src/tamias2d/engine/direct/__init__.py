"""Tree-like islands, whose contacts are solved at once instead of one after the other."""
