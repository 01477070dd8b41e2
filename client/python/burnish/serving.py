"""A server of one's own, for as long as a script needs it."""

from __future__ import annotations

import atexit
import contextlib
import functools
import os
import pathlib
import subprocess
import tempfile
import time
from typing import Iterator

from ._channel import PathLike
from .connection import Connection, connect
from .errors import Error, Unavailable
from .program import find_program

START_SECONDS = 60.0
TRY_SECONDS = 0.5
STOP_SECONDS = 30.0


@contextlib.contextmanager
def serve(data: PathLike | None = None, *, user: str | None = None) -> Iterator[Connection]:
    """Starts `burnish-server` for this user alone, and connects with it; stops it at the end.

    The server also ends with this program, whatever ends it.
    `data` is the folder that keeps scans and edits; without one they go with the server.
    Raises NotFound without the program; Error with the server's words if it does not start.
    """
    with tempfile.TemporaryDirectory(prefix="burnish-") as folder:
        socket = pathlib.Path(folder) / "server.sock"
        kept = pathlib.Path(folder) / "data" if data is None else pathlib.Path(data)
        with open(pathlib.Path(folder) / "log", "w+", encoding="utf-8") as log:
            process = subprocess.Popen(
                [find_program("burnish-server"), "--listen", "", "--socket", os.fspath(socket),
                 "--socket-user-only", "--data", os.fspath(kept), "--end-with-input"],
                stdin=subprocess.PIPE, stdout=log, stderr=log)
            stop = functools.partial(_stop, process)
            atexit.register(stop)  # a caller may never leave the context
            try:
                with _connect(f"unix:{socket}", user, process, log.name) as connection:
                    yield connection
            finally:
                atexit.unregister(stop)
                stop()


def _connect(address: str, user: str | None, process: subprocess.Popen[bytes],
             log: str) -> Connection:
    end = time.monotonic() + START_SECONDS
    while True:
        try:
            return connect(address, user=user, patience=TRY_SECONDS)
        except Unavailable:
            if process.poll() is not None:
                words = pathlib.Path(log).read_text(encoding="utf-8").strip()
                raise Error(f"burnish-server ended: {words}") from None
            if time.monotonic() > end:
                raise


def _stop(process: subprocess.Popen[bytes]) -> None:
    process.terminate()
    if process.stdin:
        process.stdin.close()
    try:
        process.wait(STOP_SECONDS)
    except subprocess.TimeoutExpired:
        process.kill()
        process.wait()
