"""Writes what this version leaves to later ones: its protocol, a data folder, the Python package.

Usage: keep.py FOLDER
"""

import json
import os
import pathlib
import shutil
import sys
import tarfile
import tempfile

import burnish
import sculpture
from descriptors import this_protocol
from server_process import ServerProcess


def pack(archive, folder, names, skip=()):
    """Writes the files of a folder, the same bytes for the same files."""
    def plain(entry):
        if pathlib.PurePath(entry.name).name in skip:
            return None
        entry.uid = entry.gid = entry.mtime = 0
        entry.uname = entry.gname = ""
        entry.mode = 0o755 if entry.isdir() else 0o644
        return entry
    with tarfile.open(archive, "w:xz", preset=9, dereference=True) as packed:
        for name in names:
            packed.add(folder / name, name, filter=plain)


def keep_data(archive):
    server = ServerProcess()
    try:
        with burnish.connect(f"unix:{server.socket}", user="anna") as anna:
            others = []

            def connect(user):
                others.append(burnish.connect(f"unix:{server.socket}", user=user))
                return others[-1]

            sculpture.edit(anna, connect)
            seen = sculpture.view(anna, server.folder)
            for other in others:
                other.close()
        server.stop()
        (server.folder / "seen.json").write_text(json.dumps(seen, indent=1, ensure_ascii=False))
        shutil.rmtree(server.folder / "data" / "staging", ignore_errors=True)
        pack(archive, server.folder, ["data", "seen.json", *(f"{name}.ply" for name in seen)],
             skip=("prepared", "paint.sqlite"))
    finally:
        server.close()


def keep_python(archive):
    package = pathlib.Path(burnish.__file__).parent
    with tempfile.TemporaryDirectory() as folder:
        copy = pathlib.Path(folder)
        shutil.copytree(package, copy / "burnish", ignore=shutil.ignore_patterns("__pycache__"))
        pack(archive, copy, ["burnish"])


def main(folder):
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "protocol.binpb").write_bytes(this_protocol().SerializeToString(deterministic=True))
    keep_data(folder / "data.tar.xz")
    keep_python(folder / "python.tar.xz")
    for name in sorted(os.listdir(folder)):
        print(f"{(folder / name).stat().st_size:8d} bytes  {folder / name}")


if __name__ == "__main__":
    main(*sys.argv[1:])
