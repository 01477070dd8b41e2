"""Files on their way to a server and from it."""

from __future__ import annotations

import contextlib
import hashlib
import os
import pathlib
import queue
import tempfile
import zlib
from typing import Any, BinaryIO, Generator, Iterator

from burnish.v1 import common_pb2, library_pb2

from ._channel import PathLike
from .errors import Damaged, InvalidArgument
from .progress import Whole, report

CHUNK_BYTES = 1 << 20
CHUNKS_AHEAD = 4
FORMATS: dict[str, common_pb2.MeshFormat] = {
    "." + name.removeprefix("MESH_FORMAT_").lower(): number
    for name, number in common_pb2.MeshFormat.items() if number}
FORMAT_NAMES = {number: name[1:] for name, number in FORMATS.items()}


def format_of(path: PathLike) -> common_pb2.MeshFormat:
    """Returns the format that a file's name stands for. Raises InvalidArgument."""
    suffix = pathlib.Path(path).suffix.lower()
    if suffix not in FORMATS:
        raise InvalidArgument(f"{path} is not a mesh file: its name must end in "
                              f"{', '.join(FORMATS)}")
    return FORMATS[suffix]


def sha256_of(file: BinaryIO) -> tuple[str, int]:
    """Returns the hash and the bytes of a file, and goes back to its begin."""
    hash_, size = hashlib.sha256(), 0
    while piece := file.read(CHUNK_BYTES):
        hash_.update(piece)
        size += len(piece)
    file.seek(0)
    return hash_.hexdigest(), size


class Upload:
    """The requests of one import: the header, and the file once the server asks for it."""

    def __init__(self, file: BinaryIO, header: library_pb2.ImportHeader) -> None:
        self._file, self._size = file, header.size_bytes
        self._asked: queue.SimpleQueue[bool] = queue.SimpleQueue()
        self._header = header

    def requests(self) -> Iterator[library_pb2.ImportRequest]:
        yield library_pb2.ImportRequest(header=self._header)
        if not self._asked.get():
            return
        offset = 0
        while piece := self._file.read(CHUNK_BYTES):
            yield library_pb2.ImportRequest(chunk=common_pb2.Chunk(
                offset=offset, data=piece, crc32=zlib.crc32(piece)))
            offset += len(piece)

    def begin(self) -> None:
        """Lets the file follow the header."""
        self._asked.put(True)

    def close(self) -> None:
        """Lets nothing follow, if nothing did yet."""
        self._asked.put(False)


class Download:
    """A file from chunks, in its own folder until it is whole."""

    def __init__(self, path: PathLike) -> None:
        self._path = pathlib.Path(path)
        handle, self._part = tempfile.mkstemp(prefix=f".{self._path.name}.",
                                              dir=self._path.parent)
        self._file = os.fdopen(handle, "wb")
        self._hash, self._bytes = hashlib.sha256(), 0

    def take(self, chunk: common_pb2.Chunk) -> None:
        if chunk.offset != self._bytes or chunk.crc32 != zlib.crc32(chunk.data):
            raise Damaged(f"{self._path} was damaged on its way at byte {self._bytes}")
        self._file.write(chunk.data)
        self._hash.update(chunk.data)
        self._bytes += len(chunk.data)

    def finish(self, sha256: str) -> None:
        """Puts the file in its place."""
        if self._hash.hexdigest() != sha256:
            raise Damaged(f"{self._path} was damaged on its way: its hash is wrong")
        self._file.close()
        mask = os.umask(0)
        os.umask(mask)
        os.chmod(self._part, 0o666 & ~mask)
        os.replace(self._part, self._path)

    def close(self) -> None:
        """Removes what is not whole."""
        self._file.close()
        if os.path.exists(self._part):
            os.unlink(self._part)


def receive(stream: Generator[Any, None, None], path: PathLike, of: Whole) -> Any:
    """Writes the file of an export. Returns its summary."""
    with contextlib.closing(Download(path)) as download, contextlib.closing(stream) as events:
        for event in events:
            if event.HasField("progress"):
                report(of, event.progress)
            elif event.HasField("chunk"):
                download.take(event.chunk)
            elif event.HasField("summary"):
                download.finish(event.summary.sha256)
                return event.summary
    raise Damaged(f"{path}: the export ended without its summary")
