"""A test's own scan, and the PLY files that it sends and receives."""

import numpy as np


def bumpy_sphere(levels=5):
    """A split icosahedron with waves on it, in doubles: (vertices, triangles). No triangle uses the
    last vertex, which lies far outside."""
    golden = (1 + 5**0.5) / 2
    vertices = np.array([(s, t * golden, 0) for s in (-1, 1) for t in (-1, 1)])
    vertices = np.concatenate([np.roll(vertices, turn, axis=1) for turn in range(3)])
    edge = 2.0
    near = np.linalg.norm(vertices[:, None] - vertices, axis=2) < edge * 1.01
    triangles = np.array([(a, b, c) for a in range(12) for b in range(a) for c in range(b)
                          if near[a, b] and near[b, c] and near[c, a]])
    inwards = np.linalg.det(vertices[triangles]) < 0
    triangles[inwards] = triangles[inwards][:, ::-1]
    for _ in range(levels):
        vertices, triangles = split(vertices, triangles)
    directions = vertices / np.linalg.norm(vertices, axis=1)[:, None]
    waves = np.sin(9 * directions).sum(axis=1) + 0.3 * np.sin(31 * directions).prod(axis=1)
    vertices = directions * (10 + 0.2 * waves)[:, None]
    return np.concatenate([vertices, [[12.5, 0, 0]]]), triangles


def split(vertices, triangles):
    """Splits each triangle in four."""
    edges = np.sort(np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]],
                                    triangles[:, [2, 0]]]), axis=1)
    edges, index = np.unique(edges, axis=0, return_inverse=True)
    middle = len(vertices) + index.reshape(3, -1)
    a, b, c = triangles.T
    ab, bc, ca = middle
    pieces = [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
    return (np.concatenate([vertices, vertices[edges].mean(axis=1)]),
            np.concatenate([np.stack(piece, axis=1) for piece in pieces]))


def write_ply(vertices, triangles):
    header = (f"ply\nformat binary_little_endian 1.0\nelement vertex {len(vertices)}\n"
              "property double x\nproperty double y\nproperty double z\n"
              f"element face {len(triangles)}\n"
              "property list uchar int vertex_indices\nend_header\n")
    faces = np.zeros(len(triangles), FACE)
    faces["count"], faces["vertices"] = 3, triangles
    return header.encode() + vertices.astype("<f8").tobytes() + faces.tobytes()


def read_ply(data):
    """Reads a file in the form of write_ply(), also from the server: (vertices, triangles)."""
    header, body = data.split(b"end_header\n", 1)
    counts = [int(line.split()[2]) for line in header.splitlines() if line.startswith(b"element")]
    assert header.count(b"property double") == 3 and header.count(b"property") == 4, header
    vertices = np.frombuffer(body, "<f8", 3 * counts[0]).reshape(-1, 3)
    return vertices, np.frombuffer(body, FACE, counts[1], vertices.nbytes)["vertices"]


FACE = np.dtype([("count", "u1"), ("vertices", "<i4", 3)])
