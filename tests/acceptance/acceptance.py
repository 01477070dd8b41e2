"""Every scan, at its default depth with default controls, through every front, in pairs of features.

Usage: acceptance.py [--short] [--pairs N] [--only CASE]... [--no-page] [--table FILE] [SCAN.ply]...

Without scans it generates one of every kind. It prints a table, and ends with 1 if a cell failed.
"""

import argparse
import contextlib
import pathlib
import sys
import tempfile
import traceback
import typing

import burnish
import numpy as np
from server_process import ServerProcess

import cases
import checks
import fronts
import harm
import pictures

KINDS = ("tablet", "coloured", "icosphere", "cylinder", "sheet", "doubled", "flaps", "blob", "sheets", "fan",
         "soup", "part", "coin", "wall")
SHORT_KINDS = ("coloured", "doubled", "blob", "soup")


def generated(kinds, vertices, folder):
    for kind in kinds:
        file = folder / f"{kind}.ply"
        plain, change = CHANGED.get(kind, (kind, None))
        fronts.run("generate", plain, file, "--vertices", vertices)
        if change:
            change(file)
        yield file


def generated_for_presets(vertices, folder):
    """A noisy inscription, a lumpy shape, a part, and a ball of few triangles."""
    for name, kind, options in (("noisy", "tablet", ("--noise", 0.3, "--noise-kind", "gauss")),
                                ("lumps", "blob", ()), ("machined", "part", ())):
        file = folder / f"{name}.ply"
        fronts.run("generate", kind, file, "--vertices", vertices, *options)
        yield file
    file = folder / "coarse.ply"
    fronts.run("generate", "icosphere", file, "--vertices", 162)
    yield file


def colour(file):
    """Gives a file's vertices colours: stripes, with noise from vertex to vertex."""
    mesh = burnish.load_ply(file)
    noise = np.random.default_rng(1).integers(-20, 21, (len(mesh.vertices), 3))
    stripes = 128 + 60 * np.sin(mesh.vertices[:, 0] * (40 / np.ptp(mesh.vertices, axis=0).max()))
    vertices = np.zeros(len(mesh.vertices), [("place", "<f8", 3), ("colour", "u1", 3)])
    vertices["place"], vertices["colour"] = mesh.vertices, (stripes[:, None] + noise).astype(int)
    head, faces = mesh.to_ply().split(b"end_header\n", 1)
    head = head.replace(b"double z\n", b"double z\nproperty uchar red\nproperty uchar green\n"
                                       b"property uchar blue\n")
    faces = faces[mesh.vertices.nbytes:]
    file.write_bytes(head + b"end_header\n" + vertices.tobytes() + faces)


def double(file):
    """Lists every third triangle again, every other time turned."""
    mesh = burnish.load_ply(file)
    again = mesh.faces[::3].copy()
    again[::2] = again[::2, ::-1]
    file.write_bytes(burnish.Mesh(mesh.vertices, np.concatenate([mesh.faces, again])).to_ply())


def add_flaps(file):
    """Adds a triangle without area to every edge: it ends where it began, or beside a copy."""
    mesh = burnish.load_ply(file)
    edges = np.concatenate([mesh.faces[:, [a, b]] for a, b in ((0, 1), (1, 2), (2, 0))])
    ends = edges[:, 0].copy()
    ends[::2] = len(mesh.vertices) + np.arange(len(ends[::2]))
    vertices = np.concatenate([mesh.vertices, mesh.vertices[edges[::2, 0]]])
    flaps = np.column_stack([edges, ends]).astype(mesh.faces.dtype)
    file.write_bytes(burnish.Mesh(vertices, np.concatenate([mesh.faces, flaps])).to_ply())


CHANGED = {"coloured": ("tablet", colour), "doubled": ("tablet", double), "flaps": ("sheet", add_flaps)}


