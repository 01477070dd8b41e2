"""Errors of servers and of programs, as exceptions with a code and a message."""

from __future__ import annotations


class Error(Exception):
    """Anything that a server or the program `burnish` reports."""

    code = "UNKNOWN"
    """The name of the gRPC status."""

    def __init__(self, message: str) -> None:
        super().__init__(message)
        self.message = message
        """English, for people. It names the thing, its value and its limit."""


class Refused(Error):
    """The request was understood and refused. The same request is refused again."""


class InvalidArgument(Refused):
    """A value is wrong."""

    code = "INVALID_ARGUMENT"


class NotFound(Refused):
    """There is no such scan, session, entry or checkpoint."""

    code = "NOT_FOUND"


class AlreadyExists(Refused):
    """The name is taken by something else."""

    code = "ALREADY_EXISTS"


class PermissionDenied(Refused):
    """The user may not do that."""

    code = "PERMISSION_DENIED"


class Unauthenticated(Refused):
    """The server does not know the caller."""

    code = "UNAUTHENTICATED"


class ResourceExhausted(Refused):
    """A limit of count, memory or disk."""

    code = "RESOURCE_EXHAUSTED"


class FailedPrecondition(Refused):
    """Right, but not now: nothing to undo, a scan in use."""

    code = "FAILED_PRECONDITION"


class Unimplemented(Refused):
    """There is no such call: client and server are of different versions."""

    code = "UNIMPLEMENTED"


class Damaged(Error):
    """Bytes were damaged on their way, or in a file."""

    code = "DATA_LOSS"


class Unavailable(Error):
    """The server is going, gone or coming. All repetitions failed too."""

    code = "UNAVAILABLE"


class SessionEnded(Error):
    """The server ended a live session for good: it was closed, or the user may not be there."""

    code = "GO_AWAY"


class Internal(Error):
    """A fault of the server."""

    code = "INTERNAL"


class Cancelled(Error):
    """This side gave up."""

    code = "CANCELLED"


class DeadlineExceeded(Error):
    """The work took longer than it may."""

    code = "DEADLINE_EXCEEDED"


_NAMES = {kind.code: kind for kind in (
    InvalidArgument, NotFound, AlreadyExists, PermissionDenied, Unauthenticated, ResourceExhausted,
    FailedPrecondition, Unimplemented, Damaged, Unavailable, Internal, Cancelled,
    DeadlineExceeded)}

_NUMBERS = {1: Cancelled, 3: InvalidArgument, 4: DeadlineExceeded, 5: NotFound, 6: AlreadyExists,
            7: PermissionDenied, 8: ResourceExhausted, 9: FailedPrecondition, 12: Unimplemented,
            13: Internal, 14: Unavailable, 15: Damaged, 16: Unauthenticated}


def error_of(code: str | int, message: str) -> Error:
    """Returns the exception for a gRPC status, by its name or its number."""
    kind = _NUMBERS.get(code) if isinstance(code, int) else _NAMES.get(code)
    return (kind or Error)(message)
