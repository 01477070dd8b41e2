"""Surfaces as arrays, and the PLY in which the program `burnish` takes and returns them."""

from __future__ import annotations

import dataclasses
from typing import Any

import numpy as np
import numpy.typing as npt

from .edits import rows

BYTE_MAX = 255
Floats = npt.NDArray[Any]
Ints = npt.NDArray[np.int64]


@dataclasses.dataclass(frozen=True)
class Polygons:
    """Faces of any number of vertices."""

    sizes: Ints
    """m numbers of vertices, 3 at least."""
    corners: Ints
    """The indices of all faces' vertices, face by face."""


def polygons_of(faces: Any, vertices: int) -> Polygons:
    """Returns faces that are given as m x 3, m x 4, m x k with -1 behind the last vertex of a face,
    flat (n i0 i1 ... n i0 i1 ..., as VTK has them), or as a sequence of sequences.

    Raises ValueError for a face of fewer than 3 vertices and for an index outside `vertices`.
    """
    polygons = _split(faces)
    few = np.flatnonzero(polygons.sizes < 3)
    if len(few):
        raise ValueError(f"faces[{few[0]}] has {polygons.sizes[few[0]]} vertices: 3 at least")
    wrong = np.flatnonzero((polygons.corners < 0) | (polygons.corners >= vertices))
    if len(wrong):
        face = np.searchsorted(np.cumsum(polygons.sizes), wrong[0], side="right")
        raise ValueError(f"faces[{face}] has the index {polygons.corners[wrong[0]]}: it must be "
                         f"within 0 to {vertices - 1}")
    return polygons


def _split(faces: Any) -> Polygons:
    try:
        array = np.asarray(faces)
    except ValueError:  # the sequences have different lengths
        array = np.empty(0, object)
    if array.dtype == object:
        return _split_sequences(faces)
    whole = _whole(array)
    if whole.ndim == 1 and whole.size:
        return _split_flat(whole)
    if whole.ndim != 2:
        raise ValueError(f"faces has the shape {whole.shape}: it must be (m, k), or flat")
    used = whole >= 0
    if (used[:, 1:] & ~used[:, :-1]).any():
        face = int(np.flatnonzero((used[:, 1:] & ~used[:, :-1]).any(axis=1))[0])
        raise ValueError(f"faces[{face}] is {whole[face].tolist()}: a negative index is allowed "
                         "behind the last vertex alone")
    return Polygons(used.sum(axis=1), whole[used])


def _whole(array: npt.NDArray[Any]) -> Ints:
    if array.dtype.kind not in "iuf":
        raise TypeError(f"faces has values of type {array.dtype}: it takes indices of vertices")
    whole = array.astype(np.int64)
    if (whole != array).any():
        raise ValueError("faces has numbers that are not whole: it has indices of vertices")
    return whole


def _split_sequences(faces: Any) -> Polygons:
    parts = [_whole(np.asarray(face).ravel()) for face in faces]
    return Polygons(np.array([len(part) for part in parts], np.int64),
                    np.concatenate(parts) if parts else np.empty(0, np.int64))


def _split_flat(flat: Ints) -> Polygons:
    starts, at = [], 0
    while at < len(flat) and flat[at] > 0:
        starts.append(at)
        at += int(flat[at]) + 1
    if at != len(flat):
        raise ValueError(f"faces is flat, of {len(flat)} numbers, and the face at {starts[-1:]} "
                         f"leads to {at}: each face is its number of vertices and their indices")
    is_corner = np.ones(len(flat), bool)
    is_corner[starts] = False
    return Polygons(flat[starts], flat[is_corner])


def colours_of(colours: Any, vertices: int) -> npt.NDArray[Any]:
    """Returns n x 3 or n x 4 colours: bytes, or numbers of 0 to 1. Raises ValueError, TypeError."""
    array = np.asarray(colours)
    if array.ndim != 2 or array.shape[0] != vertices or array.shape[1] not in (3, 4):
        raise ValueError(f"colours has the shape {array.shape}: it must be ({vertices}, 3) or "
                         f"({vertices}, 4)")
    if array.dtype != np.uint8 and array.dtype.kind != "f":
        raise TypeError(f"colours has values of type {array.dtype}: it takes uint8, or floats of "
                        "0 to 1")
    if array.dtype.kind == "f" and not ((array >= 0) & (array <= 1)).all():
        raise ValueError(f"colours has values of {array.min()} to {array.max()}: floats must be "
                         "within 0 to 1")
    return array