class Table:
    """The outcome of each case on each scan."""

    def __init__(self):
        self.rows = []
        self.failures = []

    def add(self, scan, case, outcome, detail=""):
        self.rows.append((scan, case, outcome, detail))
        if outcome == "FAILED":
            self.failures.append(f"{scan}, {case}: {detail}")
        print(f"{scan:28} {case:28} {outcome:8} {detail}", flush=True)

    def markdown(self):
        lines = ["| scan | cases | right | refused, with a sentence | failed |", "|---|---|---|---|---|"]
        for scan in dict.fromkeys(row[0] for row in self.rows):
            outcomes = [row[2] for row in self.rows if row[0] == scan]
            counts = [outcomes.count(word) for word in ("right", "refused", "FAILED")]
            lines.append(f"| {scan} | {len(outcomes)} | " + " | ".join(map(str, counts)) + " |")
        return "\n".join(lines) + "\n"


def try_case(facts, case, ways, folder):
    """Returns the largest move over the diagonal. Raises AssertionError for what is not true."""
    settings = case.settings(facts)
    first, *others = [name for name, way in ways.items() if way.can(settings)]
    out = folder / f"{first}.ply"
    report = ways[first].go(settings, out)
    checks.check_report(report)
    moved = checks.moved_by(facts, out)
    checks.check_rims(facts, case, report, moved)
    checks.check_cap(facts, case, settings, moved)
    checks.check_kept(facts, case, out)
    checks.check_volume(facts, case, out)
    checks.check_stroke(case, moved)
    checks.check_protected(facts, case, report, moved)
    for name in others:
        other = folder / f"{name}.ply"
        told = ways[name].go(settings, other)
        assert other.read_bytes() == out.read_bytes(), f"{name} differs from {first}"
        if name == "python":
            checks.check_frame(facts, report, moved, told.frame)
            checks.check_shown_rims(facts, case, report, moved, told)
    return moved.max() / facts.diagonal


def try_refusal(facts, case, ways, folder):
    """Every front refuses what the scan cannot take, and leaves no file. Returns the sentence."""
    settings = case.settings(facts)
    sentence = ""
    for name, way in ways.items():
        if not way.can(settings) or name == "python":
            continue
        out = folder / "refused.ply"
        try:
            way.go(settings, out)
        except fronts.Refused as refused:
            sentence = sentence or str(refused)
        else:
            raise AssertionError(f"{name} took what others refuse")
        assert not out.exists(), f"{name} refused and left a file"
    return sentence


class Way(typing.NamedTuple):
    """A front: what it can be told, and how it is told to make a file. The first one reports."""

    can: typing.Callable
    go: typing.Callable


def ways_of(facts, server, page):
    ways = {
        "filter": Way(fronts.can_filter,
                      lambda settings, out: fronts.filtered(facts.file, settings, out)),
        "commands": Way(fronts.can_session, server.by_commands),
        "script": Way(fronts.can_session, server.by_script),
        "python": Way(fronts.can_python, server.by_python),
    }
    if page:
        ways["page"] = Way(fronts.can_session,
                           lambda settings, out: server.by_page(page, settings, out))
    return ways


def opened_page(process, with_page, scan, stack):
    """Returns the page of a server, which `stack` closes; None if there is none."""
    if not with_page or not fronts.has_page(process.web):
        print(f"{scan}: without the page", flush=True)
        return None
    page = fronts.Page(process.web)
    stack.callback(page.close)
    return page


def try_scan(file, tried, table, with_page):
    facts = checks.facts_of(file)
    with contextlib.ExitStack() as stack:
        process = ServerProcess("--log-level", "warn", "--web", "127.0.0.1:0")
        stack.callback(process.close)
        server = fronts.Server(process.socket, file)
        page = opened_page(process, with_page, file.stem, stack)
        ways = ways_of(facts, server, page)
        folder = pathlib.Path(stack.enter_context(tempfile.TemporaryDirectory(prefix="burnish-")))
        for case in tried:
            try:
                if cases.applies(case, facts):
                    detail = f"moved {try_case(facts, case, ways, folder):.1e}"
                    table.add(file.stem, case.name, "right", detail)
                else:
                    table.add(file.stem, case.name, "refused",
                              try_refusal(facts, case, ways, folder))
            except (AssertionError, fronts.Refused, burnish.Error) as wrong:
                table.add(file.stem, case.name, "FAILED", str(wrong) or traceback.format_exc())


