"""Edits the fine detail of 3D scans, on a Burnish server or on this computer.

>>> import burnish
>>> burnish.filter("tablet.ply", "smooth.ply", beta=0.2)
>>> with burnish.connect("127.0.0.1:7411", user="Anna") as server:
...     session = server.open_session(server.import_scan("tablet.ply"), "carving")
...     session.set_beta(0.2)
...     session.export("edited.ply", exact=True)
"""

from ._version import __version__
from .cells import CellEdges, CellFields, CellProtection, CellTexture
from .connection import Connection, connect
from .edits import (Band, Brush, ColourFilter, Controls, EdgeFilter, Equaliser, GradientScale,
                    Palette, PaletteCurve, Stroke, TextureFilter, TransferCurve)
from .errors import (AlreadyExists, Cancelled, Damaged, DeadlineExceeded, Error,
                     FailedPrecondition, Internal, InvalidArgument, NotFound, PermissionDenied,
                     Refused, ResourceExhausted, SessionEnded, Unauthenticated, Unavailable,
                     Unimplemented)
from .frame import Frame
from .gesture import Gesture
from .history import AxisMoves, Deviation, Entry, Exported, State
from .live import Live
from .local import Filtered, filter, filter_all, filter_mesh, filter_vertices
from .mesh import Mesh, load_ply
from .options import Options
from .people import People
from .pictures import animate, render
from .presets import presets
from .region import (ClearProtected, GrowProtected, InvertProtected, ProtectCurvature,
                     ProtectLasso, ProtectPiece)
from .scan import EdgeProposal, Histogram, Prepared, Scan, ThinWalls
from .serving import Server, serve
from .session import Session

__all__ = [
    "AlreadyExists", "AxisMoves", "Band", "Brush", "Cancelled", "CellEdges", "CellFields", "CellProtection", "CellTexture",
    "ClearProtected", "ColourFilter", "Connection", "Controls", "Damaged", "DeadlineExceeded", "Deviation", "EdgeFilter",
    "EdgeProposal", "Entry", "Equaliser", "Error", "Exported", "FailedPrecondition", "Filtered",
    "Frame", "Gesture", "GradientScale", "GrowProtected", "Histogram", "Internal",
    "InvalidArgument", "InvertProtected", "Live", "Mesh", "NotFound", "Options", "Palette",
    "PaletteCurve", "People", "PermissionDenied", "Prepared", "ProtectCurvature", "ProtectLasso",
    "ProtectPiece", "Refused", "ResourceExhausted", "Scan", "Server", "Session", "SessionEnded", "State",
    "Stroke", "TextureFilter", "ThinWalls", "TransferCurve", "Unauthenticated", "Unavailable",
    "Unimplemented", "__version__", "animate", "connect", "filter", "filter_all", "filter_mesh", "filter_vertices",
    "load_ply", "presets", "render", "serve",
]
