"""Sessions that move to another server: the package follows them. The servers here only refuse and answer."""

import concurrent.futures
import unittest

import grpc

import burnish
from burnish.v1 import editing_pb2, editing_pb2_grpc, library_pb2, library_pb2_grpc


class Server(editing_pb2_grpc.EditingServicer, library_pb2_grpc.LibraryServicer):
    """Sends callers elsewhere, or answers them. Notes the header of each call."""

    def __init__(self, moved=None):
        self.moved, self.nodes = moved, []
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
        if self.moved:
            context.set_trailing_metadata((("grpc-status-details-bin", self.moved.SerializeToString()),))
            context.abort(grpc.StatusCode.FAILED_PRECONDITION, "server two holds the session")
        return editing_pb2.SessionState(
            session=editing_pb2.SessionInfo(id="0123456789abcdef", name=request.session))


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

    def test_without_an_address_the_header_leads_there(self):
        edge = self.server(editing_pb2.Moved(node="two"))
        with self.assertRaisesRegex(burnish.FailedPrecondition, "server two"):
            self.session_at(edge)
        self.assertEqual(edge.nodes, [""] + 5 * ["two"])


if __name__ == "__main__":
    unittest.main()
