"""`python -m tamias2d` is the `tamias2d` command."""

from tamias2d.cli import main

main()
