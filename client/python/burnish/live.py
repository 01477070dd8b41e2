"""Live sessions: edits, and the surface as it moves."""

from __future__ import annotations

import contextlib
import secrets
import threading
from types import TracebackType
from typing import Any, Callable, Iterator

import numpy as np
import numpy.typing as npt

from burnish.v1 import editing_pb2

from ._arguments import with_change
from ._calls import Calls
from .cells import CellEdges, CellFields, CellProtection, CellTexture
from .edits import Change, rows
from .errors import Error, FailedPrecondition
from .frame import Frame
from .gesture import Gesture
from .history import State
from .live_link import LiveLink
from .live_stream import HEARTBEAT_SECONDS
from .mesh import Mesh
from .progress import Progress
from .surface import Surface, fetch_surface
from .weights import Weighed

TIMEOUT_SECONDS = 600.0


class Live:
    """A live session. Use it with `with`, or close() it.

    It comes back by itself when the link or the server breaks, and sends unanswered edits again.
    The server sends the next frame when the last one was taken: a slow reader misses frames, and
    delays nobody. Methods may be called from any thread.
    """

    def __init__(self, calls: Calls, info: editing_pb2.SessionInfo, *, triangles_max: int,
                 level: int | None, vertices: npt.ArrayLike | None = None,
                 progress: Progress | None = None,
                 heartbeat_seconds: float = HEARTBEAT_SECONDS) -> None:
        places = None if vertices is None else rows(vertices, 3, "vertices")

        def fetch() -> Surface:
            return fetch_surface(calls, info.scan_id, info.depth, triangles_max, level, progress,
                                 places)
        self._calls, self._session = calls, info.id
        self._depth, self._callers = info.depth, list[threading.Thread]()
        self._link = LiveLink(calls, info.id, fetch, heartbeat_seconds)
        self._edits = 0
        try:
            self._link.wait_for_welcome(TIMEOUT_SECONDS)
        except BaseException:
            self._link.close()
            raise

    def __enter__(self) -> Live:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None,
                 trace: TracebackType | None) -> None:
        self.close()

    def close(self) -> None:
        """Leaves the session. Callbacks of on_frame() have ended when it returns."""
        self._link.close()
        for caller in self._callers:
            if caller is not threading.current_thread():
                caller.join()

    @property
    def faces(self) -> npt.NDArray[np.int64]:
        """m x 3 indices of the frames' vertices. Pages repeat the vertices of their borders, unless
        the frames are in the scan's own order."""
        return self._link.surface.faces

    @property
    def original(self) -> Mesh:
        """The surface before all edits."""
        return Mesh(self._link.surface.rest, self._link.surface.faces)

    @property
    def origin(self) -> npt.NDArray[np.float64]:
        """3 numbers: where cell (0, 0, 0) of the grid begins, the scan's units."""
        return self._link.surface.head.origin

    @property
    def lattice_step(self) -> float:
        """`original` is the scan rounded to half of this, the scan's units."""
        return self._link.surface.head.side / (1 << self._link.surface.head.bits)

    @property
    def waiting_frames(self) -> int:
        """Frames that came and that nobody has taken."""
        return self._link.received - self._link.taken

    def wait_for_heartbeats(self, count: int, timeout: float = TIMEOUT_SECONDS) -> None:
        """Waits until the server has answered so many heartbeats since the beginning."""
        link = self._link
        with link.changed:
            link.wait(lambda: link.heartbeats >= count, timeout, "heartbeat")

    def apply(self, *changes: Change, timeout: float = TIMEOUT_SECONDS) -> list[int]:
        """As Session.apply(): returns the number of the entry that each edit made."""
        return self.apply_as([(secrets.token_hex(10), change) for change in changes], timeout)

    def apply_as(self, changes: list[tuple[str, Change]],
                 timeout: float = TIMEOUT_SECONDS) -> list[int]:
        """As apply(), with an id for each edit: 1 to 64 characters, '!' to '~'."""
        edits = [editing_pb2.Edit(id=edit_id, **with_change(change).to_wire())
                 for edit_id, change in changes]
        with self._link.changed:
            answer = self._link.apply(edits, timeout)
            self._edits = max(self._edits, answer.edits)
            return list(answer.entries)

    def gesture(self) -> Gesture:
        """Begins a gesture: edits that are shown to everybody and kept by Gesture.keep() alone."""
        return Gesture(self)

    def preview(self, edit_id: str, change: Any) -> None:
        """Shows a change until its edit of the same id is applied. Raises an earlier refusal."""
        with self._link.changed:
            refused = self._link.take_refusal(edit_id)
            if refused is not None:
                raise refused
            self._link.send(preview=editing_pb2.Preview(edit_id=edit_id, **change))

    def next_frame(self, timeout: float = TIMEOUT_SECONDS) -> Frame:
        """Returns the newest frame, once there is one that was not returned before.

        Raises DeadlineExceeded: a surface at rest sends no frames.
        """
        link = self._link
        with link.changed:
            link.wait(lambda: link.received > link.taken, timeout, "frame")
            link.take_frame()
            assert link.frame is not None
            return link.frame

    def poll(self) -> Frame | None:
        """Returns the newest frame if it was not returned before, else None; does not wait.

        Raises what ended the session.
        """
        link = self._link
        with link.changed:
            link.check()
            if link.received == link.taken:
                return None
            link.take_frame()
            return link.frame

    def on_frame(self, callback: Callable[[Frame], object]) -> None:
        """Calls `callback` with each new frame, in a thread of its own, until the session ends.

        An exception of it goes to threading.excepthook and ends the calls. Frames go to one reader:
        next_frame(), poll() and frames() miss those that the callback has.
        """
        def call() -> None:
            with contextlib.suppress(Error):  # other methods raise what ended the session
                while True:
                    frame = self.next_frame(threading.TIMEOUT_MAX)
                    callback(frame)
        caller = threading.Thread(target=call, daemon=True)
        self._callers.append(caller)
        caller.start()

    def cell_fields(self, beta: npt.ArrayLike, alpha: npt.ArrayLike | None = None) -> CellFields:
        """Returns an edit that sets cells of the surface by values per vertex.

        `beta`: n gradient scales, 0 to 10, in the order of the frames' vertices; NaN leaves a cell
        as it is. `alpha`: n fidelity weights times L, or one for all; by default the session's. A cell has the mean of the
        values within it; between vertices they are interpolated over the triangles. A cell of which
        the surface only cuts off a corner may stay as it is.
        Raises ValueError for another shape; FailedPrecondition without alpha if the session's
        changes with curvature.
        """
        return self._weighed().fields(beta, self._constant_alpha() if alpha is None else alpha)

    def cell_edges(self, strength: npt.ArrayLike) -> CellEdges:
        """Returns an edit that paints how strongly edges are kept, by values per vertex.

        `strength`: n numbers, 0 to keep noise and 1 to take it, in the order of the frames' vertices;
        NaN leaves a cell as it is. Cells as in cell_fields(). Raises ValueError.
        """
        return self._weighed().edges(strength)

    def cell_texture(self, gain: npt.ArrayLike) -> CellTexture:
        """Returns an edit that paints the texture gain, by values per vertex.

        `gain`: n numbers, 0 to 4, in the order of the frames' vertices; 1 leaves the texels as they
        are, NaN a cell. Cells as in cell_fields(). Raises ValueError.
        """
        return self._weighed().texture(gain)

    def cell_protection(self, weights: npt.ArrayLike) -> CellProtection:
        """Returns an edit that protects cells by weights per vertex.

        `weights`: n numbers, 0 to 1, or truth values, in the order of the frames' vertices. A cell
        whose mean is half or more is protected, another one released; NaN leaves a cell as it is.
        Cells as in cell_fields(). Raises ValueError.
        """
        return self._weighed().protection(weights)

    def frames(self, timeout: float = TIMEOUT_SECONDS) -> Iterator[Frame]:
        """Yields frames until the surface with all edits that were applied here is at rest."""
        while not self._is_at_rest():
            yield self.next_frame(timeout)

    def settle(self, timeout: float = TIMEOUT_SECONDS) -> Frame:
        """Returns the frame of the surface at rest, with all edits that were applied here."""
        for _ in self.frames(timeout):
            pass
        assert self._link.frame is not None
        return self._link.frame

    def _weighed(self) -> Weighed:
        surface = self._link.surface
        return Weighed(surface.rest, surface.faces, surface.head.origin,
                       surface.head.side / (1 << self._depth))

    def _constant_alpha(self) -> float:
        points = State.of(self._calls.ask(self._calls.editing.GetState, (
            editing_pb2.GetStateRequest(session=self._session)))).curve.points
        if len(points) != 1:
            raise FailedPrecondition(f"the session's transfer curve has {len(points)} points: "
                                     "give alpha")
        return next(iter(points.values()))

    def _is_at_rest(self) -> bool:
        link = self._link
        with link.changed:
            return (link.frame is not None and link.taken == link.received and
                    link.frame.settled and link.frame.edits >= self._edits)
