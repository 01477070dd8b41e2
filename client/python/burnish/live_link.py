"""A live session's stream, which is opened again when it breaks."""

from __future__ import annotations

import threading
import time
from typing import Any, Callable

from burnish.v1 import editing_pb2

from ._calls import PAUSE_SECONDS, Calls
from .errors import DeadlineExceeded, Error, SessionEnded, Unavailable, error_of
from .formats.frames import MissingReference, read_frame_header
from .frame import Frame
from .live_stream import LiveStream
from .surface import Surface

UNAVAILABLE = 14
LOST = (editing_pb2.GO_AWAY_CODE_GOING_DOWN, editing_pb2.GO_AWAY_CODE_NOT_OWNER)


class Batch:
    """Edits of one message, until they are answered."""

    def __init__(self, edits: list[editing_pb2.Edit]) -> None:
        self.edits = edits
        self.answer: editing_pb2.ApplyResponse | None = None
        self.error: Error | None = None


class LiveLink:
    """Keeps a stream open until close(): its thread takes frames and answers.

    `fetch` returns the pages that are shown. Methods that say so need the lock `changed`.
    """

    def __init__(self, calls: Calls, session: str, fetch: Callable[[], Surface],
                 heartbeat_seconds: float) -> None:
        self._calls, self._session, self._fetch = calls, session, fetch
        self._heartbeat_seconds = heartbeat_seconds
        self.surface = fetch()
        self.changed = threading.Condition()
        self.frame: Frame | None = None
        self.taken, self.received, self.heartbeats = 0, 0, 0
        self._joining: LiveStream | None = None  # before its welcome, and after
        self._stream: LiveStream | None = None  # from its welcome on
        self._closing = False
        self._error: Error | None = None
        self._decoded = 0
        self._batches: list[Batch] = []
        self._refused: dict[str, Error] = {}
        self._reader = threading.Thread(target=self._run, daemon=True)
        self._reader.start()

    def close(self) -> None:
        """Ends the stream and the thread."""
        with self.changed:
            self._closing = True
            stream = self._joining
            self.changed.notify_all()
        if stream is not None:
            stream.end()
        self._reader.join()

    def wait_for_welcome(self, timeout: float) -> None:
        """Returns once the server let this client in. Raises why it did not."""
        with self.changed:
            self.wait(lambda: self._stream is not None, timeout, "welcome")

    def apply(self, edits: list[editing_pb2.Edit], timeout: float) -> editing_pb2.ApplyResponse:
        """Returns the server's answer, also over several streams. Needs the lock."""
        batch = Batch(edits)
        self._batches.append(batch)
        self.send(apply=editing_pb2.ApplyEdits(edits=edits))
        try:
            self.wait(lambda: batch.answer is not None or batch.error is not None, timeout,
                      "answer to edits")
        finally:
            if batch in self._batches:
                self._batches.remove(batch)
        if batch.error is not None:
            raise batch.error
        assert batch.answer is not None
        return batch.answer

    def take_refusal(self, edit_id: str) -> Error | None:
        """Returns why a preview was refused, or what ended the session. Needs the lock."""
        return self._refused.pop(edit_id, None) or self._error

    def send(self, **message: Any) -> None:
        """Sends a message if there is a stream. Needs the lock."""
        if self._stream is not None:
            self._stream.send(**message)

    def take_frame(self) -> None:
        """Counts the newest frame as taken, and asks for another. Needs the lock."""
        self.taken = self.received
        if self._stream is not None:
            self._grant(self._stream)

    def wait(self, is_done: Any, timeout: float, what: str) -> None:
        """Waits with the lock held. Raises what ended the session."""
        end = time.monotonic() + timeout
        while not is_done():
            self.check()
            if not self.changed.wait(end - time.monotonic()) and time.monotonic() >= end:
                raise DeadlineExceeded(f"no {what} came within {timeout} s")

    def check(self) -> None:
        """Raises what ended the session. Needs the lock."""
        if self._error is not None:
            raise self._error
        if self._closing:
            raise SessionEnded("the live session was closed here")

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
        with self.changed:
            self._error = error
            self.changed.notify_all()

    def _join(self) -> None:
        """Takes part in one stream, until it breaks."""
        with self.changed:
            if self._closing:
                return
            stream = LiveStream(self._calls, self._session, self._heartbeat_seconds)
            self._joining = stream
        try:
            for message in stream.messages():
                self._take(stream, message)
                if message.HasField("go_away"):
                    self._go_elsewhere(message.go_away)
                    break
        except Unavailable:
            if self._closing or self._stream is stream:
                return  # it worked before: the pauses begin anew
            raise
        except Error:
            if not self._closing:
                raise
        finally:
            with self.changed:
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
        with self.changed:
            if kind == "acknowledged":
                self._answer(list(message.acknowledged.edit_ids), message.acknowledged.outcome)
            elif kind == "refused" and message.refused.code != UNAVAILABLE:
                self._answer(list(message.refused.edit_ids),
                             error_of(message.refused.code, message.refused.message))
            elif kind == "heartbeat":
                self.heartbeats += 1
            self.changed.notify_all()

    def _go_elsewhere(self, go_away: editing_pb2.GoAway) -> None:
        """Turns to the server that the old one named, or to another one if it lost the session."""
        if go_away.fleet:
            self._calls.editing.learn(list(go_away.fleet))
        if go_away.HasField("moved"):
            self._calls.editing.follow(go_away.moved)
        elif go_away.code in LOST:
            self._calls.editing.give_up()

    def _begin(self, stream: LiveStream, welcome: editing_pb2.Welcome) -> None:
        """Shows the pages, and sends again what was not answered."""
        self._calls.editing.learn(list(welcome.fleet))
        if welcome.pages_fingerprint != self.surface.head.fingerprint:
            self.surface = self._fetch()
        self._decoder = self.surface.decoder()
        stream.send(show_pages=editing_pb2.ShowPages(revision=1, added=self.surface.numbers))
        with self.changed:
            self._decoded = 0
            self._stream = stream
            for batch in self._batches:
                stream.send(apply=editing_pb2.ApplyEdits(edits=batch.edits))
            self._grant(stream)

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
        moves = self.surface.displacements(self._decoder)
        frame = Frame(self.surface.rest + moves, moves,
                      message.state == editing_pb2.SOLVE_STATE_SETTLED, message.exact,
                      message.edits, message.cycles, message.distance, message.volume or None)
        with self.changed:
            self.frame = frame
            self.received += 1

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
