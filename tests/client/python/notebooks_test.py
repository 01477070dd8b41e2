"""The notebooks of client/python, cell by cell. Jupyter is not needed."""

import contextlib
import csv
import io
import json
import os
import pathlib
import tempfile
import unittest

NOTEBOOKS = pathlib.Path(__file__).parents[3] / "client" / "python" / "notebooks"


class Notebooks(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="burnish-")
        self.addCleanup(folder.cleanup)
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(folder.name)

    def run_notebook(self, name):
        """Runs the cells in one namespace. Returns it, and what they printed."""
        notebook = json.loads((NOTEBOOKS / f"{name}.ipynb").read_text(encoding="utf-8"))
        names, printed = {"__name__": name}, io.StringIO()
        with contextlib.redirect_stdout(printed):
            for number, cell in enumerate(notebook["cells"]):
                if cell["cell_type"] == "code":
                    exec(compile("".join(cell["source"]), f"{name}, cell {number}", "exec"), names)
        return names, printed.getvalue()

    def test_a_folder_is_smoothed_with_a_report(self):
        _, printed = self.run_notebook("folder_report")
        self.assertIn("broken.ply failed", printed)
        with open("report.csv", encoding="utf-8", newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([row["scan"] for row in rows],
                         [f"tablet-{seed}.ply" for seed in (1, 2, 3)])
        for row in rows:
            self.assertGreater(float(row["largest move"]), 0)
            self.assertLess(float(row["area"]), 1)

    def test_a_curve_from_the_histogram_spares_the_edges(self):
        names, _ = self.run_notebook("curve_by_histogram")
        moves = names["moves"]
        self.assertLess(moves["by curvature"].mean(), moves["everywhere"].mean())
        self.assertGreater(moves["by curvature"].max(), 0)

    def test_frames_become_a_film(self):
        names, _ = self.run_notebook("frames_as_film")
        film = pathlib.Path("film.png").read_bytes()
        self.assertEqual(len(names["pictures"]), 7)
        self.assertEqual(film.count(b"fcTL"), 7)
        self.assertEqual(film.count(b"fdAT"), 6)

    def test_notebooks_are_kept_without_their_output(self):
        for path in NOTEBOOKS.glob("*.ipynb"):
            for cell in json.loads(path.read_text(encoding="utf-8"))["cells"]:
                self.assertEqual(cell.get("outputs", []), [], path.name)


if __name__ == "__main__":
    unittest.main()
