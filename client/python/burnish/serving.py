"""A server of one's own, for as long as a script needs it."""

from __future__ import annotations

import contextlib
import os
import pathlib
import subprocess
import tempfile
import time
import weakref

from ._calls import Calls
from ._channel import PathLike
from .connection import Connection, connect
from .errors import Error, Unavailable
from .program import find_program

START_SECONDS = 60.0
TRY_SECONDS = 0.5
STOP_SECONDS = 30.0


class Server(Connection):
    """A server of this user alone, and the connection with it. Made by serve(). Use it with `with`,
    or close() it."""

    def __init__(self, calls: Calls, started: contextlib.ExitStack) -> None:
        super().__init__(calls)
        # Sessions need the server as long as they have the calls; at the program's end it goes too.
        self._end = weakref.finalize(calls, started.close)

    def close(self) -> None:
        """Ends all calls and live sessions, and stops the server. Harmless to repeat."""
        super().close()
        self._end()


def serve(data: PathLike | None = None, *, user: str | None = None) -> Server:
    """Starts `burnish-server` for this user alone, and connects with it, until close().

    The server also ends with this program, whatever ends it.
    `data` is the folder that keeps scans and edits; without one they go with the server.
    Raises NotFound without the program; Error with the server's words if it does not start.
    """
    with contextlib.ExitStack() as started:
        folder = pathlib.Path(started.enter_context(
            tempfile.TemporaryDirectory(prefix="burnish-")))
        kept = folder / "data" if data is None else pathlib.Path(data)
        with open(folder / "log", "wb") as log:
            process = subprocess.Popen(
                [find_program("burnish-server"), "--listen", "", "--socket",
                 os.fspath(folder / "server.sock"), "--socket-user-only", "--data",
                 os.fspath(kept), "--end-with-input"],
                stdin=subprocess.PIPE, stdout=log, stderr=log)
        started.callback(_stop, process)
        connection = _connect(f"unix:{folder / 'server.sock'}", user, process, folder / "log")
        stop = started.pop_all()
    return Server(connection.calls, stop)


def _connect(address: str, user: str | None, process: subprocess.Popen[bytes],
             log: pathlib.Path) -> Connection:
    end = time.monotonic() + START_SECONDS
    while True:
        try:
            return connect(address, user=user, patience=TRY_SECONDS)
        except Unavailable:
            if process.poll() is not None:
                words = log.read_text(encoding="utf-8").strip()
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
