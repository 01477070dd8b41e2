"""Meshes of other libraries. The test of a library that is not installed is skipped; libraries that
Debian does not have are played by stand-ins with their members' names."""

import copy
import importlib
import json
import shutil
import subprocess
import sys
import tempfile
import unittest

import numpy as np

import burnish
import scan

SMOOTH = {"beta": 0, "alpha": 5, "depth": 4}
VERTICES, FACES = scan.bumpy_sphere(2)
COLOURS = np.zeros((len(VERTICES), 3), np.uint8)
COLOURS[::2, 0] = 200
EDITED, EDITED_COLOURS = burnish.filter_vertices(VERTICES, FACES, colours=COLOURS, colour_beta=0,
                                                 colour_alpha=5, **SMOOTH)
QUADS = np.array([[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]])
CUBE = np.array([[x, y, z] for z in (0, 1) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))], float)
SMALL = {"beta": 0, "alpha": 1, "depth": 4}

BLENDER = """
import sys, json
sys.path[:0] = json.loads({path!r})
import bpy, numpy as np, burnish
bpy.ops.mesh.primitive_monkey_add()
mesh = bpy.context.object.data
mesh.uv_layers.new(name="kept")
def places(mesh):
    found = np.empty(3 * len(mesh.vertices), np.float32)
    mesh.vertices.foreach_get("co", found)
    return found.reshape(-1, 3)
before = places(mesh)
edited = burnish.filter_mesh(mesh, beta=0, alpha=5, depth=4)
expected = burnish.filter_vertices(before, [list(one.vertices) for one in mesh.polygons], beta=0, alpha=5, depth=4)
print("FOUND", json.dumps(dict(
    kind=type(edited).__name__, kept=[layer.name for layer in edited.uv_layers],
    sides=sorted({{len(one.vertices) for one in edited.polygons}}), stays=bool((places(mesh) == before).all()),
    moved=float(abs(places(edited) - before).max()), error=float(abs(places(edited) - expected).max()))))
"""


def library(name):
    """Returns a library, or skips the test."""
    try:
        return importlib.import_module(name)
    except ImportError as error:
        raise unittest.SkipTest(f"{name} is not installed: {error}") from None


class Visual:
    kind = "vertex"

    def __init__(self, colours):
        self.vertex_colors = colours


class Trimesh:
    """As trimesh.Trimesh: arrays, copy(), and the colours of vertices in `visual`."""

    def __init__(self, vertices, faces, colours):
        self.vertices, self.faces, self.visual = vertices, faces, Visual(colours)
        self.metadata = {"name": "kept"}

    def copy(self):
        return copy.deepcopy(self)


class PyMeshLabMesh:
    """As pymeshlab.Mesh: matrices that cannot be set."""

    def __init__(self, vertex_matrix, face_matrix, v_color_matrix=None):
        self._vertices, self._faces, self._colours = vertex_matrix, face_matrix, v_color_matrix

    def vertex_matrix(self):
        return self._vertices

    def face_matrix(self):
        return self._faces

    def has_vertex_color(self):
        return self._colours is not None

    def vertex_color_matrix(self):
        return self._colours


class StandIns(unittest.TestCase):
    def test_a_trimesh_comes_back_with_its_metadata_and_colours(self):
        mesh = Trimesh(VERTICES, FACES, np.insert(COLOURS, 3, 255, axis=1))
        edited = burnish.filter_mesh(mesh, **SMOOTH)
        np.testing.assert_array_equal(edited.vertices, EDITED)
        np.testing.assert_array_equal(edited.visual.vertex_colors, mesh.visual.vertex_colors)
        self.assertEqual((type(edited), edited.metadata), (Trimesh, {"name": "kept"}))
        np.testing.assert_array_equal(mesh.vertices, VERTICES)
        edited = burnish.filter_mesh(mesh, colour_beta=0, colour_alpha=5, **SMOOTH)
        np.testing.assert_array_equal(edited.visual.vertex_colors[:, :3], EDITED_COLOURS)

    def test_a_mesh_of_pymeshlab_comes_back_with_its_triangles_and_colours(self):
        colours = np.insert(COLOURS / 255, 3, 1, axis=1)
        mesh = PyMeshLabMesh(VERTICES, FACES, colours)
        edited = burnish.filter_mesh(mesh, **SMOOTH)
        np.testing.assert_array_equal(edited.vertex_matrix(), EDITED)
        np.testing.assert_array_equal(edited.face_matrix(), FACES)
        np.testing.assert_array_equal(edited.vertex_color_matrix(), colours)
        edited = burnish.filter_mesh(mesh, colour_beta=0, colour_alpha=5, **SMOOTH)
        np.testing.assert_allclose(edited.vertex_color_matrix()[:, :3], EDITED_COLOURS / 255)
        self.assertFalse(burnish.filter_mesh(PyMeshLabMesh(VERTICES, FACES), **SMOOTH)
                         .has_vertex_color())

    def test_anything_else_is_refused_with_its_type(self):
        for thing, words in ((VERTICES, "numpy.ndarray.*trimesh.*filter_vertices"), ("a.ply", "str"),
                             (None, "NoneType")):
            with self.subTest(words), self.assertRaisesRegex(TypeError, words):
                burnish.filter_mesh(thing)


