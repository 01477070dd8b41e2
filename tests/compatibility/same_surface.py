"""Compares two PLY files of one scan: their vertices are within the bar of two exact exports.

Usage: same_surface.py A.ply B.ply      prints the distance over the diagonal; exit code 1 above the bar
"""

import re
import sys

import numpy as np

BAR = 2e-5  # each may use all of the 1e-5 of an exact export


def vertices_of(path):
    """Reads the float positions at the beginning of each vertex of a binary PLY."""
    data = open(path, "rb").read()
    header, body = data.split(b"end_header\n", 1)
    count = int(re.search(rb"element vertex (\d+)", header)[1])
    kinds = re.findall(rb"property (float|double|uchar) \w+", header.split(b"element face")[0])
    row = np.dtype([(f"p{at}", {b"float": "<f4", b"double": "<f8", b"uchar": "u1"}[kind])
                    for at, kind in enumerate(kinds)])
    rows = np.frombuffer(body, row, count)
    return np.stack([rows[f"p{axis}"] for axis in range(3)], axis=1).astype(float)


def main(one, other):
    a, b = vertices_of(one), vertices_of(other)
    distance = np.linalg.norm(a - b, axis=1).max() / np.linalg.norm(np.ptp(a, axis=0))
    print(f"{other}: {distance:.2g} of the diagonal from {one}; the bar is {BAR:g}")
    return 0 if distance <= BAR else 1


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
