"""Measurements: `python -m tools.measure NAME [--json]`; each is a module of tools/measurements.

A measurement has `measure()`, which returns what JSON can hold, and `table(found)`, which makes
heads and rows of it. What they say depends on the machine; no test asks for it.
"""

import argparse
from importlib import import_module
from pathlib import Path

from tamias2d.commands.output import print_json, print_table

_FOLDER = Path(__file__).parent / "measurements"


def main() -> None:
    """Measure what the command line names, and print it."""
    names = sorted(
        path.stem for path in _FOLDER.glob("[a-z]*.py") if "\ndef measure(" in path.read_text()
    )
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else None)
    parser.add_argument("name", choices=names)
    parser.add_argument("--json", action="store_true", help="print JSON and nothing else")
    asked = parser.parse_args()
    module = import_module(f"tools.measurements.{asked.name}")
    found = module.measure()
    if asked.json:
        print_json(found)
    else:
        print_table(*module.table(found))


if __name__ == "__main__":
    main()
