"""The programs of Burnish on this computer."""

from __future__ import annotations

import os
import shutil

from .errors import NotFound


def find_program(name: str = "burnish") -> str:
    """Returns the program `burnish` or `burnish-server`: the one that BURNISH_BINARY or
    BURNISH_SERVER_BINARY names, or from the path. Raises NotFound."""
    variable = name.replace("-", "_").upper() + "_BINARY"
    found = os.environ.get(variable) or shutil.which(name)
    if found is None:
        raise NotFound(f"no program {name} here: install the package {name}, or let {variable} "
                       "name it")
    return found
