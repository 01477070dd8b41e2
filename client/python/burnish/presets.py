"""The presets of the program `burnish`, and the user's own."""

from __future__ import annotations

import json
import subprocess
from typing import Any

from .edits import Band, Equaliser, GradientScale, TransferCurve
from .errors import InvalidArgument, NotFound
from .program import find_program

USAGE = 2  # the exit code for options that are wrong


def presets() -> dict[str, str]:
    """Returns the presets by name, with what they are for. Raises NotFound without the program."""
    return {preset["name"]: preset["description"] for preset in _ask()}


def preset_changes(name: str, strength: float, length_unit: float,
                   cell_size: float) -> tuple[TransferCurve, GradientScale, Equaliser]:
    """Returns the edits that a preset is on a scan of these lengths. Raises NotFound for an unknown
    name, InvalidArgument for a strength outside 0 to 1."""
    found = _ask(f"--length-unit={float(length_unit)!r}", f"--cell-size={float(cell_size)!r}",
                 f"--strength={float(strength)!r}", "--", name)
    return (TransferCurve({kappa: alpha for kappa, alpha in found["curve"]}),
            GradientScale(found["beta"]),
            Equaliser([Band(size, gain) for size, gain in found["bands"]]))


def _ask(*words: str) -> Any:
    answer = subprocess.run([find_program(), "presets", "--json", *words], capture_output=True,
                            text=True, check=False)
    if answer.returncode == USAGE:
        raise InvalidArgument(answer.stderr.strip())
    if answer.returncode != 0:
        raise NotFound(answer.stderr.strip().removeprefix("burnish: "))
    return json.loads(answer.stdout)
