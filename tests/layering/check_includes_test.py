"""What deploy/checks/includes finds, and what it leaves."""

import pathlib
import subprocess
import tempfile
import unittest

CHECKER = pathlib.Path(__file__).resolve().parents[2] / "deploy" / "checks" / "includes"

THING = """#pragma once
namespace burnish {
class Other;
enum class Colour { kRed };
MAKES_FUNCTIONS_FOR(Colour, kRed)
struct Thing {
  int weight() const { return weight_; }
  int weight_ = 0;
};
template <typename T>
inline T twice(T value) { return 2 * value; }
inline constexpr int kThings = 3;
}  // namespace burnish
"""


class Includes(unittest.TestCase):
    def findings(self, text, name="a.cpp"):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            (root / "thing.h").write_text(THING)
            (root / name).write_text(text)
            run = subprocess.run([CHECKER, name], cwd=root, capture_output=True, text=True)
            self.assertEqual(run.stderr, "")
            self.assertEqual(run.returncode, 1 if run.stdout else 0)
            return run.stdout

    def test_a_header_of_which_nothing_is_named_is_found_by_file_and_line(self):
        self.assertIn("a.cpp:2: thing.h", self.findings('// one\n#include "thing.h"\nint a;\n'))

    def test_types_functions_constants_and_enumerations_count_as_used(self):
        for use in ("Thing a;", "auto a = twice(1);", "int a = kThings;", "Colour a;"):
            self.assertEqual(self.findings(f'#include "thing.h"\n{use}\n'), "", use)

    def test_a_member_counts_where_it_is_asked_for(self):
        self.assertEqual(self.findings('#include "thing.h"\nint a = b().weight();\n'), "")
        self.assertIn("a.cpp:1:", self.findings('#include "thing.h"\nint weight = 1;\n'))

    def test_a_forward_declaration_is_not_a_use(self):
        self.assertIn("a.cpp:1:", self.findings('#include "thing.h"\nOther* a;\n'))

    def test_comments_and_text_are_not_a_use(self):
        self.assertIn("a.cpp:1:", self.findings('#include "thing.h"\nauto a = "Thing";  // Thing\n'))

    def test_a_header_that_is_included_twice_is_found(self):
        twice = '#include <vector>\n#include "thing.h"\n#include <vector>\nThing a;\n'
        self.assertIn("a.cpp:3: vector is included twice", self.findings(twice))

    def test_a_source_may_include_its_own_header_for_nothing(self):
        self.assertEqual(self.findings('#include "thing.h"\n', name="thing.cpp"), "")


if __name__ == "__main__":
    unittest.main()
