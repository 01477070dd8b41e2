"""Progress of long work."""

from __future__ import annotations

from typing import Any, Callable

Progress = Callable[[str, float], None]
"""Is called with the name of a phase and its done part, 0 to 1. An exception ends the work."""


def report(progress: Progress | None, message: Any) -> None:
    """Tells a message Progress of the server."""
    if progress is not None:
        progress(message.phase, message.fraction)
