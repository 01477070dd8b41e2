"""A test's own burnish-server, in a temporary folder."""

import os
import pathlib
import subprocess
import tempfile
import threading

PATIENCE_S = 120  # a step of a test that takes longer counts as hanging


class ServerProcess:
    """Listens on a free loopback port and on a Unix socket; `flags` are burnish-server's.

    `web`: the page's address, if they have one.
    """

    def __init__(self, *flags):
        self._folder = tempfile.TemporaryDirectory(prefix="burnish-")
        self.folder = pathlib.Path(self._folder.name)
        self.socket = self.folder / "server.sock"
        self._flags = flags
        self._log = open(self.folder / "server.log", "w+", encoding="utf-8")
        self.start()

    def start(self):
        """Starts it, or starts it again on the same socket and data."""
        self._process = subprocess.Popen(
            [os.environ["BURNISH_SERVER_BINARY"], "--listen", "127.0.0.1:0",
             "--socket", self.socket, "--data", self.folder / "data", *self._flags],
            stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        self.pid = self._process.pid
        self._address = None
        self.web = None
        self._listens = threading.Event()
        self._reader = threading.Thread(target=self._read, daemon=True)
        self._reader.start()
        if not self._listens.wait(PATIENCE_S) or self._address is None:
            self.stop()
            raise RuntimeError("burnish-server does not start:\n" + self.log())

    @property
    def address(self):
        """HOST:PORT."""
        return self._address

    def is_alive(self):
        return self._process.poll() is None

    def log(self):
        return (self.folder / "server.log").read_text(encoding="utf-8")

    def stop(self):
        """Sends SIGTERM and waits for the end. Returns the exit code."""
        self._process.terminate()
        try:
            return self._process.wait(PATIENCE_S)
        except subprocess.TimeoutExpired:
            self._process.kill()
            return self._process.wait()

    def kill(self):
        """Ends it at once, as a crash would."""
        self._process.kill()
        self._process.wait()
        self._end_reading()

    def close(self):
        code = self.stop()
        self._end_reading()
        self._log.close()
        self._folder.cleanup()
        return code

    def _end_reading(self):
        self._reader.join()
        self._process.stdout.close()

    def _read(self):
        announcement = "listening on "
        for line in self._process.stdout:
            self._log.write(line)
            self._log.flush()
            if line.startswith("web on "):  # comes before the other one
                self.web = line.split()[-1]
            if self._address is None and announcement in line:
                self._address = line.split(announcement, 1)[1].split()[0]
                self._listens.set()
        self._listens.set()
