"""Servers and films of scripts."""

import gc
import os
import pathlib
import struct
import subprocess
import sys
import tempfile
import time
import unittest
import zlib

import burnish
import scan


PROGRAM = """
import contextlib, os, pathlib, signal, burnish
stack = contextlib.ExitStack()
stack.enter_context(burnish.serve())
children = pathlib.Path("/proc/self/task")
print(*{{child for task in children.iterdir() for child in (task / "children").read_text().split()}}, flush=True)
{end}
"""


def png(side, grey):
    """Returns a grey picture of side x side pixels."""
    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(
            ">I", zlib.crc32(kind + body))
    rows = (b"\0" + bytes([grey]) * side) * side
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", side, side, 8, 0, 0, 0, 0))
            + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


class Serving(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="burnish-")
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def test_a_server_of_ones_own_keeps_its_data_in_the_folder(self):
        mesh = burnish.Mesh(*scan.bumpy_sphere(3))
        with burnish.serve(self.folder / "data", user="Anna") as server:
            session = server.open_session(server.import_scan(mesh, "ball", depth=4), "kept")
            session.set_beta(0.5)
        with burnish.serve(self.folder / "data") as server:
            self.assertEqual(server.session("kept").state().beta, 0.5)

    def test_a_server_of_ones_own_is_an_object_that_is_closed(self):
        server = burnish.serve()
        mesh = burnish.Mesh(*scan.bumpy_sphere(3))
        session = server.open_session(server.import_scan(mesh, "ball", depth=4), "open")
        live = session.live()
        server.close()
        server.close()
        with self.assertRaises(burnish.Error):
            while True:  # a frame may have come before
                live.next_frame()
        live.close()
        with self.assertRaisesRegex(burnish.FailedPrecondition, "closed"):
            server.scans()

    def test_a_server_serves_while_a_session_of_it_is_used(self):
        mesh = burnish.Mesh(*scan.bumpy_sphere(3))
        session = (lambda server: server.open_session(
            server.import_scan(mesh, "ball", depth=4)))(burnish.serve())
        gc.collect()
        session.set_beta(0.5)
        self.assertEqual(session.state().beta, 0.5)

    def test_a_server_of_ones_own_ends_with_its_program(self):
        for end in ("os.kill(os.getpid(), signal.SIGKILL)", "kept = stack.pop_all()"):
            program = subprocess.run(
                [sys.executable, "-c", PROGRAM.format(end=end)], capture_output=True, text=True,
                check=False, timeout=300)
            server = int(program.stdout)
            for _ in range(6000):  # the server is another process, and has the clock
                if not pathlib.Path(f"/proc/{server}/exe").exists():
                    break
                time.sleep(0.05)
            else:
                self.fail(f"server {server} outlives its program, ended by {end}")

    def test_a_server_that_does_not_start_tells_why(self):
        (self.folder / "data").write_text("a file")
        with self.assertRaisesRegex(burnish.Error, "data"):
            with burnish.serve(self.folder / "data"):
                pass

    def test_a_program_that_is_missing_is_named(self):
        path, binary = os.environ["PATH"], os.environ.pop("BURNISH_SERVER_BINARY")
        self.addCleanup(os.environ.update, PATH=path, BURNISH_SERVER_BINARY=binary)
        os.environ["PATH"] = os.fspath(self.folder)
        with self.assertRaisesRegex(burnish.NotFound, "burnish-server.*BURNISH_SERVER_BINARY"):
            with burnish.serve():
                pass

    def test_pictures_become_a_film(self):
        for grey in (0, 100, 200):
            (self.folder / f"{grey}.png").write_bytes(png(4, grey))
        pictures = sorted(self.folder.glob("*.png"))
        burnish.animate(pictures, self.folder / "film.apng", seconds=0.5)
        film = (self.folder / "film.apng").read_bytes()
        at = film.index(b"acTL")
        self.assertEqual(struct.unpack_from(">II", film, at + 4), (3, 0))
        self.assertEqual(struct.unpack_from(">HH", film, film.index(b"fcTL") + 24), (500, 1000))

    def test_pictures_of_two_sizes_are_refused(self):
        for side in (4, 5):
            (self.folder / f"{side}.png").write_bytes(png(side, 0))
        with self.assertRaisesRegex(burnish.InvalidArgument, "2 kinds"):
            burnish.animate(sorted(self.folder.glob("*.png")), self.folder / "film.apng")
        (self.folder / "6.png").write_bytes(b"GIF89a")
        with self.assertRaisesRegex(burnish.InvalidArgument, "6.png"):
            burnish.animate([self.folder / "6.png"], self.folder / "film.apng")


if __name__ == "__main__":
    unittest.main()
