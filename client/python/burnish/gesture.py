"""Changes that are tried before they are kept."""

from __future__ import annotations

import secrets
from types import TracebackType
from typing import TYPE_CHECKING

from burnish.v1 import editing_pb2

from ._arguments import with_change
from .edits import Change

if TYPE_CHECKING:
    from .live import Live

SHOWN = {field.name for field in editing_pb2.Preview.DESCRIPTOR.oneofs_by_name["change"].fields
         if field.name != "drop"}


class Gesture:
    """A drag of a slider or of a brush. Use it with `with`: at the end it keeps nothing by itself.

    A stroke's path continues where the last one ended; other changes replace the last one.
    """

    def __init__(self, live: Live) -> None:
        self._live, self._id = live, secrets.token_hex(10)
        self._is_shown = False

    def __enter__(self) -> Gesture:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None,
                 trace: TracebackType | None) -> None:
        self.drop()

    def show(self, change: Change) -> None:
        """Lets everybody see the change. Raises ValueError for one that has no preview."""
        wire = with_change(change).to_wire()
        if not set(wire) <= SHOWN:
            raise ValueError(f"{type(change).__name__} has no preview")
        self._is_shown = True
        self._live.preview(self._id, wire)

    def keep(self, change: Change) -> int:
        """Applies the edit. Returns the number of its entry in the history."""
        self._is_shown = False
        return self._live.apply_as([(self._id, change)])[0]

    def drop(self) -> None:
        """Shows the surface without the gesture again."""
        if self._is_shown:
            self._is_shown = False
            self._live.preview(self._id, {"drop": editing_pb2.DropPreview()})
