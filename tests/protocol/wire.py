"""The common part of views and frames: checksums, zstd, zigzag, Morton keys (docs/protocol.md)."""

import numpy as np
import xxhash
import zstandard


class Damaged(Exception):
    """Bytes that are damaged or of another kind."""


def require(condition, what):
    if not condition:
        raise Damaged(what)


def xxh3(data, seed=0):
    return xxhash.xxh3_64_intdigest(bytes(data), seed)


def checksum(data, header_bytes):
    """Returns the checksum of a view or a frame; it takes the last 8 bytes of the header."""
    return xxh3(data[header_bytes:], seed=xxh3(data[:header_bytes - 8]))


def decompress(data, size):
    require(zstandard.frame_content_size(data) == size, f"not one zstd frame of {size} bytes")
    return zstandard.ZstdDecompressor().decompress(data, max_output_size=size)


def unzigzag(words):
    return (words >> 1) ^ (~(words & 1) + 1).astype(words.dtype)


def morton_point(keys):
    """Returns (i, j, k) of Morton keys: bit b of i, j, k is bit 3b, 3b+1, 3b+2."""
    point = np.zeros((len(keys), 3), np.int64)
    for bit in range(13):
        for axis in range(3):
            point[:, axis] |= ((keys >> np.uint64(3 * bit + axis)) & np.uint64(1)).astype(
                np.int64) << bit
    return point


def morton_key(points):
    keys = np.zeros(len(points), np.uint64)
    for bit in range(13):
        for axis in range(3):
            keys |= (points[:, axis] >> bit & 1).astype(np.uint64) << np.uint64(3 * bit + axis)
    return keys
