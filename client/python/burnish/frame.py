"""A frame of a live session."""

from __future__ import annotations

import dataclasses

import numpy as np
import numpy.typing as npt


@dataclasses.dataclass(frozen=True)
class Frame:
    """The surface at a moment. Within 1/64 cell of it at rest; up to 1/4 cell while it moves."""

    vertices: npt.NDArray[np.float64]
    """n x 3, the scan's units; they belong to Live.faces."""
    displacements: npt.NDArray[np.float64]
    """n x 3, the scan's units: how far edits moved the vertices."""
    settled: bool
    """The surface is at rest."""
    exact: bool
    """At rest, and the server has solved it to the accuracy of exact exports. The vertices are
    rounded as in every frame at rest: Session.export() and mesh() have all digits."""
    edits: int
    """So many of the session's edits are in it."""
    cycles: int
    distance: float
    """Estimated to the converged surface, over the box's diagonal."""
    volume: float | None
    """Over the scan's, if the controls keep it; None if they do not. It is 1, except for rounding,
    unless the cap wins or the edited part cannot grow enough."""
