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
        session = self.client.open_session(self.scan.id, name or self.id(), DEPTH)
        self.addCleanup(self.delete, session)
        return session

    def delete(self, session):
        if self.server.is_alive():
            request = editing_pb2.DeleteSessionRequest(session=session.id)
            self.client.call(self.client.editing.DeleteSession, request)

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

    def test_a_file_that_is_not_what_was_announced_is_data_loss(self):
        self.assertFails(grpc.StatusCode.DATA_LOSS, lambda: self.client.import_scan(
            "another", self.ply, DEPTH, sha256="0" * 64))

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
        cell = editing_pb2.CellField(i=i, j=j, k=k, alpha1=50, alpha2=50, beta=0.5)
        self.assertEqual(self.client.upload_cells(session, "upload", [cell]).applied, 1)
        self.assertEqual(self.client.upload_cells(session, "upload", [cell]).known, 1)
        request = editing_pb2.GetCellsRequest(session=session.id,
                                              value=editing_pb2.CELL_VALUE_BETA)
        data = client.join_chunks(self.client.call(self.client.editing.GetCells, request))
        expected = np.ones(len(view.cells), np.float32)
        expected[7] = 0.5
        np.testing.assert_array_equal(np.frombuffer(data, "<f4"), expected)


    def test_an_upload_that_ends_early_is_data_loss(self):
        session = self.open()
        self.assertFails(grpc.StatusCode.DATA_LOSS, lambda: self.client.upload_cells(
            session, "upload", [], announced=1))


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

    def test_the_limits_of_the_page_hold(self):
        session = self.open()
        long_stroke = client.stroke([(0, 0, 0), (0, 0, 1025)], radius=1, beta=0)
        wide_curve = client.curve((0, 0.05), (1, 60))
        for name, edits in {
                "no edits": [], "65 edits": [client.slider(1) for _ in range(65)],
                "4101 dabs": [long_stroke], "a contrast of 1200": [wide_curve],
                "NaN": [client.slider(float("nan"))], "alpha": [client.curve((0, 2e5))],
                "an id of 65": [editing_pb2.Edit(id="a" * 65, undo=editing_pb2.Undo())],
                "a space": [editing_pb2.Edit(id="a b", undo=editing_pb2.Undo())]}.items():
            with self.subTest(name):
                self.assertFails(grpc.StatusCode.INVALID_ARGUMENT,
                                 lambda: self.client.apply(session, *edits))
        too_large = client.edit(set_checkpoint=editing_pb2.SetCheckpoint(name="a" * (16 << 20)))
        self.assertFails(grpc.StatusCode.RESOURCE_EXHAUSTED,
                         lambda: self.client.apply(session, too_large))
        for name in ("a" * 201, "a\nb", "a\x7fb"):
            self.assertFails(grpc.StatusCode.INVALID_ARGUMENT, lambda: self.open(name))
            self.assertFails(grpc.StatusCode.INVALID_ARGUMENT,
                             lambda: self.connect(name).apply(session, client.slider(1)))

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
        path = self.vertices[np.argsort(self.vertices[:, 0])[:400:10]]
        for name, content in CONTENTS.items():
            session = self.open(f"{self.id()} {name}")
            live = self.join(session, content)
            live.settle()
            self.assertEqual(live.headers[0].reference, 0)
            np.testing.assert_allclose(live.positions(), self.vertices, atol=1e-5)
            for change in (client.slider(0.2), client.curve((-3, 20), (3, 80)),
                           client.stroke(path, radius=2, beta=2.5)):
                before = len(live.headers)
                live.grant()  # for a frame of the first cycle: the surface moves
                live.settle(live.apply(change).edits)
                self.assertTrue(all(header.reference for header in live.headers[before:]))
                self.assertCurrent(live, session)
            moving = [header.step_shift for header in live.headers if header.step_shift]
            self.assertEqual(set(moving), {2}, "1/64 cell while it moves")

    def assertCurrent(self, live, session):
        """An export relaxes the surface a little further; the frame after it shows the same."""
        cycles = live.frame.cycles
        ply, summary = self.client.export(session)
        self.assertEqual(hashlib.sha256(ply).hexdigest(), summary.sha256)
        live.receive_frame(lambda frame: frame.cycles == cycles + summary.cycles and
                           frame.state == editing_pb2.SOLVE_STATE_SETTLED)
        exported, triangles = scan.read_ply(ply)
        np.testing.assert_array_equal(triangles, self.triangles)
        cell_size = live.view.cell_size
        moved = np.abs(exported - self.vertices).max() / cell_size
        off = np.abs(live.positions() - exported).max() / cell_size
        self.assertGreater(moved, 8 * STEP)
        self.assertLess(off, STEP / 2 + 1e-5)

    def test_moving_frames_of_both_contents_are_as_near_as_their_steps(self):
        session = self.open()
        both = [self.join(session, content) for content in CONTENTS.values()]
        for frame_bytes, step_shift, change in (
                (0, 2, client.slider(0.2)), (1000, 6, client.curve((-3, 2), (3, 150)))):
            for live in both:
                live.settle()
                live.grant(frame_bytes=frame_bytes)
                live.send(heartbeat=editing_pb2.Heartbeat())
                live.receive("heartbeat")  # so the server has the credit, too
            both[0].send(apply=editing_pb2.ApplyEdits(edits=[change]))
            frames = [live.receive("frame") for live in both]
            self.assertEqual(frames[0].cycles, frames[1].cycles)
            self.assertEqual([live.headers[-1].step_shift for live in both], [step_shift] * 2)
            off = np.abs(both[0].positions() - both[1].positions()).max() / both[0].view.cell_size
            step = 2**step_shift * STEP
            self.assertLess(off, (step + STEP / 2) + (step / 2 + STEP / 2))
            self.assertGreater(off, STEP)

    def test_small_frames_are_coarser_and_end_exact(self):
        session = self.open()
        live = self.join(session)
        live.settle()
        live.grant(frame_bytes=1000)
        edits = live.apply(client.slider(0)).edits
        live.settle(edits, frame_bytes=1000)
        steps = [header.step_shift for header in live.headers]
        self.assertEqual(max(steps), 6, steps)
        self.assertGreater(steps.count(0), 2, "the still surface comes in parts")
        self.assertCurrent(live, session)

    def test_a_frame_that_shows_nothing_new_has_no_data(self):
        session = self.open()
        live = self.join(session)
        cycles = live.settle().cycles
        summary = self.client.export(session, cycles=3)[1]
        frame = live.receive_frame(lambda frame: frame.cycles == cycles + summary.cycles)
        self.assertEqual(frame.data, b"")

    def test_a_frame_whose_reference_was_lost_is_refused_and_a_key_frame_comes(self):
        session = self.open()
        live = self.join(session)
        live.settle()
        live.decoder.forget()
        live.settle(live.apply(client.slider(0.2)).edits)
        self.assertEqual([header.reference for header in live.headers].count(0), 2)
        self.assertCurrent(live, session)

    def test_who_holds_nothing_asks_for_a_key_frame(self):
        live = self.join(self.open())
        live.settle()
        live.decoder.forget()
        live.grant(key_frame=True)
        live.receive("frame")
        self.assertEqual(live.headers[-1].reference, 0)
        self.assertEqual(len(live.headers), 2)

    def test_until_a_frame_is_named_all_are_key_frames(self):
        live = self.join(self.open())
        for beta in (0.5, 0.2):
            live.apply(client.slider(beta))
            live.send(credit=editing_pb2.Credit(frames=1))
            live.receive("frame")
        self.assertEqual([header.reference for header in live.headers], [0, 0])

    def test_a_heartbeat_comes_back_and_frames_tell_the_newest(self):
        live = self.join(self.open())
        live.send(heartbeat=editing_pb2.Heartbeat(client_time_us=1234567))
        self.assertEqual(live.receive("heartbeat").client_time_us, 1234567)
        self.assertEqual(live.settle().client_time_us, 1234567)

    def test_a_preview_is_shown_and_kept_nowhere(self):
        session = self.open()
        live = self.join(session)
        live.settle()
        live.preview("gesture", gradient_scale=editing_pb2.SetGradientScale(beta=0))
        live.settle(previews=1)
        moved = np.abs(live.positions() - self.vertices).max() / live.view.cell_size
        self.assertGreater(moved, 8 * STEP)
        self.assertEqual(list(self.client.history(session, page=10)), [])
        live.preview("gesture", drop=editing_pb2.DropPreview())
        live.settle(previews=2)
        np.testing.assert_allclose(live.positions(), self.vertices, atol=1e-3)

    def test_a_wrong_preview_is_refused_by_its_id(self):
        live = self.join(self.open())
        live.preview("loud", gradient_scale=editing_pb2.SetGradientScale(beta=11))
        self.assertRefused(live, ["loud"], grpc.StatusCode.INVALID_ARGUMENT)
        for radius in (1, 2):
            begun = client.stroke(self.vertices[:2], radius, beta=0).stroke
            live.preview("stroke", stroke=begun)
        self.assertRefused(live, ["stroke"], grpc.StatusCode.INVALID_ARGUMENT)

    def test_a_wrong_edit_is_refused_and_the_stream_goes_on(self):
        live = self.join(self.open())
        wrong = client.slider(0.5), client.slider(-1)
        live.send(apply=editing_pb2.ApplyEdits(edits=wrong))
        self.assertRefused(live, [one.id for one in wrong], grpc.StatusCode.INVALID_ARGUMENT)
        self.assertEqual(live.apply(client.slider(0.5)).edits, 1)

    def test_a_viewer_is_refused(self):
        session = self.open()
        request = editing_pb2.SetRoleRequest(session=session.id, user="Anna",
                                             role=editing_pb2.ROLE_VIEWER)
        self.client.call(self.client.editing.SetRole, request)
        anna = LiveSession(self.connect("Anna"), session, self.client.fetch_view(session),
                           editing_pb2.FRAME_CONTENT_UNSPECIFIED)
        self.addCleanup(anna.cancel)
        self.assertEqual(anna.welcome.role, editing_pb2.ROLE_VIEWER)
        anna.preview("gesture", gradient_scale=editing_pb2.SetGradientScale(beta=0))
        self.assertRefused(anna, ["gesture"], grpc.StatusCode.PERMISSION_DENIED)

    def assertRefused(self, live, edit_ids, code):
        refused = live.receive("refused")
        self.assertEqual(list(refused.edit_ids), edit_ids)
        self.assertEqual(refused.code, code.value[0], refused.message)

    def test_an_edit_sent_again_on_a_new_stream_is_known(self):
        session, change = self.open(), client.slider(0.5)
        first = self.join(session)
        first.send(apply=editing_pb2.ApplyEdits(edits=[change]))
        while first.receive("history").edits == 0:
            pass
        first.cancel()  # the answer counts as lost
        outcome = self.join(session).apply(change)
        self.assertEqual((outcome.applied, outcome.known, outcome.edits), (0, 1, 1))

    def test_a_brush_is_seen_by_everybody(self):
        session = self.open()
        painter, watcher = self.join(session), self.join(session)
        ring = editing_pb2.BrushRing(centre=common_pb2.Point(x=10), radius=2)
        painter.send(move_brush=editing_pb2.MoveBrush(ring=ring))
        while True:
            present = {user.connection: user for user in watcher.receive("people").present}
            if present[painter.welcome.connection].HasField("ring"):
                break
        self.assertEqual(present[painter.welcome.connection].ring, ring)
        self.assertEqual(present[watcher.welcome.connection].user, "Zoë")

    def test_who_leaves_gets_his_answers_first(self):
        live, change = self.join(self.open()), client.slider(0.5)
        live.send(apply=editing_pb2.ApplyEdits(edits=[change]))
        rest, code = live.leave()
        self.assertIn([change.id], [list(message.acknowledged.edit_ids) for message in rest])
        self.assertEqual(code, grpc.StatusCode.OK)

    def test_a_malformed_message_ends_the_call(self):
        session = self.open()
        for wrong in (dict(greeting=editing_pb2.Greeting(session=session.id)), dict(),
                      dict(credit=editing_pb2.Credit(decoded=range(1, 258))),
                      dict(move_brush=editing_pb2.MoveBrush(ring=editing_pb2.BrushRing()))):
            live = self.join(session)
            live.send(**wrong)
            self.assertFails(grpc.StatusCode.INVALID_ARGUMENT, lambda: live.receive("go_away"))

    def test_a_closed_session_says_go_away_and_do_not_come_back(self):
        session = self.open()
        live = self.join(session)
        request = editing_pb2.CloseSessionRequest(session=session.id)
        self.client.call(self.client.editing.CloseSession, request)
        rest, code = live.leave()
        self.assertEqual(rest[-1].WhichOneof("message"), "go_away")
        self.assertFalse(rest[-1].go_away.come_back)
        self.assertEqual(code, grpc.StatusCode.OK)

    def test_a_watcher_gets_key_frames_without_asking(self):
        session = self.open()
        view = self.client.fetch_view(session)
        request = editing_pb2.WatchRequest(greeting=editing_pb2.Greeting(session=session.id))
        messages = self.client.call(self.client.editing.Watch, request)
        self.addCleanup(messages.cancel)
        welcome = next(message.welcome for message in messages if message.HasField("welcome"))
        decoder = wire.FrameDecoder(wire.Layout(view, welcome.content - 1))
        edits = self.client.apply(session, client.slider(0.2)).edits
        for message in messages:
            if message.frame.data:
                self.assertEqual(decoder.decode(message.frame.data).reference, 0)
            if message.HasField("frame") and message.frame.edits == edits:
                return
        self.fail("the stream ended")


class Drained(Served):
    def test_a_server_that_ends_says_come_back(self):
        live = self.join(self.open())
        self.assertEqual(self.server.stop(), 0)
        rest, code = live.leave()
        self.assertEqual(rest[-1].WhichOneof("message"), "go_away")
        self.assertTrue(rest[-1].go_away.come_back)
        self.assertEqual(code, grpc.StatusCode.OK)


if __name__ == "__main__":
    unittest.main()
