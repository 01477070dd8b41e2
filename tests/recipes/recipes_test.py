"""Adds a kind of edit to a copy of the tree by docs/recipes.md, and counts what that takes.

Usage: recipes_test.py BUILD, where BUILD has compile_commands.json.

edit.patch is the example. Change it where it does not apply any more.
"""

import concurrent.futures
import json
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
PATCH = HERE / "edit.patch"
PRODUCT = ("client", "common", "proto", "server")
FILES_MAX = 12
# Each of them stops the compiler where it has not heard of the new kind.
TABLES = ("common/edit/edit_kinds.cpp", "common/edit/edit_lines.cpp", "common/wire/edit_wire.cpp")
build = ROOT


def touched():
    return re.findall(r"^\+\+\+ b/(\S+)", PATCH.read_text(), re.MULTILINE)


def is_product(path):
    return path.startswith(tuple(f"{folder}/" for folder in PRODUCT))


def flags(tree):
    """Returns the compiler and the flags of the window's sources, for another tree."""
    commands = json.loads((build / "compile_commands.json").read_text())
    words = shlex.split(next(one["command"] for one in commands
                             if "/burnish_app.dir/" in "/" + one["command"]))
    kept = [next(word for word in words if word.endswith(("++", "g++", "cc")))]
    for word, value in zip(words, words[1:] + [""]):
        if word == "-isystem" and not value.startswith(str(build)):
            kept += [word, value]
        elif word.startswith(("-D", "-std", "-f", "-W")) and word != "-Winvalid-pch":
            kept.append(word)
    return kept + [f"-I{tree}", "-isystem", f"{tree}/build"]


class EditByTheRecipe(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.tree = pathlib.Path(cls.folder.name) / "tree"
        for folder in PRODUCT:
            shutil.copytree(ROOT / folder, cls.tree / folder,
                            ignore=shutil.ignore_patterns("node_modules", "__pycache__", "build"))
        run = subprocess.run(["patch", "-p1", "--quiet", "--no-backup-if-mismatch", "-i", PATCH],
                             cwd=cls.tree, capture_output=True, text=True)
        if run.returncode:
            raise AssertionError(f"edit.patch does not apply: {run.stdout}{run.stderr}")
        (cls.tree / "build").mkdir()
        subprocess.run(["protoc", "-Iproto", "--cpp_out=build",
                        *sorted(path.relative_to(cls.tree)
                                for path in (cls.tree / "proto").rglob("*.proto"))],
                       cwd=cls.tree, check=True)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def complaints(self, path):
        """Returns what the compiler says about a source."""
        return subprocess.run([*flags(self.tree), "-fsyntax-only", path], cwd=self.tree,
                              capture_output=True, text=True).stderr

    def test_it_takes_few_files_of_the_product(self):
        files = [path for path in touched() if is_product(path)]
        print(f"a kind of edit takes {len(files)} files of the product")
        self.assertLessEqual(len(files), FILES_MAX, files)

    def test_the_recipe_names_each_of_its_files(self):
        recipe = (ROOT / "docs/recipes.md").read_text()
        rows = re.findall(r"^\| (`.*?) \|", recipe, re.MULTILINE)
        named = [place for row in rows for place in re.findall(r"`([^`]+)`", row)]
        for path in touched():
            self.assertTrue(any(path == place or path.startswith(place + "/") for place in named), path)

    def test_its_sources_compile(self):
        sources = [path for path in touched() if path.endswith(".cpp")]
        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            for path, said in zip(sources, pool.map(self.complaints, sources)):
                self.assertEqual(said, "", path)

    def test_a_table_without_it_does_not_compile(self):
        for path in TABLES:
            with self.subTest(path):
                whole = (self.tree / path).read_bytes()
                shutil.copyfile(ROOT / path, self.tree / path)
                try:
                    self.assertIn("error", self.complaints(path))
                finally:
                    (self.tree / path).write_bytes(whole)


if __name__ == "__main__":
    build = pathlib.Path(sys.argv.pop(1)).resolve()
    unittest.main(verbosity=2)
