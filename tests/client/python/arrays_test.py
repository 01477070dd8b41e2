"""Surfaces as arrays: triangles, quads, polygons, any float type, and colours."""

import unittest

import numpy as np

import burnish
import scan

SMOOTH = {"beta": 0, "alpha": 5, "depth": 4}
VERTICES, FACES = scan.bumpy_sphere(3)


def cube(side):
    """Returns a cube with steps on it, of side x side quads a side: (vertices, quads)."""
    places, quads, number_of = [], [], {}

    def number(place):
        if place not in number_of:
            number_of[place] = len(places)
            places.append(np.array(place) + 0.2 * (sum(place) % 2))
        return number_of[place]
    for axis in range(3):
        for level in (0, side):
            for a in range(side):
                for b in range(side):
                    corners = [np.roll((level, *corner), axis).tolist()
                               for corner in ((a, b), (a + 1, b), (a + 1, b + 1), (a, b + 1))]
                    quads.append([number(tuple(corner)) for corner in corners][::1 if level else -1])
    return np.array(places, float), np.array(quads)


QUAD_VERTICES, QUADS = cube(6)


class Arrays(unittest.TestCase):
    def test_vertices_are_those_of_the_mesh_that_is_filtered(self):
        smooth = burnish.filter_vertices(VERTICES, FACES, **SMOOTH)
        mesh = burnish.filter_mesh(burnish.Mesh(VERTICES, FACES), **SMOOTH)
        np.testing.assert_array_equal(smooth, mesh.vertices)
        self.assertLess(mesh.area, burnish.Mesh(VERTICES, FACES).area)

    def test_all_ways_to_give_faces_give_the_same_surface(self):
        expected = burnish.filter_vertices(QUAD_VERTICES, QUADS, **SMOOTH)
        self.assertGreater(np.abs(expected - QUAD_VERTICES).max(), 0.05)
        padded = np.concatenate([QUADS, np.full((len(QUADS), 2), -1)], axis=1)
        flat = np.concatenate([np.full((len(QUADS), 1), 4), QUADS], axis=1).ravel()
        for faces in (padded, flat, QUADS.tolist(), [tuple(quad) for quad in QUADS],
                      QUADS.astype(np.uint16), QUADS.astype(float)):
            np.testing.assert_array_equal(
                burnish.filter_vertices(QUAD_VERTICES, faces, **SMOOTH), expected)

    def test_triangles_quads_and_polygons_go_together(self):
        """Two quads beside each other are a hexagon; a quad is two triangles: the same surface."""
        fans = [triangle for a, b, c, d in QUADS[:50] for triangle in ((a, b, c), (a, c, d))]
        mixed = fans + QUADS[50:].tolist()
        ragged = burnish.filter_vertices(QUAD_VERTICES, mixed, **SMOOTH)
        quads = burnish.filter_vertices(QUAD_VERTICES, QUADS, **SMOOTH)
        np.testing.assert_allclose(ragged, quads, atol=1e-6)
        flat = np.concatenate([[len(face), *face] for face in mixed])
        np.testing.assert_array_equal(burnish.filter_vertices(QUAD_VERTICES, flat, **SMOOTH), ragged)

    def test_a_polygon_of_more_than_255_vertices_is_one_face(self):
        angles = np.linspace(0, 2 * np.pi, 300, endpoint=False)
        ring = np.stack([np.cos(angles), np.sin(angles), np.zeros(300)], axis=1)
        vertices = np.concatenate([ring, [[0, 0, 1]]])
        faces = [[(i + 1) % 300, i, 300][::-1] for i in range(300)] + [list(range(299, -1, -1))]
        done = burnish.filter_vertices(vertices, faces, **SMOOTH)
        self.assertEqual(done.shape, vertices.shape)
        self.assertGreater(np.abs(done - vertices).max(), 0.001)

    def test_the_float_type_stays(self):
        exact = burnish.filter_vertices(VERTICES, FACES, **SMOOTH)
        for kind in (np.float16, np.float32, np.float64, np.longdouble, ">f4"):
            done = burnish.filter_vertices(VERTICES.astype(kind), FACES, **SMOOTH)
            self.assertEqual(done.dtype, np.dtype(kind))
            np.testing.assert_allclose(done, exact, atol=0.05)
        self.assertEqual(burnish.filter_vertices(np.rint(10 * VERTICES).astype(int), FACES,
                                                 **SMOOTH).dtype, np.float64)

    def test_colours_are_edited_and_their_alpha_and_type_stay(self):
        colours = np.zeros((len(VERTICES), 4), np.uint8)
        colours[::2, 0], colours[:, 3] = 200, 77
        _, same = burnish.filter_vertices(VERTICES, FACES, colours=colours, **SMOOTH)
        np.testing.assert_array_equal(same, colours)
        _, edited = burnish.filter_vertices(VERTICES, FACES, colours=colours, colour_beta=0,
                                            colour_alpha=5, **SMOOTH)
        self.assertEqual(edited.dtype, np.uint8)
        self.assertLess(edited[:-1, 0].std(), colours[:-1, 0].std() / 2)
        np.testing.assert_array_equal(edited[:, 3], 77)
        floats = np.float32(colours[:, :3] / 255)
        _, edited_floats = burnish.filter_vertices(VERTICES, FACES, colours=floats, colour_beta=0,
                                                   colour_alpha=5, **SMOOTH)
        self.assertEqual(edited_floats.dtype, np.float32)
        np.testing.assert_allclose(edited_floats, edited[:, :3] / 255, atol=1e-6)

    def test_arrays_that_are_not_a_surface_are_refused_with_what_is_wrong(self):
        nowhere = VERTICES.copy()
        nowhere[5, 1] = np.nan
        rows = np.arange(12).reshape(3, 4)
        for words, vertices, faces, more in (
                (r"vertices.*\(\d+, 2\).*\(n, 3\)", VERTICES[:, :2], FACES, {}),
                (r"vertices\[5\].*nan.*finite", nowhere, FACES, {}),
                (r"faces\[1\].*99999.*0 to \d+", VERTICES, [[0, 1, 2], [0, 1, 99999]], {}),
                (r"faces\[1\] has 2 vertices: 3", VERTICES, [[0, 1, 2], [0, 1, -1]], {}),
                (r"faces\[0\].*negative", VERTICES, [[0, -1, 2, 3]], {}),
                (r"flat.*4 numbers", VERTICES, [4, 0, 1, 2], {}),
                (r"faces.*not whole", VERTICES, FACES + 0.5, {}),
                (r"faces.*shape \(1, 3, 4\)", VERTICES, rows[None], {}),
                (r"colours.*\(3, 4\).*\(\d+, 3\)", VERTICES, FACES, {"colours": rows}),
                (r"colours.*2.0.*0 to 1", VERTICES, FACES, {"colours": np.full(VERTICES.shape, 2.0)})):
            with self.subTest(words), self.assertRaisesRegex(ValueError, words):
                burnish.filter_vertices(vertices, faces, **more)
        with self.assertRaisesRegex(TypeError, "colours.*int64.*uint8"):
            burnish.filter_vertices(VERTICES, FACES, colours=np.zeros(VERTICES.shape, int))
        with self.assertRaisesRegex(TypeError, "faces.*indices"):
            burnish.filter_vertices(VERTICES, [["a", "b", "c"]])

    def test_an_error_of_the_program_names_no_file(self):
        with self.assertRaisesRegex(burnish.Refused, "the mesh") as raised:
            burnish.filter_vertices([[0, 0, 0], [1, 0, 0], [2, 0, 0]], [[0, 1, 2]])
        self.assertNotIn("in.ply", str(raised.exception))


if __name__ == "__main__":
    unittest.main()
