"""Edits of the protected region, in which nothing moves."""

from __future__ import annotations

import dataclasses
from typing import Any

import numpy as np
import numpy.typing as npt

from burnish.v1 import common_pb2, editing_pb2

from ._arguments import check_fields
from .edits import rows


@dataclasses.dataclass(frozen=True)
class ProtectCurvature:
    """Protects cells by their principal curvature of the larger magnitude, times L.

    `release`: they are no longer protected.
    """

    least: float
    most: float
    release: bool = False

    def __post_init__(self) -> None:
        check_fields(self, least=float, most=float, release=bool)

    def to_wire(self) -> dict[str, Any]:
        return {"protect": editing_pb2.Protect(release=self.release, curvature=(
            editing_pb2.CurvatureRange(least=self.least, most=self.most)))}


@dataclasses.dataclass(frozen=True)
class ProtectPiece:
    """Protects all surface that is connected with the cell nearest to `point` (3 numbers)."""

    point: npt.ArrayLike
    release: bool = False

    def __post_init__(self) -> None:
        check_fields(self, release=bool)

    def to_wire(self) -> dict[str, Any]:
        (x, y, z), = rows(np.reshape(self.point, (1, -1)), 3, "a point")
        return {"protect": editing_pb2.Protect(release=self.release,
                                               piece=common_pb2.Point(x=x, y=y, z=z))}


@dataclasses.dataclass(frozen=True)
class ProtectLasso:
    """Protects cells whose middle lies in a polygon of a picture.

    `view_projection`: 4 x 4, from (x, y, z, 1) in the scan's units to clip space. `points`: n x 2
    in the picture, -1 to 1, y upwards, 3 to 1024 of them. `through`: also surface that faces away.
    """

    view_projection: npt.ArrayLike
    points: npt.ArrayLike
    through: bool = False
    release: bool = False

    def __post_init__(self) -> None:
        check_fields(self, through=bool, release=bool)

    def to_wire(self) -> dict[str, Any]:
        matrix = rows(self.view_projection, 4, "view_projection")
        lasso = editing_pb2.Lasso(view_projection=matrix.ravel().tolist(), through=self.through,
                                  points=rows(self.points, 2, "a lasso").ravel().tolist())
        return {"protect": editing_pb2.Protect(lasso=lasso, release=self.release)}


@dataclasses.dataclass(frozen=True)
class GrowProtected:
    """Grows the protected region by 1 to 64 `cells`; below 0 it shrinks."""

    cells: int

    def __post_init__(self) -> None:
        check_fields(self, cells=int)

    def to_wire(self) -> dict[str, Any]:
        return {"protect": editing_pb2.Protect(grow=self.cells)}


@dataclasses.dataclass(frozen=True)
class InvertProtected:
    """Protects what was not protected, and nothing else."""

    def to_wire(self) -> dict[str, Any]:
        return {"protect": editing_pb2.Protect(invert=editing_pb2.Invert())}


@dataclasses.dataclass(frozen=True)
class ClearProtected:
    """Protects nothing."""

    def to_wire(self) -> dict[str, Any]:
        return {"protect": editing_pb2.Protect(clear=editing_pb2.ClearRegion())}
