"""What each command of `tamias2d` does, one file a command.

Serves: `tamias2d.cli`. Hides: which parts of the library answer a command.
"""
