"""`python -m tamias2d` runs the `tamias2d` command, where no script is installed."""

from tamias2d.cli import main

main()
