"""docs/protocol.md and the comments in proto/, each fact tried on a server."""

import hashlib
import pathlib
import re
import unittest

import grpc
import numpy as np

import client
import scan
import wire
from burnish.v1 import common_pb2, editing_pb2, library_pb2
from client import Client, LiveSession
from server_process import ServerProcess

PAGE = pathlib.Path(__file__).parents[2] / "docs" / "protocol.md"
DEPTH = 6
STEP = 1 / 256  # cells
CONTENTS = {"coefficients": editing_pb2.FRAME_CONTENT_COEFFICIENTS,
            "vertices": editing_pb2.FRAME_CONTENT_VERTICES}


def examples(kind):
    """The bytes that the page shows."""
    blocks = re.findall(rf"```{kind}\n(.*?)```", PAGE.read_text(encoding="utf-8"), re.S)
    return [bytes.fromhex(block) for block in blocks]


class Page(unittest.TestCase):
    """The page's own examples."""

    def setUp(self):
        self.view = wire.read_view(*examples("view"))
        self.decoder = wire.FrameDecoder(wire.Layout(self.view, wire.COEFFICIENTS))

    def test_the_view_says_what_the_page_says(self):
        np.testing.assert_array_equal(self.view.positions(), [
            (-0.375, -0.75, -1.125), (-0.125, -0.75, -1.375), (-0.25, -0.5, -1.25), (1, 2, 3)])
        self.assertEqual(wire.morton_point(self.view.cells).tolist(), [[1, 2, 3]])
        self.assertEqual(self.view.triangles.tolist(), [[0, 1, 2]])

    def test_the_frames_say_what_the_page_says(self):
        key, delta = examples("frame")
        self.assertEqual(self.decoder.layout.fingerprint, 0x9da72cf5a4875830)
        self.assertEqual(self.decoder.decode(key).reference, 0)
        expected = np.array([(64, 0, -value) for value in range(8)])
        np.testing.assert_array_equal(self.decoder.state, expected)
        self.assertEqual(self.decoder.decode(delta).reference, 1)
        expected[0, 0] += 8
        np.testing.assert_array_equal(self.decoder.state, expected)

    def test_a_flipped_bit_is_found(self):
        for data, read in [(*examples("view"), wire.read_view),
                           (examples("frame")[0], wire.read_frame_header)]:
            for byte in range(len(data)):
                flipped = bytearray(data)
                flipped[byte] ^= 1 << byte % 8
                with self.assertRaises(wire.Damaged, msg=f"byte {byte}"):
                    read(bytes(flipped))

    def test_a_frame_without_its_reference_is_told_from_a_damaged_one(self):
        with self.assertRaises(wire.MissingReference):
            self.decoder.decode(examples("frame")[1])


class Served(unittest.TestCase):
    """With a server, and a scan on it."""

    @classmethod
    def setUpClass(cls):
        cls.server = ServerProcess()
        cls.addClassCleanup(cls.server.close)
        cls.client = cls.connect("Zoë")
        cls.vertices, cls.triangles = scan.bumpy_sphere()
        cls.ply = scan.write_ply(cls.vertices, cls.triangles)
        cls.events = cls.client.import_scan("sphere", cls.ply, DEPTH)
        cls.scan = cls.events[-1].done.scan

    @classmethod
    def connect(cls, user=None):
        made = Client(f"unix:{cls.server.socket}", user)
        cls.addClassCleanup(made.close)
        return made

    def open(self, name=None):
        """A session of this test's own."""
        return self.client.open_session(self.scan.id, name or self.id(), DEPTH)

    def join(self, session, content=editing_pb2.FRAME_CONTENT_UNSPECIFIED, triangles_max=0):
        view = self.client.fetch_view(session, triangles_max)
        live = LiveSession(self.client, session, view, content, triangles_max)
        self.addCleanup(live.cancel)
        return live

    def assertFails(self, code, call):
        with self.assertRaises(grpc.RpcError) as failed:
            call()
        self.assertEqual(failed.exception.code(), code, failed.exception.details())


class Files(Served):
    def test_an_import_is_announced_received_and_done(self):
        kinds = [event.WhichOneof("event") for event in self.events]
        self.assertEqual((kinds[0], kinds[-1]), ("received", "done"))
        self.assertEqual(self.scan.id, hashlib.sha256(self.ply).hexdigest())

    def test_a_known_scan_is_not_sent_again(self):
        events = self.client.import_scan("again", self.ply, DEPTH, sha256=self.scan.id)
        self.assertEqual([event.WhichOneof("event") for event in events][-1], "done")
        self.assertNotIn("received", [event.WhichOneof("event") for event in events])
        self.assertTrue(events[-1].done.already_present)

    def test_a_damaged_chunk_is_data_loss(self):
        def damage(chunk):
            chunk.crc32 ^= 1
        self.assertFails(grpc.StatusCode.DATA_LOSS, lambda: self.client.import_scan(
            "damaged", self.ply, DEPTH, damage=damage))

    def test_a_view_holds_the_scans_vertices_to_a_millionth_of_a_cell(self):
        view = self.client.fetch_view(self.open())
        np.testing.assert_array_equal(view.triangles, self.triangles)
        off = np.abs(view.positions() - self.vertices).max() / view.cell_size
        self.assertLess(off, 1e-6)
        self.assertEqual(view.homes[-1], -1)
        np.testing.assert_array_equal(view.strays, self.vertices[-1:])

    def test_a_depth_that_nobody_prepared_is_a_failed_precondition(self):
        self.assertFails(grpc.StatusCode.FAILED_PRECONDITION, lambda: self.client.fetch_view(
            editing_pb2.SessionInfo(scan_id=self.scan.id, depth=5)))

    def test_cells_come_in_the_views_order(self):
        session = self.open()
        view = self.client.fetch_view(session)
        i, j, k = wire.morton_point(view.cells[7:8])[0].tolist()
        self.client.apply(session, client.edit(cell_fields=editing_pb2.SetCellFields(cells=[
            editing_pb2.CellField(i=i, j=j, k=k, alpha1=50, alpha2=50, beta=0.5)])))
        request = editing_pb2.GetCellsRequest(session=session.id,
                                              value=editing_pb2.CELL_VALUE_BETA)
        data = client.join_chunks(self.client.call(self.client.editing.GetCells, request))
        expected = np.ones(len(view.cells), np.float32)
        expected[7] = 0.5
        np.testing.assert_array_equal(np.frombuffer(data, "<f4"), expected)


