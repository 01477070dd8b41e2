"""The programs of Burnish on this computer."""

from __future__ import annotations

import importlib
import importlib.util
import os
import shutil

from .errors import NotFound


def find_program(name: str = "burnish") -> str:
    """Returns the program `burnish` or `burnish-server`: the one that BURNISH_BINARY or
    BURNISH_SERVER_BINARY names, from the path, or of the package burnish-programs. Raises
    NotFound."""
    variable = name.replace("-", "_").upper() + "_BINARY"
    found = os.environ.get(variable) or shutil.which(name) or _bundled(name)
    if found is None:
        raise NotFound(f"no program {name} here: install the package {name} or the wheel "
                       f"burnish-programs, or let {variable} name it")
    return found


def _bundled(name: str) -> str | None:
    if importlib.util.find_spec("burnish_programs") is None:
        return None
    return str(importlib.import_module("burnish_programs").path(name))
