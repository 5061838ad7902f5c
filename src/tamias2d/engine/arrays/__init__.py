"""The arrays of a world: allocated, named, and enlarged when bodies are added."""
