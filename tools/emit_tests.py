"""Generated tests."""

from tamias2d.spec.specification import Specification


def emit(specification: Specification) -> dict[str, str]:
    """Generated tests by file name, not yet formatted."""
    return {"__init__.py": ""}
