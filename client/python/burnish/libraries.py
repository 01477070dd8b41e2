"""Meshes of other libraries, known by their members: no library is imported.

Faces never change, so a mesh is a copy of the given one with other positions, and what a library
keeps beside them stays. Normals that a library keeps are those of the given mesh.
"""

from __future__ import annotations

import copy
import dataclasses
from typing import Any, Callable

import numpy as np
import numpy.typing as npt

from .mesh import Mesh

Colours = npt.NDArray[Any] | None
TAKEN = ("a burnish.Mesh, a Trimesh of trimesh, a TriangleMesh of Open3D, a PolyData of PyVista or VTK, "
         "a Mesh of meshio, of PyMeshLab or of Blender")


@dataclasses.dataclass(frozen=True)
class Held:
    """A mesh of a library, as filter_vertices() takes it."""

    vertices: Any
    faces: Any
    colours: Colours
    rebuild: Callable[[npt.NDArray[Any], Colours], Any]
    """Returns a copy of the mesh with these vertices, and with these colours unless they are None."""


def held(mesh: Any) -> Held:
    """Returns a library's mesh as arrays. Raises TypeError for anything else."""
    for name, read in _LIBRARIES.items():
        if all(hasattr(mesh, member) for member in name.split()):
            return read(mesh)
    raise TypeError(f"the mesh is of type {type(mesh).__module__}.{type(mesh).__name__}: it takes {TAKEN}; "
                    "filter_vertices() takes arrays")


def _own(mesh: Mesh) -> Held:
    return Held(mesh.vertices, mesh.faces, None, lambda vertices, _: Mesh(vertices, mesh.faces))


def _trimesh(mesh: Any) -> Held:
    def rebuild(vertices: npt.NDArray[Any], colours: Colours) -> Any:
        made = mesh.copy()
        made.vertices = vertices
        if colours is not None:
            made.visual.vertex_colors = colours
        return made
    has_colours = getattr(getattr(mesh, "visual", None), "kind", None) == "vertex"
    colours = np.asarray(mesh.visual.vertex_colors) if has_colours else None
    return Held(np.asarray(mesh.vertices), np.asarray(mesh.faces), colours, rebuild)


def _open3d(mesh: Any) -> Held:
    def rebuild(vertices: npt.NDArray[Any], colours: Colours) -> Any:
        made = copy.deepcopy(mesh)
        made.vertices = type(mesh.vertices)(vertices)
        if colours is not None:
            made.vertex_colors = type(mesh.vertex_colors)(colours)
        return made
    colours = np.asarray(mesh.vertex_colors) if len(mesh.vertex_colors) else None
    return Held(np.asarray(mesh.vertices), np.asarray(mesh.triangles), colours, rebuild)


def _open3d_tensors(mesh: Any) -> Held:
    """Reads a TriangleMesh of open3d.t.geometry, whose arrays may be on a graphics card."""
    places = mesh.vertex["positions"]

    def tensor(array: npt.NDArray[Any]) -> Any:
        return type(places).from_numpy(np.ascontiguousarray(array)).to(places.device)

    def rebuild(vertices: npt.NDArray[Any], colours: Colours) -> Any:
        made = mesh.clone()
        made.vertex["positions"] = tensor(vertices)
        if colours is not None:
            made.vertex["colors"] = tensor(colours)
        return made
    colours = mesh.vertex["colors"].cpu().numpy() if "colors" in mesh.vertex else None
    return Held(places.cpu().numpy(), mesh.triangle["indices"].cpu().numpy(), colours, rebuild)


def _vtk_array(array: Any) -> npt.NDArray[Any]:
    """Returns the values of a vtkDataArray, shared with it: one axis, or a row a tuple."""
    values = np.asarray(memoryview(array))
    return values.reshape(array.GetNumberOfTuples(), -1) if array.GetNumberOfComponents() > 1 else values.ravel()


