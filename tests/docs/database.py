"""A PostgreSQL of a test's own, on a Unix socket in a temporary folder."""

import os
import pathlib
import shutil
import subprocess
import tempfile


class Database:
    """Runs until close(). `uri` names its database `burnish`."""

    def __init__(self):
        found = sorted(pathlib.Path("/usr/lib/postgresql").glob("*/bin/initdb"))
        if not found:
            raise FileNotFoundError("no PostgreSQL here: deploy/setup installs it")
        self._programs = found[-1].parent
        self._folder = pathlib.Path(tempfile.mkdtemp(prefix="burnish-database-"))
        if os.getuid() == 0:  # PostgreSQL does not run as root
            shutil.chown(self._folder, "postgres")
        self._call("initdb", "-D", self._folder / "data", "-A", "trust", "-U", "burnish", "-E",
                   "UTF8", "--locale=C", "--no-sync", "--no-instructions")
        self._control("start", "-o", f"-k {self._folder} -c listen_addresses= -c fsync=off")
        self._call("createdb", "-h", self._folder, "-U", "burnish", "burnish")
        self.uri = f"postgresql://burnish@/burnish?host={self._folder}"

    def close(self):
        self._control("stop", "-m", "immediate")
        shutil.rmtree(self._folder)

    def _control(self, *words):
        self._call("pg_ctl", "-w", "-D", self._folder / "data", "-l", self._folder / "log", *words)

    def _call(self, program, *words):
        owner = ["runuser", "-u", "postgres", "--"] if os.getuid() == 0 else []
        subprocess.run([*owner, self._programs / program, *words], check=True, cwd="/",
                       stdout=subprocess.DEVNULL)
