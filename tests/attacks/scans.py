"""Generated scans, as the bytes of a PLY file, with their SHA-256."""

import hashlib
import math
import struct

HEADER = """ply
format binary_little_endian 1.0
element vertex %d
property float x
property float y
property float z
element face %d
property list uchar int vertex_indices
end_header
"""


def _ply(vertices, triangles):
    file = bytearray((HEADER % (len(vertices), len(triangles))).encode())
    for vertex in vertices:
        file += struct.pack("<3f", *vertex)
    for triangle in triangles:
        file += struct.pack("<B3i", 3, *triangle)
    return bytes(file)


def sha256(file):
    return hashlib.sha256(file).hexdigest()


def two_triangles():
    return _ply([(0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0.1)], [(0, 1, 2), (1, 3, 2)])


def sphere(rows):
    """A bumpy sphere of about 4 rows^2 triangles."""
    columns = 2 * rows
    vertices = []
    for row in range(rows + 1):
        polar = math.pi * (row + 0.5) / (rows + 1)
        for column in range(columns):
            around = 2 * math.pi * column / columns
            radius = 1 + 0.05 * math.sin(7 * polar) * math.sin(5 * around)
            vertices.append((radius * math.sin(polar) * math.cos(around),
                             radius * math.sin(polar) * math.sin(around),
                             radius * math.cos(polar)))
    triangles = []
    for row in range(rows):
        for column in range(columns):
            a, b = row * columns + column, row * columns + (column + 1) % columns
            triangles += [(a, a + columns, b), (b, a + columns, b + columns)]
    return _ply(vertices, triangles)
