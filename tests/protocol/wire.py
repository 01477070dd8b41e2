"""Views and frames, decoded as docs/protocol.md says. Arrays are NumPy's, one row per element."""

import dataclasses
import io
import struct

import numpy as np
import xxhash
import zstandard

TILE_VALUES = 2048
NONE = TILE_VALUES  # of a predictor: stands for 0
COEFFICIENTS, VERTICES = 0, 1


class Damaged(Exception):
    """Bytes that are not what they should be."""


class MissingReference(Exception):
    """A frame is the difference to one that is not held here."""


def require(condition, what):
    if not condition:
        raise Damaged(what)


def take(stream, count):
    data = stream.read(count)
    require(len(data) == count, "a stream is cut off")
    return data


def xxh3(data, seed=0):
    return xxhash.xxh3_64_intdigest(bytes(data), seed)


def checksum(data, header_bytes):
    """Of a view or a frame; the last 8 bytes of the header are the checksum's own."""
    return xxh3(data[header_bytes:], seed=xxh3(data[:header_bytes - 8]))


def decompress(data, size):
    require(zstandard.frame_content_size(data) == size, f"not one zstd frame of {size} bytes")
    return zstandard.ZstdDecompressor().decompress(data, max_output_size=size)


def unzigzag(words):
    return (words >> 1) ^ (~(words & 1) + 1).astype(words.dtype)


def morton_point(keys):
    """(i, j, k) of Morton keys: bit b of i, j, k is bit 3b, 3b+1, 3b+2."""
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


# ---- Views

@dataclasses.dataclass
class View:
    depth: int
    origin: np.ndarray          # the scan's units
    cell_size: float
    length_unit: float
    scan_vertices: int
    scan_triangles: int
    cells: np.ndarray           # Morton keys
    triangles: np.ndarray       # n x 3
    homes: np.ndarray           # index into cells, or -1
    locals: np.ndarray          # n x 3, float32
    strays: np.ndarray          # n x 3: positions of the vertices without a home
    colours: np.ndarray         # n x 4 bytes, or empty
    corners: np.ndarray = None       # Morton keys
    cell_corners: np.ndarray = None  # cells x 8, index into corners

    def __post_init__(self):
        offsets = np.array([(a & 1, a >> 1 & 1, a >> 2) for a in range(8)])
        places = morton_point(self.cells)[:, None, :] + offsets
        self.corners, index = np.unique(morton_key(places.reshape(-1, 3)), return_inverse=True)
        self.cell_corners = index.reshape(-1, 8)

    def weights(self):
        """Vertices x 8, float32: of the corners of each vertex's cell."""
        local = self.locals
        weights = np.ones((len(local), 8), np.float32)
        for a in range(8):
            for axis in range(3):
                at = local[:, axis]
                weights[:, a] *= at if a >> axis & 1 else np.float32(1) - at
        return weights

    def positions(self, displacements=None):
        """Of the vertices, displaced by so many cells each, in the scan's units."""
        positions = np.empty((len(self.homes), 3))
        home = self.homes >= 0
        positions[~home] = self.strays
        grid = morton_point(self.cells)[self.homes[home]] + self.locals[home].astype(float)
        if displacements is not None:
            grid += displacements[home]
        positions[home] = self.origin + self.cell_size * grid
        return positions

    def interpolate(self, corner_displacements):
        """The displacement of each vertex from those of the corners."""
        at_corners = corner_displacements[self.cell_corners[self.homes]]
        displacements = np.einsum("va,vax->vx", self.weights().astype(float), at_corners)
        displacements[self.homes < 0] = 0
        return displacements


def read_section(data, count, word, words_of_element, back):
    """Byte planes of words, which may be differences to the word `back` before."""
    words = count * words_of_element
    size = np.dtype(word).itemsize
    planes = np.frombuffer(decompress(data, words * size), np.uint8).reshape(size, words)
    values = np.ascontiguousarray(planes.T).view(word).reshape(words)
    if back:
        columns = unzigzag(values).reshape(-1, back)
        values = np.cumsum(columns, axis=0, dtype=word).reshape(words)
    return values.reshape(count, words_of_element)


