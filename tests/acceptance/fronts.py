"""The ways to a result. Each takes a scan's file and a case's settings, and writes a file."""

import contextlib
import dataclasses
import json
import os
import pathlib
import subprocess
import tempfile
import urllib.request

import burnish
import numpy as np

PATIENCE_S = 1200  # for a frame at rest, and for the page
ROOT = pathlib.Path(__file__).resolve().parents[2]


@dataclasses.dataclass(frozen=True)
class Shown:
    """A live frame."""

    frame: burnish.Frame
    rest: np.ndarray  # the places of its vertices before all edits
    step: float  # of the lattice that they are rounded to


class Refused(Exception):
    """A front said no, in one sentence."""


def run(*words):
    """Runs burnish. Returns what it printed. Raises Refused with its message."""
    done = subprocess.run([os.environ["BURNISH_BINARY"], *map(str, words)], capture_output=True,
                          text=True, check=False, stdin=subprocess.DEVNULL)
    if done.returncode < 0:
        raise AssertionError(f"burnish {words[0]} died of signal {-done.returncode}: {done.stderr}")
    if done.returncode != 0:
        raise Refused(done.stderr.strip().splitlines()[-1])
    return done.stdout


def _words(settings, strokes, out):
    """Returns the words of a command. Text goes into files beside `out`; `strokes`: its option."""
    words = []
    for name, value in settings:
        if name not in ("--palette", "--stroke", "--protect"):
            words += [name, value]
    texts = {"--palette": [value for name, value in settings if name == "--palette"],
             strokes: [f"brush {value}" for name, value in settings if name == "--stroke"]}
    for name, text in texts.items():
        if text:
            file = out.with_suffix("." + name.strip("-"))
            file.write_text("\n".join(text) + "\n", encoding="utf-8")
            words += [name, file]
    return words


def can_filter(settings):
    """Returns whether `burnish filter` has all of these: it protects no region."""
    return not any(name == "--protect" for name, _ in settings)


def filtered(scan, settings, out):
    """By `burnish filter`. Returns its report."""
    report = out.with_suffix(".json")
    run("filter", scan, out, "--exact", "--report", report,
        *_words(settings, "--beta-paint", out))
    return json.loads(report.read_text(encoding="utf-8"))


class Server:
    """A server with one scan on it, for the fronts that need one."""

    def __init__(self, socket, scan):
        self.at = ("--server", f"unix:{socket}")
        self.connection = burnish.connect(f"unix:{socket}", user="acceptance")
        self.scan = self.connection.import_scan(scan)
        self._opened = 0

    def _open(self):
        self._opened += 1
        return self.connection.open_session(self.scan, f"session {self._opened}")

    def by_commands(self, settings, out):
        """By `burnish edit`, `protect` and `export`. Returns as much of a report as they tell."""
        with _deleted(self._open()) as session:
            words = _words(settings, "--stroke", out)
            if words:
                run("edit", session.id, *words, *self.at)
            for name, value in settings:
                if name == "--protect":
                    run("protect", *self.at, session.id, *value.split())
            told = json.loads(run("export", session.id, out, "--exact", "--json", *self.at))
            state = session.state()
        prepared = self.scan.prepared(session.depth)
        return {"converged": told["converged"], "distance": told["distance"], "fell_back": False,
                "rims": {"number": state.rims, "held": state.rims_held},
                "grid": {"cell_size": prepared.cell_size}}

    def by_script(self, settings, out):
        """By a script of the window's commands."""
        script = out.with_suffix(".txt")
        with _deleted(self._open()) as session:
            lines = [f"join {session.id}", *_script_lines(settings), "wait", f"export {out} exact"]
            script.write_text("\n".join(lines) + "\n", encoding="utf-8")
            run("--script", script, *self.at)

    def by_page(self, page, settings, out):
        """By a script that the page replays."""
        script = out.with_suffix(".txt")
        with _deleted(self._open()) as session:
            lines = [*_script_lines(settings), "wait", f"export {out.name} exact"]
            script.write_text("\n".join(lines) + "\n", encoding="utf-8")
            page.follow(session.name, script, out)

    @contextlib.contextmanager
    def opened(self):
        """A session while the block runs."""
        with _deleted(self._open()) as session:
            yield session

    def shown_by_script(self, session, lines, out):
        """Runs lines of a script in a session, and keeps the window's picture."""
        script = out.with_suffix(".txt")
        lines = [f"join {session.id}", "wait", "size 320x240", *lines, "wait", f"screenshot {out}"]
        script.write_text("\n".join(lines) + "\n", encoding="utf-8")
        run("--script", script, *self.at)

    def shown_by_page(self, page, session, lines, out):
        """Lets the page run them, and keeps its picture."""
        script = out.with_suffix(".txt")
        lines = [*lines, "wait", f"screenshot {out.name}"]
        script.write_text("\n".join(lines) + "\n", encoding="utf-8")
        page.follow(session.name, script, out)

    def by_python(self, settings, out):
        """By the Python package. Returns what is shown at rest."""
        with _deleted(self._open()) as session:
            with session.live() as live:
                changes = _changes(settings)
                if changes:
                    live.apply(*changes)
                frame = live.settle(PATIENCE_S)
                rest, step = live.original.vertices, live.lattice_step
            session.export(out, exact=True)
        return Shown(frame, rest, step)


