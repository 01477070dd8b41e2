"""Edits of a session. Lengths are in the scan's own units; L is the square root of its area."""

from __future__ import annotations

import dataclasses
from typing import Any, Mapping, Protocol, Sequence

import numpy as np
import numpy.typing as npt

from burnish.v1 import common_pb2, editing_pb2

from ._arguments import check_all, check_fields, check_type

FALL_OFFS = {"smooth": editing_pb2.FALL_OFF_SMOOTH, "linear": editing_pb2.FALL_OFF_LINEAR,
             "sharp": editing_pb2.FALL_OFF_SHARP, "constant": editing_pb2.FALL_OFF_CONSTANT}
NORMAL_FILTERS = {"bilateral": common_pb2.NORMAL_FILTER_KIND_BILATERAL,
                  "edges": common_pb2.NORMAL_FILTER_KIND_EDGES}


class Change(Protocol):
    """Anything that Session.apply() takes."""

    def to_wire(self) -> dict[str, Any]:
        """Returns the member of the message Edit, and its value."""


def rows(values: npt.ArrayLike, columns: int, what: str) -> npt.NDArray[np.float64]:
    """Returns an n x `columns` array.

    Raises ValueError for another shape, TypeError for what is not numbers.
    """
    try:
        array = np.asarray(values, np.float64)
    except (TypeError, ValueError):
        raise TypeError(f"{what} is {values!r}: it takes n x {columns} numbers") from None
    if array.ndim != 2 or array.shape[1] != columns:
        raise ValueError(f"{what} has the shape {array.shape}: it must be (n, {columns})")
    return array


@dataclasses.dataclass(frozen=True)
class GradientScale:
    """The gradient scale of the whole scan. `beta`: 0 to 10; below 1 smooths, above 1 sharpens."""

    beta: float

    def __post_init__(self) -> None:
        check_fields(self, beta=float)

    def to_wire(self) -> dict[str, Any]:
        return {"gradient_scale": editing_pb2.SetGradientScale(beta=self.beta)}


@dataclasses.dataclass(frozen=True)
class TransferCurve:
    """The fidelity weight alpha as a function of the curvature kappa.

    `points` has 1 to 64 of them: kappa (times L, rising) to alpha (times L, 0.01 to 1e5, within a
    factor of 1000). The larger alpha, the finer the detail that is changed.
    """

    points: Mapping[float, float]

    def __post_init__(self) -> None:
        if not isinstance(self.points, Mapping):
            raise TypeError(f"TransferCurve: points is {self.points!r}, of type "
                            f"{type(self.points).__name__}: it takes {{kappa: alpha, ...}}, "
                            "or use TransferCurve.constant(alpha)")
        for kappa, alpha in self.points.items():
            check_type("TransferCurve: a kappa of points", kappa, float)
            check_type(f"TransferCurve: points[{kappa!r}]", alpha, float)

    @classmethod
    def constant(cls, alpha: float) -> TransferCurve:
        """The same alpha everywhere."""
        check_type("alpha", alpha, float)
        return cls({0.0: alpha})

    @classmethod
    def of(cls, message: editing_pb2.SetTransferCurve) -> TransferCurve:
        return cls({point.kappa: point.alpha for point in message.points})

    def message(self) -> editing_pb2.SetTransferCurve:
        return editing_pb2.SetTransferCurve(points=[
            editing_pb2.CurvePoint(kappa=kappa, alpha=alpha)
            for kappa, alpha in sorted(self.points.items())])

    def to_wire(self) -> dict[str, Any]:
        return {"transfer_curve": self.message()}


@dataclasses.dataclass(frozen=True)
class Brush:
    """A ball that paints. `fall_off`: smooth, linear, sharp or constant.

    It paints the gradient scale; or the gain of a `band` of the equaliser (from 1); or where a
    `curve` of the palette rules (from 1); or the gradient scale of the colours; or with `edges` the
    strength of kept edges, where `beta` is 0 to keep noise and 1 to take it; or with `texture` the
    texture gain, 0 to 4. It reaches the surface that hangs together with the place that it touches;
    `through` reaches the other side of thin walls too.
    """

    radius: float
    beta: float = 1.0
    strength: float = 1.0
    fall_off: str = "smooth"
    band: int | None = None
    curve: int | None = None
    colour: bool = False
    edges: bool = False
    texture: bool = False
    through: bool = False

    def __post_init__(self) -> None:
        check_fields(self, radius=float, beta=float, strength=float, fall_off=str, colour=bool,
                     edges=bool, texture=bool, through=bool)
        check_fields(self, optional=True, band=int, curve=int)

    def message(self) -> editing_pb2.Brush:
        if self.fall_off not in FALL_OFFS:
            raise ValueError(f"fall_off '{self.fall_off}' is not one of {', '.join(FALL_OFFS)}")
        paints = {"band": self.band, "curve": self.curve, "colour": self.colour or None,
                  "edges": self.edges or None, "texture": self.texture or None}
        given = {name: value for name, value in paints.items() if value is not None}
        if len(given) > 1:
            raise ValueError(f"a brush paints one thing, not {' and '.join(given)}")
        members: dict[str, Any] = given
        return editing_pb2.Brush(radius=self.radius, strength=self.strength, beta=self.beta,
                                 fall_off=FALL_OFFS[self.fall_off], connected=not self.through,
                                 **members)