def read_view(data):
    require(data[:4] == b"BnVw" and data[4] == 1, "not a view of version 1")
    numbers = struct.unpack_from("<5d2Q6Q6QQ", data, 8)
    require(numbers[-1] == checksum(data, 168), "the view's checksum is wrong")
    counts, sizes = numbers[7:13], numbers[13:19]
    ends = 168 + np.cumsum(sizes)
    require(ends[-1] == len(data), "the sections do not fill the view")
    kinds = [("<u8", 1, 1), ("<u4", 3, 3), ("<u4", 1, 1), ("<u4", 3, 0), ("<u8", 3, 0),
             ("<u4", 1, 0)]
    cells, triangles, homes, places, strays, colours = [
        read_section(data[end - size:end], count, *kind)
        for end, size, count, kind in zip(ends, sizes, counts, kinds)]
    return View(depth=data[5], origin=np.array(numbers[:3]), cell_size=numbers[3],
                length_unit=numbers[4], scan_vertices=numbers[5], scan_triangles=numbers[6],
                cells=cells[:, 0], triangles=triangles, homes=homes[:, 0].view(np.int32),
                locals=places.view(np.float32), strays=strays.view(np.float64),
                colours=colours.view(np.uint8))


# ---- Frames

class Layout:
    """Which values the frames of a view carry, and what predicts each."""

    def __init__(self, view, content):
        self.content = content
        if content == COEFFICIENTS:
            largest = np.zeros(len(view.corners), np.float32)
            home = view.homes >= 0
            np.maximum.at(largest, view.cell_corners[view.homes[home]], view.weights()[home])
            self.source = np.flatnonzero(largest > 0).astype("<i4")
            places = morton_point(view.corners[self.source])
            tiles = [self._grid_predictors(places[begin:begin + TILE_VALUES])
                     for begin in range(0, len(places), TILE_VALUES)]
            self.predictors = np.concatenate(tiles) if tiles else np.empty((0, 3), "<u2")
        else:
            vertices = np.flatnonzero(view.homes >= 0)
            within = np.minimum((view.locals[vertices] * np.float32(256)).astype(np.int64), 255)
            order = np.lexsort((vertices, morton_key(within), view.homes[vertices]))
            self.source = vertices[order].astype("<i4")
            self.predictors = np.full((len(order), 3), NONE, "<u2")
            index = np.arange(len(order)) % TILE_VALUES
            self.predictors[index > 0, 0] = index[index > 0] - 1
        self.fingerprint = xxh3(self.predictors.tobytes(),
                                seed=xxh3(self.source.tobytes(), seed=content))

    @staticmethod
    def _grid_predictors(places):
        index_of = {tuple(place): index for index, place in enumerate(places)}
        predictors = np.full((len(places), 3), NONE, "<u2")
        for index, (i, j, k) in enumerate(places):
            def at(x, y, z):
                return index_of.get((i - x, j - y, k - z), NONE)
            along = at(1, 0, 0), at(0, 1, 0), at(0, 0, 1)
            squares = [(along[0], along[1], at(1, 1, 0)), (along[0], along[2], at(1, 0, 1)),
                       (along[1], along[2], at(0, 1, 1))]
            whole = [square for square in squares if NONE not in square]
            alone = [one for one in along if one != NONE] + [index - 1 if index else NONE]
            predictors[index] = whole[0] if whole else (alone[0], NONE, NONE)
        return predictors

    @property
    def tile_sizes(self):
        count = len(self.source)
        return [min(TILE_VALUES, count - begin) for begin in range(0, count, TILE_VALUES)]


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
        """The next numbers of one tile and axis."""
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
        """In cells: of `count` corners or vertices, 0 for those that frames do not carry."""
        displacements = np.zeros((count, 3))
        displacements[self.layout.source] = self.state / 256
        return displacements

    def forget(self):
        """As if nothing had come."""
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
        k = np.zeros((TILE_VALUES + 1, 3), np.uint32)  # the last row is what NONE names
        predictors = self.layout.predictors[begin:begin + size].tolist()
        for i, (a, b, c) in enumerate(predictors):
            k[i] = residuals[i] + k[a] + k[b] - k[c]
        state[begin:begin + size] += (k[:size] << np.uint32(step_shift)).view(np.int32)