class _deleted:
    def __init__(self, session):
        self._session = session

    def __enter__(self):
        return self._session

    def __exit__(self, *_):
        self._session.delete()


def has_page(address):
    """Returns whether the server at this address carries the page, and not a note in its place."""
    with urllib.request.urlopen(address, timeout=PATIENCE_S) as answer:
        return b"data-core" in answer.read()


class Page:
    """The page of a server, in Chromium. Needs what `deploy/setup --web` installs."""

    def __init__(self, address):
        self._folder = tempfile.TemporaryDirectory(prefix="burnish-")
        program = f"{self._folder.name}/page_front.cjs"
        subprocess.run(["esbuild", ROOT / "tests/acceptance/page_front.ts", "--bundle",
                        "--platform=node", "--format=cjs", "--external:playwright-core",
                        "--log-level=warning", f"--outfile={program}"], check=True)
        self._process = subprocess.Popen(
            ["node", program, address, str(PATIENCE_S)], stdin=subprocess.PIPE,
            stdout=subprocess.PIPE, text=True, env={**os.environ, "NODE_PATH": ROOT / "node_modules"})

    def follow(self, session, script, out):
        """Lets the page replay a script in a session. Raises Refused with its sentence."""
        order = {"session": session, "script": str(script), "out": str(out)}
        print(json.dumps(order), file=self._process.stdin, flush=True)
        answer = self._process.stdout.readline()
        if not answer:
            raise AssertionError(f"the page's browser ended with {self._process.wait()}")
        told = json.loads(answer)
        if "failed" in told:
            raise AssertionError(told["failed"])
        if "refused" in told:
            raise Refused(told["refused"])

    def close(self):
        self._process.stdin.close()
        self._process.wait()
        self._process.stdout.close()
        self._folder.cleanup()


def _controls(settings):
    given = dict(settings)
    return burnish.Controls(pin_rims=given.get("--pin-rims", "on") == "on",
                            cap=float(given.get("--cap", 0)),
                            keep_volume=given.get("--keep-volume", "off") == "on")


def _has_controls(settings):
    return any(name in ("--pin-rims", "--cap", "--keep-volume") for name, _ in settings)


def _bands(settings):
    return [value for name, value in settings if name == "--band"]


def _without_lines(settings):
    """Returns the settings with an option of its own for each line of --edit."""
    return [("--" + value.split()[0], value.split(maxsplit=1)[1]) if name == "--edit"
            else (name, value) for name, value in settings]


