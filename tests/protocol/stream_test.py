"""A live session without its frames (docs/protocol.md, section 5)."""

import unittest

import grpc
import numpy as np

import edits
from burnish.v1 import common_pb2, editing_pb2
from live import LiveSession
from served import Served


class Stream(Served):
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
        self.assertGreater(self.largest_move(live), 0.1)
        self.assertEqual(list(self.client.history(session, page=10)), [])
        live.preview("gesture", drop=editing_pb2.DropPreview())
        live.settle(previews=2)
        self.assertLess(self.largest_move(live), 1e-2)

    @staticmethod
    def largest_move(live):
        """Returns the largest move of the shown vertices along an axis, cells."""
        return max(np.abs(moved).max() for moved in live.displacements().values())

    def test_a_wrong_preview_is_refused_by_its_id(self):
        live = self.join(self.open())
        live.preview("loud", gradient_scale=editing_pb2.SetGradientScale(beta=11))
        self.assertRefused(live, ["loud"], grpc.StatusCode.INVALID_ARGUMENT)
        for radius in (1, 2):
            begun = edits.stroke(self.vertices[:2], radius, beta=0).stroke
            live.preview("stroke", stroke=begun)
        self.assertRefused(live, ["stroke"], grpc.StatusCode.INVALID_ARGUMENT)

    def test_a_wrong_edit_is_refused_and_the_stream_goes_on(self):
        live = self.join(self.open())
        wrong = edits.slider(0.5), edits.slider(-1)
        live.send(apply=editing_pb2.ApplyEdits(edits=wrong))
        self.assertRefused(live, [one.id for one in wrong], grpc.StatusCode.INVALID_ARGUMENT)
        self.assertEqual(live.apply(edits.slider(0.5)).edits, 1)

    def test_a_viewer_is_refused(self):
        session = self.open()
        request = editing_pb2.SetRoleRequest(session=session.id, user="Anna",
                                             role=editing_pb2.ROLE_VIEWER)
        self.client.call(self.client.editing.SetRole, request)
        anna = LiveSession(self.connect("Anna"), session)
        self.addCleanup(anna.cancel)
        self.assertEqual(anna.welcome.role, editing_pb2.ROLE_VIEWER)
        anna.preview("gesture", gradient_scale=editing_pb2.SetGradientScale(beta=0))
        self.assertRefused(anna, ["gesture"], grpc.StatusCode.PERMISSION_DENIED)

    def assertRefused(self, live, edit_ids, code):
        refused = live.receive("refused")
        self.assertEqual(list(refused.edit_ids), edit_ids)
        self.assertEqual(refused.code, code.value[0], refused.message)

    def test_an_edit_sent_again_on_a_new_stream_is_known(self):
        session, change = self.open(), edits.slider(0.5)
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
        live, change = self.join(self.open()), edits.slider(0.5)
        live.send(apply=editing_pb2.ApplyEdits(edits=[change]))
        rest, code = live.leave()
        self.assertIn([change.id], [list(message.acknowledged.edit_ids) for message in rest])
        self.assertEqual(code, grpc.StatusCode.OK)

    def test_a_malformed_message_ends_the_call(self):
        session = self.open()
        for wrong in (dict(greeting=editing_pb2.Greeting(session=session.id, pages=True)), dict(),
                      dict(credit=editing_pb2.Credit(decoded=range(1, 258))),
                      dict(move_brush=editing_pb2.MoveBrush(ring=editing_pb2.BrushRing()))):
            live = self.join(session)
            live.send(**wrong)
            self.assertFails(grpc.StatusCode.INVALID_ARGUMENT, lambda: live.receive("go_away"))

    def test_a_wrong_change_of_pages_ends_the_call_and_no_other(self):
        session = self.open()
        other = self.join(session)
        count = other.scan.head.page_count
        for change in (dict(revision=2, added=[0]), dict(revision=1, added=[count]),
                       dict(revision=1, added=[0, 0]), dict(revision=1, removed=[0])):
            live = self.join(session, pages=[])
            live.send(show_pages=editing_pb2.ShowPages(**change))
            self.assertFails(grpc.StatusCode.INVALID_ARGUMENT, lambda: live.receive("go_away"))
        other.settle()

    def test_a_client_that_does_not_know_pages_is_told(self):
        greeting = editing_pb2.Greeting(session=self.open().id)
        messages = self.client.call(self.client.editing.Edit,
                                    iter([editing_pb2.ClientMessage(greeting=greeting)]))
        self.assertFails(grpc.StatusCode.FAILED_PRECONDITION, lambda: list(messages))

    def test_a_closed_session_says_go_away_and_do_not_come_back(self):
        session = self.open()
        live = self.join(session)
        request = editing_pb2.CloseSessionRequest(session=session.id)
        self.client.call(self.client.editing.CloseSession, request)
        rest, code = live.leave()
        self.assertEqual(rest[-1].WhichOneof("message"), "go_away")
        self.assertFalse(rest[-1].go_away.come_back)
        self.assertEqual(rest[-1].go_away.code, editing_pb2.GO_AWAY_CODE_CLOSED)
        self.assertEqual(code, grpc.StatusCode.OK)


class Drained(Served):
    def test_a_server_that_ends_says_come_back(self):
        live = self.join(self.open())
        self.assertEqual(self.server.stop(), 0)
        rest, code = live.leave()
        self.assertEqual(rest[-1].WhichOneof("message"), "go_away")
        self.assertTrue(rest[-1].go_away.come_back)
        self.assertEqual(rest[-1].go_away.code, editing_pb2.GO_AWAY_CODE_GOING_DOWN)
        self.assertEqual(code, grpc.StatusCode.OK)


if __name__ == "__main__":
    unittest.main()
