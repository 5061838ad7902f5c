"""`python -m tamias2d` is the `tamias2d` command.

Serves: the command where no script is installed. Hides: nothing; it calls `tamias2d.cli`.
"""

from tamias2d.cli import main

main()
