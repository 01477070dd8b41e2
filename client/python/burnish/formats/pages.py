"""Pages and their head, decoded as docs/protocol.md says in section 6."""

from __future__ import annotations

import dataclasses
import struct
from typing import Any

import numpy as np
import numpy.typing as npt

from .normals import normals_of, predicted_codes
from .walk import Walk
from .wire import Bytes, Ints, Words, checksum, decompress, require, unzigzag


@dataclasses.dataclass
class Page:
    """A piece of a scan's surface at one level of detail."""

    number: int
    border: int
    """So many of the first vertices are on the border: other pages have them too."""
    positions: Words
    """n x 3 places on the lattice of the head."""
    triangles: Ints
    """m x 3 indices of vertices, patch by patch."""
    patches: list[tuple[int, int]]
    """The finer page that each patch replaces, and its number of triangles."""
    normals: npt.NDArray[np.float64]
    """A unit vector per vertex, or for the vertices of the border alone."""
    colours: Bytes
    """n x 4: red, green, blue, alpha in sRGB; 0 x 4 for a scan without colours."""


@dataclasses.dataclass
class Head:
    """What all pages of a scan share."""

    bits: int
    """The lattice has 2^bits places a side."""
    origin: npt.NDArray[np.float64]
    """Corner of the cube, the scan's units."""
    side: float
    """Of the cube, the scan's units."""
    triangles: int
    """Of the scan."""
    level_pages: list[int]
    """Number of pages of each level, the scan itself first."""
    fingerprint: int
    """Its checksum."""

    @property
    def page_count(self) -> int:
        return sum(self.level_pages)

    def places(self, positions: Words) -> npt.NDArray[np.float64]:
        """Returns n x 3 places in the scan's units of positions of pages."""
        return np.asarray(self.origin + (positions + 0.5) * (self.side / (1 << self.bits)))


def read_head(data: bytes) -> Head:
    """Returns the head of a scan's pages. Raises Damaged."""
    require(len(data) >= 80 and data[:4] == b"BnPh" and data[4] == 1, "not a head of version 1")
    bits, levels = data[5], data[6]
    numbers = struct.unpack_from("<4d5Q", data, 8)
    require(numbers[-1] == checksum(data, 80), "the head's checksum is wrong")
    require(1 <= bits <= 24 and 1 <= levels <= 64 and len(data) >= 80 + 4 * levels,
            "a field of the head is wrong")
    return Head(bits, np.array(numbers[:3]), numbers[3], numbers[5],
                list(struct.unpack_from(f"<{levels}I", data, 80)), numbers[-1])


def unpack_bits(data: Bytes, count: int) -> Bytes:
    return np.unpackbits(data, bitorder="little")[:count]