@dataclasses.dataclass(frozen=True)
class Stroke:
    """A drag of a brush. `path`: n x 3 points of the original surface, 1 to 4096."""

    brush: Brush
    path: npt.ArrayLike

    def __post_init__(self) -> None:
        check_fields(self, brush=Brush)

    def to_wire(self) -> dict[str, Any]:
        points = [common_pb2.Point(x=x, y=y, z=z)
                  for x, y, z in rows(self.path, 3, "a stroke's path").tolist()]
        return {"stroke": editing_pb2.Stroke(brush=self.brush.message(), path=points)}


@dataclasses.dataclass(frozen=True)
class Controls:
    """Bounds on what all edits do; the last such edit counts.

    `pin_rims`: rims of an open surface stay. `cap`: nothing moves more than this, 0 for no cap.
    `keep_volume`: a closed surface keeps its volume.
    """

    pin_rims: bool = True
    cap: float = 0.0
    keep_volume: bool = False

    def __post_init__(self) -> None:
        check_fields(self, pin_rims=bool, cap=float, keep_volume=bool)

    def to_wire(self) -> dict[str, Any]:
        return {"controls": editing_pb2.Controls(pin_rims=self.pin_rims, cap=self.cap,
                                                 keep_volume=self.keep_volume)}


@dataclasses.dataclass(frozen=True)
class Band:
    """Details up to the wavelength `size` (the scan's units), with a `gain` of 0 to 10."""

    size: float
    gain: float

    def __post_init__(self) -> None:
        check_fields(self, size=float, gain=float)


@dataclasses.dataclass(frozen=True)
class Equaliser:
    """Gains by the size of details: 0 to 6 bands, from fine to coarse, each 1.2 times the last."""

    bands: Sequence[Band]

    def __post_init__(self) -> None:
        check_all("Equaliser: bands", self.bands, Band)

    def to_wire(self) -> dict[str, Any]:
        return {"equaliser": editing_pb2.Equaliser(
            bands=[editing_pb2.Band(size=band.size, gain=band.gain) for band in self.bands])}


@dataclasses.dataclass(frozen=True)
class PaletteCurve:
    """A curve that a brush can paint. `colour`: 0xRRGGBB."""

    name: str
    curve: TransferCurve
    colour: int = 0xFF8000

    def __post_init__(self) -> None:
        check_fields(self, name=str, curve=TransferCurve, colour=int)


@dataclasses.dataclass(frozen=True)
class Palette:
    """Curves for brushes to paint, at most 8."""

    curves: Sequence[PaletteCurve]

    def __post_init__(self) -> None:
        check_all("Palette: curves", self.curves, PaletteCurve)

    def to_wire(self) -> dict[str, Any]:
        return {"palette": editing_pb2.Palette(curves=[
            editing_pb2.PaletteCurve(name=one.name, colour=one.colour, curve=one.curve.message())
            for one in self.curves])}


@dataclasses.dataclass(frozen=True)
class ColourFilter:
    """Filters the scan's colours over its surface. `alpha` (times L) and `beta` as for the shape."""

    beta: float
    alpha: float = 50.0

    def __post_init__(self) -> None:
        check_fields(self, beta=float, alpha=float)

    def to_wire(self) -> dict[str, Any]:
        return {"colour": editing_pb2.ColourFilter(alpha=self.alpha, beta=self.beta)}


@dataclasses.dataclass(frozen=True)
class TextureFilter:
    """Changes the scan's colours and the texels of its pictures, without a solve.

    `gain`, 0 to 4: times how much they differ from what the grid knows of them. `remove_light`, 0 to
    1: how much of the light goes that was there when they were taken. `level_seams`, 0 to 1: how
    much of the steps goes between charts of the pictures, in exports and in views.
    """

    gain: float = 1.0
    remove_light: float = 0.0
    level_seams: float = 0.0

    def __post_init__(self) -> None:
        check_fields(self, gain=float, remove_light=float, level_seams=float)

    def to_wire(self) -> dict[str, Any]:
        return {"texture": editing_pb2.TextureFilter(gain=self.gain, remove_light=self.remove_light,
                                                     level_seams=self.level_seams)}


@dataclasses.dataclass(frozen=True)
class EdgeFilter:
    """Takes noise away and keeps edges, before the shape is smoothed or sharpened; strength 0 ends it.

    `filter`: "bilateral", or "edges" for machined parts. `edge_angle` (degrees): sharper bends are
    edges. `passes`: more take longer noise. `crispness`: low for relief, high for machined parts.
    """

    strength: float = 1.0
    filter: str = "bilateral"
    edge_angle: float = 35.0
    passes: int = 20
    crispness: float = 1.0

    def __post_init__(self) -> None:
        check_fields(self, strength=float, filter=str, edge_angle=float, passes=int,
                     crispness=float)

    def to_wire(self) -> dict[str, Any]:
        if self.filter not in NORMAL_FILTERS:
            raise ValueError(f"filter '{self.filter}' is not one of {', '.join(NORMAL_FILTERS)}")
        if self.passes < 0:
            raise ValueError(f"passes {self.passes} is less than 0")
        return {"edges": common_pb2.EdgeFilter(
            strength=self.strength, kind=NORMAL_FILTERS[self.filter], edge_angle=self.edge_angle,
            passes=self.passes, crispness=self.crispness)}

    @classmethod
    def of(cls, message: common_pb2.EdgeFilter) -> EdgeFilter:
        names = {number: name for name, number in NORMAL_FILTERS.items()}
        return cls(message.strength, names.get(message.kind, "bilateral"), message.edge_angle,
                   message.passes, message.crispness)
