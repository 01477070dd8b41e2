"""Decodes frames by section 7 of docs/protocol.md."""

from __future__ import annotations

import dataclasses
import struct
from typing import Callable, Iterable

import numpy as np
import numpy.typing as npt

from burnish.errors import Damaged

from .body import HAS_GAIN, HAS_HELD, SENT, Body, body_bytes_max
from .layout import Chain, Layout, wrap
from .wire import Ints, checksum, decompress, require

COLOURS = 1 << 31
"""A page's number plus this stands for its colours."""


class MissingReference(Damaged):
    """The reference of a frame is not held here."""


@dataclasses.dataclass
class FrameHeader:
    """The 56 bytes before a frame's body."""

    kind: int
    step_shift: int
    sequence: int
    reference: int
    reference_checksum: int
    revision: int
    largest_move: float
    """Of the whole surface, cells."""
    sent_pages: int
    body_bytes: int
    checksum: int
    sent: list[int] = dataclasses.field(default_factory=list)
    """Numbers of the pages whose values it has."""


@dataclasses.dataclass
class PageState:
    """The values of a page."""

    values: npt.NDArray[np.int32]
    """n x 3, in 1/256 cell."""
    gain: int = 0
    """Exponent of two."""
    held: Ints = dataclasses.field(default_factory=lambda: np.zeros(0, np.int64))
    """Vertices that stay where they are, whatever the values are."""


def read_frame_header(data: bytes) -> FrameHeader:
    """Returns the header of a frame. Raises Damaged."""
    require(len(data) >= 56 and data[:4] == b"BnFr" and data[4] == 2, "not a frame of version 2")
    kind, step_shift, zero = struct.unpack_from("<3B", data, 5)
    numbers = struct.unpack_from("<3QIf2IQ", data, 8)
    require(numbers[-1] == checksum(data, 56), "the frame's checksum is wrong")
    require(kind <= 1 and step_shift <= 7 and zero == 0 and numbers[1] < numbers[0],
            "a field is wrong")
    return FrameHeader(kind, step_shift, *numbers)


class FrameDecoder:
    """Turns the frames of one stream into displacements. `layout_of(page, kind)` gives the layout of
    a page that the client has."""

    def __init__(self, layout_of: Callable[[int, int], Layout]) -> None:
        self._layout_of = layout_of
        self.revisions: dict[int, list[int]] = {0: []}
        """Numbers of the shown pages, rising."""
        self.layouts: dict[int, Layout] = {}
        """By page, of the present kind."""
        self.kind: int | None = None
        self.state: dict[int, PageState] = {}
        self._held: dict[int, tuple[int, dict[int, PageState]]] = {}
        self._chain: tuple[list[Layout], Chain] | None = None

    def show(self, added: Iterable[int], removed: Iterable[int] = ()) -> int:
        """Makes the next revision. Returns its number."""
        newest = max(self.revisions)
        shown = (set(self.revisions[newest]) | set(added)) - set(removed)
        self.revisions[newest + 1] = sorted(shown)
        return newest + 1

    def decode(self, data: bytes) -> FrameHeader:
        """Returns the header. A frame that fails changes nothing.

        Raises MissingReference for a frame whose reference is not held, and Damaged.
        """
        frame = read_frame_header(data)
        require(frame.revision in self.revisions, "a revision that nobody asked for")
        require(frame.sequence > max(self._held, default=0), "a late frame")
        reference = self._reference_of(frame)
        pages = self.revisions[frame.revision]
        layouts = {page: self._layout(page, frame.kind) for page in pages}
        sizes = [layouts[page].size for page in pages]
        vertices = [layouts[page].vertices for page in pages]
        require(frame.body_bytes <= body_bytes_max(sizes, vertices),
                "a body is longer than its pages")
        body = Body(decompress(data[56:], frame.body_bytes), sizes, vertices)
        frame.sent = [page for page, flag in zip(pages, body.flags) if flag & SENT]
        require(len(frame.sent) == frame.sent_pages, "other pages are sent than announced")
        state = {page: reference.get(page, PageState(np.zeros((size, 3), np.int32)))
                 for page, size in zip(pages, sizes)}
        gains, held = iter(body.gains), iter(body.held)
        for page, flag in zip(pages, body.flags):
            if flag & HAS_GAIN:
                state[page] = dataclasses.replace(state[page], gain=next(gains))
            if flag & HAS_HELD:
                state[page] = dataclasses.replace(state[page], held=next(held))
        self._move(state, layouts, frame, body)
        self._keep(frame, state, layouts)
        return frame

    def forget(self) -> None:
        """Forgets all held frames."""
        self._held = {}

    def displacements(self, page: int) -> npt.NDArray[np.float64]:
        """Returns the n x 3 displacements of a page's vertices, cells."""
        moves = self.layouts[page].at_vertices(self.state[page].values / 256)
        moves[self.state[page].held] = 0
        return moves

    def _layout(self, page: int, kind: int) -> Layout:
        known = self.layouts.get(page)
        return known if known and known.kind == kind else self._layout_of(page & ~COLOURS, kind)

    def _reference_of(self, frame: FrameHeader) -> dict[int, PageState]:
        if not frame.reference:
            return {}
        held = self._held.get(frame.reference)
        if not held or held[0] != frame.reference_checksum or frame.kind != self.kind:
            raise MissingReference(f"frame {frame.sequence} needs frame {frame.reference}")
        return held[1]

    def _move(self, state: dict[int, PageState], layouts: dict[int, Layout], frame: FrameHeader,
              body: Body) -> None:
        """Moves the sent pages."""
        if not frame.sent:
            return
        k = self._chain_of([layouts[page] for page in frame.sent]).undo(body.residuals()).T
        first, shift = 0, frame.step_shift
        for page in frame.sent:
            old = state[page]
            end = first + len(old.values)
            rounded = wrap(old.values.astype(np.int64) + (1 << shift >> 1)) >> shift
            moved = wrap((rounded + k[first:end]) << shift).astype(np.int32)
            state[page] = dataclasses.replace(old, values=moved)
            first = end

    def _chain_of(self, layouts: list[Layout]) -> Chain:
        """Returns the chain of these pages. Keeps the last one: frames often send the same pages."""
        if self._chain is None or self._chain[0] != layouts:
            self._chain = layouts, Chain(layouts)
        return self._chain[1]

    def _keep(self, frame: FrameHeader, state: dict[int, PageState],
              layouts: dict[int, Layout]) -> None:
        if frame.kind != self.kind:
            self.forget()
        if frame.reference:
            self._held = {sequence: held for sequence, held in self._held.items()
                          if sequence >= frame.reference}
        self._held[frame.sequence] = frame.checksum, state
        self.kind, self.state, self.layouts = frame.kind, state, layouts
        self.revisions = {revision: pages for revision, pages in self.revisions.items()
                          if revision >= frame.revision}