def _vtk(mesh: Any) -> Held:
    """Reads vtkPolyData, and so PyVista's PolyData. Lines, points and strips stay where they are."""
    def rebuild(vertices: npt.NDArray[Any], colours: Colours) -> Any:
        made = type(mesh)()
        made.DeepCopy(mesh)
        _vtk_array(made.GetPoints().GetData())[:] = vertices
        made.GetPoints().Modified()
        if colours is not None:
            _vtk_array(made.GetPointData().GetScalars())[:] = colours
            made.GetPointData().GetScalars().Modified()
        return made
    if mesh.GetPoints() is None or not mesh.GetPolys().GetNumberOfCells():
        raise ValueError(f"the mesh, a {type(mesh).__name__}, has no polygons: 1 at least")
    places = _vtk_array(mesh.GetPoints().GetData())
    offsets = _vtk_array(mesh.GetPolys().GetOffsetsArray())
    corners = _vtk_array(mesh.GetPolys().GetConnectivityArray())
    scalars = mesh.GetPointData().GetScalars()
    has_colours = scalars is not None and scalars.GetNumberOfComponents() in (3, 4)
    colours = _vtk_array(scalars) if has_colours else None
    if colours is not None and colours.dtype != np.uint8:
        colours = None
    return Held(places, _faces(np.diff(offsets), corners), colours, rebuild)


def _meshio(mesh: Any) -> Held:
    def rebuild(vertices: npt.NDArray[Any], colours: Colours) -> Any:
        made = copy.deepcopy(mesh)
        made.points = vertices
        return made
    blocks = [np.asarray(block.data) for block in mesh.cells
              if block.type in ("triangle", "quad") or block.type.startswith("polygon")]
    if not blocks:
        types = ", ".join(block.type for block in mesh.cells) or "nothing"
        raise ValueError(f"the mesh has cells of {types}: it takes triangle, quad, polygon")
    sizes = np.concatenate([np.full(len(block), block.shape[1]) for block in blocks])
    return Held(mesh.points, _faces(sizes, np.concatenate([block.ravel() for block in blocks])), None, rebuild)


def _pymeshlab(mesh: Any) -> Held:
    """Reads a Mesh of PyMeshLab, which cannot be copied: the new one has positions, triangles and
    colours alone."""
    def rebuild(vertices: npt.NDArray[Any], colours: Colours) -> Any:
        kept = mesh.vertex_color_matrix() if colours is None and has_colours else colours
        more = {} if kept is None else {"v_color_matrix": kept}
        return type(mesh)(vertex_matrix=vertices, face_matrix=mesh.face_matrix(), **more)
    has_colours = mesh.has_vertex_color()
    colours = mesh.vertex_color_matrix() if has_colours else None
    return Held(mesh.vertex_matrix(), mesh.face_matrix(), colours, rebuild)


def _blender(mesh: Any) -> Held:
    """Reads a Mesh of Blender, bpy.types.Mesh; an object has one as its data."""
    def read(items: Any, name: str, kind: Any, each: int = 1) -> npt.NDArray[Any]:
        values = np.empty(len(items) * each, kind)
        items.foreach_get(name, values)
        return values

    def rebuild(vertices: npt.NDArray[Any], colours: Colours) -> Any:
        made = mesh.copy()
        made.vertices.foreach_set("co", np.ascontiguousarray(vertices, np.float32).ravel())
        made.update()
        return made
    sizes = read(mesh.polygons, "loop_total", np.int32)
    corners = read(mesh.loops, "vertex_index", np.int32)
    return Held(read(mesh.vertices, "co", np.float32, 3).reshape(-1, 3), _faces(sizes, corners), None, rebuild)


def _faces(sizes: npt.NDArray[Any], corners: npt.NDArray[Any]) -> Any:
    """Returns the rows of faces of these sizes: padded with -1 unless all have one size."""
    width = int(sizes.max()) if len(sizes) else 3
    used = np.arange(width) < sizes[:, None]
    faces = np.full(used.shape, -1, np.int64)
    faces[used] = corners
    return faces


_LIBRARIES: dict[str, Callable[[Any], Held]] = {
    "to_ply vertices faces": _own,
    "GetPolys GetPoints DeepCopy": _vtk,
    "points cells cells_dict": _meshio,
    "vertex_matrix face_matrix": _pymeshlab,
    "vertex triangle clone": _open3d_tensors,
    "vertices triangles vertex_colors": _open3d,
    "vertices polygons loops": _blender,
    "vertices faces copy": _trimesh,
}
"""The members by which a mesh is known, and what reads it."""
