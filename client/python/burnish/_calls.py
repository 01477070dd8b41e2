"""Calls of a server. A harmless call is repeated while the server cannot be reached."""

from __future__ import annotations

import time
from typing import Any, Callable, Generator, Iterable, Iterator, TypeVar

import grpc

from burnish.v1.library_pb2_grpc import LibraryStub

from ._channel import Trust, make_channel
from ._route import MOVES_MAX, Moved, Route, moved_of
from .errors import Error, FailedPrecondition, Unavailable, error_of

CALL_SECONDS_MAX = 600.0
PATIENCE_SECONDS = 13.0  # a fleet's usual lease of 10 s, and what it takes to open a session elsewhere
PAUSE_SECONDS = 0.1
PAUSE_SECONDS_MAX = 2.0
T = TypeVar("T")


def as_error(error: grpc.RpcError) -> Error:
    """Returns the exception for a call that failed."""
    return moved_of(error) or error_of(error.code().name, error.details() or "")


def pauses(seconds: float) -> Iterator[float]:
    """Sleeps with growing pauses for so many seconds in all. Returns after the last."""
    end, pause = time.monotonic() + seconds, PAUSE_SECONDS
    while (left := end - time.monotonic()) > 0:
        time.sleep(min(pause, left))
        yield left
        pause = min(2 * pause, PAUSE_SECONDS_MAX)


class Calls:
    """The calls of one connection. `patience`: seconds for which calls are repeated."""

    def __init__(self, address: str, trust: Trust, patience: float) -> None:
        self.address, self.patience = address, patience
        self._is_closed = False
        channel = make_channel(address, trust)
        self._metadata = trust.metadata()
        self.library = LibraryStub(channel)
        self.editing = Route(address, channel, trust)

    def close(self) -> None:
        self._is_closed = True
        self.editing.close()

    def ask(self, method: Any, request: Any) -> Any:
        """Returns the answer. Repeats the call: it must be harmless to repeat."""
        return self.repeat(self._call, method, request)

    def ask_once(self, method: Any, request: Any) -> Any:
        return self._follow(self._call, method, request)

    def _call(self, method: Any, request: Any) -> Any:
        try:
            return method(request, metadata=self._metadata, timeout=CALL_SECONDS_MAX)
        except grpc.RpcError as error:
            raise as_error(error) from None
        except ValueError as error:  # gRPC's word for a channel that is closed
            if not self._is_closed:
                raise
            raise FailedPrecondition("the connection is closed") from error

    def stream(self, method: Any, request: Any, seconds: float | None = None) -> Generator[Any, None, None]:
        """Yields the answers of a call, and cancels it when it is closed. `request`: a message, or an
        iterator of them."""
        call = method(request, metadata=self._metadata, timeout=seconds)
        try:
            yield from call
        except grpc.RpcError as error:
            raise as_error(error) from None
        finally:
            call.cancel()

    def open_stream(self, method: Any, requests: Iterable[Any]) -> Any:
        """Returns gRPC's call of a stream in both directions."""
        return method(iter(requests), metadata=self._metadata)

    def repeat(self, work: Callable[..., T], *arguments: Any) -> T:
        """Returns what `work(*arguments)` returns. Repeats it while the server cannot be reached."""
        try:
            return self._follow(work, *arguments)
        except Unavailable as error:
            last = error
        for _ in pauses(self.patience):
            try:
                return self._follow(work, *arguments)
            except Unavailable as error:
                last = error
                self.editing.give_up()
        raise Unavailable(f"{self.address}: {last.message}")

    def _follow(self, work: Callable[..., T], *arguments: Any) -> T:
        """Returns what `work(*arguments)` returns. Does it at the server that has the session."""
        for _ in range(MOVES_MAX):
            try:
                return work(*arguments)
            except Moved as moved:
                self.editing.follow(moved.place)
        return work(*arguments)
