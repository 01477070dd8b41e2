"""The programs burnish and burnish-server, with the libraries that they need."""

import os
import pathlib
import sys


def path(name: str) -> str:
    """Returns where the program `burnish` or `burnish-server` is."""
    return str(pathlib.Path(__file__).parent / "bin" / name)


def burnish() -> None:
    os.execv(path("burnish"), sys.argv)


def burnish_server() -> None:
    os.execv(path("burnish-server"), sys.argv)
