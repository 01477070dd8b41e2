"""A filter of ParaView that smooths or sharpens a surface with Burnish.

In ParaView: Tools, Manage Plugins, Load New, this file; tick Auto Load to keep it. The filter is then
Filters, Alphabetical, Burnish. It takes polygonal data: put Extract Surface before it for other data.
ParaView's Python must find the package `burnish`.
"""

import os

from paraview.util.vtkAlgorithm import VTKPythonAlgorithmBase, smdomain, smhint, smproperty, smproxy
from vtkmodules.vtkCommonDataModel import vtkPolyData

# ParaView has a protobuf of its own in its process; a second one in C++ would end it.
os.environ.setdefault("PROTOCOL_BUFFERS_PYTHON_IMPLEMENTATION", "python")
import burnish  # noqa: E402

AS_IT_IS = "as it is"


class Aborted(Exception):
    """The user has stopped the filter."""


@smproxy.filter(name="Burnish", label="Burnish")
@smproperty.input(name="Input")
@smdomain.datatype(dataTypes=["vtkPolyData"], composite_data_supported=False)
@smhint.xml('<ShowInMenu category="Burnish" />')
class BurnishFilter(VTKPythonAlgorithmBase):
    """Moves the points of a surface; cells and arrays stay, and normals are dropped."""

    def __init__(self):
        VTKPythonAlgorithmBase.__init__(self, nInputPorts=1, nOutputPorts=1, outputType="vtkPolyData")
        self._beta = 0.5
        self._wavelength = 0.0
        self._edges = AS_IT_IS
        self._exact = False

    def _set(self, name, value):
        if getattr(self, name) != value:
            setattr(self, name, value)
            self.Modified()

    @smproperty.doublevector(name="GradientScale", default_values=0.5)
    @smdomain.doublerange(min=0, max=10)
    def SetGradientScale(self, beta):
        """Below 1 smooths, 1 keeps, above 1 sharpens."""
        self._set("_beta", beta)

    @smproperty.doublevector(name="Wavelength", default_values=0.0)
    def SetWavelength(self, length):
        """Longer waves stay; in the units of the points. 0: the default."""
        self._set("_wavelength", length)

    @smproperty.stringvector(name="EdgeNames", information_only="1")
    def GetEdgeNames(self):
        return [AS_IT_IS, "auto", "machined", "scanner", "relief", "soft"]

    @smproperty.stringvector(name="KeepEdges", default_values=AS_IT_IS)
    @smdomain.xml('<StringListDomain name="list"><RequiredProperties>'
                  '<Property name="EdgeNames" function="StringInfo"/></RequiredProperties></StringListDomain>')
    def SetKeepEdges(self, name):
        """Takes noise away and keeps edges first, by the scan's own noise or for a kind of scan."""
        self._set("_edges", name)

    @smproperty.intvector(name="Exact", default_values=0)
    @smdomain.xml('<BooleanDomain name="bool"/>')
    def SetExact(self, exact):
        """Solves to the accuracy of final results, which takes longer."""
        self._set("_exact", bool(exact))

    def RequestData(self, request, inputs, outputs):
        surface = vtkPolyData.GetData(inputs[0])
        options = {"beta": self._beta, "exact": self._exact,
                   "wavelength": self._wavelength if self._wavelength > 0 else None,
                   "keep_edges": None if self._edges == AS_IT_IS else self._edges}
        try:
            moved = burnish.filter_mesh(surface, progress=self._tell, **options)
        except Aborted:
            return 0
        for of in (moved.GetPointData(), moved.GetCellData()):
            of.SetNormals(None)
        vtkPolyData.GetData(outputs).ShallowCopy(moved)
        return 1

    def _tell(self, phase, fraction):
        self.UpdateProgress(fraction)
        if self.GetAbortExecute():
            raise Aborted
