"""Measurements: `python -m tools.measure NAME [--json]`; each is a module of tools/measurements.

A measurement has `measure()`, which returns what JSON can hold, and `table(found)`, which makes
heads and rows of it. It may have `options(parser)`, which `measure` then takes by name, and
`notes(found)`, lines below the table. What they say depends on the machine; no test asks for it.
"""

import argparse
import sys
from importlib import import_module
from pathlib import Path
from types import ModuleType
from typing import Any

from tamias2d.commands.output import print_json, print_table, say

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


def _module(name: str) -> ModuleType:
    return import_module(f"tools.measurements.{name}")


def _print(module: ModuleType, json: bool, asked: dict[str, Any]) -> None:
    found = module.measure(**asked)
    if json:
        print_json(found)
        return
    print_table(*module.table(found))
    for line in module.notes(found) if hasattr(module, "notes") else ():
        say(line)


if __name__ == "__main__":
    main()
