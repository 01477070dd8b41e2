"""The way to a server: address, TLS, token, user."""

from __future__ import annotations

import dataclasses
import os
import re
import urllib.parse
from typing import Any

import grpc

from .errors import FailedPrecondition, InvalidArgument

RECEIVE_BYTES_MAX = 64 << 20
KEEPALIVE_MS = 20_000
PathLike = str | os.PathLike[str]


@dataclasses.dataclass(frozen=True)
class Trust:
    """Who the server is, and who the caller is."""

    user: str | None = None
    token: str | None = None
    ca: PathLike | None = None
    certificate: PathLike | None = None
    key: PathLike | None = None
    tls: bool = False
    insecure: bool = False

    @property
    def uses_tls(self) -> bool:
        return self.tls or self.ca is not None or self.certificate is not None

    def metadata(self) -> list[tuple[str, str | bytes]]:
        """Returns the headers of each call."""
        found: list[tuple[str, str | bytes]] = []
        if self.user:
            found.append(("burnish-user-bin", self.user.encode()))
        if self.token:
            found.append(("authorization", "Bearer " + self.token))
        return found


def check_trust(address: str, trust: Trust) -> None:
    if (trust.certificate is None) != (trust.key is None):
        raise InvalidArgument("a client's certificate and its key go together: give both or neither")
    if trust.token is None:
        return
    if not re.fullmatch(r"[A-Za-z0-9._~+/=-]+", trust.token):
        raise InvalidArgument("the token has characters other than letters, digits and -._~+/=")
    is_near = re.match(r"unix:|localhost:|127\.|\[::1\]:", address)
    if not (is_near or trust.uses_tls or trust.insecure):
        raise FailedPrecondition(f"the token would travel to {address} in plain text; use TLS, or "
                                 "say insecure=True if that is meant")


def _read(path: PathLike | None) -> bytes | None:
    if path is None:
        return None
    with open(path, "rb") as file:
        return file.read()


def make_channel(address: str, trust: Trust) -> Any:
    """Returns a gRPC channel to HOST:PORT or unix:PATH. Raises OSError, and Refused."""
    check_trust(address, trust)
    if address.startswith("unix:"):
        address = "unix:" + urllib.parse.quote(address[len("unix:"):], safe="/~")
    options = [("grpc.max_receive_message_length", RECEIVE_BYTES_MAX),
               ("grpc.keepalive_time_ms", KEEPALIVE_MS), ("grpc.enable_http_proxy", 0),
               ("grpc.use_local_subchannel_pool", 1)]
    if not trust.uses_tls:
        return grpc.insecure_channel(address, options)
    credentials = grpc.ssl_channel_credentials(_read(trust.ca), _read(trust.key),
                                               _read(trust.certificate))
    return grpc.secure_channel(address, credentials, options)
