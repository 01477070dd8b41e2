"""Connecting, limits and edits (docs/protocol.md, sections 1, 2 and 4)."""

import unittest

import grpc

import edits
from burnish.v1 import editing_pb2, library_pb2
from client import Client
from served import Served


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
        session, other, change = self.open(), self.connect("Zoe"), edits.slider(0.5)
        self.assertEqual(self.client.apply(session, change).applied, 1)
        again = self.client.apply(session, change)
        self.assertEqual((again.applied, again.known, again.entries[0]), (0, 1, 0))
        self.assertEqual(other.apply(session, change).applied, 1)

    def test_who_gives_no_name_is_one_author(self):
        session, change = self.open(), edits.slider(0.5)
        for known in (0, 1):
            self.assertEqual(self.connect().apply(session, change).known, known)

    def test_history_comes_in_pages_with_authors(self):
        session = self.open()
        self.client.apply(session, *[edits.slider(beta / 10) for beta in range(5)])
        self.client.apply(session, edits.edit(undo=editing_pb2.Undo()))
        entries = list(self.client.history(session, page=2))
        self.assertEqual([entry.number for entry in entries], [1, 2, 3, 4, 5])
        self.assertEqual([entry.enabled for entry in entries], [True] * 4 + [False])
        self.assertEqual({entry.author for entry in entries}, {"Zoë"})

    def test_the_limits_of_the_page_hold(self):
        session = self.open()
        long_stroke = edits.stroke([(0, 0, 0), (0, 0, 1025)], radius=1, beta=0)
        wide_curve = edits.curve((0, 0.05), (1, 60))
        for name, wrong in {
                "no edits": [], "65 edits": [edits.slider(1) for _ in range(65)],
                "4101 dabs": [long_stroke], "a contrast of 1200": [wide_curve],
                "NaN": [edits.slider(float("nan"))], "alpha": [edits.curve((0, 2e5))],
                "an id of 65": [editing_pb2.Edit(id="a" * 65, undo=editing_pb2.Undo())],
                "a space": [editing_pb2.Edit(id="a b", undo=editing_pb2.Undo())]}.items():
            with self.subTest(name):
                self.assertFails(grpc.StatusCode.INVALID_ARGUMENT,
                                 lambda: self.client.apply(session, *wrong))
        too_large = edits.edit(set_checkpoint=editing_pb2.SetCheckpoint(name="a" * (16 << 20)))
        self.assertFails(grpc.StatusCode.RESOURCE_EXHAUSTED,
                         lambda: self.client.apply(session, too_large))
        for name in ("a" * 201, "a\nb", "a\x7fb"):
            self.assertFails(grpc.StatusCode.INVALID_ARGUMENT, lambda: self.open(name))
            self.assertFails(grpc.StatusCode.INVALID_ARGUMENT,
                             lambda: self.connect(name).apply(session, edits.slider(1)))

    def test_a_call_of_another_version_is_told(self):
        for method in ("/burnish.v1.Library/FetchView", "/burnish.v2.Editing/Edit"):
            call = self.client.channel.unary_unary(method)
            with self.assertRaisesRegex(grpc.RpcError, method + ".*different versions") as failed:
                call(b"")
            self.assertEqual(failed.exception.code(), grpc.StatusCode.UNIMPLEMENTED)

    def test_all_edits_of_a_message_are_applied_or_none(self):
        session = self.open()
        self.assertFails(grpc.StatusCode.INVALID_ARGUMENT, lambda: self.client.apply(
            session, edits.slider(0.5), edits.slider(11)))
        self.assertEqual(list(self.client.history(session, page=10)), [])


if __name__ == "__main__":
    unittest.main()
