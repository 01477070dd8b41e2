"""Filters of VTK and Open3D. Each yields its settings in words, and the points that come out."""

import numpy as np

STEPS = (1, 2, 3, 5, 10, 20, 50, 100)


def vtk_version() -> str:
    from vtkmodules.vtkCommonCore import vtkVersion
    return vtkVersion.GetVTKVersion()


def _polydata(shape):
    from vtkmodules.util import numpy_support
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
    points, cells, data = vtkPoints(), vtkCellArray(), vtkPolyData()
    points.SetData(numpy_support.numpy_to_vtk(shape.points, deep=True))
    starts = np.arange(0, 3 * len(shape.triangles) + 1, 3)
    cells.SetData(numpy_support.numpy_to_vtkIdTypeArray(starts, deep=True),
                  numpy_support.numpy_to_vtkIdTypeArray(shape.triangles.ravel(), deep=True))
    data.SetPoints(points)
    data.SetPolys(cells)
    return data


def _result(smoother, data, keeps_edges):
    from vtkmodules.util import numpy_support
    smoother.SetInputData(data)
    smoother.SetFeatureEdgeSmoothing(keeps_edges)
    smoother.Update()
    return numpy_support.vtk_to_numpy(smoother.GetOutput().GetPoints().GetData())


def vtk_filters(shape):
    from vtkmodules.vtkFiltersCore import vtkSmoothPolyDataFilter, vtkWindowedSincPolyDataFilter
    data = _polydata(shape)
    for edges in (0, 1):
        with_edges = ", feature edges" if edges else ""
        for iterations in (20, 100):
            for band in (0.5, 0.3, 0.2, 0.1, 0.05, 0.02, 0.01, 0.005):
                sinc = vtkWindowedSincPolyDataFilter()
                sinc.NormalizeCoordinatesOn()
                sinc.SetNumberOfIterations(iterations)
                sinc.SetPassBand(band)
                yield f"sinc {band:g}, {iterations}{with_edges}", _result(sinc, data, edges)
        for iterations in STEPS:
            laplacian = vtkSmoothPolyDataFilter()
            laplacian.SetRelaxationFactor(0.1)
            laplacian.SetNumberOfIterations(iterations)
            yield f"Laplacian 0.1, {iterations}{with_edges}", _result(laplacian, data, edges)


def open3d_version() -> str:
    import open3d
    return open3d.__version__


def open3d_filters(shape):
    import open3d
    mesh = open3d.geometry.TriangleMesh(open3d.utility.Vector3dVector(shape.points),
                                        open3d.utility.Vector3iVector(shape.triangles))
    for steps in STEPS:
        yield f"Taubin {steps}", np.asarray(mesh.filter_smooth_taubin(steps).vertices)
        yield f"Laplacian {steps}", np.asarray(mesh.filter_smooth_laplacian(steps).vertices)
