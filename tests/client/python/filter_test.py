"""Filters on this computer, without a server."""

import dataclasses
import inspect
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest
import unittest.mock

import numpy as np

import burnish
import scan
from burnish.options import OptionWords
from burnish.program import find_program
from rising import assert_rises

PROGRAMS = pathlib.Path(__file__).parents[3] / "client/python/programs"
QUICK = {"depth": 4, "cycles": 1}


class Program(unittest.TestCase):
    def test_is_that_of_the_wheel_where_neither_a_variable_nor_the_path_has_one(self):
        with tempfile.TemporaryDirectory() as folder:
            wheel = pathlib.Path(folder) / "burnish_programs"
            wheel.mkdir()
            (wheel / "__init__.py").write_text(
                (PROGRAMS / "burnish_programs/__init__.py").read_text("utf-8"), "utf-8")
            with unittest.mock.patch.dict(os.environ, {"PATH": ""}), \
                    unittest.mock.patch("sys.path", [folder]):
                del os.environ["BURNISH_BINARY"]
                self.assertEqual(find_program(), str(wheel / "bin" / "burnish"))
        sys.modules.pop("burnish_programs")

    def test_that_is_nowhere_names_what_to_install(self):
        with unittest.mock.patch.dict(os.environ, {"PATH": ""}):
            del os.environ["BURNISH_BINARY"]
            with self.assertRaisesRegex(burnish.NotFound, "burnish-programs.*BURNISH_BINARY"):
                find_program()


