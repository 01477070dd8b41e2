"""Scans that a server keeps."""

from __future__ import annotations

import dataclasses
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from burnish.v1 import common_pb2, library_pb2

from .edits import EdgeFilter, Equaliser, GradientScale, TransferCurve
from .errors import NotFound
from .files import FORMAT_NAMES
from .presets import PresetChanges, preset_changes

if TYPE_CHECKING:
    from ._calls import Calls
    from .connection import Connection


@dataclasses.dataclass(frozen=True)
class Histogram:
    """The area of a scan by its curvature."""

    kappa: npt.NDArray[np.float64]
    """n + 1 edges of the bins: curvature times L, even in asinh."""
    area: npt.NDArray[np.float64]
    """n fractions of the area."""
    range: float = 0.0
    """The bins end here."""

    def quantile(self, fraction: float) -> float:
        """Returns the curvature (times L) below which this fraction of the area lies."""
        sums = np.concatenate([[0.0], np.cumsum(self.area)])
        return float(np.sinh(np.interp(fraction * sums[-1], sums, np.arcsinh(self.kappa))))


@dataclasses.dataclass(frozen=True)
class ThinWalls:
    """Walls thinner than a cell of the grid: an edit of one side moves the other."""

    share: float
    """Of the scan's area; 0: nothing to tell."""
    depth: int
    """The least at which nine tenths of them are not thinner than a cell; 0: none."""

    @classmethod
    def of(cls, message: common_pb2.ThinWalls) -> ThinWalls:
        return cls(message.share, message.depth)


@dataclasses.dataclass(frozen=True)
class EdgeProposal:
    """How the scan's own noise asks to keep edges."""

    noise: float
    """Deviation of the flatter parts along their normals, the scan's units."""
    mean_edge: float
    """The scan's units."""
    machined: bool
    """Nearly all bends are about right angles."""
    filter: EdgeFilter
    """Of strength 0 if there is no noise to speak of. It goes with waves of 12 mean edges."""


def propose_edges(calls: Calls, scan: str) -> EdgeProposal:
    events = calls.repeat(lambda: list(calls.stream(
        calls.library.ProposeEdges, library_pb2.ProposeEdgesRequest(scan=scan))))
    done = events[-1].done
    return EdgeProposal(done.noise, done.mean_edge, done.machined, EdgeFilter.of(done.filter))


@dataclasses.dataclass(frozen=True)
class Prepared:
    """A scan at one depth of the grid."""

    depth: int
    cell_size: float
    """The scan's units."""
    length_unit: float
    """L, the square root of the area, the scan's units."""
    cells: int
    memory_bytes: int
    """Shared by all sessions at this depth."""
    histogram: Histogram
    walls: ThinWalls

    def alpha_of(self, wavelength: float) -> float:
        """Returns the alpha at which a wave of this length is halved by beta 0. The scan's units."""
        return 2 * np.pi * self.length_unit / wavelength

    def preset(self, name: str, strength: float = 1.0, proposal: EdgeProposal | None = None,
               ) -> tuple[TransferCurve, GradientScale, Equaliser]:
        """Returns the edits that a preset of the program `burnish` is here; `strength`: 0 to 1.

        `proposal`: the scan's noise, which some presets follow; without it they are those for much
        noise. The equaliser has no bands where the preset has none. Raises NotFound,
        InvalidArgument. `Session.preset()` has the edits of kept edges too.
        """
        found = self.preset_changes(name, strength, proposal)
        return found.curve, found.beta, found.bands

    def preset_changes(self, name: str, strength: float, proposal: EdgeProposal | None = None,
                       can_keep_edges: bool = True) -> PresetChanges:
        """Does the same, with what the preset makes of kept edges."""
        bins = ",".join(repr(float(each)) for each in (self.histogram.range, *self.histogram.area))
        measures = [f"--length-unit={self.length_unit!r}", f"--cell-size={self.cell_size!r}",
                    f"--curvature={bins}"]
        if proposal:
            measures += [f"--mean-edge={proposal.mean_edge!r}", f"--noise={proposal.noise!r}"]
        if not can_keep_edges:
            measures.append("--without-edges")
        return preset_changes(name, strength, measures)


