"""Live sessions: edits, and the surface as it moves."""

from __future__ import annotations

import dataclasses
import secrets
import threading
import time
from types import TracebackType
from typing import Any, Callable, Iterator

import numpy as np
import numpy.typing as npt

from burnish.v1 import editing_pb2

from ._calls import PAUSE_SECONDS, Calls
from .edits import Change
from .errors import DeadlineExceeded, Error, SessionEnded, Unavailable, error_of
from .formats.frames import MissingReference, read_frame_header
from .gesture import Gesture
from .live_stream import HEARTBEAT_SECONDS, LiveStream
from .mesh import Mesh
from .progress import Progress
from .surface import Surface, fetch_surface

TIMEOUT_SECONDS = 600.0
UNAVAILABLE = 14


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
    """At rest, to the accuracy of exact exports."""
    edits: int
    """So many of the session's edits are in it."""
    cycles: int
    distance: float
    """Estimated to the converged surface, over the box's diagonal."""


class _Batch:
    """Edits of one message, until they are answered."""

    def __init__(self, edits: list[editing_pb2.Edit]) -> None:
        self.edits = edits
        self.answer: editing_pb2.ApplyResponse | None = None
        self.error: Error | None = None


class Live:
    """A live session. Use it with `with`, or close() it.

    It comes back by itself when the link or the server breaks, and sends unanswered edits again.
    The server sends the next frame when the last one was taken: a slow reader misses frames, and
    delays nobody. Methods may be called from any thread.
    """

    def __init__(self, calls: Calls, info: editing_pb2.SessionInfo, *, triangles_max: int,
                 level: int | None, progress: Progress | None = None,
                 heartbeat_seconds: float = HEARTBEAT_SECONDS) -> None:
        self._calls, self._info, self._heartbeat_seconds = calls, info, heartbeat_seconds
        self._fetch: Callable[[], Surface] = lambda: fetch_surface(
            calls, info.scan_id, info.depth, triangles_max, level, progress)
        self._surface = self._fetch()
        self._changed = threading.Condition()
        self._stream: LiveStream | None = None
        self._closing = False
        self._error: Error | None = None
        self._frame: Frame | None = None
        self._taken, self._received, self._decoded = 0, 0, 0
        self._heartbeats = 0
        self._edits = 0
        self._batches: list[_Batch] = []
        self._refused: dict[str, Error] = {}
        self._reader = threading.Thread(target=self._run, daemon=True)
        self._reader.start()
        try:
            with self._changed:
                self._wait(lambda: self._stream is not None, TIMEOUT_SECONDS, "welcome")
        except BaseException:
            self.close()
            raise

    def __enter__(self) -> Live:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None,
                 trace: TracebackType | None) -> None:
        self.close()

    def close(self) -> None:
        """Leaves the session."""
        with self._changed:
            self._closing = True
            stream = self._stream
            self._changed.notify_all()
        if stream is not None:
            stream.end()
        self._reader.join()

    @property
    def faces(self) -> npt.NDArray[np.int64]:
        """m x 3 indices of the frames' vertices. Pages repeat the vertices of their borders."""
        return self._surface.faces

    @property
    def original(self) -> Mesh:
        """The surface before all edits."""
        return Mesh(self._surface.rest, self._surface.faces)

    @property
    def origin(self) -> npt.NDArray[np.float64]:
        """3 numbers: where cell (0, 0, 0) of the grid begins, the scan's units."""
        return self._surface.head.origin

    @property
    def lattice_step(self) -> float:
        """`original` is the scan rounded to half of this, the scan's units."""
        return self._surface.head.side / (1 << self._surface.head.bits)

    @property
    def waiting_frames(self) -> int:
        """Frames that came and that nobody has taken."""
        return self._received - self._taken

    def wait_for_heartbeats(self, count: int, timeout: float = TIMEOUT_SECONDS) -> None:
        """Waits until the server has answered so many heartbeats since the beginning."""
        with self._changed:
            self._wait(lambda: self._heartbeats >= count, timeout, "heartbeat")

    def apply(self, *changes: Change, timeout: float = TIMEOUT_SECONDS) -> list[int]:
        """As Session.apply(): returns the number of the entry that each edit made."""
        return self.apply_as([(secrets.token_hex(10), change) for change in changes], timeout)

    def apply_as(self, changes: list[tuple[str, Change]],
                 timeout: float = TIMEOUT_SECONDS) -> list[int]:
        """As apply(), with an id for each edit: 1 to 64 characters, '!' to '~'."""
        batch = _Batch([editing_pb2.Edit(id=edit_id, **change.to_wire())
                        for edit_id, change in changes])
        with self._changed:
            self._batches.append(batch)
            if self._stream is not None:
                self._stream.send(apply=editing_pb2.ApplyEdits(edits=batch.edits))
            try:
                self._wait(lambda: batch.answer is not None or batch.error is not None, timeout,
                           "answer to edits")
            finally:
                if batch in self._batches:
                    self._batches.remove(batch)
            if batch.error is not None:
                raise batch.error
            assert batch.answer is not None
            self._edits = max(self._edits, batch.answer.edits)
            return list(batch.answer.entries)

    def gesture(self) -> Gesture:
        """Begins a gesture: edits that are shown to everybody and kept by Gesture.keep() alone."""
        return Gesture(self)

    def preview(self, edit_id: str, change: Any) -> None:
        """Shows a change until its edit of the same id is applied. Raises an earlier refusal."""
        with self._changed:
            refused = self._refused.pop(edit_id, None) or self._error
            if refused is not None:
                raise refused
            if self._stream is not None:
                self._stream.send(preview=editing_pb2.Preview(edit_id=edit_id, **change))

    def next_frame(self, timeout: float = TIMEOUT_SECONDS) -> Frame:
        """Returns the newest frame, once there is one that was not returned before.

        Raises DeadlineExceeded: a surface at rest sends no frames.
        """
        with self._changed:
            self._wait(lambda: self._received > self._taken, timeout, "frame")
            self._taken = self._received
            if self._stream is not None:
                self._grant(self._stream)
            assert self._frame is not None
            return self._frame

    def frames(self, timeout: float = TIMEOUT_SECONDS) -> Iterator[Frame]:
        """Yields frames until the surface with all edits that were applied here is at rest."""
        while not self._is_at_rest():
            yield self.next_frame(timeout)

    def settle(self, timeout: float = TIMEOUT_SECONDS) -> Frame:
        """Returns the frame of the surface at rest, with all edits that were applied here."""
        for _ in self.frames(timeout):
            pass
        assert self._frame is not None
        return self._frame

    def _is_at_rest(self) -> bool:
        with self._changed:
            return (self._frame is not None and self._taken == self._received and
                    self._frame.settled and self._frame.edits >= self._edits)

    def _wait(self, is_done: Any, timeout: float, what: str) -> None:
        """Waits with the lock held. Raises what ended the session."""
        end = time.monotonic() + timeout
        while not is_done():
            if self._error is not None:
                raise self._error
            if self._closing:
                raise SessionEnded("the live session was closed here")
            if not self._changed.wait(end - time.monotonic()) and time.monotonic() >= end:
                raise DeadlineExceeded(f"no {what} came within {timeout} s")

    def _run(self) -> None:
        """Keeps a stream open until close(), or until the server says that it is over."""
        try:
            while not self._closing:
                self._calls.repeat(self._join)
                time.sleep(PAUSE_SECONDS)  # a server that sends us out at once is not besieged
        except Error as error:
            self._fail(error)
        except Exception as error:  # a bug here must not let callers wait
            self._fail(Error(f"the live session broke: {error!r}"))

    def _fail(self, error: Error) -> None:
        with self._changed:
            self._error = error
            self._changed.notify_all()

    def _join(self) -> None:
        """Takes part in one stream, until it breaks."""
        if self._closing:
            return
        stream = LiveStream(self._calls, self._info.id, self._heartbeat_seconds)
        try:
            for message in stream.messages():
                self._take(stream, message)
                if message.HasField("go_away"):
                    break
        except Unavailable:
            if self._closing or self._stream is stream:
                return  # it worked before: the pauses begin anew
            raise
        except Error:
            if not self._closing:
                raise
        finally:
            with self._changed:
                self._stream = None
            stream.end()

    def _take(self, stream: LiveStream, message: editing_pb2.ServerMessage) -> None:
        kind = message.WhichOneof("message")
        if kind == "welcome":
            self._begin(stream, message.welcome)
        elif kind == "frame":
            self._take_frame(stream, message.frame)
        elif kind == "go_away" and not message.go_away.come_back:
            raise SessionEnded(message.go_away.reason)
        with self._changed:
            if kind == "acknowledged":
                self._answer(list(message.acknowledged.edit_ids), message.acknowledged.outcome)
            elif kind == "refused" and message.refused.code != UNAVAILABLE:
                self._answer(list(message.refused.edit_ids),
                             error_of(message.refused.code, message.refused.message))
            elif kind == "heartbeat":
                self._heartbeats += 1
            self._changed.notify_all()

    def _begin(self, stream: LiveStream, welcome: editing_pb2.Welcome) -> None:
        """Shows the pages, and sends again what was not answered."""
        if welcome.pages_fingerprint != self._surface.head.fingerprint:
            self._surface = self._fetch()
        self._decoder = self._surface.decoder()
        stream.send(show_pages=editing_pb2.ShowPages(revision=1, added=self._surface.numbers))
        with self._changed:
            self._decoded = 0
            self._stream = stream
            for batch in self._batches:
                stream.send(apply=editing_pb2.ApplyEdits(edits=batch.edits))
            self._grant(stream)
            if self._closing:
                stream.end()

    def _grant(self, stream: LiveStream) -> None:
        """Asks for a frame more, and says which one is held."""
        decoded, self._decoded = [self._decoded] if self._decoded else [], 0
        stream.send(credit=editing_pb2.Credit(frames=1, decoded=decoded))

    def _take_frame(self, stream: LiveStream, message: editing_pb2.Frame) -> None:
        try:
            if message.data:
                self._decoded = self._decoder.decode(message.data).sequence
        except MissingReference:
            refused = read_frame_header(message.data).sequence
            stream.send(credit=editing_pb2.Credit(frames=1, refused=[refused]))
            return
        if 0 in self._decoder.revisions:  # it shows no pages yet
            self._grant(stream)
            return
        moves = self._surface.displacements(self._decoder)
        frame = Frame(self._surface.rest + moves, moves,
                      message.state == editing_pb2.SOLVE_STATE_SETTLED, message.exact,
                      message.edits, message.cycles, message.distance)
        with self._changed:
            self._frame = frame
            self._received += 1

    def _answer(self, ids: list[str], answer: Any) -> None:
        """Gives an answer to the edits that it names; with the lock held."""
        for batch in self._batches:
            if [edit.id for edit in batch.edits] == ids:
                self._batches.remove(batch)
                if isinstance(answer, Error):
                    batch.error = answer
                else:
                    batch.answer = answer
                return
        if isinstance(answer, Error) and ids:
            self._refused[ids[0]] = answer
