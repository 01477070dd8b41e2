"""Codes of normals (docs/protocol.md, section 6, "Normals")."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from .wire import Ints, Words

Numbers = npt.NDArray[Any]


def fold(u: Numbers, v: Numbers, one: int) -> tuple[Numbers, Numbers]:
    """Returns the code of the lower half of the octahedron: each value keeps its sign."""
    return (np.where(u < 0, abs(v) - one, one - abs(v)),
            np.where(v < 0, abs(u) - one, one - abs(u)))


def bit_lengths(values: Ints) -> Ints:
    """Returns the bits that values of at least 0 have."""
    high = values >> 31  # floats hold what is below 2^53
    return np.where(high > 0, np.frexp(high)[1] + 31, np.frexp(values & (1 << 31) - 1)[1])


def predicted_codes(triangles: Ints, positions: Words) -> Ints:
    """Returns the n x 2 codes that the triangles predict, in integers."""
    places = positions.astype(np.int64)
    p0, p1, p2 = (places[triangles[:, corner]] for corner in range(3))
    cross = np.cross(p1 - p0, p2 - p0)
    sums = np.zeros((len(positions), 3), np.int64)
    for corner in range(3):
        np.add.at(sums, triangles[:, corner], cross)
    shift = np.maximum(0, bit_lengths(np.abs(sums).sum(axis=1)) - 21)
    x, y, z = (sums >> shift[:, None]).T
    size = abs(x) + abs(y) + abs(z)
    u, v = (np.sign(axis) * (127 * abs(axis) // np.maximum(size, 1)) for axis in (x, y))
    below = fold(u, v, 127)
    return np.stack([np.where(z < 0, below[0], u), np.where(z < 0, below[1], v)], axis=1)


def normals_of(codes: Ints) -> npt.NDArray[np.float64]:
    """Returns the n x 3 unit vectors of codes."""
    u, v = codes.T / 127
    z = 1 - abs(u) - abs(v)
    below = fold(u, v, 1)
    vectors = np.stack([np.where(z < 0, below[0], u), np.where(z < 0, below[1], v), z], axis=1)
    return np.asarray(vectors / np.linalg.norm(vectors, axis=1, keepdims=True))
