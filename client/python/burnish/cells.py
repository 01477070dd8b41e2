"""Edits of single cells of the grid."""

from __future__ import annotations

import dataclasses
from typing import Any, Iterator

import numpy as np
import numpy.typing as npt

from burnish.v1 import editing_pb2

from .edits import rows

CELLS_PER_MESSAGE = 50_000
CELL_VALUES = {"beta": editing_pb2.CELL_VALUE_BETA, "kappa1": editing_pb2.CELL_VALUE_KAPPA1,
               "kappa2": editing_pb2.CELL_VALUE_KAPPA2, "alpha1": editing_pb2.CELL_VALUE_ALPHA1,
               "alpha2": editing_pb2.CELL_VALUE_ALPHA2,
               "protected": editing_pb2.CELL_VALUE_PROTECTED,
               "curve": editing_pb2.CELL_VALUE_CURVE}


class SingleCells:
    """An edit that may be too large for one message."""

    def to_wire(self) -> dict[str, Any]:
        raise NotImplementedError


@dataclasses.dataclass(frozen=True)
class CellFields(SingleCells):
    """Sets alpha and beta of single cells, over all paint; others keep theirs.

    `cells`: n x 3 integers at the session's depth, each once, on the surface. `alpha1`, `alpha2`
    (times L, along and across the larger curvature) and `beta`: n numbers each, or one for all.
    """

    cells: npt.ArrayLike
    alpha1: npt.ArrayLike
    alpha2: npt.ArrayLike
    beta: npt.ArrayLike

    def to_wire(self) -> dict[str, Any]:
        return _wire(self.cells, alpha1=self.alpha1, alpha2=self.alpha2, beta=self.beta)


@dataclasses.dataclass(frozen=True)
class CellEdges(SingleCells):
    """Paints the strength of kept edges in single cells, over earlier paint.

    `cells`: as those of CellFields. `strength`: n numbers or one, 0 to keep noise and 1 to take it.
    How noise is found says EdgeFilter; with its strength of 0 edges are kept in painted cells alone.
    """

    cells: npt.ArrayLike
    strength: npt.ArrayLike

    def to_wire(self) -> dict[str, Any]:
        return _wire(self.cells, {"edges": True}, beta=self.strength)


@dataclasses.dataclass(frozen=True)
class CellTexture(SingleCells):
    """Paints the texture gain in single cells, over earlier paint.

    `cells`: as those of CellFields. `gain`: n numbers or one, 0 to 4; 1 leaves the texels as they are.
    The scan must have colours or pictures.
    """

    cells: npt.ArrayLike
    gain: npt.ArrayLike

    def to_wire(self) -> dict[str, Any]:
        return _wire(self.cells, {"texture": True}, beta=self.gain)


@dataclasses.dataclass(frozen=True)
class CellProtection(SingleCells):
    """Protects single cells, and releases others.

    `cells`: as those of CellFields. `protect`: n truth values, or one for all.
    """

    cells: npt.ArrayLike
    protect: npt.ArrayLike = True

    def to_wire(self) -> dict[str, Any]:
        return _wire(self.cells, {"protection": True}, beta=np.asarray(self.protect, bool))


def _wire(cells: npt.ArrayLike, sets: dict[str, Any] | None = None,
          **values: npt.ArrayLike) -> dict[str, Any]:
    places = rows(cells, 3, "cells").astype(np.int64)
    columns = [np.broadcast_to(np.asarray(value, np.float64), len(places)).tolist()
               for value in values.values()]
    fields = [editing_pb2.CellField(i=i, j=j, k=k, **dict(zip(values, of_cell)))
              for (i, j, k), *of_cell in zip(places.tolist(), *columns)]
    return {"cell_fields": editing_pb2.SetCellFields(cells=fields, **(sets or {}))}


def cell_messages(edit: SingleCells, session: str,
                  edit_id: str) -> Iterator[editing_pb2.UploadCellFieldsRequest]:
    """Yields the messages of an upload: the header, then the cells."""
    whole = edit.to_wire()["cell_fields"]
    cells, sets = whole.cells, whole.WhichOneof("sets")
    yield editing_pb2.UploadCellFieldsRequest(header=editing_pb2.CellFieldsHeader(
        session=session, edit_id=edit_id, cells=len(cells)))
    for begin in range(0, len(cells), CELLS_PER_MESSAGE):
        yield editing_pb2.UploadCellFieldsRequest(cells=editing_pb2.SetCellFields(
            cells=cells[begin:begin + CELLS_PER_MESSAGE], **({sets: True} if sets else {})))
