"""What is tried on every scan. A case is written once, in the options of `burnish filter` and
`burnish edit`; each front translates it. Three options hold text in place of a file's name:
--palette, --stroke for both commands' strokes, and --protect, the words of `burnish protect`."""

import dataclasses
import itertools
import random


@dataclasses.dataclass(frozen=True)
class Case:
    """Settings for one result. Lengths are parts of the scan's diagonal, a stroke says what it paints
    and a region is a part of the scan: settings() makes them real."""

    name: str
    options: tuple[tuple[str, str], ...]

    def settings(self, facts):
        """Returns the options as a list of pairs, with the scan's own lengths and places."""
        return [(option, _on_scan(option, value, facts)) for option, value in self.options]

    def has(self, option):
        return any(name == option for name, _ in self.options)


def _on_scan(option, value, facts):
    if option == "--cap":
        return repr(float(value) * facts.diagonal)
    if option == "--band":
        size, gain = value.split(":")
        return f"{float(size) * facts.diagonal!r}:{gain}"
    if option == "--stroke":
        beta, paints = value.split()
        points = [" ".join(map(repr, point)) for point in facts.path.tolist()]
        return "\n".join([f"{BRUSH_RADIUS * facts.diagonal!r} 1 {beta} smooth {paints}", *points])
    if option == "--protect":
        return f"through {' '.join(map(repr, facts.half))} -1 -1 0 -1 0 1 -1 1"
    return value


def _case(name, *options):
    return Case(name, options)


BRUSH_RADIUS = 0.1
CURVE = "-40:200,-10:2,10:2,40:200"
PRESETS = ("Reduce scanner noise", "Soften", "Bring out an inscription", "Deepen carving")

PLAIN = (
    _case("beta 1", ("--beta", "1")),
    _case("beta 0", ("--beta", "0")),
    _case("beta 2", ("--beta", "2")),
    _case("alpha 5", ("--alpha", "5"), ("--beta", "0")),
    _case("alpha 20", ("--alpha", "20"), ("--beta", "0")),
    _case("alpha 200", ("--alpha", "200"), ("--beta", "0")),
    _case("curve", ("--curve", CURVE), ("--beta", "0")),
    *(_case(preset, ("--preset", preset)) for preset in PRESETS),
)

# What may stand beside each other.
PARTS = {
    "beta": (("--beta", "0.3"),),
    "alpha": (("--alpha", "30"),),
    "bands": (("--band", "0.01:0"), ("--band", "0.03:1.5")),
    "colours": (("--colour-beta", "0"),),
    "texture": (("--texture-gain", "2"), ("--remove-light", "0.5")),
    "cap": (("--cap", "0.002"),),
    "volume": (("--keep-volume", "on"),),
    "free rims": (("--pin-rims", "off"),),
    "stroke": (("--stroke", "0 beta"),),
    "palette": (("--palette", "10 ff8000 soft\n-40:20,40:200 0080ff keen"),
                ("--stroke", "0.3 curve:1")),
    "protected": (("--protect", "half"),),
}
SINGLE = tuple(Case(name, (*options, *(() if name in ("beta", "stroke") else (("--beta", "0.3"),))))
               for name, options in PARTS.items())

# Any edit, as a script writes it.
LINES = (_case("lines", ("--edit", f"curve {CURVE}"), ("--edit", "beta 0.3")),)

TEXTURE_STROKE = ("--stroke", "2 texture")
PAINTED = (_case("painted texture", ("--beta", "0.3"), TEXTURE_STROKE),)

# Only the filter keeps edges.
EDGES = (
    _case("edges", ("--keep-edges", "machined")),
    _case("edges + beta 3", ("--keep-edges", "relief"), ("--beta", "3")),
    _case("edges + free rims", ("--keep-edges", "scanner"), ("--pin-rims", "off")),
    _case("edges + cap", ("--keep-edges", "soft"), *PARTS["cap"]),
    _case("edges + bands", ("--keep-edges", "machined"), *PARTS["bands"]),
    _case("edges + stroke", ("--keep-edges", "scanner"), *PARTS["stroke"]),
    _case("edges + palette", ("--keep-edges", "scanner"), *PARTS["palette"]),
    _case("edges + colours", ("--keep-edges", "scanner"), *PARTS["colours"]),
    _case("painted edges", ("--keep-edges", "scanner"), ("--stroke", "0 edges")),
    _case("edges by brush alone", ("--beta", "2"), ("--stroke", "1 edges")),
    _case("edges + volume", ("--keep-edges", "machined"), *PARTS["volume"]),
)


def pairs(count, seed=1):
    """Returns random pairs of PARTS, each with a beta that moves something."""
    all_pairs = list(itertools.combinations(PARTS, 2))
    chosen = random.Random(seed).sample(all_pairs, min(count, len(all_pairs)))
    made = []
    for first, second in chosen:
        options = PARTS[first] + PARTS[second]
        if "beta" not in (first, second):
            options += (("--beta", "0.3"),)
        made.append(Case(f"{first} + {second}", options))
    return tuple(made)


def applies(case, facts):
    """Returns whether a scan can take the case: others are refused, which is tried as well."""
    edits_colours = (case.has("--colour-beta") or case.has("--texture-gain")
                     or TEXTURE_STROKE in case.options)
    if edits_colours and not facts.has_colours:
        return False
    if case.has("--keep-edges") and (case.has("--keep-volume") or case.has("--band")):
        return False
    return not (case.has("--keep-volume") and not facts.is_closed)
