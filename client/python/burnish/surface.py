"""The surface that a live session shows: pages of one level of detail, as one mesh."""

from __future__ import annotations

import itertools

import numpy as np
import numpy.typing as npt

from burnish.v1 import library_pb2

from ._calls import Calls
from .errors import Damaged, ResourceExhausted
from .formats.frames import FrameDecoder
from .formats.layout import Layout
from .formats.pages import Head, Page, read_head, read_page
from .progress import Progress

PAGES_AT_ONCE = 64
PAGES_MAX = 4096


def choose_level(head: Head, triangles_max: int) -> int:
    """Returns the finest level with at most so many triangles, and pages that may be shown."""
    for level, pages in enumerate(head.level_pages):
        if pages <= PAGES_MAX and head.triangles >> level <= max(triangles_max, 1):
            return level
    return len(head.level_pages) - 1


def describe(calls: Calls, scan: str) -> Head:
    """Returns the head of a scan's pages. The server makes them if there are none."""
    events = calls.repeat(lambda: list(calls.stream(
        calls.library.DescribePages, library_pb2.DescribePagesRequest(scan=scan))))
    return read_head(events[-1].done.head)


class Surface:
    """The pages of one level. The level is a whole surface; its pages repeat the vertices of their
    borders."""

    def __init__(self, head: Head, pages: list[Page], depth: int) -> None:
        self.head = head
        self._pages = {page.number: page for page in pages}
        self._shift = head.bits - depth
        self._cell_size = head.side / (1 << depth)
        firsts = np.cumsum([0] + [len(page.positions) for page in pages])
        self.rest: npt.NDArray[np.float64] = np.concatenate(
            [head.places(page.positions) for page in pages])
        self.faces: npt.NDArray[np.int64] = np.concatenate(
            [page.triangles + first for page, first in zip(pages, firsts)])

    @property
    def numbers(self) -> list[int]:
        """The pages' numbers, rising."""
        return list(self._pages)

    def decoder(self) -> FrameDecoder:
        """Returns a decoder for one stream, whose first revision has all pages."""
        decoder = FrameDecoder(lambda page, kind: Layout(self._pages[page], self._shift, kind))
        decoder.show(self.numbers)
        return decoder

    def displacements(self, decoder: FrameDecoder) -> npt.NDArray[np.float64]:
        """Returns n x 3, the scan's units, of the newest frame."""
        moves = [decoder.displacements(number) for number in self.numbers]
        return np.concatenate(moves) * self._cell_size


class ScanSurface(Surface):
    """The pages of level 0 in the order of the scan's own vertices.

    `rest` are those vertices, without the rounding of pages; those of no triangle do not move.
    """

    def __init__(self, head: Head, pages: list[Page], depth: int,
                 vertices: npt.NDArray[np.float64]) -> None:
        """Raises ValueError unless each place of the pages is one of `vertices`."""
        super().__init__(head, pages, depth)
        matches = LatticeMatches(np.concatenate([page.positions for page in pages]))
        cells = np.floor((vertices - head.origin) / head.side * (1 << head.bits)).astype(np.int64)
        self._partners = matches.find(cells)
        scan = LatticeMatches(cells).find(matches.cells)
        if (scan < 0).any():
            raise ValueError(f"vertices has none at {np.count_nonzero(scan < 0)} of {len(scan)} places "
                             "of the surface: it takes those of the imported file")
        self.rest, self.faces = vertices, scan[self.faces]

    def displacements(self, decoder: FrameDecoder) -> npt.NDArray[np.float64]:
        moves = super().displacements(decoder)[self._partners]
        moves[self._partners < 0] = 0
        return moves


class LatticeMatches:
    """Finds places of the lattice among others."""

    def __init__(self, cells: npt.ArrayLike) -> None:
        self.cells: npt.NDArray[np.int64] = np.asarray(cells, np.int64)
        keys = self._keys(self.cells)
        self._order = np.argsort(keys, kind="stable")
        self._keys_in_order = keys[self._order]

    def _keys(self, cells: npt.NDArray[np.int64]) -> npt.NDArray[np.uint64]:
        """Returns a number per place. Two places of one number are about as likely as 2^-64."""
        factors = np.array([0x9E3779B97F4A7C15, 0xC2B2AE3D27D4EB4F, 0x165667B19E3779F9], np.uint64)
        return np.asarray((cells.astype(np.uint64) * factors).sum(axis=1, dtype=np.uint64))

    def find(self, cells: npt.NDArray[np.int64]) -> npt.NDArray[np.int64]:
        """Returns for each cell the index of an equal one, else of a neighbour, else -1."""
        found = np.full(len(cells), -1)
        shifts = sorted(itertools.product((0, -1, 1), repeat=3), key=np.count_nonzero)
        for shift in shifts:
            missing = np.flatnonzero(found < 0)
            if not len(missing):
                break
            keys = self._keys(cells[missing] + np.array(shift))
            at = np.minimum(np.searchsorted(self._keys_in_order, keys), len(self._order) - 1)
            is_equal = self._keys_in_order[at] == keys
            found[missing[is_equal]] = self._order[at[is_equal]]
        return found


def fetch_surface(calls: Calls, scan: str, depth: int, triangles_max: int, level: int | None,
                  progress: Progress | None = None,
                  vertices: npt.NDArray[np.float64] | None = None) -> Surface:
    """Fetches the pages of a level, or of the finest with at most `triangles_max` triangles.

    With the scan's `vertices` it is level 0 in their order.
    """
    head = describe(calls, scan)
    if vertices is not None:
        level = 0
    chosen = choose_level(head, triangles_max) if level is None else level
    if not 0 <= chosen < len(head.level_pages):
        raise ResourceExhausted(f"level {chosen} is outside 0 to {len(head.level_pages) - 1}")
    first, count = sum(head.level_pages[:chosen]), head.level_pages[chosen]
    if count > PAGES_MAX:
        raise ResourceExhausted(f"level {chosen} has {count} pages: at most {PAGES_MAX} are shown")
    pages: list[Page] = []
    for begin in range(first, first + count, PAGES_AT_ONCE):
        numbers = list(range(begin, min(begin + PAGES_AT_ONCE, first + count)))
        pages += _fetch(calls, scan, numbers)
        if progress is not None:
            progress("fetching pages", len(pages) / count)
    return Surface(head, pages, depth) if vertices is None else ScanSurface(head, pages, depth, vertices)


def _fetch(calls: Calls, scan: str, numbers: list[int]) -> list[Page]:
    request = library_pb2.FetchPagesRequest(scan=scan, pages=numbers)
    events = calls.repeat(lambda: list(calls.stream(calls.library.FetchPages, request)))
    pages = [read_page(event.page.data) for event in events]
    if [page.number for page in pages] != numbers:
        raise Damaged("the server sent other pages than asked for")
    return pages