class Vtk(unittest.TestCase):
    """PyVista's PolyData is a vtkPolyData."""

    def setUp(self):
        library("vtkmodules.vtkCommonDataModel")
        self.vtk = library("vtkmodules.all")
        self.support = library("vtkmodules.util.numpy_support")

    def polydata(self, vertices, faces):
        mesh, points, cells = self.vtk.vtkPolyData(), self.vtk.vtkPoints(), self.vtk.vtkCellArray()
        points.SetData(self.support.numpy_to_vtk(vertices, deep=1))
        mesh.SetPoints(points)
        for face in faces:
            cells.InsertNextCell(len(face), [int(index) for index in face])
        mesh.SetPolys(cells)
        return mesh

    def places(self, mesh):
        return self.support.vtk_to_numpy(mesh.GetPoints().GetData())

    def test_polydata_comes_back_with_its_arrays(self):
        mesh = self.polydata(VERTICES, FACES)
        heights = self.support.numpy_to_vtk(VERTICES[:, 2].copy(), deep=1)
        heights.SetName("height")
        mesh.GetPointData().AddArray(heights)
        edited = burnish.filter_mesh(mesh, **SMOOTH)
        np.testing.assert_array_equal(self.places(edited), EDITED)
        np.testing.assert_array_equal(self.places(mesh), VERTICES)
        np.testing.assert_array_equal(
            self.support.vtk_to_numpy(edited.GetPointData().GetArray("height")), VERTICES[:, 2])
        self.assertEqual(edited.GetNumberOfPolys(), len(FACES))

    def test_quads_and_triangles_in_single_precision_stay_so(self):
        faces = [*QUADS[:5].tolist(), [3, 0, 4], [3, 4, 7]]
        edited = burnish.filter_mesh(self.polydata(np.float32(CUBE), faces), **SMALL)
        self.assertEqual(self.places(edited).dtype, np.float32)
        np.testing.assert_array_equal(self.places(edited),
                                      burnish.filter_vertices(np.float32(CUBE), faces, **SMALL))
        self.assertEqual(edited.GetCell(0).GetNumberOfPoints(), 4)

    def test_colours_are_edited_on_demand(self):
        mesh = self.polydata(VERTICES, FACES)
        mesh.GetPointData().SetScalars(self.support.numpy_to_vtk(COLOURS, deep=1))
        edited = burnish.filter_mesh(mesh, colour_beta=0, colour_alpha=5, **SMOOTH)
        np.testing.assert_array_equal(
            self.support.vtk_to_numpy(edited.GetPointData().GetScalars()), EDITED_COLOURS)

    def test_a_subclass_as_pyvistas_stays_itself(self):
        class PolyData(self.vtk.vtkPolyData):
            """Has arrays beside VTK's members, as pyvista.PolyData."""
            points = property(lambda self: None)
            faces = property(lambda self: None)
            copy = None
        mesh = PolyData()
        mesh.DeepCopy(self.polydata(VERTICES, FACES))
        edited = burnish.filter_mesh(mesh, **SMOOTH)
        self.assertIs(type(edited), PolyData)
        np.testing.assert_array_equal(self.places(edited), EDITED)

    def test_normals_and_clean_filters_take_the_result(self):
        edited = burnish.filter_mesh(self.polydata(VERTICES[:-1], FACES), **SMOOTH)
        for kind in ("vtkPolyDataNormals", "vtkCleanPolyData", "vtkTriangleFilter"):
            with self.subTest(kind):
                step = getattr(self.vtk, kind)()
                step.SetInputData(edited)
                step.Update()
                self.assertGreaterEqual(step.GetOutput().GetNumberOfPolys(), len(FACES))

    def test_a_mesh_without_polygons_is_refused(self):
        with self.assertRaisesRegex(ValueError, "no polygons"):
            burnish.filter_mesh(self.vtk.vtkPolyData())


