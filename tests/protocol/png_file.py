"""PNG files, written and read without another package."""

import struct
import zlib

import numpy as np


def encoded(texels):
    """Returns a picture (rows, columns, 3 bytes) as a PNG file."""
    rows, columns, _ = texels.shape
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    lines = b"".join(b"\0" + row.tobytes() for row in texels)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", columns, rows, 8, 2, 0, 0, 0))
            + chunk(b"tEXt", b"Title\0skin") + chunk(b"IDAT", zlib.compress(lines)) + chunk(b"IEND", b""))


def decoded(file):
    """Returns the texels of a PNG file of 8 bits a channel and three channels."""
    at, data, size = 8, b"", None
    while at < len(file):
        length, kind = struct.unpack(">I4s", file[at:at + 8])
        body = file[at + 8:at + 8 + length]
        size = struct.unpack(">II", body[:8]) if kind == b"IHDR" else size
        data += body if kind == b"IDAT" else b""
        at += 12 + length
    columns, rows = size
    lines = np.frombuffer(zlib.decompress(data), np.uint8).reshape(rows, 3 * columns + 1)
    texels = np.zeros((rows, columns + 1, 3), np.int64)  # a column of zeros before the first one
    above = np.zeros((columns + 1, 3), np.int64)
    for y, line in enumerate(lines):
        texels[y] = above = _unfiltered(int(line[0]), line[1:].reshape(columns, 3).astype(int), above)
    return texels[:, 1:]


def _unfiltered(kind, line, above):
    """Undoes a row's filter. Source: the PNG specification, 9.2."""
    row = np.zeros_like(above)
    if kind in (0, 2):
        row[1:] = (line + (above[1:] if kind == 2 else 0)) % 256
        return row
    for x, value in enumerate(line, 1):
        left, up, corner = row[x - 1], above[x], above[x - 1]
        guess = left if kind == 1 else (left + up) // 2 if kind == 3 else _paeth(left, up, corner)
        row[x] = (value + guess) % 256
    return row


def _paeth(left, up, corner):
    ways = np.abs(np.stack([up - corner, left - corner, left + up - 2 * corner]))
    return np.where((ways[0] <= ways[1]) & (ways[0] <= ways[2]), left,
                    np.where(ways[1] <= ways[2], up, corner))
