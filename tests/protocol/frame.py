"""Decodes frames by section 7 of docs/protocol.md. Arrays are NumPy's, a row per value."""

import dataclasses
import io
import struct

import numpy as np

from layout import TILE_VALUES
from wire import checksum, decompress, require, unzigzag


class MissingReference(Exception):
    """The reference of a frame is not held here."""


def take(stream, count):
    data = stream.read(count)
    require(len(data) == count, "a stream is cut off")
    return data


@dataclasses.dataclass
class Frame:
    content: int
    step_shift: int
    sequence: int
    reference: int
    reference_checksum: int
    fingerprint: int
    sent_tiles: int
    body_bytes: int
    checksum: int


def read_frame_header(data):
    require(len(data) >= 64 and data[:4] == b"BnFr" and data[4] == 1, "not a frame of version 1")
    content, step_shift, _ = struct.unpack_from("<3B", data, 5)
    numbers = struct.unpack_from("<4Q2I2Q", data, 8)
    require(numbers[-1] == checksum(data, 64), "the frame's checksum is wrong")
    require(content <= 1 and step_shift <= 7 and numbers[1] < numbers[0], "a field is wrong")
    return Frame(content, step_shift, *numbers[:6], numbers[7])


class Body:
    """The six streams of a frame's body."""

    def __init__(self, data, layout):
        streams = io.BytesIO(data)
        sizes = layout.tile_sizes
        self.sent = [tile for tile, flag in enumerate(take(streams, len(sizes))) if flag]
        groups = [-(-sizes[tile] // 16) for tile in self.sent for axis in range(3)]
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
        """Returns the next numbers of one tile and axis."""
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


class FrameDecoder:
    """Turns the frames of one stream into displacements."""

    def __init__(self, layout):
        self.layout = layout
        self.state = np.zeros((len(layout.source), 3), np.int32)  # in 1/256 cell
        self._held = {}  # sequence: (checksum, state)

    def decode(self, data):
        """Returns the header. A frame that fails changes nothing."""
        frame = read_frame_header(data)
        require((frame.content, frame.fingerprint) ==
                (self.layout.content, self.layout.fingerprint), "a frame of another layout")
        require(frame.sequence > max(self._held, default=0), "a late frame")
        state = self._reference_of(frame).copy()
        body = Body(decompress(data[64:], frame.body_bytes), self.layout)
        require(len(body.sent) == frame.sent_tiles, "other tiles are sent than announced")
        for tile in body.sent:
            self._add_tile(tile, frame.step_shift, body, state)
        if frame.reference:
            self._held = {sequence: held for sequence, held in self._held.items()
                          if sequence >= frame.reference}
        self._held[frame.sequence] = frame.checksum, state
        self.state = state
        return frame

    def displacements(self, count):
        """Returns `count` displacements in cells; 0 for corners or vertices that frames leave out."""
        displacements = np.zeros((count, 3))
        displacements[self.layout.source] = self.state / 256
        return displacements

    def forget(self):
        """Forgets all held frames."""
        self._held = {}

    def _reference_of(self, frame):
        if not frame.reference:
            return np.zeros_like(self.state)
        known, state = self._held.get(frame.reference, (None, None))
        if known != frame.reference_checksum:
            raise MissingReference(f"frame {frame.sequence} needs frame {frame.reference}")
        return state

    def _add_tile(self, tile, step_shift, body, state):
        begin, size = tile * TILE_VALUES, self.layout.tile_sizes[tile]
        residuals = np.stack([unzigzag(body.read_axis(size)) for axis in range(3)], axis=1)
        k = np.zeros((TILE_VALUES + 1, 3), np.uint32)  # the last row stands for NONE
        predictors = self.layout.predictors[begin:begin + size].tolist()
        for i, (a, b, c) in enumerate(predictors):
            k[i] = residuals[i] + k[a] + k[b] - k[c]
        state[begin:begin + size] += (k[:size] << np.uint32(step_shift)).view(np.int32)
