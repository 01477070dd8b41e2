"""Checks of arguments: a wrong type is told by the argument's name, its value and what it takes."""

from __future__ import annotations

import numbers
from typing import Any, Iterable

import numpy as np

_NAMES = {float: "a number", int: "a whole number", bool: "True or False", str: "a text"}


def _fits(value: Any, kind: type) -> bool:
    if kind is bool:
        return isinstance(value, (bool, np.bool_))
    if kind is float:
        return isinstance(value, numbers.Real) and not isinstance(value, bool)
    if kind is int:
        return isinstance(value, numbers.Integral) and not isinstance(value, bool)
    return isinstance(value, kind)


def check_type(name: str, value: Any, kind: type) -> None:
    """Raises TypeError unless the value is of the kind. float, int and bool take NumPy's too."""
    if not _fits(value, kind):
        takes = _NAMES.get(kind, f"a {kind.__name__}")
        raise TypeError(f"{name} is {value!r}, of type {type(value).__name__}: it takes {takes}")


def check_fields(owner: Any, *, optional: bool = False, **kinds: type) -> None:
    """Checks fields of a dataclass by their names. `optional`: they may be None."""
    for name, kind in kinds.items():
        value = getattr(owner, name)
        if value is not None or not optional:
            check_type(f"{type(owner).__name__}: {name}", value, kind)


def check_all(name: str, values: Any, kind: type) -> None:
    """Raises TypeError unless the values are a sequence, each of the kind."""
    if isinstance(values, (str, bytes)) or not isinstance(values, Iterable):
        raise TypeError(f"{name} is {values!r}, of type {type(values).__name__}: "
                        f"it takes a sequence, each of type {kind.__name__}")
    for number, value in enumerate(values):
        check_type(f"{name}[{number}]", value, kind)


def with_change(change: Any) -> Any:
    """Returns the change. Raises TypeError for what is not one, and for the class of one."""
    if hasattr(change, "to_wire") and not isinstance(change, type):
        return change
    raise TypeError(f"the change is {change!r}, of type {type(change).__name__}: "
                    "it takes an edit, such as GradientScale(0.5)")
