"""Fields of single cells of the grid."""

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


@dataclasses.dataclass(frozen=True)
class CellFields:
    """Sets alpha and beta of single cells; others keep theirs.

    `cells`: n x 3 integers at the session's depth, each once, on the surface. `alpha1`, `alpha2`
    (times L, along and across the larger curvature) and `beta`: n numbers each, or one for all.
    """

    cells: npt.ArrayLike
    alpha1: npt.ArrayLike
    alpha2: npt.ArrayLike
    beta: npt.ArrayLike

    def _messages(self) -> list[editing_pb2.CellField]:
        cells = rows(self.cells, 3, "cells").astype(np.int64)
        values = [np.broadcast_to(np.asarray(value, np.float64), len(cells)).tolist()
                  for value in (self.alpha1, self.alpha2, self.beta)]
        return [editing_pb2.CellField(i=i, j=j, k=k, alpha1=alpha1, alpha2=alpha2, beta=beta)
                for (i, j, k), alpha1, alpha2, beta in zip(cells.tolist(), *values)]

    def to_wire(self) -> dict[str, Any]:
        return {"cell_fields": editing_pb2.SetCellFields(cells=self._messages())}


def cell_messages(fields: CellFields, session: str,
                  edit_id: str) -> Iterator[editing_pb2.UploadCellFieldsRequest]:
    """Yields the messages of an upload: the header, then the cells."""
    cells = fields.to_wire()["cell_fields"].cells
    yield editing_pb2.UploadCellFieldsRequest(header=editing_pb2.CellFieldsHeader(
        session=session, edit_id=edit_id, cells=len(cells)))
    for begin in range(0, len(cells), CELLS_PER_MESSAGE):
        yield editing_pb2.UploadCellFieldsRequest(cells=editing_pb2.SetCellFields(
            cells=cells[begin:begin + CELLS_PER_MESSAGE]))
