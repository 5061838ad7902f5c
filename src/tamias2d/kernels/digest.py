"""What compiled code is known by: the statements of its source, not what the source says of them.

Serves: `compiled` and `cache`. A docstring or a comment that is put in better words must not make
everybody compile anew.
"""

import hashlib
import re
from functools import cache

_SAYS = re.compile(r'"""[\s\S]*?"""|#.*')
"""Docstrings and comments: sources hold no other texts of several lines, and no text with a '#'."""


@cache
def digest_of(source: str) -> str:
    """Return what changes with each statement of a source, and not with docstrings or comments."""
    lines = (line.rstrip() for line in _SAYS.sub("", source).splitlines())
    return hashlib.sha256("\n".join(filter(None, lines)).encode()).hexdigest()[:16]
