"""Runs what the documents tell their readers to run, page by page.

Usage: commands_test.py PAGE...     pages as paths in the repository
       commands_test.py --pictures PAGE...
           runs them with scans of full size, and keeps the pictures that they show in docs/pictures
"""

import re
import shutil
import sys
import unittest

from blocks import RUNS, blocks_of, faults_of
from desk import ROOT, Desk
from inline import faults_in

# docs/python.md has a test of its own: tests/client/python/examples_test.py.
OWN_TEST = {("docs/python.md", "python")}


def blocks_in(page):
    return blocks_of(page, (ROOT / page).read_text(encoding="utf-8"))


def run_block(desk, block):
    """Runs a block, or writes its file. Returns what went wrong, or None."""
    if "file" in block.marks:
        desk.write(block.marks["file"], block.text)
        return None
    steps = [("sh", block.marks["before"])] if "before" in block.marks else []
    if block.runs and (block.page, block.language) not in OWN_TEST:
        steps.append((block.language, block.text))
    for language, text in steps:
        code, output = desk.run(language, text)
        if code != 0:
            return f"{block.place}: exit code {code}\n{output}"
    return None


def pictures_of(page):
    """Returns the names of the pictures that a page's own commands make."""
    text = (ROOT / page).read_text(encoding="utf-8")
    return re.findall(r"!\[[^\]]*\]\(pictures/([^)]+)\)", text)


def keep_pictures(page):
    """Makes a page's pictures anew."""
    desk = Desk(vertices_max=10**9)
    try:
        for block in blocks_in(page):
            if fault := run_block(desk, block):
                sys.exit(fault)
        for name in pictures_of(page):
            shutil.copy(desk.folder / name, ROOT / "docs" / "pictures" / name)
    finally:
        desk.close()


class Commands(unittest.TestCase):
    """Has a test for each page."""

    def check(self, page):
        self.assertEqual(faults_in((ROOT / page).read_text(encoding="utf-8")), [])
        blocks = blocks_in(page)
        self.assertEqual([f"{one.place}: {faults_of(one)}" for one in blocks if faults_of(one)], [])
        desk = Desk()
        self.addCleanup(desk.close)
        for block in blocks:
            fault = run_block(desk, block)
            self.assertIsNone(fault, fault)
        made = [name for name in pictures_of(page) if (desk.folder / name).exists()]
        self.assertEqual(made, pictures_of(page), "the commands do not make all pictures")
        for block in blocks:
            if block.language in RUNS and "not run" in block.marks:
                print(f"{block.place}: not run: {block.marks['not run']}")


def add_test(page):
    setattr(Commands, f"test_{page}", lambda self: self.check(page))


if __name__ == "__main__":
    if sys.argv[1] == "--pictures":
        for argument in sys.argv[2:]:
            keep_pictures(argument)
        sys.exit()
    for argument in sys.argv[1:]:
        if argument != "-v":
            add_test(argument)
    unittest.main(argv=sys.argv[:1], verbosity=2)
