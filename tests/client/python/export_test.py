"""Exports of the package, and those of the program."""

import os
import subprocess
import unittest

import numpy as np

import burnish
from rising import assert_rises
from sdk import Sdk

CHANGES = burnish.GradientScale(0.2), burnish.TransferCurve({-3.0: 20.0, 3.0: 80.0})


class Export(Sdk):
    def open_edited(self, name):
        session = self.open(f"{self.id()} {name}")
        session.apply(*CHANGES)
        return session

    def export_by_program(self, session, path, *options):
        subprocess.run([os.environ["BURNISH_BINARY"], "export", session.id, path, *options,
                        "--server", f"unix:{self.server.socket}"], check=True,
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)

    def test_an_export_is_the_programs_byte_for_byte(self):
        for options, words in (({}, []), ({"exact": True}, ["--exact"]),
                               ({"cycles": 3}, ["--cycles", "3"])):
            with self.subTest(options):
                paths = [self.folder / name for name in ("package.ply", "program.ply")]
                self.open_edited(f"package {words}").export(paths[0], **options)
                self.export_by_program(self.open_edited(f"program {words}"), paths[1], *words)
                self.assertEqual(paths[0].read_bytes(), paths[1].read_bytes())

    def test_the_summary_tells_of_the_file(self):
        path, phases = self.folder / "out.obj", []
        summary = self.open_edited("obj").export(path, exact=True,
                                                 progress=lambda *step: phases.append(step))
        self.assertEqual(summary.size_bytes, path.stat().st_size)
        self.assertEqual((summary.vertices, summary.triangles),
                         (len(self.mesh.vertices), len(self.mesh.faces)))
        self.assertTrue(summary.converged)
        assert_rises(self, [done for _, done in phases])

    def test_a_mesh_has_the_scans_order(self):
        mesh = self.open_edited("mesh").mesh()
        np.testing.assert_array_equal(mesh.faces, self.mesh.faces)
        moves = np.linalg.norm(mesh.vertices - self.mesh.vertices, axis=1)
        self.assertGreater(moves.max(), 0.01)
        self.assertLess(moves.max(), 1)

    def test_an_export_that_fails_leaves_what_was_there(self):
        session, path = self.open_edited("failing"), self.folder / "out.off"
        path.write_text("mine")
        with self.assertRefused(burnish.InvalidArgument):
            session.export(path)
        with self.assertRefused(burnish.InvalidArgument, "out.txt"):
            session.export(self.folder / "out.txt")

        def stop(phase, fraction):
            raise KeyboardInterrupt
        with self.assertRaises(KeyboardInterrupt):
            session.export(self.folder / "other.ply", exact=True, progress=stop)
        self.assertEqual([one.name for one in self.folder.iterdir()], ["out.off"])
        self.assertEqual(path.read_text(), "mine")


if __name__ == "__main__":
    unittest.main()
