"""One stream of a live session (docs/protocol.md, section 5)."""

from __future__ import annotations

import queue
import threading
from typing import Any, Iterator

import grpc

from burnish.v1 import editing_pb2

from ._calls import Calls, as_error

HEARTBEAT_SECONDS = 5.0


class LiveStream:
    """Sends a greeting, then messages and heartbeats, until it ends."""

    def __init__(self, calls: Calls, session: str, heartbeat_seconds: float) -> None:
        self._outbox: queue.SimpleQueue[editing_pb2.ClientMessage | None] = queue.SimpleQueue()
        self._ended = threading.Event()
        self.send(greeting=editing_pb2.Greeting(session=session, pages=True, held=True))
        self._call = calls.open_stream(calls.editing.Edit, iter(self._outbox.get, None))
        self._heart = threading.Thread(target=self._beat, args=(heartbeat_seconds,), daemon=True)
        self._heart.start()

    def send(self, **message: Any) -> None:
        self._outbox.put(editing_pb2.ClientMessage(**message))

    def messages(self) -> Iterator[editing_pb2.ServerMessage]:
        """Yields what the server sends. Raises Error when the stream breaks."""
        try:
            yield from self._call
        except grpc.RpcError as error:
            raise as_error(error) from None

    def end(self) -> None:
        """Ends the stream at once. Harmless to repeat."""
        self._ended.set()
        self._outbox.put(None)
        self._call.cancel()

    def _beat(self, seconds: float) -> None:
        beats = 0
        while not self._ended.wait(seconds):
            beats += 1
            self.send(heartbeat=editing_pb2.Heartbeat(client_time_us=beats))
