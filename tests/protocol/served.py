"""The tests' common server, with a scan on it."""

import unittest

import grpc

import scan
from burnish.v1 import editing_pb2
from client import Client
from live import LiveSession
from server_process import ServerProcess

DEPTH = 6


class Served(unittest.TestCase):
    """A test case with a server and a scan on it."""

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
        """Opens this test's own session."""
        session = self.client.open_session(self.scan.id, name or self.id(), DEPTH)
        self.addCleanup(self.delete, session)
        return session

    def delete(self, session):
        if self.server.is_alive():
            request = editing_pb2.DeleteSessionRequest(session=session.id)
            self.client.call(self.client.editing.DeleteSession, request)

    def join(self, session, kind=editing_pb2.FRAME_KIND_UNSPECIFIED, pages=None):
        """Shows `pages`, or the scan itself."""
        live = LiveSession(self.client, session, kind)
        self.addCleanup(live.cancel)
        pages = live.scan.level_0 if pages is None else pages
        if pages:
            live.show(pages)
        return live

    def assertFails(self, code, call):
        with self.assertRaises(grpc.RpcError) as failed:
            call()
        self.assertEqual(failed.exception.code(), code, failed.exception.details())
