"""Every scan, at its default depth with default controls, through every front, in pairs of features.

Usage: acceptance.py [--short] [--pairs N] [--table FILE] [SCAN.ply]...

Without scans it generates one of every kind. It prints a table, and ends with 1 if a cell failed.
"""

import argparse
import contextlib
import pathlib
import sys
import tempfile
import traceback

from server_process import ServerProcess

import cases
import checks
import fronts

KINDS = ("tablet", "icosphere", "cylinder", "sheet", "blob", "sheets", "fan", "soup", "part", "wall")
SHORT_KINDS = ("tablet", "blob", "soup")


def generated(kinds, vertices, folder):
    for kind in kinds:
        file = folder / f"{kind}.ply"
        fronts.run("generate", kind, file, "--vertices", vertices)
        yield file


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


def try_case(facts, case, server, folder):
    """Returns the largest move over the diagonal. Raises AssertionError for what is not true."""
    settings = case.settings(facts.diagonal)
    out = folder / "filtered.ply"
    report = fronts.filtered(facts.file, settings, out)
    checks.check_report(report)
    moved = checks.moved_by(facts, out)
    checks.check_rims(facts, case, report, moved)
    checks.check_cap(facts, case, settings, moved)
    checks.check_kept(facts, case, out)
    checks.check_volume(facts, case, out)
    ways = [("commands", server.by_commands), ("script", server.by_script)]
    for name, way in ways:
        other = folder / f"{name}.ply"
        way(settings, other)
        assert other.read_bytes() == out.read_bytes(), f"{name} differs from filter"
    if fronts.can_python(settings):
        other = folder / "python.ply"
        frame, _ = server.by_python(settings, other)
        assert other.read_bytes() == out.read_bytes(), "python differs from filter"
        checks.check_frame(facts, report, moved, frame)
    return moved.max() / facts.diagonal


def try_refusal(facts, case, server, folder):
    """Every front refuses what the scan cannot take, and leaves no file. Returns the sentence."""
    settings = case.settings(facts.diagonal)
    sentence = ""
    for way in (lambda out: fronts.filtered(facts.file, settings, out),
                lambda out: server.by_commands(settings, out),
                lambda out: server.by_script(settings, out)):
        out = folder / "refused.ply"
        try:
            way(out)
        except fronts.Refused as refused:
            sentence = str(refused)
        else:
            raise AssertionError("a front took what others refuse")
        assert not out.exists(), "a refused command left a file"
    return sentence


def try_scan(file, tried, table):
    facts = checks.facts_of(file)
    with contextlib.ExitStack() as stack:
        process = ServerProcess("--log-level", "warn")
        stack.callback(process.close)
        server = fronts.Server(process.socket, file)
        folder = pathlib.Path(stack.enter_context(tempfile.TemporaryDirectory(prefix="burnish-")))
        for case in tried:
            try:
                if cases.applies(case, facts):
                    detail = f"moved {try_case(facts, case, server, folder):.1e}"
                    table.add(file.stem, case.name, "right", detail)
                else:
                    table.add(file.stem, case.name, "refused",
                              try_refusal(facts, case, server, folder))
            except (AssertionError, fronts.Refused) as wrong:
                table.add(file.stem, case.name, "FAILED", str(wrong) or traceback.format_exc())


def main(words=None):
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--short", action="store_true", help="few kinds, few cases")
    parser.add_argument("--pairs", type=int, default=6, help="so many random pairs of features")
    parser.add_argument("--table", type=pathlib.Path, help="writes the table as Markdown")
    parser.add_argument("-v", action="store_true", help=argparse.SUPPRESS)
    parser.add_argument("scans", nargs="*", type=pathlib.Path)
    given = parser.parse_args(words)
    table = Table()
    tried = (cases.PLAIN[:2] + cases.SINGLE if given.short
             else cases.PLAIN + cases.SINGLE + cases.pairs(given.pairs))
    with tempfile.TemporaryDirectory(prefix="burnish-") as folder:
        files = given.scans or generated(SHORT_KINDS if given.short else KINDS,
                                         3000 if given.short else 30_000, pathlib.Path(folder))
        for file in files:
            try_scan(file, tried, table)
    print(table.markdown())
    if given.table:
        given.table.write_text(table.markdown(), encoding="utf-8")
    for failure in table.failures:
        print("FAILED:", failure, file=sys.stderr)
    return 1 if table.failures else 0


if __name__ == "__main__":
    sys.exit(main())