class Meshio(unittest.TestCase):
    def setUp(self):
        self.meshio = library("meshio")

    def test_a_mesh_comes_back_with_its_data(self):
        mesh = self.meshio.Mesh(VERTICES, [("line", [[0, 1]]), ("triangle", FACES)],
                                point_data={"height": VERTICES[:, 2]})
        edited = burnish.filter_mesh(mesh, **SMOOTH)
        np.testing.assert_array_equal(edited.points, EDITED)
        np.testing.assert_array_equal(mesh.points, VERTICES)
        np.testing.assert_array_equal(edited.point_data["height"], VERTICES[:, 2])
        self.assertEqual([block.type for block in edited.cells], ["line", "triangle"])

    def test_quads_and_triangles_go_together(self):
        cells = [("quad", QUADS[:5]), ("triangle", np.array([[3, 0, 4], [3, 4, 7]]))]
        edited = burnish.filter_mesh(self.meshio.Mesh(np.float32(CUBE), cells), **SMALL)
        expected = burnish.filter_vertices(
            np.float32(CUBE), [*QUADS[:5].tolist(), [3, 0, 4], [3, 4, 7]], **SMALL)
        np.testing.assert_array_equal(edited.points, expected)
        self.assertEqual(edited.points.dtype, np.float32)

    def test_its_files_go_in_and_out(self):
        with tempfile.TemporaryDirectory(prefix="burnish-") as folder:
            self.meshio.Mesh(VERTICES, [("triangle", FACES)]).write(f"{folder}/in.vtk")
            burnish.filter_mesh(self.meshio.read(f"{folder}/in.vtk"), **SMOOTH).write(f"{folder}/out.vtk")
            np.testing.assert_array_equal(self.meshio.read(f"{folder}/out.vtk").points, EDITED)

    def test_a_mesh_of_solids_is_refused_with_its_types(self):
        with self.assertRaisesRegex(ValueError, "tetra.*triangle, quad, polygon"):
            burnish.filter_mesh(self.meshio.Mesh(CUBE, [("tetra", [[0, 1, 2, 4]])]))


class Open3d(unittest.TestCase):
    def setUp(self):
        self.open3d = library("open3d")

    def test_a_triangle_mesh_comes_back_with_its_colours(self):
        vector = self.open3d.utility
        mesh = self.open3d.geometry.TriangleMesh(vector.Vector3dVector(VERTICES),
                                                 vector.Vector3iVector(FACES))
        mesh.vertex_colors = vector.Vector3dVector(COLOURS / 255)
        edited = burnish.filter_mesh(mesh, **SMOOTH)
        np.testing.assert_array_equal(np.asarray(edited.vertices), EDITED)
        np.testing.assert_array_equal(np.asarray(mesh.vertices), VERTICES)
        np.testing.assert_array_equal(np.asarray(edited.vertex_colors), COLOURS / 255)
        edited = burnish.filter_mesh(mesh, colour_beta=0, colour_alpha=5, **SMOOTH)
        np.testing.assert_allclose(np.asarray(edited.vertex_colors), EDITED_COLOURS / 255)
        edited.compute_vertex_normals()
        self.assertTrue(edited.has_vertex_normals() and edited.has_triangles())

    def test_a_mesh_of_tensors_comes_back(self):
        tensor = self.open3d.core.Tensor
        mesh = self.open3d.t.geometry.TriangleMesh(tensor(np.float32(VERTICES)), tensor(FACES))
        edited = burnish.filter_mesh(mesh, **SMOOTH)
        expected = burnish.filter_vertices(np.float32(VERTICES), FACES, **SMOOTH)
        np.testing.assert_array_equal(edited.vertex["positions"].numpy(), expected)
        np.testing.assert_array_equal(mesh.vertex["positions"].numpy(), np.float32(VERTICES))


class Blender(unittest.TestCase):
    def test_a_mesh_comes_back_with_its_layers(self):
        if shutil.which("blender") is None:
            self.skipTest("blender is not installed")
        code = BLENDER.format(path=json.dumps([path for path in sys.path if path]))
        done = subprocess.run(["blender", "--background", "--factory-startup", "--python-exit-code", "1",
                               "--python-expr", code], capture_output=True, text=True, check=False)
        lines = [line for line in done.stdout.splitlines() if line.startswith("FOUND ")]
        self.assertEqual(len(lines), 1, done.stdout + done.stderr)
        found = json.loads(lines[0][6:])
        self.assertGreater(found.pop("moved"), 0.001)
        self.assertEqual(found, {"kind": "Mesh", "kept": ["UVMap", "kept"], "sides": [3, 4],
                                 "stays": True, "error": 0})


if __name__ == "__main__":
    unittest.main()