def try_presets(file, strengths, only, table):
    """No preset harms a scan that nobody has looked at, not even at full strength."""
    facts = checks.facts_of(file)
    for preset in burnish.presets():
        for strength in strengths:
            case = f"{preset} {strength}"
            if only and case not in only:
                continue
            with tempfile.TemporaryDirectory(prefix="burnish-") as folder:
                try:
                    table.add(file.stem, case, "right",
                              str(harm.check(facts, preset, strength, pathlib.Path(folder))))
                except (AssertionError, fronts.Refused) as wrong:
                    table.add(file.stem, case, "FAILED", str(wrong) or traceback.format_exc())


def try_pictures(vertices, table, with_page):
    with contextlib.ExitStack() as stack:
        process = ServerProcess("--log-level", "warn", "--web", "127.0.0.1:0")
        stack.callback(process.close)
        page = opened_page(process, with_page, "textured", stack)
        checks_of = {"colours in pictures": lambda: pictures.check_scan(process.socket, vertices),
                     "level seams": lambda: seams_told(pictures.check_seams(process.socket, page)),
                     "sharp views": lambda: sharpness_told(pictures.check_sharpness(process.socket, page)),
                     "close views": lambda: sharpness_told(pictures.check_close_view(process.socket, page)),
                     "a dense part": lambda: sharpness_told(pictures.check_dense_part(process.socket, page)),
                     "scale bars": lambda: bars_told(pictures.check_scale_bar(process.socket, page))}
        for case, check in checks_of.items():
            try:
                table.add("textured", case, "right", check())
            except (AssertionError, fronts.Refused, burnish.Error) as wrong:
                table.add("textured", case, "FAILED", str(wrong) or traceback.format_exc())


def seams_told(steps):
    return "steps: " + ", ".join(f"{way} {before:.1f} to {after:.1f}" for way, (before, after) in steps.items())


def bars_told(lengths):
    return "units: " + ", ".join(f"{way} {length:.2f}" for way, length in lengths.items())


def sharpness_told(parts):
    return "contrast: " + ", ".join(f"{way} {part:.2f}" for way, part in parts.items())


def main(words=None):
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--short", action="store_true", help="few kinds, few cases")
    parser.add_argument("--only", action="append", metavar="CASE", help="this case; repeatable")
    parser.add_argument("--pairs", type=int, default=6, help="so many random pairs of features")
    parser.add_argument("--no-page", action="store_true", help="leave out the page in Chromium")
    parser.add_argument("--table", type=pathlib.Path, help="writes the table as Markdown")
    parser.add_argument("-v", action="store_true", help=argparse.SUPPRESS)
    parser.add_argument("scans", nargs="*", type=pathlib.Path)
    given = parser.parse_args(words)
    table = Table()
    tried = (cases.PLAIN[:2] + cases.SINGLE + cases.LINES + cases.PAINTED + cases.EDGES[:2] if given.short
             else cases.PLAIN + cases.SINGLE + cases.LINES + cases.PAINTED + cases.EDGES + cases.pairs(given.pairs))
    tried = tuple(case for case in tried if not given.only or case.name in given.only)
    with tempfile.TemporaryDirectory(prefix="burnish-") as folder:
        files = given.scans or generated(SHORT_KINDS if given.short else KINDS,
                                         3000 if given.short else 30_000, pathlib.Path(folder))
        strengths = harm.STRENGTHS[:1] if given.short else harm.STRENGTHS
        for file in files:
            try_scan(file, tried, table, not given.no_page)
            if not given.short:
                try_presets(file, strengths, given.only, table)
        if not given.scans:
            for file in generated_for_presets(3000 if given.short else 30_000, pathlib.Path(folder)):
                try_presets(file, strengths, given.only, table)
        if not given.scans and not given.only:
            try_pictures(3000 if given.short else 30_000, table, not given.no_page)
    print(table.markdown())
    if given.table:
        given.table.write_text(table.markdown(), encoding="utf-8")
    for failure in table.failures:
        print("FAILED:", failure, file=sys.stderr)
    return 1 if table.failures else 0


if __name__ == "__main__":
    sys.exit(main())
