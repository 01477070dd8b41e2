"""The common part of pages and frames: checksums, zstd, zigzag, Morton keys (docs/protocol.md)."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt
import xxhash
import zstandard

from burnish.errors import Damaged

Ints = npt.NDArray[np.int64]
Words = npt.NDArray[np.uint32]
Bytes = npt.NDArray[np.uint8]


def require(condition: object, what: str) -> None:
    """Raises Damaged unless the condition holds."""
    if not condition:
        raise Damaged(what)


def xxh3(data: bytes, seed: int = 0) -> int:
    """Returns XXH3 of 64 bits."""
    return xxhash.xxh3_64_intdigest(data, seed)


def checksum(data: bytes, header_bytes: int) -> int:
    """Returns the checksum of a head, a page or a frame. It takes the last 8 bytes of the header."""
    return xxh3(data[header_bytes:], seed=xxh3(data[:header_bytes - 8]))


def decompress(data: bytes, size: int) -> bytes:
    """Returns the content of one zstd frame of `size` bytes."""
    require(zstandard.frame_content_size(data) == size, f"not one zstd frame of {size} bytes")
    try:
        return zstandard.ZstdDecompressor().decompress(data, max_output_size=size)
    except zstandard.ZstdError as error:
        raise Damaged(f"a zstd frame of {size} bytes: {error}") from error


def unzigzag(words: npt.NDArray[Any]) -> npt.NDArray[Any]:
    """Returns what zigzag words stand for, modulo their bits."""
    return np.asarray((words >> 1) ^ (~(words & 1) + 1).astype(words.dtype))


def morton_key(points: Ints) -> npt.NDArray[np.uint64]:
    """Returns the Morton keys of n x 3 cells or corners of a grid of at most depth 12."""
    keys = np.zeros(len(points), np.uint64)
    for bit in range(13):
        for axis in range(3):
            keys |= (points[:, axis] >> bit & 1).astype(np.uint64) << np.uint64(3 * bit + axis)
    return keys
