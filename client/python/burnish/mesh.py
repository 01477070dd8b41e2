"""Meshes as NumPy arrays, and their PLY files."""

from __future__ import annotations

import dataclasses

import numpy as np
import numpy.typing as npt

from ._channel import PathLike
from .edits import rows
from .errors import InvalidArgument

_TYPES = {"char": "i1", "uchar": "u1", "short": "i2", "ushort": "u2", "int": "i4", "uint": "u4",
          "float": "f4", "double": "f8", "int8": "i1", "uint8": "u1", "int16": "i2",
          "uint16": "u2", "int32": "i4", "uint32": "u4", "float32": "f4", "float64": "f8"}
_FACE = np.dtype([("count", "u1"), ("vertices", "<i4", 3)])


@dataclasses.dataclass
class Mesh:
    """Triangles on vertices."""

    vertices: npt.NDArray[np.float64]
    """n x 3, in the scan's own units."""
    faces: npt.NDArray[np.int64]
    """m x 3 indices of vertices."""

    def __post_init__(self) -> None:
        self.vertices = rows(self.vertices, 3, "vertices")
        faces = rows(self.faces, 3, "faces")
        self.faces = faces.astype(np.int64)
        if (self.faces != faces).any():
            raise ValueError("faces has numbers that are not whole: it has indices of vertices")

    @property
    def bounds(self) -> npt.NDArray[np.float64]:
        """2 x 3: the least and the largest coordinates."""
        return np.array([self.vertices.min(axis=0), self.vertices.max(axis=0)])

    @property
    def area(self) -> float:
        """Of all triangles, the scan's units squared."""
        a, b, c = (self.vertices[self.faces[:, corner]] for corner in range(3))
        return float(np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2)

    def to_ply(self) -> bytes:
        """Returns the mesh as a binary PLY with double positions."""
        header = ("ply\nformat binary_little_endian 1.0\n"
                  f"element vertex {len(self.vertices)}\n"
                  "property double x\nproperty double y\nproperty double z\n"
                  f"element face {len(self.faces)}\n"
                  "property list uchar int vertex_indices\nend_header\n")
        faces = np.zeros(len(self.faces), _FACE)
        faces["count"], faces["vertices"] = 3, self.faces
        return header.encode() + self.vertices.astype("<f8").tobytes() + faces.tobytes()


def load_ply(path: PathLike) -> Mesh:
    """Returns the mesh of a binary PLY of triangles. Raises InvalidArgument for another one."""
    with open(path, "rb") as file:
        return read_ply(file.read())


def read_ply(data: bytes) -> Mesh:
    """As load_ply(), of a file's bytes."""
    head, found, body = data.partition(b"end_header\n")
    lines = [line.split() for line in head.decode("ascii", "replace").splitlines()]
    if not found or lines[:1] != [["ply"]]:
        raise InvalidArgument("not a PLY file")
    order = {"binary_little_endian": "<", "binary_big_endian": ">"}.get(
        next((line[1] for line in lines if line[:1] == ["format"] and len(line) > 1), ""))
    if order is None:
        raise InvalidArgument("a PLY that is not binary: convert it with `burnish filter`")
    offset, elements = 0, {}
    for name, count, properties in _elements(lines):
        kind = _record(properties, order, name)
        if offset + count * kind.itemsize > len(body):
            raise InvalidArgument(f"the PLY is cut off in element {name}")
        elements[name] = np.frombuffer(body, kind, count, offset)
        offset += count * kind.itemsize
    vertex, face = elements["vertex"], elements["face"]
    if "count" not in (face.dtype.names or ()):
        raise InvalidArgument("the PLY has no list vertex_indices")
    sides = face["count"]
    if len(sides) and (sides != 3).any():
        raise InvalidArgument(f"the PLY has a face of {sides[sides != 3][0]} vertices, not 3")
    return Mesh(np.stack([vertex[axis] for axis in "xyz"], axis=1), face["vertices"])


def _elements(lines: list[list[str]]) -> list[tuple[str, int, list[list[str]]]]:
    found: list[tuple[str, int, list[list[str]]]] = []
    for line in lines:
        if line[:1] == ["element"]:
            found.append((line[1], int(line[2]), []))
        elif line[:1] == ["property"]:
            found[-1][2].append(line[1:])
    if not {"vertex", "face"} <= {name for name, *_ in found}:
        raise InvalidArgument("the PLY has no vertices or no faces")
    return found


def _record(properties: list[list[str]], order: str, element: str) -> np.dtype[np.void]:
    """Returns the type of an element's records. The lists of faces have 3 numbers."""
    fields: list[tuple[str, str] | tuple[str, str, int]] = []
    for words in properties:
        if words[0] != "list":
            fields.append((words[1], order + _TYPES[words[0]]))
        elif element == "face" and words[3] in ("vertex_indices", "vertex_index"):
            fields += [("count", order + _TYPES[words[1]]),
                       ("vertices", order + _TYPES[words[2]], 3)]
        else:
            raise InvalidArgument(f"the PLY has a list {words[3]} in element {element}")
    return np.dtype(fields)
