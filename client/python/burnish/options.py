"""The options of a filter on this computer."""

from __future__ import annotations

import dataclasses
import inspect
from typing import Any, Callable, Mapping, Sequence, TypedDict, TypeVar

from ._arguments import check_all, check_fields
from .edits import Band, Controls, TransferCurve

Function = TypeVar("Function", bound=Callable[..., Any])


@dataclasses.dataclass(frozen=True)
class Options:
    """A filter. None: as the program's default says. Lengths are in the scan's units.

    Raises TypeError for a value of a wrong type.
    """

    beta: float | None = None
    """Gradient scale, 0 to 10: below 1 smooths, 1 keeps, above 1 sharpens."""
    alpha: float | None = None
    """Fidelity weight times L, 0.01 to 1e5: the larger, the finer the detail that is changed."""
    wavelength: float | None = None
    """Fidelity as a length: at beta 0 this wave is halved."""
    curve: TransferCurve | None = None
    """Alpha by curvature."""
    preset: str | None = None
    """A preset of the window by its name."""
    strength: float | None = None
    """How much of the preset, 0 to 1."""
    bands: Sequence[Band] = ()
    """Gains by the size of details, at most 6."""
    colour_beta: float | None = None
    colour_alpha: float | None = None
    texture_gain: float | None = None
    """Details of the colours, 0 to 4: below 1 fades, 1 keeps."""
    remove_light: float | None = None
    """How much of the light in the colours goes, 0 to 1."""
    level_seams: float | None = None
    """How much of the steps between photos goes, in the pictures of files, 0 to 1."""
    keep_edges: str | None = None
    """Takes noise away and keeps edges before beta smooths or sharpens: "machined", "scanner",
    "soft" or "relief", "auto", as the scan's own noise asks, or "off"."""
    edge_strength: float | None = None
    """How much of it, 0 to 1."""
    edge_angle: float | None = None
    """Degrees, 5 to 120: sharper bends are edges."""
    edge_passes: int | None = None
    """1 to 100: more take away longer noise."""
    crispness: float | None = None
    """0 to 1: low for relief, high for machined parts."""
    controls: Controls | None = None
    depth: int | None = None
    """Of the grid, 4 to 12."""
    exact: bool = False
    """Solve to the accuracy of final results."""
    cycles: int | None = None
    """Solve with exactly so many cycles."""

    def __post_init__(self) -> None:
        check_fields(self, optional=True, beta=float, alpha=float, wavelength=float,
                     curve=TransferCurve, preset=str, strength=float, colour_beta=float,
                     colour_alpha=float, texture_gain=float, remove_light=float, level_seams=float, keep_edges=str,
                     edge_strength=float, edge_angle=float, edge_passes=int, crispness=float, controls=Controls, depth=int, cycles=int)
        check_fields(self, exact=bool)
        check_all("Options: bands", self.bands, Band)

    def words(self) -> list[str]:
        """Returns the options of `burnish filter`."""
        given = {"beta": self.beta, "alpha": self.alpha, "wavelength": self.wavelength,
                 "preset": self.preset, "strength": self.strength,
                 "colour-beta": self.colour_beta, "colour-alpha": self.colour_alpha,
                 "texture-gain": self.texture_gain, "remove-light": self.remove_light,
                 "level-seams": self.level_seams,
                 "keep-edges": self.keep_edges, "edge-strength": self.edge_strength,
                 "edge-angle": self.edge_angle, "edge-passes": self.edge_passes,
                 "crispness": self.crispness,
                 "depth": self.depth, "cycles": self.cycles}
        words = [f"--{name}={value}" for name, value in given.items() if value is not None]
        words += [f"--band={float(band.size)!r}:{float(band.gain)!r}" for band in self.bands]
        if self.curve is not None:
            points = sorted(self.curve.points.items())
            words.append("--curve=" + ",".join(f"{float(kappa)!r}:{float(alpha)!r}"
                                                 for kappa, alpha in points))
        if self.controls is not None:
            words += [f"--pin-rims={'on' if self.controls.pin_rims else 'off'}",
                      f"--keep-volume={'on' if self.controls.keep_volume else 'off'}"]
            words += [f"--cap={float(self.controls.cap)!r}"] if self.controls.cap else []
        return words + (["--exact"] if self.exact else [])


class OptionWords(TypedDict, total=False):
    """The fields of Options as keyword arguments, for checkers of types."""

    beta: float | None
    alpha: float | None
    wavelength: float | None
    curve: TransferCurve | None
    preset: str | None
    strength: float | None
    bands: Sequence[Band]
    colour_beta: float | None
    colour_alpha: float | None
    texture_gain: float | None
    remove_light: float | None
    level_seams: float | None
    keep_edges: str | None
    edge_strength: float | None
    edge_angle: float | None
    edge_passes: int | None
    crispness: float | None
    controls: Controls | None
    depth: int | None
    exact: bool
    cycles: int | None


def edits_colours(words: Mapping[str, Any]) -> bool:
    """Returns whether these options change the colours of a mesh that has some."""
    return any(words.get(name) is not None
               for name in ("colour_beta", "texture_gain", "remove_light"))


def options_of(words: Mapping[str, Any]) -> Options:
    """Returns options. Raises TypeError for a name that is none, or a value of a wrong type."""
    names = [field.name for field in dataclasses.fields(Options)]
    unknown = [word for word in words if word not in names]
    if unknown:
        raise TypeError(f"{unknown[0]} is not an option: options are {', '.join(names)}")
    return Options(**words)


def shows_options(function: Function) -> Function:
    """Lets help() and completion show the fields of Options in the place of **options."""
    signature = inspect.signature(function)
    own = [one for one in signature.parameters.values() if one.kind is not one.VAR_KEYWORD]
    more = [inspect.Parameter(field.name, inspect.Parameter.KEYWORD_ONLY, annotation=field.type,
                              default=field.default) for field in dataclasses.fields(Options)]
    setattr(function, "__signature__", signature.replace(parameters=[*own, *more]))
    return function
