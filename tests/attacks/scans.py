"""Generated scans, as the bytes of a PLY file, with their SHA-256."""

import hashlib
import io
import math
import random
import struct
import zipfile
import zlib

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


def needles(vertices, triangles):
    """Triangles between vertices at random in a cube."""
    chance = random.Random(1)
    places = [(chance.random(), chance.random(), chance.random()) for _ in range(vertices)]
    return _ply(places, [chance.sample(range(vertices), 3) for _ in range(triangles)])


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


def _png_of_zeros(width, height):
    """Grey pixels, all zero. A comment makes the file large enough for so many pixels."""
    packer, rows = zlib.compressobj(9), b""
    for _ in range(height):
        rows += packer.compress(bytes(width + 1))
    rows += packer.flush()
    header = struct.pack(">IIBBBBB", width, height, 8, 0, 0, 0, 0)
    comment = b"Comment" + bytes(8000)
    chunks = ((b"IHDR", header), (b"tEXt", comment), (b"IDAT", rows), (b"IEND", b""))
    return b"\x89PNG\r\n\x1a\n" + b"".join(
        struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))
        for kind, body in chunks)


def textured_zip(width, height):
    """A square as OBJ with a picture of zeros, in a small archive."""
    obj = ("mtllib s.mtl\nusemtl s\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0.1\n"
           "vt 0 0\nvt 1 0\nvt 0 1\nvt 1 1\nf 1/1 2/2 3/3\nf 2/2 4/4 3/3\n")
    file = io.BytesIO()
    with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as archive:
        archive.writestr("s.obj", obj)
        archive.writestr("s.mtl", "newmtl s\nmap_Kd s.png\n")
        archive.writestr("s.png", _png_of_zeros(width, height))
    return file.getvalue()
