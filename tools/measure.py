"""Measurements: `python -m tools.measure NAME [--json]`; each is a module of tools/measurements.

A measurement has `measure()`, which returns what JSON can hold, and the `COLUMNS` of a table of
its rows, or `table(found)`, which makes heads and rows of it. It may have `options(parser)`, which
`measure` then takes by name, and `notes(found)`, lines below the table. What they say depends on
the machine; no test asks for it.
"""

import argparse
import sys
from importlib import import_module
from pathlib import Path
from types import ModuleType
from typing import Any

from tamias2d.commands.output import print_json, print_table, say
from tools.measurements.columns import Table, table_of

_FOLDER = Path(__file__).parent / "measurements"


def main() -> None:
    """Measure what the command line names, and print it."""
    names = sorted(
        path.stem for path in _FOLDER.glob("[a-z]*.py") if "\ndef measure(" in path.read_text()
    )
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else None)
    modules = parser.add_subparsers(dest="name", required=True)
    for name in names:
        own = modules.add_parser(name)
        own.add_argument("--json", action="store_true", help="print JSON and nothing else")
        if name in sys.argv[1:2] and hasattr(_module(name), "options"):
            _module(name).options(own)
    asked = vars(parser.parse_args())
    _print(_module(asked.pop("name")), asked.pop("json"), asked)


def table(module: ModuleType, found: dict[str, Any]) -> Table:
    """Return heads and rows of what a measurement found."""
    if hasattr(module, "COLUMNS"):
        return table_of(module.COLUMNS, found["rows"])
    own: Table = module.table(found)
    return own


def _module(name: str) -> ModuleType:
    return import_module(f"tools.measurements.{name}")


def _print(module: ModuleType, json: bool, asked: dict[str, Any]) -> None:
    found = module.measure(**asked)
    if json:
        print_json(found)
        return
    print_table(*table(module, found))
    for line in module.notes(found) if hasattr(module, "notes") else ():
        say(line)


if __name__ == "__main__":
    main()
