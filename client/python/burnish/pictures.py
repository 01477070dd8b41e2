"""Pictures of meshes, and films of pictures."""

from __future__ import annotations

import pathlib
import struct
import subprocess
import tempfile
import warnings
import zlib
from typing import Iterator, Sequence

from ._channel import PathLike
from .errors import Error, InvalidArgument
from .mesh import Mesh
from .program import find_program

_SIGNATURE = b"\x89PNG\r\n\x1a\n"


def render(source: PathLike | Mesh, picture: PathLike, *, view: tuple[float, float] = (25, 20),
           size: tuple[int, int] = (1280, 960), light: str = "clay",
           scale_bar: str | None = None) -> None:
    """Draws a mesh, or a mesh file, as a PNG, by the program `burnish`.

    A file with pictures shows their texels; `light="unlit"` shows these as they are. `view`:
    azimuth from +z towards +x, elevation towards +y, degrees. `size`: pixels. `light`: as `burnish
    render --help` lists them. `scale_bar`: the unit of a bar's length, "" for none; None: there is
    no bar. Warns of what cannot be shown. Raises Error.
    """
    with tempfile.TemporaryDirectory(prefix="burnish-") as folder:
        if isinstance(source, Mesh):
            file = pathlib.Path(folder) / "mesh.ply"
            file.write_bytes(source.to_ply())
            source = file
        bar = [] if scale_bar is None else ["--scale-bar", scale_bar]
        done = subprocess.run(
            [find_program(), "render", f"--view={view[0]},{view[1]}", f"--size={size[0]}x{size[1]}",
             f"--light={light}", *bar, "--", source, picture], stdin=subprocess.DEVNULL,
            capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise Error(done.stderr.strip())
    for line in done.stderr.splitlines():
        if line.startswith("warning: "):
            warnings.warn(line.removeprefix("warning: "), stacklevel=2)


def animate(pictures: Sequence[PathLike], film: PathLike, *, seconds: float = 0.2) -> None:
    """Joins PNG files of one size and kind to one that moves (APNG), for browsers.

    `seconds`: how long each picture is shown, up to 65. Raises InvalidArgument.
    """
    contents = [list(_chunks(pathlib.Path(picture))) for picture in pictures]
    headers = {content[0][1] for content in contents}
    if len(headers) != 1:
        raise InvalidArgument(f"{len(headers)} kinds of pictures in {film}: they must have one "
                              "size and one kind")
    header, = headers
    out = [_SIGNATURE, _chunk(b"IHDR", header),
           _chunk(b"acTL", struct.pack(">II", len(contents), 0))]
    sequence = 0
    for index, content in enumerate(contents):
        out.append(_chunk(b"fcTL", struct.pack(">I8sIIHHBB", sequence, header[:8], 0, 0,
                                               round(1000 * seconds), 1000, 0, 0)))
        sequence += 1
        data = b"".join(body for kind, body in content if kind == b"IDAT")
        if index == 0:
            out.append(_chunk(b"IDAT", data))
        else:
            out.append(_chunk(b"fdAT", struct.pack(">I", sequence) + data))
            sequence += 1
    pathlib.Path(film).write_bytes(b"".join(out) + _chunk(b"IEND", b""))


def _chunk(kind: bytes, body: bytes) -> bytes:
    return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))


def _chunks(picture: pathlib.Path) -> Iterator[tuple[bytes, bytes]]:
    data = picture.read_bytes()
    if data[:8] != _SIGNATURE:
        raise InvalidArgument(f"{picture} is not a PNG")
    at = 8
    while at < len(data):
        size, = struct.unpack_from(">I", data, at)
        yield data[at + 4:at + 8], data[at + 8:at + 8 + size]
        at += 12 + size