class Calls(Served):
    def test_the_same_server_listens_on_tcp(self):
        over_tcp = Client(self.server.address)
        self.addCleanup(over_tcp.close)
        listed = over_tcp.call(over_tcp.library.ListScans, library_pb2.ListScansRequest())
        self.assertEqual([found.id for found in listed.scans], [self.scan.id])

    def test_each_answer_names_its_request(self):
        call = self.client.library.ListScans.with_call(library_pb2.ListScansRequest())[1]
        self.assertRegex(dict(call.initial_metadata())["x-request-id"], "^[0-9a-f]{16}$")

    def test_ids_belong_to_one_author(self):
        session, other, change = self.open(), self.connect("Zoe"), client.slider(0.5)
        self.assertEqual(self.client.apply(session, change).applied, 1)
        again = self.client.apply(session, change)
        self.assertEqual((again.applied, again.known, again.entries[0]), (0, 1, 0))
        self.assertEqual(other.apply(session, change).applied, 1)

    def test_who_gives_no_name_is_one_author(self):
        session, change = self.open(), client.slider(0.5)
        for known in (0, 1):
            self.assertEqual(self.connect().apply(session, change).known, known)

    def test_history_comes_in_pages_with_authors(self):
        session = self.open()
        self.client.apply(session, *[client.slider(beta / 10) for beta in range(5)])
        self.client.apply(session, client.edit(undo=editing_pb2.Undo()))
        entries = list(self.client.history(session, page=2))
        self.assertEqual([entry.number for entry in entries], [1, 2, 3, 4, 5])
        self.assertEqual([entry.enabled for entry in entries], [True] * 4 + [False])
        self.assertEqual({entry.author for entry in entries}, {"Zoë"})

    def test_all_edits_of_a_message_are_applied_or_none(self):
        session = self.open()
        self.assertFails(grpc.StatusCode.INVALID_ARGUMENT, lambda: self.client.apply(
            session, client.slider(0.5), client.slider(11)))
        self.assertEqual(list(self.client.history(session, page=10)), [])


class Live(Served):
    def test_both_sides_compute_the_same_layout(self):
        session = self.open()
        for content in CONTENTS.values():
            for triangles_max in (0, 3000):
                live = self.join(session, content, triangles_max)
                self.assertEqual(live.welcome.content, content)
                self.assertEqual(live.layout.fingerprint, live.welcome.layout_fingerprint)

    def test_settled_frames_are_the_exported_surface(self):
        """Keys, then differences, after sliders, a curve and a stroke, are within half a step."""
        ring = np.linspace(0, 1, 30)
        path = self.vertices[np.argsort(self.vertices[:, 0])[:400:10]]
        for name, content in CONTENTS.items():
            session = self.open(f"{self.id()} {name}")
            live = self.join(session, content)
            live.settle()
            self.assertEqual(live.headers[0].reference, 0)
            np.testing.assert_allclose(live.positions(), self.vertices, atol=1e-5)
            for change in (client.slider(0.2), client.curve((-3, 20), (3, 80)),
                           client.stroke(path, radius=2, beta=2.5)):
                outcome = live.apply(change)
                before = len(live.headers)
                live.settle(outcome.edits)
                self.assertTrue(all(header.reference for header in live.headers[before:]))
                self.assertCurrent(live, session)
            moving = [header.step_shift for header in live.headers if header.step_shift]
            self.assertEqual(set(moving), {2}, "1/64 cell while it moves")

    def assertCurrent(self, live, session):
        """The export, which only writes down what is settled, is what the frames show."""
        ply, summary = self.client.export(session)
        self.assertEqual(hashlib.sha256(ply).hexdigest(), summary.sha256)
        self.assertEqual(summary.cycles, 0)
        exported, triangles = scan.read_ply(ply)
        np.testing.assert_array_equal(triangles, self.triangles)
        cell_size = live._view.cell_size
        moved = np.abs(exported - self.vertices).max() / cell_size
        off = np.abs(live.positions() - exported).max() / cell_size
        print(f"moved {moved:.3f} cells, off {off:.6f} cells = {off / STEP:.4f} steps")
        self.assertGreater(moved, 8 * STEP)
        self.assertLess(off, STEP / 2 + 1e-5)


if __name__ == "__main__":
    unittest.main()
