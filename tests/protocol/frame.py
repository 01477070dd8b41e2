"""Decodes frames by section 7 of docs/protocol.md. Arrays are NumPy's, a row per value."""

import dataclasses
import io
import struct

import numpy as np

from wire import checksum, decompress, require, unzigzag


class MissingReference(Exception):
    """The reference of a frame is not held here."""


def take(stream, count):
    data = stream.read(count)
    require(len(data) == count, "a stream is cut off")
    return data


@dataclasses.dataclass
class Frame:
    kind: int
    step_shift: int
    sequence: int
    reference: int
    reference_checksum: int
    revision: int
    largest_move: float  # cells
    sent_pages: int
    body_bytes: int
    checksum: int
    sent: list = None    # numbers of the pages whose values it has


@dataclasses.dataclass
class PageState:
    values: np.ndarray  # n x 3, in 1/256 cell
    gain: int = 0       # exponent of two


def read_frame_header(data):
    require(len(data) >= 56 and data[:4] == b"BnFr" and data[4] == 2, "not a frame of version 2")
    kind, step_shift, zero = struct.unpack_from("<3B", data, 5)
    numbers = struct.unpack_from("<3QIf2IQ", data, 8)
    require(numbers[-1] == checksum(data, 56), "the frame's checksum is wrong")
    require(kind <= 1 and step_shift <= 7 and zero == 0 and numbers[1] < numbers[0],
            "a field is wrong")
    return Frame(kind, step_shift, *numbers)


class Body:
    """The seven streams of a frame's body. `sizes`: values of each shown page."""

    def __init__(self, data, sizes):
        streams = io.BytesIO(data)
        self.flags = list(take(streams, len(sizes)))
        require(max(self.flags, default=0) <= 3, "a page has an unknown flag")
        self.gains = list(take(streams, sum(flag >> 1 for flag in self.flags)))
        groups = [-(-size // 16) for size, flag in zip(sizes, self.flags) if flag & 1
                  for axis in range(3)]
        self._widths = [self._read_widths(streams, count) for count in groups]
        widths = [width for axis in self._widths for width in axis]
        require(max(widths, default=0) <= 6, "a group is wider than 6")
        lengths = [sum(2 << (width - 1) for width in widths if 1 <= width <= 3),
                   16 * sum(width >= 4 for width in widths),
                   16 * sum(width >= 5 for width in widths),
                   32 * sum(width == 6 for width in widths)]
        self._streams = [io.BytesIO(take(streams, length)) for length in lengths]
        require(not streams.read(), "bytes follow the last stream")

    @staticmethod
    def _read_widths(streams, groups):
        pairs = take(streams, -(-groups // 2))
        return [width for pair in pairs for width in (pair & 15, pair >> 4)][:groups]

    def read_axis(self, size):
        """Returns the next numbers of one page and axis."""
        if not size:
            return self._widths.pop(0)
        return np.concatenate([self._group(width) for width in self._widths.pop(0)])[:size]

    def _group(self, width):
        packed, byte0, byte1, bytes23 = self._streams
        if width == 0:
            return np.zeros(16, np.uint32)
        if width <= 3:
            bits = 1 << (width - 1)
            word = int.from_bytes(packed.read(2 * bits), "little")
            return np.array([word >> (i * bits) & ((1 << bits) - 1) for i in range(16)], np.uint32)
        planes = [byte0, byte1, bytes23, bytes23][:1 << (width - 4)]
        pieces = [np.frombuffer(plane.read(16), np.uint8).astype(np.uint32) for plane in planes]
        return sum(piece << np.uint32(8 * byte) for byte, piece in enumerate(pieces))


def signed(number):
    """Returns a number modulo 2^32, as i32."""
    return (number + (1 << 31)) % (1 << 32) - (1 << 31)


def undo_axis(residuals, predictors):
    """Returns the numbers k of one axis."""
    k = []
    for residual, found in zip(residuals.tolist(), predictors):
        count = len(found)
        mean = (2 * sum(k[p] for p in found) + count) // (2 * count) if count else 0
        k.append(signed(residual + mean))
    return np.array(k, np.int64)


class FrameDecoder:
    """Turns the frames of one stream into displacements. `layout_of(page, kind)` gives the layout of
    a page that the client has."""

    def __init__(self, layout_of):
        self._layout_of = layout_of
        self.revisions = {0: []}  # numbers of the shown pages, rising
        self.layouts = {}         # by page, of the present kind
        self.kind = None
        self.state = {}           # PageState by page
        self._held = {}           # sequence: (checksum, state)

    def show(self, added, removed):
        """Makes the next revision. Returns its number."""
        newest = max(self.revisions)
        shown = (set(self.revisions[newest]) | set(added)) - set(removed)
        self.revisions[newest + 1] = sorted(shown)
        return newest + 1

    def decode(self, data):
        """Returns the header. A frame that fails changes nothing."""
        frame = read_frame_header(data)
        require(frame.revision in self.revisions, "a revision that nobody asked for")
        require(frame.sequence > max(self._held, default=0), "a late frame")
        reference = self._reference_of(frame)
        pages = self.revisions[frame.revision]
        layouts = {page: self._layout(page, frame.kind) for page in pages}
        sizes = [len(layouts[page].predictors) for page in pages]
        body = Body(decompress(data[56:], frame.body_bytes), sizes)
        frame.sent = [page for page, flag in zip(pages, body.flags) if flag & 1]
        require(len(frame.sent) == frame.sent_pages, "other pages are sent than announced")
        state = {page: reference.get(page, PageState(np.zeros((size, 3), np.int32)))
                 for page, size in zip(pages, sizes)}
        for page, flag in zip(pages, body.flags):
            if flag & 2:
                state[page] = PageState(state[page].values, body.gains.pop(0))
        for page in frame.sent:
            state[page] = self._move(state[page], layouts[page], frame.step_shift, body)
        self._keep(frame, state, layouts)
        return frame

    def forget(self):
        """Forgets all held frames."""
        self._held = {}

    def _layout(self, page, kind):
        known = self.layouts.get(page)
        return known if known and known.kind == kind else self._layout_of(page, kind)

    def _reference_of(self, frame):
        if not frame.reference:
            return {}
        known, state = self._held.get(frame.reference, (None, None))
        if known != frame.reference_checksum or frame.kind != self.kind:
            raise MissingReference(f"frame {frame.sequence} needs frame {frame.reference}")
        return state

    @staticmethod
    def _move(old, layout, shift, body):
        size = len(layout.predictors)
        residuals = [unzigzag(body.read_axis(size)).view(np.int32) for axis in range(3)]
        k = np.stack([undo_axis(axis, layout.predictors) for axis in residuals], axis=1)
        rounded = signed(old.values.astype(np.int64) + (1 << shift >> 1)) >> shift
        return PageState(signed((rounded + k) << shift).astype(np.int32), old.gain)

    def _keep(self, frame, state, layouts):
        if frame.kind != self.kind:
            self.forget()
        if frame.reference:
            self._held = {sequence: held for sequence, held in self._held.items()
                          if sequence >= frame.reference}
        self._held[frame.sequence] = frame.checksum, state
        self.kind, self.state, self.layouts = frame.kind, state, layouts
        self.revisions = {revision: pages for revision, pages in self.revisions.items()
                          if revision >= frame.revision}

    def displacements(self, page):
        """Returns the displacements of a page's vertices, cells."""
        return self.layouts[page].at_vertices(self.state[page].values / 256)
