"""Meshes as arrays, and their PLY files."""

import unittest

import numpy as np

import burnish
from burnish.mesh import read_ply

SQUARE = burnish.Mesh([[0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0]], [[0, 1, 2], [0, 2, 3]])


class Meshes(unittest.TestCase):
    def test_a_mesh_comes_back_from_its_ply(self):
        mesh = read_ply(SQUARE.to_ply())
        np.testing.assert_array_equal(mesh.vertices, SQUARE.vertices)
        np.testing.assert_array_equal(mesh.faces, SQUARE.faces)

    def test_a_square_has_its_area_and_bounds(self):
        self.assertEqual(SQUARE.area, 4)
        np.testing.assert_array_equal(SQUARE.bounds, [[0, 0, 0], [2, 2, 0]])

    def test_a_big_endian_ply_with_more_properties_is_read(self):
        header = ("ply\nformat binary_big_endian 1.0\nelement vertex 3\nproperty float x\n"
                  "property float y\nproperty float z\nproperty uchar red\nelement face 1\n"
                  "property list uchar int vertex_indices\nend_header\n")
        vertices = np.zeros(3, [("p", ">f4", 3), ("red", "u1")])
        vertices["p"] = np.arange(9).reshape(3, 3)
        face = b"\x03" + np.array([2, 1, 0], ">i4").tobytes()
        mesh = read_ply(header.encode() + vertices.tobytes() + face)
        np.testing.assert_array_equal(mesh.vertices[2], [6, 7, 8])
        np.testing.assert_array_equal(mesh.faces, [[2, 1, 0]])

    def test_other_plys_are_refused(self):
        quad = SQUARE.to_ply().replace(b"\x03\x00\x00\x00\x00\x01", b"\x04\x00\x00\x00\x00\x01")
        for data, words in {b"solid": "not a PLY", SQUARE.to_ply()[:-1]: "cut off",
                            quad: "4 vertices",
                            b"ply\nformat ascii 1.0\nend_header\n": "not binary"}.items():
            with self.subTest(words), self.assertRaisesRegex(burnish.InvalidArgument, words):
                read_ply(data)

    def test_arrays_of_another_shape_are_refused(self):
        with self.assertRaisesRegex(ValueError, r"vertices.*\(4, 2\).*\(n, 3\)"):
            burnish.Mesh(np.zeros((4, 2)), SQUARE.faces)

    def test_faces_of_broken_numbers_are_refused(self):
        with self.assertRaisesRegex(ValueError, "faces.*whole"):
            burnish.Mesh(SQUARE.vertices, SQUARE.faces + 0.5)


if __name__ == "__main__":
    unittest.main()