class Scan:
    """A mesh in a server's library. Its figures are those of the moment when it was asked for."""

    def __init__(self, connection: Connection, info: library_pb2.ScanInfo) -> None:
        self._connection, self._info = connection, info

    def __repr__(self) -> str:
        return f"<Scan {self.name} ({self.id[:12]}), {self.triangles} triangles>"

    @property
    def id(self) -> str:
        """SHA-256 of the file, 64 hexadecimal digits."""
        return self._info.id

    @property
    def name(self) -> str:
        return self._info.name

    @property
    def format(self) -> str:
        """"ply", "obj" ..."""
        return FORMAT_NAMES.get(self._info.format, "unknown")

    @property
    def size_bytes(self) -> int:
        return self._info.size_bytes

    @property
    def vertices(self) -> int:
        """The number of vertices."""
        return self._info.statistics.vertices

    @property
    def triangles(self) -> int:
        """The number of triangles."""
        return self._info.statistics.triangles

    @property
    def area(self) -> float:
        """The scan's units squared."""
        return self._info.statistics.area

    @property
    def is_watertight(self) -> bool:
        """Whether each edge has two triangles."""
        found = self._info.statistics
        return found.boundary_edges == 0 and found.non_manifold_edges == 0

    @property
    def bounds(self) -> npt.NDArray[np.float64]:
        """2 x 3: the least and the largest coordinates, the scan's units."""
        found = self._info.statistics
        return np.array([[point.x, point.y, point.z] for point in (found.box_min, found.box_max)])

    @property
    def unit(self) -> str:
        """Of the coordinates, as users named it: "mm"; empty if nobody did."""
        return self._info.unit

    @property
    def has_colours(self) -> bool:
        return self._info.has_colours

    @property
    def default_depth(self) -> int:
        """The depth of sessions that name none."""
        return self._info.default_depth

    @property
    def depths(self) -> list[int]:
        """The depths at which the scan is prepared."""
        return [prepared.depth for prepared in self._info.prepared]

    def prepared(self, depth: int = 0) -> Prepared:
        """Returns the facts of the scan at one depth; 0: the deepest. Raises NotFound."""
        calls = self._connection.calls
        described = calls.ask(calls.library.DescribeScan, library_pb2.DescribeScanRequest(
            scan=self.id, depth=depth))
        if not described.HasField("prepared"):
            raise self._not_prepared(depth)
        return prepared_of(described.prepared)

    def propose_edges(self) -> EdgeProposal:
        """Has the server measure the scan's noise, and say how to keep edges. It remembers that."""
        return propose_edges(self._connection.calls, self.id)

    def rename(self, name: str) -> None:
        """Gives the scan another name, 1 to 200 bytes of UTF-8."""
        calls = self._connection.calls
        self._info = calls.ask(calls.library.RenameScan, library_pb2.RenameScanRequest(
            scan=self.id, name=name))

    def set_unit(self, unit: str) -> None:
        """Names the unit of the coordinates, at most 16 bytes. Numbers do not change."""
        calls = self._connection.calls
        self._info = calls.ask(calls.library.SetScanUnit, library_pb2.SetScanUnitRequest(
            scan=self.id, unit=unit))

    def delete(self) -> None:
        """Deletes the scan. Raises FailedPrecondition while sessions edit it."""
        calls = self._connection.calls
        calls.ask_once(calls.library.DeleteScan, library_pb2.DeleteScanRequest(scan=self.id))

    def _not_prepared(self, depth: int) -> Exception:
        return NotFound(f"scan {self.name} is not prepared at depth {depth}, but at {self.depths}")


def prepared_of(message: Any) -> Prepared:
    area = np.array(message.histogram, np.float64)
    reach = np.arcsinh(message.histogram_range)
    kappa = np.sinh(np.linspace(-reach, reach, len(area) + 1))
    return Prepared(message.depth, message.cell_size, message.length_unit, message.cells,
                    message.memory_bytes, Histogram(kappa, area, message.histogram_range),
                    ThinWalls.of(message.walls))
