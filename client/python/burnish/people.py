"""The people of a session."""

from __future__ import annotations

import dataclasses

from burnish.v1 import editing_pb2

from .errors import InvalidArgument

ROLES = {"viewer": editing_pb2.ROLE_VIEWER, "editor": editing_pb2.ROLE_EDITOR,
         "owner": editing_pb2.ROLE_OWNER}
_NAMES = {number: name for name, number in ROLES.items()}


@dataclasses.dataclass(frozen=True)
class People:
    """Who may do what in a session, and who is there."""

    roles: dict[str, str]
    """viewer, editor or owner by user; "" stands for everybody without a role of their own."""
    present: list[str]
    """Users with a live session, in the order of arrival."""

    @classmethod
    def of(cls, message: editing_pb2.People) -> People:
        return cls({one.user: _NAMES.get(one.role, "unknown") for one in message.roles},
                   [one.user for one in message.present])


def role_of(name: str) -> editing_pb2.Role:
    """Returns the role of this name. Raises InvalidArgument."""
    if name not in ROLES:
        raise InvalidArgument(f"role '{name}' is not one of {', '.join(ROLES)}")
    return ROLES[name]
