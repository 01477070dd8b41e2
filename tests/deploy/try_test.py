"""deploy/try finds what tests a file."""

import importlib.machinery
import importlib.util
import pathlib
import unittest

ROOT = pathlib.Path(__file__).parents[2]


def load(path):
    """Returns a program without .py as a module."""
    loader = importlib.machinery.SourceFileLoader(path.name, str(path))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader(path.name, loader))
    loader.exec_module(module)
    return module


TRY = load(ROOT / "deploy" / "try")


class Try(unittest.TestCase):
    def found_for(self, path):
        return [str(test.relative_to(ROOT)) for test in TRY.tests_of(ROOT / path)]

    def test_a_source_and_its_header_have_their_own_test(self):
        own = ["tests/common/mesh/agreeing_vertices_test.cpp"]
        self.assertEqual(self.found_for("common/mesh/agreeing_vertices.cpp"), own)
        self.assertEqual(self.found_for("common/mesh/agreeing_vertices.h"), own)
        self.assertEqual(self.found_for(own[0]), own)

    def test_the_test_of_a_source_may_lie_in_a_folder_above(self):
        self.assertEqual(self.found_for("common/mesh/ply/ply_reader.cpp"),
                         ["tests/common/mesh/ply_reader_test.cpp"])

    def test_a_source_without_a_test_has_those_of_the_nearest_folder(self):
        tests = self.found_for("client/cli/filter/filter_command.cpp")
        self.assertIn("tests/client/cli/command_test.cpp", tests)

    def test_what_has_no_test_is_refused_by_name(self):
        for path, word in (("README.md", "not a C"), ("common/none.cpp", "not a file")):
            with self.assertRaisesRegex(SystemExit, word):
                self.found_for(path)

    def test_every_suite_is_found(self):
        text = "TEST(A, b) {}\nTEST_F(C, d) {}\nTEST_P(\n    E, f) {}\n  TEST(Inner, x)\n"
        self.assertEqual(TRY.TEST.findall(text), ["A", "C", "E"])


class Commits(unittest.TestCase):
    def setUp(self):
        self.fault = load(ROOT / "deploy" / "checks" / "commits").fault

    def test_a_long_subject_and_a_missing_body_are_told(self):
        self.assertEqual(self.fault("Short\n\nBecause."), "")
        self.assertIn("73", self.fault("x" * 73 + "\n\nBecause."))
        self.assertIn("no body", self.fault("Short"))


if __name__ == "__main__":
    unittest.main()
