"""The scripts that other programs load. Decorators of ParaView and the module of Metashape are
stand-ins; VTK is the real one, where it is installed."""

import importlib.util
import os
import pathlib
import sys
import types
import unittest

import numpy as np

import burnish
import scan

HERE = pathlib.Path(__file__).resolve().parents[3] / "client" / "integrations"
VERTICES, FACES = scan.bumpy_sphere(2)


def load(name):
    spec = importlib.util.spec_from_file_location(name, HERE / f"{name}.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


class Decorators:
    """Any decorator of ParaView: leaves what it decorates."""

    def __getattr__(self, _):
        return lambda *args, **words: lambda decorated: decorated


class ParaView(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        try:
            from vtkmodules.util.vtkAlgorithm import VTKPythonAlgorithmBase
        except ImportError as error:
            raise unittest.SkipTest(f"VTK is not installed: {error}") from None
        algorithm = types.ModuleType("paraview.util.vtkAlgorithm")
        algorithm.VTKPythonAlgorithmBase = VTKPythonAlgorithmBase
        for name in ("smdomain", "smhint", "smproperty", "smproxy"):
            setattr(algorithm, name, Decorators())
        for name in ("paraview", "paraview.util"):
            sys.modules[name] = types.ModuleType(name)
        sys.modules[algorithm.__name__] = algorithm
        cls.plugin = load("paraview_burnish")

    @classmethod
    def tearDownClass(cls):
        for name in [name for name in sys.modules if name.split(".")[0] == "paraview"]:
            del sys.modules[name]

    def surface(self):
        from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
        from vtkmodules.vtkCommonCore import vtkPoints
        from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
        points, cells, surface = vtkPoints(), vtkCellArray(), vtkPolyData()
        points.SetData(numpy_to_vtk(VERTICES, deep=True))
        rows = np.concatenate([np.full((len(FACES), 1), 3), FACES], axis=1).astype(np.int64)
        cells.SetCells(len(FACES), numpy_to_vtkIdTypeArray(rows.ravel(), deep=True))
        surface.SetPoints(points)
        surface.SetPolys(cells)
        kept = numpy_to_vtk(np.arange(len(VERTICES), dtype=float), deep=True)
        kept.SetName("kept")
        surface.GetPointData().AddArray(kept)
        return surface

    def points_of(self, surface):
        from vtkmodules.util.numpy_support import vtk_to_numpy
        return vtk_to_numpy(surface.GetPoints().GetData())

    def test_the_filter_moves_points_and_keeps_cells_and_arrays(self):
        given = self.surface()
        algorithm = self.plugin.BurnishFilter()
        algorithm.SetInputDataObject(given)
        algorithm.SetGradientScale(0)
        algorithm.Update()
        moved = algorithm.GetOutputDataObject(0)
        expected = burnish.filter_vertices(VERTICES, FACES, beta=0)
        np.testing.assert_array_equal(self.points_of(moved), expected)
        np.testing.assert_array_equal(self.points_of(given), VERTICES)
        self.assertEqual(moved.GetNumberOfPolys(), len(FACES))
        self.assertEqual(moved.GetPointData().GetArray("kept").GetValue(7), 7)

    def test_a_value_that_changes_nothing_runs_nothing_again(self):
        algorithm = self.plugin.BurnishFilter()
        algorithm.SetKeepEdges("auto")
        before = algorithm.GetMTime()
        algorithm.SetKeepEdges("auto")
        self.assertEqual(algorithm.GetMTime(), before)
        algorithm.SetKeepEdges("machined")
        self.assertGreater(algorithm.GetMTime(), before)


class Metashape(unittest.TestCase):
    def setUp(self):
        self.items, self.said, model = {}, [], burnish.Mesh(VERTICES, FACES)
        chunk = types.SimpleNamespace(model=model, exportModel=self.export, importModel=self.take)
        module = types.ModuleType("Metashape")
        module.ModelFormatOBJ = "OBJ"
        module.app = types.SimpleNamespace(
            document=types.SimpleNamespace(chunk=chunk), addMenuItem=self.items.__setitem__,
            getBool=lambda question: True, getFloat=lambda question, value: 0.0,
            messageBox=self.said.append)
        sys.modules["Metashape"] = module
        self.addCleanup(sys.modules.pop, "Metashape")
        self.chunk, self.taken = chunk, None
        self.script = load("metashape_burnish")
        self.script.program = lambda: os.environ.get("BURNISH_BINARY", "burnish")

    def export(self, path, **options):
        lines = [f"v {x!r} {y!r} {z!r}" for x, y, z in VERTICES.tolist()]
        lines += [f"f {a} {b} {c}" for a, b, c in (FACES + 1).tolist()]
        pathlib.Path(path).write_text("\n".join(lines) + "\n")

    def take(self, path, **options):
        lines = pathlib.Path(path).read_text().splitlines()
        self.taken = np.array([line.split()[1:4] for line in lines if line.startswith("v ")], float)

    def test_a_menu_item_replaces_the_model_by_the_filtered_one(self):
        self.items["Burnish/Gradient scale..."]()
        self.assertEqual(self.said, [])
        np.testing.assert_allclose(self.taken, burnish.filter_vertices(VERTICES, FACES, beta=0), atol=1e-5)

    def test_each_preset_of_the_menu_is_one_of_the_program(self):
        for preset in self.script.PRESETS:
            self.items[f"Burnish/{preset}"]()
        self.assertEqual(self.said, [])

    def test_what_fails_is_said(self):
        self.script.filter_model = lambda options: self.script.filtered("absent.obj", "out.obj", options)
        self.items["Burnish/Take noise, keep edges"]()
        self.assertIn("absent.obj", self.said[0])
        self.chunk.model = None
        self.script = load("metashape_burnish")
        with self.assertRaisesRegex(RuntimeError, "has no model"):
            self.script.filter_model([])


if __name__ == "__main__":
    unittest.main()
