"""Meshes of the comparison: PLY files in and out, and vertices at one place made one."""

import dataclasses
import pathlib

import numpy as np

TYPES = {"double": "<f8", "float": "<f4", "uchar": "u1", "int": "<i4", "uint": "<u4"}
TRIANGLE = np.dtype([("count", "u1"), ("corners", "<u4", 3)])


@dataclasses.dataclass
class Shape:
    """A noisy mesh. Peers see vertices at one place as one: they take seams for borders."""

    points: np.ndarray  # n x 3, welded
    triangles: np.ndarray  # m x 3, of the welded points
    place_of: np.ndarray  # of each vertex in the file, its welded point
    file_triangles: np.ndarray

    @staticmethod
    def read(path: pathlib.Path) -> "Shape":
        points, triangles = read_ply(path)
        places, place_of = np.unique(points, axis=0, return_inverse=True)
        if len(places) == len(points):
            places, place_of = points, np.arange(len(points))
        return Shape(places, place_of[triangles], place_of, triangles)

    def write_welded(self, path: pathlib.Path) -> None:
        write_ply(self.points, self.triangles, path)

    def write(self, points: np.ndarray, path: pathlib.Path) -> None:
        """Writes the file's mesh with these welded points."""
        write_ply(points[self.place_of], self.file_triangles, path)


def read_ply(path: pathlib.Path) -> tuple[np.ndarray, np.ndarray]:
    """Returns points and triangles of a binary PLY file whose faces are triangles."""
    with open(path, "rb") as file:
        counts: list[int] = []
        fields: list[tuple[str, str]] = []
        while (words := file.readline().decode().split()) != ["end_header"]:
            if words[0] == "element":
                counts.append(int(words[2]))
            elif words[0] == "property" and len(counts) == 1:
                fields.append((words[2], TYPES[words[1]]))
        vertices = np.fromfile(file, fields, counts[0])
        faces = np.fromfile(file, TRIANGLE, counts[1])
    points = np.column_stack([vertices[axis].astype(float) for axis in "xyz"])
    return points, faces["corners"].astype(np.int64)


def write_ply(points: np.ndarray, triangles: np.ndarray, path: pathlib.Path) -> None:
    faces = np.empty(len(triangles), TRIANGLE)
    faces["count"], faces["corners"] = 3, triangles
    axes = "".join(f"property double {axis}\n" for axis in "xyz")
    head = (f"ply\nformat binary_little_endian 1.0\nelement vertex {len(points)}\n{axes}"
            f"element face {len(faces)}\nproperty list uchar uint vertex_indices\nend_header\n")
    with open(path, "wb") as file:
        file.write(head.encode() + points.astype("<f8").tobytes() + faces.tobytes())