class ArrayFile:
    """The PLY of a surface: positions in doubles, and colours in bytes where it has some."""

    def __init__(self, vertices: Any, faces: Any, colours: Any = None) -> None:
        """Raises ValueError, TypeError for arrays that are not a surface."""
        self._given = np.asarray(vertices)
        self._places = rows(vertices, 3, "vertices")
        bad = np.flatnonzero(~np.isfinite(self._places).all(axis=1))
        if len(bad):
            raise ValueError(f"vertices[{bad[0]}] is {self._places[bad[0]].tolist()}: it must be "
                             "finite")
        self._polygons = polygons_of(faces, len(self._places))
        self._colours = None if colours is None else colours_of(colours, len(self._places))
        fields: list[Any] = [("place", "<f8", 3)]
        self._record = np.dtype(fields + ([] if colours is None else [("colour", "u1", 3)]))

    def to_bytes(self) -> bytes:
        """Returns the file."""
        wide = len(self._polygons.sizes) and self._polygons.sizes.max() > BYTE_MAX
        count = np.dtype("<u4" if wide else "u1")
        properties = [f"property double {axis}" for axis in "xyz"]
        if self._colours is not None:
            properties += [f"property uchar {channel}" for channel in ("red", "green", "blue")]
        lines = ["ply", "format binary_little_endian 1.0", f"element vertex {len(self._places)}",
                 *properties, f"element face {len(self._polygons.sizes)}",
                 f"property list {'uint' if wide else 'uchar'} int vertex_indices", "end_header\n"]
        records = np.zeros(len(self._places), self._record)
        records["place"] = self._places
        if self._colours is not None:
            records["colour"] = _bytes_of(self._colours[:, :3])
        return "\n".join(lines).encode() + records.tobytes() + _face_bytes(self._polygons, count)

    def read(self, data: bytes) -> tuple[Floats, npt.NDArray[Any] | None]:
        """Returns the vertices, and the colours, of such a file with other values. They have the
        types of what was given; integers become doubles."""
        start = data.index(b"end_header\n") + len(b"end_header\n")
        records = np.frombuffer(data, self._record, len(self._places), start)
        kind = self._given.dtype if self._given.dtype.kind == "f" else np.dtype(np.float64)
        colours = None
        if self._colours is not None:
            colours = self._colours.copy()
            changed = records["colour"] != _bytes_of(self._colours[:, :3])
            full = 1 if colours.dtype == np.uint8 else BYTE_MAX
            colours[:, :3][changed] = (records["colour"] / full).astype(colours.dtype)[changed]
        return records["place"].astype(kind), colours


def _bytes_of(colours: npt.NDArray[Any]) -> npt.NDArray[np.uint8]:
    if colours.dtype == np.uint8:
        return np.asarray(colours, np.uint8)
    return np.asarray(np.rint(colours.astype(np.float64) * BYTE_MAX), np.uint8)


def _face_bytes(polygons: Polygons, count: np.dtype[Any]) -> bytes:
    """Returns the records of the faces: all those of one size at once."""
    widths = count.itemsize + 4 * polygons.sizes
    ends, lasts = np.cumsum(widths), np.cumsum(polygons.sizes)
    data = np.zeros(int(ends[-1]) if len(ends) else 0, np.uint8)
    for size in np.unique(polygons.sizes).tolist():
        chosen = np.flatnonzero(polygons.sizes == size)
        record = np.zeros(len(chosen), [("count", count), ("corners", "<i4", size)])
        record["count"] = size
        record["corners"] = polygons.corners[(lasts[chosen] - size)[:, None] + np.arange(size)]
        width = record.dtype.itemsize
        places = (ends[chosen] - width)[:, None] + np.arange(width)
        data[places] = record.view(np.uint8).reshape(-1, width)
    return data.tobytes()