def join_planes(data: Bytes, planes: int) -> npt.NDArray[Any]:
    """Returns the words of byte planes."""
    words = np.zeros((len(data) // max(planes, 1), 4), np.uint8)
    words[:, :planes] = data.reshape(planes, -1).T
    return words.view("<u4")[:, 0]


def read_positions(residuals: npt.NDArray[Any], first: tuple[int, ...], walk: Walk) -> Words:
    axes = []
    for axis in range(3):
        found: list[int] = []
        for residual, (a, b, c) in zip(residuals[axis].tolist(), walk.origins):
            prediction = found[a] + found[b] - found[c] if found else first[axis]
            found.append((prediction + residual) & 0xFFFFFFFF)
        axes.append(found)
    positions = np.array(axes, np.uint32).T
    require((positions < 1 << 24).all(), "a position is outside the lattice")
    return positions


def read_colours(planes: Bytes, walk: Walk) -> Bytes:
    green, red, blue, alpha = planes
    residuals = np.stack([red + green, green, blue + green, alpha])
    channels = []
    for channel in residuals.tolist():
        found: list[int] = []
        for residual, (a, b, _) in zip(channel, walk.origins):
            found.append(((found[a] + found[b]) // 2 + residual & 255) if found else residual)
        channels.append(found)
    return np.array(channels, np.uint8).T


@dataclasses.dataclass
class _Header:
    first: tuple[int, ...]
    flags: int
    planes: int
    number: int
    vertices: int
    triangles: int
    border: int
    patches: int
    steps: int
    named_vertices: int
    named_patches: int

    def section_bytes(self) -> list[int]:
        normals = self.vertices if self.flags & 1 else self.border
        return [4 * self.patches, (self.steps + 1) // 2, 2 * self.named_vertices,
                (self.triangles + 7) // 8 if self.patches > 1 else 0, 2 * self.named_patches,
                (self.vertices + 7) // 8, 3 * self.planes * self.vertices, 2 * normals,
                4 * self.vertices if self.flags & 2 else 0]


def _read_header(data: bytes) -> _Header:
    require(len(data) >= 48 and data[:4] == b"BnPg" and data[4] == 1, "not a page of version 1")
    fields = struct.unpack_from("<3BI8H3IQ", data, 5)
    zeros, first, check = (fields[2], fields[11]), fields[12:15], fields[15]
    require(check == checksum(data, 48), "the page's checksum is wrong")
    require(zeros == (0, 0) and fields[0] < 4 and fields[1] <= 4, "reserved bits are set")
    return _Header(first, *fields[:2], *fields[3:11])


def read_page(data: bytes) -> Page:
    """Returns a page. Raises Damaged."""
    header = _read_header(data)
    sizes = header.section_bytes()
    body = np.frombuffer(decompress(data[48:], sum(sizes)), np.uint8)
    finer, step, named, turn, patch, border_bits, place, code, colour = np.split(
        body, np.cumsum(sizes)[:-1])
    turns = unpack_bits(turn, header.triangles) if header.patches > 1 else np.zeros(
        header.triangles, np.uint8)
    walk = Walk(np.stack([step & 15, step >> 4], axis=1).ravel()[:header.steps].tolist(),
                join_planes(named, 2).tolist(), turns.tolist(), join_planes(patch, 2).tolist())
    require(len(walk.origins) == header.vertices and len(walk.triangles) == header.triangles,
            "the walk ends early")
    require(max(walk.patches, default=0) < max(header.patches, 1), "a patch that there is not")
    residuals = unzigzag(join_planes(place, header.planes)).reshape(3, -1) if header.planes else (
        np.zeros((3, header.vertices), np.uint32))
    positions = read_positions(residuals, header.first, walk)
    is_border = unpack_bits(border_bits, header.vertices).astype(bool)
    return _sorted(header, walk, positions, is_border,
                   np.cumsum(join_planes(finer, 4), dtype=np.uint32).tolist(),
                   code.reshape(2, -1),
                   read_colours(colour.reshape(4, -1), walk) if header.flags & 2 else
                   np.zeros((header.vertices, 0), np.uint8))


def _sorted(header: _Header, walk: Walk, positions: Words, is_border: npt.NDArray[np.bool_],
            finer: list[int], code: Bytes, colours: Bytes) -> Page:
    """Puts the vertices of the border first, and the triangles patch by patch."""
    triangles = np.array(walk.triangles, np.int64).reshape(-1, 3)
    has_normal = np.ones(header.vertices, bool) if header.flags & 1 else is_border
    codes = predicted_codes(triangles, positions)[has_normal] + unzigzag(code).T
    order = np.argsort(~is_border, kind="stable")
    number_of = np.argsort(order)
    by_patch = np.argsort(walk.patches, kind="stable")
    coded_order = np.argsort(~is_border[has_normal], kind="stable")
    normals = normals_of(codes.astype(np.uint8).view(np.int8).astype(np.int64))
    return Page(number=header.number, border=int(is_border.sum()), positions=positions[order],
                triangles=number_of[triangles[by_patch]],
                patches=list(zip(finer, np.bincount(np.array(walk.patches, np.int64),
                                                    minlength=header.patches).tolist())),
                normals=normals[coded_order],
                colours=colours[order] if header.flags & 2 else np.zeros((0, 4), np.uint8))
