"""Connections and scans."""

import unittest
import warnings

import numpy as np

import burnish
from rising import assert_rises
from sdk import DEPTH, Sdk


class Library(Sdk):
    def test_scans_are_listed_with_their_figures(self):
        found, = [one for one in self.connection.scans() if one.name == "sphere"]
        self.assertEqual((found.id, found.format), (self.scan.id, "ply"))
        self.assertEqual(found.vertices, len(self.mesh.vertices))
        self.assertEqual(found.triangles, len(self.mesh.faces))
        self.assertTrue(found.is_watertight)
        self.assertEqual(found.depths, [DEPTH])
        self.assertAlmostEqual(found.area, self.mesh.area)
        np.testing.assert_allclose(found.bounds, burnish.Mesh(
            self.mesh.vertices[:-1], self.mesh.faces).bounds)  # no triangle uses the last vertex

    def test_a_file_is_imported_under_its_name_with_progress(self):
        path, phases = self.folder / "cube.ply", []
        path.write_bytes(burnish.Mesh(self.mesh.vertices * 2, self.mesh.faces).to_ply())
        scan = self.connection.import_scan(path, depth=4, progress=lambda *step: phases.append(step))
        self.addCleanup(scan.delete)
        self.assertEqual((scan.name, scan.depths), ("cube", [4]))
        assert_rises(self, [done for _, done in phases])

    def test_a_file_whose_name_turns_the_direction_of_text_is_imported(self):
        path = self.folder / "\u200f\u05e9\u200e 1.ply"
        path.write_bytes(burnish.Mesh(self.mesh.vertices * 5, self.mesh.faces).to_ply())
        scan = self.connection.import_scan(path, depth=4)
        self.addCleanup(scan.delete)
        self.assertEqual(scan.name, "\u05e9 1")

    def test_a_deleted_scan_is_not_found(self):
        scan = self.connection.import_scan(burnish.Mesh(self.mesh.vertices * 3, self.mesh.faces),
                                           depth=4)
        scan.delete()
        with self.assertRefused(burnish.NotFound, scan.id[:12]):
            self.connection.scan(scan.id)

    def test_a_known_scan_keeps_its_name(self):
        with self.assertWarnsRegex(UserWarning, "'sphere', not 'again'"):
            scan = self.connection.import_scan(self.mesh, "again", depth=DEPTH)
        self.assertEqual(scan.name, "sphere")
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            self.connection.import_scan(self.mesh, "sphere", depth=DEPTH)
            self.connection.import_scan(self.mesh, depth=DEPTH)

    def test_a_scan_has_a_name_and_a_unit(self):
        scan = self.connection.scan(self.scan.id[:12])
        scan.rename("globe")
        scan.set_unit("mm")
        self.assertEqual([(one.name, one.unit) for one in self.connection.scans()],
                         [("globe", "mm")])
        scan.rename("sphere")
        with self.assertRefused(burnish.InvalidArgument, "17", "16"):
            scan.set_unit("m" * 17)

    def test_a_scan_in_use_is_not_deleted(self):
        self.open()
        with self.assertRefused(burnish.FailedPrecondition, "session"):
            self.scan.delete()

    def test_a_histogram_tells_the_curvature_of_most_of_the_area(self):
        histogram = self.scan.prepared().histogram
        self.assertAlmostEqual(histogram.area.sum(), 1, places=5)
        self.assertEqual(len(histogram.kappa), len(histogram.area) + 1)
        round_ = np.sqrt(4 * np.pi)  # the curvature of a sphere, times L
        self.assertLess(abs(histogram.quantile(0.5)), 3 * round_)
        self.assertGreater(histogram.quantile(0.9), histogram.quantile(0.5))

    def test_walls_thinner_than_a_cell_are_told(self):
        self.assertEqual(self.scan.prepared().walls.share, 0)
        self.assertEqual(self.open().state().walls.share, 0)
        square = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], float)
        vertices = np.concatenate([square, square + [0, 0, 0.01]])
        faces = np.array([[0, 2, 1], [0, 3, 2], [4, 5, 6], [4, 6, 7]])
        plates = self.connection.import_scan(burnish.Mesh(vertices, faces), "plates", depth=DEPTH)
        self.addCleanup(plates.delete)
        walls = plates.prepared().walls
        self.assertGreater(walls.share, 0.9)
        self.assertGreater(walls.depth, DEPTH)
        session = self.connection.open_session(plates, "thin", depth=DEPTH)
        self.addCleanup(self.delete, session)
        self.assertEqual(session.state().walls, walls)

    def test_a_wave_has_its_alpha(self):
        prepared = self.scan.prepared()
        self.assertAlmostEqual(prepared.alpha_of(2 * np.pi * prepared.length_unit), 1)
        self.assertAlmostEqual(prepared.length_unit, np.sqrt(self.mesh.area))

    def test_a_depth_that_is_not_prepared_is_not_found(self):
        with self.assertRefused(burnish.NotFound, "9", "6"):
            self.scan.prepared(9)

    def test_a_file_that_is_not_a_mesh_is_refused(self):
        with self.assertRefused(burnish.InvalidArgument, "notes.txt", ".ply"):
            self.connection.import_scan(self.folder / "notes.txt")
        (self.folder / "bad.ply").write_bytes(b"ply\n")
        with self.assertRefused(burnish.InvalidArgument):
            self.connection.import_scan(self.folder / "bad.ply")
        with self.assertRaises(FileNotFoundError):
            self.connection.import_scan(self.folder / "absent.ply")

    def test_what_a_callback_raises_ends_an_import(self):
        def stop(phase, fraction):
            raise KeyboardInterrupt
        with self.assertRaises(KeyboardInterrupt):
            self.connection.import_scan(burnish.Mesh(self.mesh.vertices + 1, self.mesh.faces),
                                        progress=stop)
        self.assertEqual(len(self.connection.scans()), 1)

    def test_nobody_listens(self):
        with self.assertRaisesRegex(burnish.Unavailable, "absent.sock"):
            burnish.connect(f"unix:{self.folder}/absent.sock", patience=0.2)

    def test_a_token_does_not_travel_in_plain_text(self):
        with self.assertRefused(burnish.FailedPrecondition, "lab:7411", "plain text"):
            burnish.connect("lab:7411", token="abc")
        with self.assertRefused(burnish.InvalidArgument, "token"):
            burnish.connect("localhost:7411", token="a b")
        with self.assertRefused(burnish.InvalidArgument, "certificate", "key"):
            burnish.connect("lab:7411", certificate="me.pem")


if __name__ == "__main__":
    unittest.main()
