"""The way to the server of a session, which may move to another server of a fleet."""

from __future__ import annotations

import threading
from typing import Any

import grpc

from burnish.v1 import editing_pb2
from burnish.v1.editing_pb2_grpc import EditingStub

from ._channel import Trust, make_channel
from .errors import FailedPrecondition

MOVES_MAX = 5
Metadata = list[tuple[str, str | bytes]]


class Moved(FailedPrecondition):
    """Another server has the session."""

    def __init__(self, message: str, place: editing_pb2.Moved) -> None:
        super().__init__(message)
        self.place = place


def moved_of(error: grpc.RpcError) -> Moved | None:
    """Returns where the error sends its caller, if it does."""
    if error.code() is not grpc.StatusCode.FAILED_PRECONDITION:
        return None
    details = dict(error.trailing_metadata() or ()).get("grpc-status-details-bin")
    if not details:
        return None
    place = editing_pb2.Moved.FromString(details)
    return Moved(error.details() or "", place) if place.address or place.node else None


class Route:
    """Calls about sessions, at the server that has them. Thread-safe."""

    def __init__(self, address: str, channel: Any, trust: Trust) -> None:
        self._trust = trust
        self._lock = threading.Lock()
        self._address, self._node = address, ""
        self._home = address
        self._fleet: list[str] = []
        self._channels = {address: channel}
        self._stub = EditingStub(channel)

    def __getattr__(self, name: str) -> Any:
        """Returns the call of this name. Its server is chosen when it is called."""
        def call(request: Any, metadata: Metadata, **options: Any) -> Any:
            with self._lock:
                stub, node = self._stub, self._node
            if node:
                metadata = [*metadata, ("x-burnish-node", node)]
            return getattr(stub, name)(request, metadata=metadata, **options)
        return call

    def follow(self, place: editing_pb2.Moved) -> None:
        """Goes to the server that has the session. Without an address it is behind the same proxy."""
        with self._lock:
            self._go(place.address or self._address, place.node)

    def learn(self, fleet: list[str]) -> None:
        """Takes the addresses of all servers of the fleet."""
        with self._lock:
            self._fleet = fleet

    def give_up(self) -> None:
        """The server does not answer: goes on to the next one of the fleet, or to the first one if no
        other is known. It says who has the session by then."""
        with self._lock:
            fleet = self._fleet or [self._home]
            at = fleet.index(self._address) + 1 if self._address in fleet else 0
            self._go(fleet[at % len(fleet)], "")

    def close(self) -> None:
        with self._lock:
            for channel in self._channels.values():
                channel.close()

    def _go(self, address: str, node: str) -> None:
        if address not in self._channels:
            self._channels[address] = make_channel(address, self._trust)
        self._stub = EditingStub(self._channels[address])
        self._address, self._node = address, node
