"""A scan's sheets, decoded as docs/protocol.md says in section 6."""

import dataclasses
import struct

import numpy as np

from burnish.formats.normals import fold
from burnish.formats.pages import join_planes, unpack_bits
from burnish.formats.wire import checksum, decompress, require, unzigzag

GUTTER = 4


@dataclasses.dataclass
class SheetHead:
    pages: int
    """Checksum of the head of the pages."""
    blocks: int


@dataclasses.dataclass
class Charts:
    of_triangle: np.ndarray
    axes: np.ndarray
    """n x 2 x 3: u and v."""
    corners: np.ndarray
    """n x 2: u0 and v0, steps."""

    def places(self, positions, triangles, texels_per_step):
        """Returns m x 3 x 2 places of the triangles' corners in texels from those of their charts,
        without gutters."""
        points = positions[triangles].astype(float)
        on_plane = np.einsum("mki,mai->mka", points, self.axes[self.of_triangle])
        return (on_plane - self.corners[self.of_triangle][:, None]) * texels_per_step


@dataclasses.dataclass
class Sheet:
    page: int
    halving: int
    size: tuple
    density: float
    places: np.ndarray
    """n x 2: x and y of the charts."""
    webp: bytes


def read_head(data):
    require(data[:4] == b"BnSh" and data[4] == 1 and data[5] == GUTTER, "not a head")
    pages, _, blocks, zero, _, _, _, check = struct.unpack_from("<QQIIQQQQ", data, 8)
    require(zero == 0 and check == checksum(data, 64), "the head's checksum is wrong")
    require(len(data) == 64 + 24 * blocks, "the head has another size")
    return SheetHead(pages, blocks)


def words_of(data):
    """Returns the words of byte planes with the difference to the one before."""
    return np.cumsum(unzigzag(join_planes(data, 4).copy()), dtype=np.uint32)


def read_block(data):
    """Returns for each page its bytes of charts, its density, and bytes and size of its sheets."""
    require(data[:4] == b"BnSb" and data[4] == 1, "not a block")
    _, pages, sheets, _, check = struct.unpack_from("<IIIIQ", data, 8)
    require(check == checksum(data, 32), "the block's checksum is wrong")
    content = np.frombuffer(decompress(data[32:], 4 * (3 * pages + 2 * sheets)), np.uint8)
    words = words_of(content)
    chart_bytes, counts = words[:pages], words[pages:2 * pages]
    densities = words[2 * pages:3 * pages].copy().view("<f4")
    sheet_bytes, sizes = words[3 * pages:].reshape(2, sheets)
    ends = np.cumsum(counts)
    return [(chart_bytes[i], densities[i],
             list(zip(sheet_bytes[ends[i] - counts[i]:ends[i]],
                      [(size & 0xFFFF, size >> 16)
                       for size in sizes[ends[i] - counts[i]:ends[i]]])))
            for i in range(pages)]


def axes_of(codes, angles):
    """Returns n x 2 x 3 axes of charts."""
    x, y = codes.T / 32767
    z = 1 - abs(x) - abs(y)
    below = fold(codes[:, 0], codes[:, 1], 32767)
    x, y = (np.where(z < 0, folded / 32767, kept) for folded, kept in zip(below, (x, y)))
    normals = np.stack([x, y, z], axis=1)
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    x, y, z = normals.T
    g = np.where(z < 0, -1, 1)
    a = -1 / (g + z)
    first = np.stack([1 + g * x * x * a, g * x * y * a, -g * x], axis=1)
    turn = angles[:, None] * (2 * np.pi / 65536)
    u = np.cos(turn) * first + np.sin(turn) * np.cross(normals, first)
    return np.stack([u, np.cross(normals, u)], axis=1)


def read_charts(data, page, triangles):
    require(data[:4] == b"BnSc" and data[4] == 1, "not charts")
    number, charts, named, check = struct.unpack_from("<IHHQ", data, 8)
    require(check == checksum(data, 24), "the charts' checksum is wrong")
    require(number == page, "charts of another page")
    sizes = [(triangles + 7) // 8, 2 * named, 4 * charts, 2 * charts, 8 * charts]
    content = np.frombuffer(decompress(data[24:], sum(sizes)), np.uint8)
    turns, names, normals, angles, corners = np.split(content, np.cumsum(sizes)[:-1])
    turns = unpack_bits(turns, triangles)
    names = join_planes(names, 2)
    require(turns[0] == 1 and turns.sum() == named, "the turns name other charts")
    codes = np.stack([join_planes(half, 2).astype("<u2").view("<i2").astype(int)
                      for half in np.split(normals, 2)], axis=1)
    lows = np.stack([join_planes(half, 4).copy().view("<i4") for half in np.split(corners, 2)],
                    axis=1)
    return Charts(names[np.cumsum(turns) - 1].astype(int),
                  axes_of(codes, join_planes(angles, 2)), lows)


def read_sheet(data):
    require(data[:4] == b"BnSt" and data[4] == 1, "not a sheet")
    charts, page, halving = struct.unpack_from("<HIB", data, 6)
    width, height, density, check = struct.unpack_from("<HHfQ", data, 16)
    require(check == checksum(data, 32), "the sheet's checksum is wrong")
    at = data.index(b"RIFF", 32)
    content = np.frombuffer(decompress(data[32:at], 4 * charts), np.uint8)
    places = np.stack([join_planes(half, 2) for half in np.split(content, 2)], axis=1)
    return Sheet(page, halving, (width, height), density, places, data[at:])
