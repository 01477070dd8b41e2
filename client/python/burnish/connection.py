"""A connection with a server."""

from __future__ import annotations

import contextlib
import io
import pathlib
import unicodedata
import warnings
from types import TracebackType
from typing import BinaryIO

from burnish.v1 import common_pb2, editing_pb2, library_pb2

from ._calls import PATIENCE_SECONDS, Calls
from ._channel import PathLike, Trust
from .errors import Damaged
from .files import Upload, format_of, sha256_of
from .mesh import Mesh
from .progress import Progress, Whole, report, whole
from .scan import Scan
from .session import Session

_NAME_BYTES_MAX = 200


def connect(address: str = "127.0.0.1:7411", *, user: str | None = None, token: str | None = None,
            ca: PathLike | None = None, certificate: PathLike | None = None,
            key: PathLike | None = None, tls: bool = False, insecure: bool = False,
            patience: float = PATIENCE_SECONDS) -> Connection:
    """Connects with a server: `address` is HOST:PORT or unix:PATH.

    `user` is your name, on a server without users; `token` says who you are on one with users.
    TLS is used with `ca` (a PEM file), with `tls` (the system's CAs) or with a client's
    `certificate` and `key`. `insecure` lets a token travel to another machine in plain text.
    `patience`: seconds for which calls are repeated while the server cannot be reached. In a fleet
    with a longer lease than 10 s: the lease, and 3 s.
    Raises Unavailable, Unauthenticated, and OSError for files.
    """
    trust = Trust(user=user, token=token, ca=ca, certificate=certificate, key=key, tls=tls,
                  insecure=insecure)
    connection = Connection(Calls(address, trust, patience))
    try:
        connection.scans()
    except BaseException:
        connection.close()
        raise
    return connection


def _name_like(stem: str) -> str:
    """Returns the name that is most like a file's: without characters that a scan's may not have."""
    shown = "".join(c for c in stem if unicodedata.category(c) not in ("Cc", "Cf", "Zl", "Zp"))
    known = shown.encode("utf-8", "surrogateescape").decode("utf-8", "replace")
    return known.encode()[:_NAME_BYTES_MAX].decode(errors="ignore")


class Connection:
    """Made by connect(). Use it with `with`, or close() it."""

    def __init__(self, calls: Calls) -> None:
        self.calls = calls

    def __enter__(self) -> Connection:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None,
                 trace: TracebackType | None) -> None:
        self.close()

    def close(self) -> None:
        """Ends all calls and live sessions of this connection."""
        self.calls.close()

    def scans(self) -> list[Scan]:
        """Returns the server's scans, by name."""
        answer = self.calls.ask(self.calls.library.ListScans, library_pb2.ListScansRequest())
        return [Scan(self, info) for info in answer.scans]

    def scan(self, name: str) -> Scan:
        """Returns a scan by its name, its id, or the beginning of one id. Raises NotFound."""
        answer = self.calls.ask(self.calls.library.DescribeScan,
                                library_pb2.DescribeScanRequest(scan=name))
        return Scan(self, answer.scan)

    def import_scan(self, source: PathLike | Mesh, name: str | None = None, *, depth: int = 0,
                    progress: Progress | None = None) -> Scan:
        """Sends a mesh file, or a mesh, and returns the scan once it is prepared.

        The file alone is sent: pack an OBJ with its textures as .zip before. A file that the
        server knows is not sent again, and keeps its name: a warning says which, if it is another.
        `name` is refused when another scan has it; by default it is the file's, with a number when
        another scan has that one; `depth` of the grid is 4 to 12, or 0 for the server's choice.
        """
        if isinstance(source, Mesh):
            file: BinaryIO = io.BytesIO(source.to_ply())
            return self._import(file, name, "", common_pb2.MESH_FORMAT_PLY, depth, progress)
        kind = format_of(source)
        with open(source, "rb") as file:
            return self._import(file, name, _name_like(pathlib.Path(source).stem), kind, depth, progress)

    def _import(self, file: BinaryIO, name: str | None, otherwise: str,
                kind: common_pb2.MeshFormat, depth: int, progress: Progress | None) -> Scan:
        sha256, size = sha256_of(file)
        wanted = name or otherwise
        header = library_pb2.ImportHeader(name=wanted or "mesh", format=kind, size_bytes=size,
                                          sha256=sha256, depth=depth, exact_name=bool(name))

        with whole(progress) as of:
            def send() -> library_pb2.ImportDone:
                file.seek(0)
                return self._send(Upload(file, header), of)
            done = self.calls.repeat(send)
        if done.already_present and wanted and done.scan.name != wanted:
            warnings.warn(f"the server has these bytes already: the scan keeps its name "
                          f"'{done.scan.name}', not '{wanted}'; Scan.rename() changes it",
                          stacklevel=3)
        return Scan(self, done.scan)

    def _send(self, upload: Upload, of: Whole) -> library_pb2.ImportDone:
        stream = self.calls.stream(self.calls.library.Import, upload.requests())
        with contextlib.closing(upload), contextlib.closing(stream) as events:
            for event in events:
                if event.HasField("received"):
                    upload.begin()
                elif event.HasField("progress"):
                    report(of, event.progress)
                elif event.HasField("done"):
                    done: library_pb2.ImportDone = event.done
                    return done
        raise Damaged("the import ended without an answer")

    def sessions(self) -> list[Session]:
        """Returns the server's sessions, by name."""
        answer = self.calls.ask(self.calls.editing.ListSessions, editing_pb2.ListSessionsRequest())
        return [Session(self.calls, info) for info in answer.sessions]

    def session(self, name: str) -> Session:
        """Returns a session by its name or id. Raises NotFound."""
        answer = self.calls.ask(self.calls.editing.GetState,
                                editing_pb2.GetStateRequest(session=name))
        return Session(self.calls, answer.session)

    def open_session(self, scan: Scan | str, name: str = "", *, depth: int = 0,
                     curvature_radius: float = 0.0) -> Session:
        """Opens a session of a scan, or joins the one of that name.

        Without a name the server chooses one. `depth` is 4 to 12, 0 for the scan's default;
        `curvature_radius` is a fraction of L, 0 to 0.2. Raises NotFound; AlreadyExists if the
        session of that name has another scan or depth.
        """
        request = editing_pb2.OpenSessionRequest(
            scan=scan.id if isinstance(scan, Scan) else scan, name=name, depth=depth,
            curvature_radius=curvature_radius)
        call = self.calls.ask if name else self.calls.ask_once
        return Session(self.calls, call(self.calls.editing.OpenSession, request).session)
