"""The presets of the program `burnish`, and the user's own."""

from __future__ import annotations

import dataclasses
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


@dataclasses.dataclass(frozen=True)
class PresetChanges:
    """The edits that a preset is on a scan, and what it makes of kept edges."""

    curve: TransferCurve
    beta: GradientScale
    bands: Equaliser
    edges: str | None
    """"auto": kept as the scan's noise asks; "off"; None: as before."""
    follows_noise: bool
    """Whether it is another one on a scan with more noise."""


def preset_changes(name: str, strength: float, measures: list[str]) -> PresetChanges:
    """Returns what a preset is on a scan of these measures, as options of `burnish presets`.
    Raises NotFound for an unknown name, InvalidArgument for a strength outside 0 to 1."""
    found = _ask(*measures, f"--strength={float(strength)!r}", "--", name)
    return PresetChanges(TransferCurve({kappa: alpha for kappa, alpha in found["curve"]}),
                         GradientScale(found["beta"]),
                         Equaliser([Band(size, gain) for size, gain in found["bands"]]),
                         found["edges"], found["follows_noise"])


def _ask(*words: str) -> Any:
    answer = subprocess.run([find_program(), "presets", "--json", *words], capture_output=True,
                            text=True, check=False)
    if answer.returncode == USAGE:
        raise InvalidArgument(answer.stderr.strip())
    if answer.returncode != 0:
        raise NotFound(answer.stderr.strip().removeprefix("burnish: "))
    return json.loads(answer.stdout)
