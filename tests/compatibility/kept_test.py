"""What earlier versions have written and built works with this one."""

import json
import os
import pathlib
import shutil
import subprocess
import sys
import tarfile
import tempfile
import unittest

import burnish
import numpy as np
import sculpture
from descriptors import losses, this_protocol
from google.protobuf import descriptor_pb2
from server_process import PATIENCE_S, ServerProcess

HERE = pathlib.Path(__file__).parent
KEPT = sorted(path for path in (HERE / "kept").iterdir())
EXACT = 1e-5  # the bar of an exact export over the box's diagonal; both exports may use all of it


KINDS_NAMED_LATER = {"cell fields", "controls", "protect", "equaliser", "palette", "colour"}


def with_kinds_of_today(then, now):
    """Returns what a version saw, but for a cured fault: 0.1.0 called several kinds of edits other."""
    for name, session in then.items():
        for before, after in zip(session["history"], now[name]["history"]):
            if before[2] == "other" and after[2] in KINDS_NAMED_LATER:
                before[2] = after[2]
    return then


def unpack(archive, folder):
    with tarfile.open(archive) as packed:
        packed.extractall(folder)


class Kept(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="burnish-")
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def test_the_protocol_has_all_fields_values_and_calls_of_earlier_ones(self):
        self.assertTrue(KEPT)
        for kept in KEPT:
            before = descriptor_pb2.FileDescriptorSet.FromString(
                (kept / "protocol.binpb").read_bytes())
            self.assertGreater(sum(len(file.message_type) for file in before.file), 80)
            self.assertEqual(losses(before, this_protocol()), [], kept.name)

    def test_a_data_folder_has_the_same_sessions_and_surfaces(self):
        for kept in KEPT:
            with self.subTest(kept.name):
                self.check_data(kept / "data.tar.xz")

    def check_data(self, archive):
        server = ServerProcess()
        self.addCleanup(server.close)
        server.kill()
        shutil.rmtree(server.folder / "data")
        unpack(archive, server.folder)
        server.start()
        with burnish.connect(f"unix:{server.socket}", user="anna") as anna:
            seen = sculpture.view(anna, self.folder)
            then = json.loads((server.folder / "seen.json").read_text())
            self.assertEqual(seen, with_kinds_of_today(then, seen))
            for name in seen:
                self.check_surface(burnish.load_ply(server.folder / f"{name}.ply"),
                                   burnish.load_ply(self.folder / f"{name}.ply"))
            carving = anna.session("carving")
            before = [one.enabled for one in carving.history()]
            carving.undo()
            self.assertEqual([one.enabled for one in carving.history()], [*before[:-1], False])
            carving.set_beta(0.5)
            self.assertEqual(carving.state().beta, 0.5)

    def check_surface(self, then, now):
        scan = sculpture.mesh()
        np.testing.assert_array_equal(then.faces, now.faces)
        self.assertGreater(np.abs(now.vertices - scan.vertices).max(), 0.01)
        diagonal = np.linalg.norm(np.ptp(scan.vertices[:-1], axis=0))
        self.assertLess(np.linalg.norm(now.vertices - then.vertices, axis=1).max() / diagonal,
                        2 * EXACT)

    def test_an_earlier_python_package_drives_this_server(self):
        for kept in KEPT:
            with self.subTest(kept.name):
                unpack(kept / "python.tar.xz", self.folder / kept.name)
                self.drive(str(self.folder / kept.name))

    def test_the_same_work_is_done_by_todays_package(self):
        self.drive(os.environ["PYTHONPATH"])

    def drive(self, path):
        server = ServerProcess()
        self.addCleanup(server.close)
        done = subprocess.run(
            [sys.executable, "-B", HERE / "drive.py", f"unix:{server.socket}", self.folder],
            env={**os.environ, "PYTHONPATH": path}, capture_output=True, text=True, check=False,
            timeout=PATIENCE_S)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertGreater(int(done.stdout), 0)


class Losses(unittest.TestCase):
    """A test that cannot fail is none."""

    def setUp(self):
        self.after = this_protocol()
        file = next(one for one in self.after.file if one.name.endswith("library.proto"))
        self.message = next(one for one in file.message_type if one.name == "ImportHeader")
        self.service = file.service[0]

    def losses(self):
        return losses(this_protocol(), self.after)

    def test_what_is_added_is_no_loss(self):
        self.message.field.add(name="added", number=99, type=9, label=1)
        self.service.method.add(name="Added", input_type=".burnish.v1.Chunk")
        self.assertEqual(self.losses(), [])

    def test_a_field_that_is_gone_or_travels_otherwise_is_named(self):
        field = self.message.field[0]
        for change in ({"number": 77}, {"type": 3}, {"label": 3}, {"name": "renamed"}):
            before = descriptor_pb2.FieldDescriptorProto()
            before.CopyFrom(field)
            for key, value in change.items():
                setattr(field, key, value)
            with self.subTest(change):
                self.assertEqual([text.split()[0] for text in self.losses()],
                                 [".burnish.v1.ImportHeader.name"])
            field.CopyFrom(before)

    def test_a_call_that_is_gone_or_streams_otherwise_is_named(self):
        self.service.method[1].server_streaming = True
        del self.service.method[0]
        self.assertEqual([text.split()[0] for text in self.losses()],
                         [".burnish.v1.Library/Import", ".burnish.v1.Library/ListScans"])


if __name__ == "__main__":
    unittest.main()
