"""The ways to a result. Each takes a scan's file and a case's settings, and writes a file."""

import json
import os
import subprocess

import burnish

FRAME_TIMEOUT_S = 600


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


def _flat(settings):
    return [word for pair in settings for word in pair]


def filtered(scan, settings, out):
    """By `burnish filter`. Returns its report."""
    report = out.with_suffix(".json")
    run("filter", scan, out, "--exact", "--report", report, *_flat(settings))
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
        """By `burnish edit` and `burnish export`."""
        with _deleted(self._open()) as session:
            if settings:
                run("edit", session.id, *_flat(settings), *self.at)
            run("export", session.id, out, "--exact", *self.at)

    def by_script(self, settings, out):
        """By a script of the window's commands."""
        script = out.with_suffix(".txt")
        with _deleted(self._open()) as session:
            lines = [f"join {session.id}", *_script_lines(settings), "wait", f"export {out} exact"]
            script.write_text("\n".join(lines) + "\n", encoding="utf-8")
            run("--script", script, *self.at)

    def by_python(self, settings, out):
        """By the Python package. Returns the live frame at rest, and the mesh that it moves."""
        with _deleted(self._open()) as session:
            with session.live() as live:
                changes = _changes(settings)
                if changes:
                    live.apply(*changes)
                frame = live.settle(FRAME_TIMEOUT_S)
                original = live.original.vertices
            session.export(out, exact=True)
        return frame, original


class _deleted:
    def __init__(self, session):
        self._session = session

    def __enter__(self):
        return self._session

    def __exit__(self, *_):
        self._session.delete()


def _controls(settings):
    given = dict(settings)
    return burnish.Controls(pin_rims=given.get("--pin-rims", "on") == "on",
                            cap=float(given.get("--cap", 0)),
                            keep_volume=given.get("--keep-volume", "off") == "on")


def _has_controls(settings):
    return any(name in ("--pin-rims", "--cap", "--keep-volume") for name, _ in settings)


def _bands(settings):
    return [value for name, value in settings if name == "--band"]


def _script_lines(settings):
    given = dict(settings)
    lines = []
    if "--preset" in given:
        lines.append(f"preset {given['--preset']}")
    if "--curve" in given or "--alpha" in given:
        lines.append(f"curve {given.get('--curve') or '0:' + given['--alpha']}")
    if "--beta" in given:
        lines.append(f"beta {given['--beta']}")
    if _bands(settings):
        lines.append("bands " + " ".join(_bands(settings)))
    if "--colour-beta" in given:
        lines.append(f"colours {given['--colour-beta']}")
    if _has_controls(settings):
        of = _controls(settings)
        words = ("on" if of.pin_rims else "off", repr(of.cap), "on" if of.keep_volume else "off")
        lines.append("controls " + " ".join(words))
    return lines


def can_python(settings):
    """Returns whether the package has all of these: presets are the window's."""
    return not any(name == "--preset" for name, _ in settings)


def _changes(settings):
    given = dict(settings)
    changes = []
    if "--curve" in given:
        points = (point.split(":") for point in given["--curve"].split(","))
        changes.append(burnish.TransferCurve({float(k): float(a) for k, a in points}))
    if "--alpha" in given:
        changes.append(burnish.TransferCurve.constant(float(given["--alpha"])))
    if "--beta" in given:
        changes.append(burnish.GradientScale(float(given["--beta"])))
    if _bands(settings):
        parts = (band.split(":") for band in _bands(settings))
        changes.append(burnish.Equaliser([burnish.Band(float(s), float(g)) for s, g in parts]))
    if "--colour-beta" in given:
        changes.append(burnish.ColourFilter(float(given["--colour-beta"])))
    if _has_controls(settings):
        changes.append(_controls(settings))
    return changes