def _script_lines(settings):
    settings = _without_lines(settings)
    given = dict(settings)
    lines = []
    if "--preset" in given:
        lines.append(f"preset {given['--preset']}")
    if "--keep-edges" in given:
        lines.append(f"keep_edges {given['--keep-edges']}")
    if "--curve" in given or "--alpha" in given:
        lines.append(f"curve {given.get('--curve') or '0:' + given['--alpha']}")
    if "--beta" in given:
        lines.append(f"beta {given['--beta']}")
    if _bands(settings):
        lines.append("bands " + " ".join(_bands(settings)))
    if "--colour-beta" in given:
        lines.append(f"colours {given['--colour-beta']} {given.get('--colour-alpha', '')}".rstrip())
    if "--texture-gain" in given or "--level-seams" in given:
        lines.append("texture " + " ".join(_texture(given)))
    for name, value in settings:
        if name == "--palette":
            lines.append("palette " + value.replace("\n", " ; "))
    for name, value in settings:
        if name == "--stroke":
            lines.append("stroke " + value.replace("\n", " "))
        if name == "--protect":
            lines.append(f"protect {value}")
    if _has_controls(settings):
        of = _controls(settings)
        words = ("on" if of.pin_rims else "off", repr(of.cap), "on" if of.keep_volume else "off")
        lines.append("controls " + " ".join(words))
    return lines


def _texture(given):
    return given.get("--texture-gain", "1"), given.get("--remove-light", "0"), given.get("--level-seams", "0")


def can_session(settings):
    """Returns whether commands and scripts have all of these for sessions: they have every edit."""
    return True


def can_python(settings):
    """Returns whether the package has all of these in sessions: presets are the window's."""
    return not any(name in ("--preset", "--keep-edges") for name, _ in settings)


def _changes(settings):
    settings = _without_lines(settings)
    given = dict(settings)
    changes = []
    if "--curve" in given:
        changes.append(_curve(given["--curve"]))
    if "--alpha" in given:
        changes.append(burnish.TransferCurve.constant(float(given["--alpha"])))
    if "--beta" in given:
        changes.append(burnish.GradientScale(float(given["--beta"])))
    if _bands(settings):
        parts = (band.split(":") for band in _bands(settings))
        changes.append(burnish.Equaliser([burnish.Band(float(s), float(g)) for s, g in parts]))
    if "--colour-beta" in given:
        changes.append(burnish.ColourFilter(float(given["--colour-beta"])))
    if "--texture-gain" in given or "--level-seams" in given:
        changes.append(burnish.TextureFilter(*map(float, _texture(given))))
    makers = {"--palette": _palette, "--stroke": _stroke, "--protect": _region}
    for wanted, make in makers.items():
        changes += [make(value) for name, value in settings if name == wanted]
    if _has_controls(settings):
        changes.append(_controls(settings))
    return changes


def _palette(text):
    lines = [line.split(maxsplit=2) for line in text.splitlines()]
    return burnish.Palette([burnish.PaletteCurve(name, _curve(curve), int(colour, 16))
                            for curve, colour, name in lines])


def _stroke(text):
    brush, *points = text.splitlines()
    radius, strength, beta, fall_off, paints = brush.split()
    curve = int(paints.split(":")[1]) if paints.startswith("curve:") else None
    return burnish.Stroke(burnish.Brush(float(radius), float(beta), float(strength), fall_off,
                                        curve=curve, edges=paints == "edges",
                                        texture=paints == "texture"),
                          [[float(x) for x in point.split()] for point in points])


def _region(text):
    numbers = [float(word) for word in text.split()[1:]]
    return burnish.ProtectLasso([numbers[row:row + 4] for row in range(0, 16, 4)],
                                [numbers[at:at + 2] for at in range(16, len(numbers), 2)],
                                through=True)


def _curve(text):
    if ":" not in text:
        return burnish.TransferCurve.constant(float(text))
    points = (point.split(":") for point in text.split(","))
    return burnish.TransferCurve({float(kappa): float(alpha) for kappa, alpha in points})
