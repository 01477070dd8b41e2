"""Progress of long work."""

from __future__ import annotations

import contextlib
from typing import Any, Callable, Iterator

Progress = Callable[[str, float], None]
"""Is called with the name of a phase and the done part of the whole work, 0 to 1. The part never
falls, and is 1 when the work has succeeded. An exception ends the work."""


class Whole:
    """Makes one rising number of phases that run from 0 to 1 each.

    How many phases will come is not known, so each takes a quarter of what is left.
    """

    PART = 0.25

    def __init__(self, progress: Progress | None, begin: float = 0.0, end: float = 1.0,
                 name: str = "") -> None:
        self._progress, self._name = progress, name
        self._phase, self._begin, self._end = "", begin, end
        self._done = begin

    def tell(self, phase: str, fraction: float) -> None:
        """Tells that a part of a phase is done, 0 to 1."""
        if phase != self._phase:
            self._phase, self._begin = phase, self._done
        reached = self._begin + self.PART * min(max(fraction, 0.0), 1.0) * (self._end - self._begin)
        self._report(max(self._done, reached))

    def finish(self) -> None:
        """Tells that all is done."""
        self._report(self._end)

    def _report(self, done: float) -> None:
        self._done = done
        if self._progress is not None:
            self._progress(self._name + self._phase, done)


@contextlib.contextmanager
def whole(progress: Progress | None, begin: float = 0.0, end: float = 1.0,
          name: str = "") -> Iterator[Whole]:
    """Tells `progress` of work that is a part of a whole. `name` begins the names of its phases."""
    of = Whole(progress, begin, end, name)
    yield of
    of.finish()


def report(of: Whole, message: Any) -> None:
    """Tells a message Progress of the server."""
    of.tell(message.phase, message.fraction)
