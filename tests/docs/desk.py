"""A reader's desk: a folder with the programs on the path, and servers that end with the page."""

import contextlib
import os
import pathlib
import random
import re
import signal
import socket
import subprocess
import tempfile
import time

from database import Database

ROOT = pathlib.Path(__file__).parents[2]
PATIENCE_S = 120
VERTICES_MAX = 3000  # of generated scans, whatever the document says
STARTS_SERVER = re.compile(r"\bburnish-server (?!.*(--help|--version|--print-|journal ))")
OF_MACHINE = re.compile(r"(?<![\w/])/(etc|run|srv|var/lib)/burnish\b")
DATABASE = re.compile(r"postgresql://burnish@db\.lab(:\d+)?/burnish\b")

# Commands take 127.0.0.1:7411 by themselves; windows and their scripts take a server of their own.
BURNISH = r"""#!/bin/bash
[[ $1 == -* || $1 == window ]] || export BURNISH_SERVER=${BURNISH_SERVER-$DESK_SERVER}
if [[ $1 == generate && " $* " != *" --vertices "* && $VERTICES_MAX -lt 100000 ]]; then
  set -- "$@" --vertices "$VERTICES_MAX"
fi
words=()
while [[ $# -gt 0 ]]; do
  if [[ $1 == --vertices && $2 -gt $VERTICES_MAX ]]; then words+=("$1" "$VERTICES_MAX"); shift
  else words+=("$1"); fi
  shift
done
exec "$BURNISH_BINARY" "${words[@]}"
"""

# A server goes on in the background once it listens, whether the document says & or not.
SERVER = r"""#!/bin/bash
case " $* " in
  *" --help "* | *" --version "* | *" --print-"* | *" journal "*) exec "$BURNISH_SERVER_BINARY" "$@" ;;
esac
log=$DESK_SERVERS/$$.log
: >"$log"  # grep may look before the server's process has it
"$BURNISH_SERVER_BINARY" "$@" >"$log" 2>&1 </dev/null &
echo $! >"$DESK_SERVERS/$$.pid"
until grep -q 'listening on' "$log"; do
  kill -0 $! 2>/dev/null || { cat "$log" >&2; wait $!; exit; }
  sleep 0.02
done
"""


def free_port():
    """Returns a port that nobody uses. It is below those that the kernel gives to connections and to
    servers of other tests."""
    while True:
        port = random.randrange(20000, 32000)
        with socket.socket() as one, contextlib.suppress(OSError):
            one.bind(("127.0.0.1", port))
            return port


def end(process):
    """Ends a process, by force after four seconds."""
    try:
        os.kill(process, signal.SIGTERM)
        for _ in range(200):
            os.kill(process, 0)
            time.sleep(0.02)
        os.kill(process, signal.SIGKILL)
    except ProcessLookupError:
        pass


class Desk:
    """Runs the blocks of one page, in order, in one folder."""

    def __init__(self, vertices_max=VERTICES_MAX):
        self._base = tempfile.TemporaryDirectory(prefix="burnish-")
        base = pathlib.Path(self._base.name)
        self.folder, programs, self._servers = base / "desk", base / "bin", base / "servers"
        for one in (self.folder, programs, self._servers, base / "home"):
            one.mkdir()
        for name, text in (("burnish", BURNISH), ("burnish-server", SERVER)):
            (programs / name).write_text(text)
            (programs / name).chmod(0o755)
        (self.folder / "deploy").symlink_to(ROOT / "deploy")
        for one in ("etc", "run", "srv", "var/lib"):
            (self.folder / one / "burnish").mkdir(parents=True)
        self._ports, self._database = {}, None
        self._environment = {
            **{name: value for name, value in os.environ.items() if not name.startswith("XDG_")},
            "PATH": f"{programs}:{os.environ['PATH']}", "HOME": str(base / "home"),
            "DESK_SERVER": self.here("127.0.0.1:7411"),
            "DESK_SERVERS": str(self._servers), "VERTICES_MAX": str(vertices_max)}

    def close(self):
        self._end_servers()
        for file in pathlib.Path("/proc").glob("[0-9]*/cmdline"):  # servers of windows' scripts
            try:
                if self._base.name.encode() in file.read_bytes():
                    end(int(file.parent.name))
            except OSError:
                pass  # it has ended
        if self._database:
            self._database.close()
        self._base.cleanup()

    def _end_servers(self):
        for file in self._servers.glob("*.pid"):
            end(int(file.read_text()))
            file.unlink()

    def here(self, text):
        """Returns a document's text with the addresses and folders of this desk."""
        text = text.replace("burnish.lab", "localhost").replace("0.0.0.0", "127.0.0.1")
        text = re.sub(r"\b(127\.0\.0\.1|localhost):(\d+)\b",
                      lambda found: f"{found[1]}:{self._port(found[2])}", text)
        text = OF_MACHINE.sub(f"{self.folder}/\\1/burnish", text)
        if DATABASE.search(text):
            self._database = self._database or Database()
            text = DATABASE.sub(self._database.uri, text)
        return text

    def _port(self, written):
        return self._ports.setdefault(written, free_port())

    def write(self, name, text):
        target = self.folder / self.here(name)
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(self.here(text), encoding="utf-8")

    def run(self, language, text):
        """Runs commands or a program. Returns (exit code, output). A server that is started takes
        the place of those before."""
        if STARTS_SERVER.search(text):
            self._end_servers()
        text = self.here(text)
        if language == "sh":
            text = re.sub(r"^(burnish-server .*?) *&( *#.*)?$", r"\1", text, flags=re.M)
            words = ["bash", "-euo", "pipefail", "-c",
                     "trap 'echo \"failed: $BASH_COMMAND\"' ERR\n" + text]
        else:
            words = ["/usr/bin/python3", "-B", "-c", text]
        done = subprocess.run(words, cwd=self.folder, env=self._environment, text=True, check=False,
                              stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, timeout=PATIENCE_S)
        return done.returncode, done.stdout
