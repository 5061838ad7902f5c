"""What each command of `tamias2d` does, one file a command."""
