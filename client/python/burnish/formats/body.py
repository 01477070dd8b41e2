"""The streams of a frame's body (docs/protocol.md, section 7)."""

from __future__ import annotations

import io
from typing import Sequence

import numpy as np

from .wire import Bytes, Ints, Words, require, unzigzag

SENT, HAS_GAIN, HAS_HELD = 1, 2, 4
GROUP = 16


def take(stream: io.BytesIO, count: int) -> Bytes:
    data = stream.read(count)
    require(len(data) == count, "a stream is cut off")
    return np.frombuffer(data, np.uint8)


def group_count(size: int) -> int:
    return -(-size // GROUP)


def held_bytes(vertices: int) -> int:
    return -(-vertices // 8)


def body_bytes_max(sizes: Sequence[int], vertices: Sequence[int]) -> int:
    """Returns the most bytes that the body of pages with so many values and vertices can have."""
    groups = 3 * sum(map(group_count, sizes))
    return 5 * len(sizes) + groups * (1 + 4 * GROUP) + sum(map(held_bytes, vertices))


def _read_held(streams: io.BytesIO, vertices: int) -> Ints:
    bits = np.unpackbits(take(streams, held_bytes(vertices)), bitorder="little")
    require(not bits[vertices:].any(), "a vertex is held that the page does not have")
    return np.flatnonzero(bits)


class Body:
    """The flags, gains, held vertices and residuals of a body. `sizes` and `vertices`: numbers of
    values and vertices of each shown page."""

    def __init__(self, data: bytes, sizes: Sequence[int], vertices: Sequence[int]) -> None:
        streams = io.BytesIO(data)
        self.flags: list[int] = take(streams, len(sizes)).tolist()
        require(max(self.flags, default=0) <= SENT | HAS_GAIN | HAS_HELD,
                "a page has an unknown flag")
        self.gains: list[int] = take(
            streams, sum(flag & HAS_GAIN != 0 for flag in self.flags)).tolist()
        require(max(self.gains, default=0) <= 15, "a gain is above 15")
        self.held = [_read_held(streams, count)
                     for count, flag in zip(vertices, self.flags) if flag & HAS_HELD]
        """The held vertices of the pages that say so, rising."""
        self._sizes = [size for size, flag in zip(sizes, self.flags) if flag & SENT]
        self._widths = self._read_widths(streams)
        self._groups = self._read_groups(streams)
        require(not streams.read(), "bytes follow the last stream")

    def _read_widths(self, streams: io.BytesIO) -> Bytes:
        widths = [np.zeros(0, np.uint8)]
        for size in self._sizes:
            groups = group_count(size)
            for _ in range(3):
                pairs = take(streams, -(-groups // 2))
                widths.append(np.stack([pairs & 15, pairs >> 4], axis=1).ravel()[:groups])
        found = np.concatenate(widths)
        require(not (found > 6).any(), "a group is wider than 6")
        return found

    def _read_groups(self, streams: io.BytesIO) -> Words:
        """Returns the numbers of all groups, 16 in a row."""
        widths, groups = self._widths, np.zeros((len(self._widths), GROUP), np.uint32)
        self._read_packed(streams, groups)
        for width, shift, planes in (4, 0, 1), (5, 8, 1), (6, 16, 2):
            wide = np.flatnonzero(widths >= width)
            data = take(streams, GROUP * planes * len(wide)).reshape(-1, planes, GROUP)
            for plane in range(planes):
                groups[wide] |= data[:, plane].astype(np.uint32) << np.uint32(shift + 8 * plane)
        return groups

    def _read_packed(self, streams: io.BytesIO, groups: Words) -> None:
        lengths = np.array([0, 2, 4, 8, 0, 0, 0], np.int64)[self._widths]
        packed, firsts = take(streams, int(lengths.sum())), np.cumsum(lengths) - lengths
        for width in 1, 2, 3:
            bits, own = 1 << (width - 1), np.flatnonzero(self._widths == width)
            data = packed[firsts[own][:, None] + np.arange(2 * bits)]
            shifts = np.arange(0, 8, bits, dtype=np.uint8)
            groups[own] = (data[:, :, None] >> shifts & ((1 << bits) - 1)).reshape(-1, GROUP)

    def residuals(self) -> Ints:
        """Returns the 3 x n residuals of the sent pages, one behind the other."""
        first, axes = 0, [[np.zeros(0, np.uint32)] for _ in range(3)]
        for size in self._sizes:
            count = group_count(size)
            for axis in axes:
                axis.append(self._groups[first:first + count].ravel()[:size])
                first += count
        words = np.stack([np.concatenate(axis) for axis in axes])
        return np.asarray(unzigzag(words).view(np.int32).astype(np.int64))
