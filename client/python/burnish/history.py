"""The history of a session, and its state."""

from __future__ import annotations

import dataclasses
import datetime

import numpy as np
import numpy.typing as npt

from burnish.v1 import editing_pb2

from .edits import Band, ColourFilter, Controls, EdgeFilter, PaletteCurve, TextureFilter, TransferCurve
from .scan import ThinWalls

KINDS: dict[int, str] = {
    number: name.removeprefix("ENTRY_KIND_").replace("_", " ").lower()
    for name, number in editing_pb2.EntryKind.items() if number}


def _kind(message: editing_pb2.HistoryEntry) -> str:
    exact = KINDS.get(message.exact_kind)
    if exact:
        return exact
    # Older servers tell all later kinds as cell fields.
    is_clear = message.kind != editing_pb2.ENTRY_KIND_CELL_FIELDS
    return KINDS.get(message.kind, "other") if is_clear else "other"


@dataclasses.dataclass(frozen=True)
class Entry:
    """An edit in the history."""

    number: int
    """Counts all edits of the session from 1."""
    author: str
    """Empty for a user without a name."""
    time: datetime.datetime
    kind: str
    """gradient scale, transfer curve, stroke, cell fields, controls, protect, equaliser, palette,
    colour, edges, texture, checkpoint or damaged; other where neither program knows more: see the summary."""
    summary: str
    """In a few words; a checkpoint's name."""
    enabled: bool
    name: str = ""
    """For people: "Smooth stroke". Later versions may say it otherwise; empty from an older server."""
    details: str = ""
    """What the name does not say, but for the radius."""
    radius: float = 0.0
    """Of a stroke's brush, the scan's units; 0: it has none."""

    @classmethod
    def of(cls, message: editing_pb2.HistoryEntry) -> Entry:
        time = datetime.datetime.fromtimestamp(message.unix_ms / 1000, datetime.timezone.utc)
        return cls(message.number, message.author, time, _kind(message), message.summary,
                   message.enabled, message.name, message.details, message.radius)


@dataclasses.dataclass(frozen=True)
class State:
    """How a session is set, and how far it is solved."""

    beta: float
    curve: TransferCurve
    controls: Controls
    bands: list[Band]
    edits: int
    cycles: int
    """Since the session came into memory; 0: no distance."""
    distance: float
    """Estimated to the converged surface, over the box's diagonal."""
    memory_bytes: int
    backend: str
    """"cpu" or "cuda"."""
    rims: int
    """Of the scan, while the controls pin them."""
    rims_held: int
    walls: ThinWalls
    """Of the scan at this depth."""
    palette: list[PaletteCurve]
    """That a brush can paint."""
    colour: ColourFilter
    """Of the scan's colours; beta 1 keeps them."""
    edges: EdgeFilter
    """How edges are kept; at strength 0 they are not."""
    texture: TextureFilter
    """Of the scan's colours."""

    @classmethod
    def of(cls, message: editing_pb2.SessionState) -> State:
        controls, colour, texture = message.controls, message.colour, message.texture
        return cls(message.gradient_scale,
                   TransferCurve.of(message.transfer_curve),
                   Controls(controls.pin_rims, controls.cap, controls.keep_volume),
                   [Band(band.size, band.gain) for band in message.equaliser.bands],
                   message.session.edits, message.cycles, message.distance, message.memory_bytes,
                   message.backend, message.rims, message.rims_held,
                   ThinWalls.of(message.walls),
                   [PaletteCurve(one.name, TransferCurve.of(one.curve), one.colour)
                    for one in message.palette.curves],
                   ColourFilter(colour.beta, colour.alpha) if message.HasField("colour")
                   else ColourFilter(1.0),
                   EdgeFilter.of(message.edges) if message.HasField("edges") else EdgeFilter(0.0),
                   TextureFilter(texture.gain, texture.remove_light, texture.level_seams)
                   if message.HasField("texture") else TextureFilter())


@dataclasses.dataclass(frozen=True)
class AxisMoves:
    """Moves along an axis; those towards larger coordinates count positive. Means are over the area."""

    least: float
    """At most 0."""
    most: float
    """At least 0."""
    mean: float
    rms: float


@dataclasses.dataclass(frozen=True)
class Deviation:
    """How far edits moved a surface. Lengths are in the scan's units; means are over the area."""

    max: float
    mean: float
    rms: float
    outward_max: float
    inward_max: float
    area: tuple[float, float]
    """Before and after, the scan's units squared."""
    volume: tuple[float, float]
    """Before and after, the scan's units cubed; of closed surfaces."""
    moves: npt.NDArray[np.float64]
    """n + 1 edges of the histogram's bins: moves along the normal."""
    histogram: npt.NDArray[np.float64]
    """n fractions of the area."""
    settled: bool
    along: tuple[AxisMoves, ...] = ()
    """x, y and z; empty from an older server."""

    @classmethod
    def of(cls, message: editing_pb2.Deviation) -> Deviation:
        histogram = np.array(message.histogram)
        reach = message.histogram_range
        return cls(message.max, message.mean, message.rms, message.outward_max,
                   message.inward_max, (message.area_before, message.area_after),
                   (message.volume_before, message.volume_after),
                   np.linspace(-reach, reach, len(histogram) + 1), histogram, message.settled,
                   tuple(AxisMoves(one.least, one.most, one.mean, one.rms) for one in message.axes))


@dataclasses.dataclass(frozen=True)
class Exported:
    """The summary of an export."""

    size_bytes: int
    sha256: str
    vertices: int
    triangles: int
    cycles: int
    """Of this export."""
    converged: bool
    distance: float
    """Estimated to the converged surface, over the box's diagonal."""
    left_out: list[str]
    """Attributes of the imported file that this file does not have."""
    volume: float | None
    """Over the scan's, if the controls keep it; None if they do not."""
    lost_volume: str
    """How much of the volume there is, and why not all of it. Empty if it was kept to 1e-6."""
    pictures: str
    """Says what became of the scan's pictures under edited colours. Empty if none shows one."""

    @classmethod
    def of(cls, message: editing_pb2.ExportSummary) -> Exported:
        return cls(message.size_bytes, message.sha256, message.vertices, message.triangles,
                   message.cycles, message.converged, message.distance, list(message.left_out),
                   message.volume or None, message.lost_volume, message.pictures)
