"""The checker of links in documents."""

import pathlib
import subprocess
import tempfile
import unittest

CHECKER = pathlib.Path(__file__).parents[2] / "deploy" / "checks" / "links"


class Links(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="burnish-")
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        (self.folder / "other.md").write_text("# `A` [title](x), with α\n\n## Twice\n\n## Twice\n")

    def faults_of(self, text):
        (self.folder / "page.md").write_text(text)
        done = subprocess.run([CHECKER, self.folder / "page.md"], capture_output=True, text=True,
                              check=False)
        self.assertEqual(done.returncode, 1 if done.stdout else 0, done.stderr)
        return done.stdout.splitlines()

    def test_links_to_files_and_headings_are_right(self):
        self.assertEqual(self.faults_of(
            "# Here\n[a](other.md) [b](other.md#a-title-with-α) [c](#here) ![d](other.md#twice-1) "
            "[e](https://example.org/nowhere) [f](.)\n```\n[g](nowhere.md)\n```\n"), [])

    def test_a_missing_file_and_a_missing_heading_are_named(self):
        missing, heading, numbered = self.faults_of(
            "[a](nowhere.md) [b](#there) [c](other.md#twice-2)\n")
        self.assertIn("nowhere.md does not exist", missing)
        self.assertIn("no heading #there", heading)
        self.assertIn("no heading #twice-2", numbered)


if __name__ == "__main__":
    unittest.main()
