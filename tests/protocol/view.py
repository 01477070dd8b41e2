"""Decodes views by section 6 of docs/protocol.md. Arrays are NumPy's, a row per element."""

import dataclasses
import struct

import numpy as np

from wire import checksum, decompress, morton_key, morton_point, require, unzigzag


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
    strays: np.ndarray  # n x 3: positions of the vertices without a cell
    colours: np.ndarray         # n x 4 bytes, or empty
    corners: np.ndarray = None       # Morton keys
    cell_corners: np.ndarray = None  # cells x 8, index into corners

    def __post_init__(self):
        offsets = np.array([(a & 1, a >> 1 & 1, a >> 2) for a in range(8)])
        places = morton_point(self.cells)[:, None, :] + offsets
        self.corners, index = np.unique(morton_key(places.reshape(-1, 3)), return_inverse=True)
        self.cell_corners = index.reshape(-1, 8)

    def weights(self):
        """Returns vertices x 8, float32: the weights of the corners of each vertex's cell."""
        local = self.locals
        weights = np.ones((len(local), 8), np.float32)
        for a in range(8):
            for axis in range(3):
                at = local[:, axis]
                weights[:, a] *= at if a >> axis & 1 else np.float32(1) - at
        return weights

    def positions(self, displacements=None):
        """Returns the vertices, displaced by this many cells each, in the scan's units."""
        positions = np.empty((len(self.homes), 3))
        home = self.homes >= 0
        positions[~home] = self.strays
        grid = morton_point(self.cells)[self.homes[home]] + self.locals[home].astype(float)
        if displacements is not None:
            grid += displacements[home]
        positions[home] = self.origin + self.cell_size * grid
        return positions

    def interpolate(self, corner_displacements):
        """Returns the displacement of each vertex from those of the corners."""
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
