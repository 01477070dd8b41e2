"""Sessions that move to another server: the package follows them. The servers here only refuse and answer."""

import concurrent.futures
import threading
import types
import unittest

import grpc

import burnish
from burnish._calls import Calls
from burnish._channel import Trust
from burnish.live_link import LOST, LiveLink
from burnish.v1 import editing_pb2, editing_pb2_grpc, library_pb2, library_pb2_grpc


class Server(editing_pb2_grpc.EditingServicer, library_pb2_grpc.LibraryServicer):
    """Sends callers elsewhere, or answers them. Notes the header of each call."""

    def __init__(self, moved=None, go_aways=()):
        self.moved, self.nodes, self.go_aways = moved, [], list(go_aways)
        self.on_call = lambda asked: None
        self.welcome, self.has_guest = editing_pb2.Welcome(), threading.Event()
        self._server = grpc.server(concurrent.futures.ThreadPoolExecutor(2))
        editing_pb2_grpc.add_EditingServicer_to_server(self, self._server)
        library_pb2_grpc.add_LibraryServicer_to_server(self, self._server)
        self.address = f"127.0.0.1:{self._server.add_insecure_port('127.0.0.1:0')}"
        self._server.start()

    def close(self):
        self._server.stop(None).wait()

    def ListScans(self, request, context):
        return library_pb2.ListScansResponse()

    def GetState(self, request, context):
        self.nodes.append(dict(context.invocation_metadata()).get("x-burnish-node", ""))
        self.on_call(len(self.nodes))
        if self.moved:
            context.set_trailing_metadata((("grpc-status-details-bin", self.moved.SerializeToString()),))
            context.abort(grpc.StatusCode.FAILED_PRECONDITION, "server two holds the session")
        return editing_pb2.SessionState(
            session=editing_pb2.SessionInfo(id="0123456789abcdef", name=request.session))

    def Edit(self, requests, context):
        """Welcomes a client, and says the next GoAway; after the last one the client may stay."""
        self.nodes.append(dict(context.invocation_metadata()).get("x-burnish-node", ""))
        yield editing_pb2.ServerMessage(welcome=self.welcome)
        if self.go_aways:
            yield editing_pb2.ServerMessage(go_away=self.go_aways.pop(0))
        else:
            self.has_guest.set()
            context.add_callback(self.has_guest.clear)
            for _ in requests:
                pass


class MovedTest(unittest.TestCase):
    def server(self, moved=None):
        server = Server(moved)
        self.addCleanup(server.close)
        return server

    def session_at(self, server):
        connection = burnish.connect(server.address, patience=0)
        self.addCleanup(connection.close)
        return connection.session("work")

    def test_a_call_goes_to_the_server_that_has_the_session(self):
        two = self.server()
        one = self.server(editing_pb2.Moved(address=two.address, node="two"))
        self.assertEqual(self.session_at(one).name, "work")
        self.assertEqual((one.nodes, two.nodes), ([""], ["two"]))

    def test_a_session_of_a_killed_server_is_asked_for_until_another_has_it(self):
        killed = self.server()
        killed.close()
        one = self.server(editing_pb2.Moved(address=killed.address, node="two"))

        def take_over(asked):
            if asked == 2:
                one.moved = None
        one.on_call = take_over
        connection = burnish.connect(one.address, patience=600)
        self.addCleanup(connection.close)
        self.assertEqual(connection.session("work").name, "work")
        self.assertEqual(one.nodes, ["", ""])

    def test_a_closed_connection_says_so(self):
        connection = burnish.connect(self.server().address)
        connection.close()
        with self.assertRaisesRegex(burnish.FailedPrecondition, "closed"):
            connection.scans()

    def test_without_an_address_the_header_leads_there(self):
        edge = self.server(editing_pb2.Moved(node="two"))
        with self.assertRaisesRegex(burnish.FailedPrecondition, "server two"):
            self.session_at(edge)
        self.assertEqual(edge.nodes, [""] + 5 * ["two"])


class GoAwayTest(unittest.TestCase):
    """A live client of a server that says GoAway. Others of its fleet let the client stay."""

    def server(self, **facts):
        server = Server(**facts)
        self.addCleanup(server.close)
        return server

    def expect_way(self, go_away, there):
        """Fails unless the client greets `there` after one GoAway of its server."""
        one = self.server(go_aways=[go_away])
        one.welcome = editing_pb2.Welcome(fleet=[one.address, self.next.address])
        calls = Calls(one.address, Trust("ann"), patience=30)
        self.addCleanup(calls.close)
        surface = types.SimpleNamespace(numbers=[], decoder=lambda: None,
                                        head=types.SimpleNamespace(fingerprint=0))
        link = LiveLink(calls, "work", lambda: surface, heartbeat_seconds=5)
        self.addCleanup(link.close)
        self.assertTrue(there.has_guest.wait(60))
        self.assertEqual(one.nodes, [""])

    def test_a_named_server_is_greeted(self):
        self.next, named = self.server(), self.server()
        place = editing_pb2.Moved(address=named.address, node="three")
        self.expect_way(editing_pb2.GoAway(come_back=True, moved=place), named)
        self.assertEqual(named.nodes, ["three"])

    def test_a_server_that_lost_the_session_is_left_for_the_next_one(self):
        for code in LOST:
            self.next = self.server()
            self.expect_way(editing_pb2.GoAway(come_back=True, code=code), self.next)

    def test_the_go_away_knows_the_servers_that_joined_the_fleet_later(self):
        self.next, joined = self.server(), self.server()
        go_away = editing_pb2.GoAway(come_back=True, code=LOST[0], fleet=[joined.address])
        self.expect_way(go_away, joined)


if __name__ == "__main__":
    unittest.main()
