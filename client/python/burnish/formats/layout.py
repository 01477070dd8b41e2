"""The values that frames carry for a page, by section 7 of docs/protocol.md."""

from __future__ import annotations

from typing import Sequence

import numpy as np
import numpy.typing as npt

from .pages import Page
from .wire import Ints, morton_key

VERTICES, CORNERS = 0, 1
OFFSETS = np.array([(a & 1, a >> 1 & 1, a >> 2) for a in range(8)], np.int64)


class Predictors:
    """The earlier values that predict each value. `pairs`: m x 2, a value and one of its own.

    A value without any has the value before it; the first has none.
    """

    def __init__(self, size: int, pairs: Ints) -> None:
        alone = np.flatnonzero(np.bincount(pairs[:, 0], minlength=size)[1:] == 0) + 1
        pairs = np.concatenate([pairs, np.stack([alone, alone - 1], axis=1)])
        pairs = pairs[np.lexsort((pairs[:, 1], pairs[:, 0]))]
        self.counts = np.bincount(pairs[:, 0], minlength=size).astype(np.int64)
        self.values = pairs[:, 1]
        self.depths = self._find_depths()

    def _find_depths(self) -> Ints:
        """Returns how many values follow one another up to each value."""
        depths: list[int] = []
        values, end = self.values.tolist(), 0
        for count in self.counts.tolist():
            begin, end = end, end + count
            depths.append(1 + max([depths[value] for value in values[begin:end]], default=-1))
        return np.array(depths, np.int64)


def vertex_pairs(page: Page) -> Ints:
    """Returns each vertex with the earlier vertices of its triangles."""
    sides = [page.triangles[:, [a, b]] for a in range(3) for b in range(3) if a != b]
    pairs = np.concatenate(sides)
    pairs = pairs[pairs[:, 1] < pairs[:, 0]]
    size = len(page.positions)
    keys = np.unique(pairs[:, 0] * size + pairs[:, 1])
    return np.stack([keys // max(size, 1), keys % max(size, 1)], axis=1)


def corner_pairs(corners: Ints) -> Ints:
    """Returns each corner with those one step down along x, y and z. They are in Morton order."""
    keys, pairs = morton_key(corners), []
    for axis in range(3):
        has_below = np.flatnonzero(corners[:, axis] > 0)
        below = corners[has_below] - np.eye(3, dtype=np.int64)[axis]
        wanted = morton_key(below)
        found = np.minimum(np.searchsorted(keys, wanted), len(keys) - 1)
        there = keys[found] == wanted
        pairs.append(np.stack([has_below[there], found[there]], axis=1))
    return np.concatenate(pairs)


class Layout:
    """The values of a page in frames of one kind. `shift`: bits of a position below its cell."""

    def __init__(self, page: Page, shift: int, kind: int) -> None:
        self.kind = kind
        self.vertices = len(page.positions)
        """The number of the page's vertices, whatever the values are."""
        if kind == VERTICES:
            self.predictors = Predictors(len(page.positions), vertex_pairs(page))
            return
        positions = page.positions.astype(np.int64)
        places = ((positions >> shift)[:, None, :] + OFFSETS).reshape(-1, 3)
        _, first, index = np.unique(morton_key(places), return_index=True, return_inverse=True)
        self.corners = places[first]
        self._of_vertex = index.reshape(-1, 8)
        local = ((positions & ((1 << shift) - 1)) + 0.5) / (1 << shift)
        self._weights = np.prod(np.where(OFFSETS == 1, local[:, None, :], 1 - local[:, None, :]),
                                axis=2)
        self.predictors = Predictors(len(self.corners), corner_pairs(self.corners))

    @property
    def size(self) -> int:
        """The number of values."""
        return len(self.predictors.counts)

    def at_vertices(self, values: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
        """Returns the n x 3 displacements of the page's vertices from those of the values."""
        if self.kind == VERTICES:
            return values
        return np.asarray(np.einsum("va,vax->vx", self._weights, values[self._of_vertex]))


def wrap(numbers: Ints) -> Ints:
    """Returns numbers modulo 2^32, as i32."""
    return ((numbers + (1 << 31)) & 0xFFFFFFFF) - (1 << 31)


class Chain:
    """The order in which the values of some pages follow from one another.

    Values that wait for equally many others are computed at once, whatever their page.
    """

    def __init__(self, layouts: Sequence[Layout]) -> None:
        parts = [layout.predictors for layout in layouts]
        sizes = np.array([layout.size for layout in layouts], np.int64)
        begins = np.cumsum(sizes) - sizes
        depths = np.concatenate([part.depths for part in parts])
        counts = np.concatenate([part.counts for part in parts])
        values = np.concatenate([part.values + begin for part, begin in zip(parts, begins)])
        order = np.argsort(depths, kind="stable")
        firsts = (np.cumsum(counts) - counts)[order]
        counts = counts[order]
        ends = np.cumsum(counts)
        values = values[np.repeat(firsts - (ends - counts), counts) + np.arange(len(values))]
        self._waves = []
        waves = np.cumsum(np.bincount(depths))
        for begin, end in zip(waves[:-1].tolist(), waves[1:].tolist()):
            first = int(ends[begin - 1])
            self._waves.append((order[begin:end], values[first:int(ends[end - 1])],
                                ends[begin:end] - counts[begin:end] - first, counts[begin:end]))

    def undo(self, residuals: Ints) -> Ints:
        """Returns the 3 x n numbers k of 3 x n residuals."""
        k = residuals.copy()
        for own, others, firsts, counts in self._waves:
            sums = np.add.reduceat(k[:, others], firsts, axis=1)
            k[:, own] = wrap(k[:, own] + (2 * sums + counts) // (2 * counts))
        return k
