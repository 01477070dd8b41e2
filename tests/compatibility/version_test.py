"""The parts say one version, and the documents know it."""

import os
import pathlib
import re
import subprocess
import unittest

import burnish

ROOT = pathlib.Path(__file__).parents[2]


def said(variable):
    """Returns the last word of a program's --version."""
    return subprocess.run([os.environ[variable], "--version"], check=True, capture_output=True,
                          text=True).stdout.split()[-1]


class Version(unittest.TestCase):
    def setUp(self):
        text = (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")
        self.version = re.search(r"^project\(burnish VERSION (\S+)", text, re.M)[1]

    def test_programs_and_package_say_the_projects_version(self):
        self.assertEqual([said("BURNISH_BINARY"), said("BURNISH_SERVER_BINARY"),
                          burnish.__version__], [self.version] * 3)

    def test_debian_packages_have_it(self):
        done = subprocess.run([ROOT / "deploy" / "package", "--print-version"], check=True,
                              capture_output=True, text=True)
        self.assertEqual(done.stdout.strip(), self.version)

    def test_the_changelog_begins_with_it(self):
        text = (ROOT / "docs" / "CHANGELOG.md").read_text(encoding="utf-8")
        self.assertEqual(re.search(r"^## (\S+)", text, re.M)[1], self.version)

    def test_something_is_kept_of_each_version_before(self):
        text = (ROOT / "docs" / "CHANGELOG.md").read_text(encoding="utf-8")
        released = re.findall(r"^## (\S+)", text, re.M)
        kept = {path.name for path in (ROOT / "tests" / "compatibility" / "kept").iterdir()}
        self.assertEqual([one for one in released[1:] if one not in kept], [])


if __name__ == "__main__":
    unittest.main()