class Filter(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="burnish-")
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.mesh = burnish.Mesh(*scan.bumpy_sphere(4))
        self.source = self.folder / "in.ply"
        self.source.write_bytes(self.mesh.to_ply())

    def test_a_file_is_the_programs_byte_for_byte(self):
        out, by_program = self.folder / "out.ply", self.folder / "program.ply"
        done = burnish.filter(self.source, out, beta=0.2, depth=5, exact=True,
                              curve=burnish.TransferCurve({-3.0: 20.0, 3.0: 80.0}),
                              bands=[burnish.Band(0.5, 0)])
        subprocess.run([os.environ["BURNISH_BINARY"], "filter", self.source, by_program, "--beta",
                        "0.2", "--depth", "5", "--exact", "--curve=-3:20,3:80", "--band", "0.5:0"],
                       check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.assertEqual(out.read_bytes(), by_program.read_bytes())
        self.assertEqual((done.outcome, done.target), ("done", out))
        self.assertEqual(done.facts["vertices"], len(self.mesh.vertices))
        self.assertTrue(done.facts["converged"])

    def test_a_mesh_is_filtered_as_arrays(self):
        smooth = burnish.filter_mesh(self.mesh, beta=0, alpha=5, depth=5)
        np.testing.assert_array_equal(smooth.faces, self.mesh.faces)
        self.assertLess(smooth.area, self.mesh.area)

    def test_progress_is_told(self):
        phases = []
        burnish.filter(self.source, self.folder / "out.ply", **QUICK,
                       progress=lambda *step: phases.append(step))
        self.assertIn("solve", [phase for phase, _ in phases])
        assert_rises(self, [done for _, done in phases])

    def test_many_files_have_one_rising_progress_with_their_names(self):
        sources = [self.folder / name for name in ("a.ply", "b.ply")]
        for source in sources:
            source.write_bytes(self.source.read_bytes())
        phases = []
        burnish.filter_all(sources, self.folder / "out", **QUICK,
                           progress=lambda *step: phases.append(step))
        assert_rises(self, [done for _, done in phases])
        of_first = [done for phase, done in phases if phase.startswith("a.ply: ")]
        of_second = [done for phase, done in phases if phase.startswith("b.ply: ")]
        self.assertEqual((of_first[-1], of_second[-1]), (0.5, 1))

    def test_what_a_callback_raises_ends_the_work(self):
        def stop(phase, fraction):
            raise KeyboardInterrupt
        with self.assertRaises(KeyboardInterrupt):
            burnish.filter(self.source, self.folder / "out.ply", progress=stop)
        self.assertFalse((self.folder / "out.ply").exists())

    def test_errors_have_a_code_and_a_message(self):
        out = self.folder / "out.ply"
        with self.assertRaisesRegex(burnish.NotFound, "absent.ply"):
            burnish.filter(self.folder / "absent.ply", out)
        with self.assertRaisesRegex(burnish.NotFound, "Nothing"):
            burnish.filter(self.source, out, preset="Nothing")
        with self.assertRaisesRegex(burnish.InvalidArgument, "11"):
            burnish.filter(self.source, out, beta=11)
        with self.assertRaisesRegex(burnish.FailedPrecondition, "colours"):
            burnish.filter(self.source, out, colour_beta=0.5, **QUICK)
        with self.assertRaisesRegex(TypeError, "betta is not an option.*beta, alpha"):
            burnish.filter(self.source, out, betta=1)
        self.assertFalse(out.exists())

    def test_a_wrong_type_is_told_with_the_argument_its_value_and_what_it_takes(self):
        out = self.folder / "out.ply"
        for words, options in ((("curve", "'1'", "a TransferCurve"), {"curve": "1"}),
                               (("beta", "'0.5'", "a number"), {"beta": "0.5"}),
                               (("depth", "5.5", "a whole number"), {"depth": 5.5}),
                               (("exact", "'no'", "True or False"), {"exact": "no"}),
                               (("bands", "3", "a sequence"), {"bands": 3}),
                               (("bands[0]", "(1, 2)", "a Band"), {"bands": [(1, 2)]}),
                               (("controls", "0.5", "a Controls"), {"controls": 0.5})):
            with self.assertRaises(TypeError) as raised:
                burnish.filter(self.source, out, **options)
            for word in words:
                self.assertIn(word, str(raised.exception))
        burnish.filter(self.source, out, beta=np.float32(0.5), depth=np.int64(4), cycles=1)
        self.assertTrue(out.exists())

    def test_options_are_seen_by_help_and_by_checkers_of_types(self):
        fields = {field.name: field.type for field in dataclasses.fields(burnish.Options)}
        self.assertEqual(fields, {name: kind.__forward_arg__ for name, kind in
                                  OptionWords.__annotations__.items()})
        for function in (burnish.filter, burnish.filter_all, burnish.filter_mesh,
                         burnish.filter_vertices):
            shown = inspect.signature(function).parameters
            self.assertLessEqual(fields.keys(), shown.keys())
            self.assertNotIn("options", shown)

    def test_an_error_of_a_mesh_names_no_file_that_its_user_does_not_know(self):
        flat = burnish.Mesh([[0, 0, 0], [1, 0, 0], [2, 0, 0]], [[0, 1, 2]])
        with self.assertRaisesRegex(burnish.Refused, "the mesh") as raised:
            burnish.filter_mesh(flat, beta=0)
        self.assertNotIn(tempfile.gettempdir(), str(raised.exception))

    def test_a_folder_is_filtered_with_a_result_for_each_file(self):
        (self.folder / "bad.ply").write_text("plx")
        sources = [self.source, self.folder / "bad.ply"]
        good, bad = burnish.filter_all(sources, self.folder / "out", beta=0.5, **QUICK)
        self.assertEqual((good.outcome, bad.outcome), ("done", "failed"))
        self.assertTrue(good.target.exists())
        self.assertIsInstance(bad.error, burnish.InvalidArgument)
        again, _ = burnish.filter_all(sources, self.folder / "out", overwrite=False, **QUICK)
        self.assertEqual(again.outcome, "skipped")

    def test_a_program_that_is_killed_fails_its_own_file_alone(self):
        program = self.folder / "program"
        program.write_text(f'#!/bin/sh\ncase "$*" in *killed.ply*) kill -9 $$ ;; esac\n'
                           f'exec "{os.environ["BURNISH_BINARY"]}" "$@"\n')
        program.chmod(0o700)
        killed = self.folder / "killed.ply"
        killed.write_bytes(self.source.read_bytes())
        with unittest.mock.patch.dict(os.environ, BURNISH_BINARY=os.fspath(program)):
            bad, good = burnish.filter_all([killed, self.source], self.folder / "out", **QUICK)
        self.assertEqual((bad.outcome, good.outcome), ("failed", "done"))
        self.assertIn("signal 9 (SIGKILL)", str(bad.error))

    def test_two_files_of_one_name_are_refused_before_the_work(self):
        with self.assertRaisesRegex(burnish.InvalidArgument, "in.ply"):
            burnish.filter_all([self.source, self.source], self.folder / "out")
        self.assertFalse((self.folder / "out").exists())


if __name__ == "__main__":
    unittest.main()
