"""The examples of docs/python.md, in the order of the page."""

import contextlib
import io
import os
import pathlib
import re
import unittest

from sdk import Sdk

PAGE = pathlib.Path(__file__).parents[3] / "docs" / "python.md"


class Examples(Sdk):
    def test_each_example_runs(self):
        self.mesh_file = self.folder / "tablet.ply"
        self.mesh_file.write_bytes(self.mesh.to_ply())
        examples = re.findall(r"```python\n(.*?)```", PAGE.read_text(encoding="utf-8"), re.S)
        names = {"ADDRESS": f"unix:{self.server.socket}"}
        here = os.getcwd()
        self.addCleanup(os.chdir, here)
        os.chdir(self.folder)
        printed = io.StringIO()
        with contextlib.redirect_stdout(printed):
            for example in examples:
                exec(compile(example, PAGE.name, "exec"), names)
        self.assertEqual(len(examples), 11)
        for word in ("absent.ply failed", "gradient scale", "NOT_FOUND"):
            self.assertIn(word, printed.getvalue())


if __name__ == "__main__":
    unittest.main()
