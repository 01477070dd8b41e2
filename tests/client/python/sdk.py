"""A server with a scan on it, and a connection of the package to it."""

import contextlib
import pathlib
import tempfile
import unittest

import burnish
import scan
from server_process import ServerProcess

DEPTH = 6


class Sdk(unittest.TestCase):
    """A test case with a server, a connection and a scan."""

    @classmethod
    def setUpClass(cls):
        cls.server = ServerProcess()
        cls.addClassCleanup(cls.server.close)
        cls.connection = cls.connect("Zoë")
        cls.mesh = burnish.Mesh(*scan.bumpy_sphere())
        cls.scan = cls.connection.import_scan(cls.mesh, "sphere", depth=DEPTH)

    @classmethod
    def connect(cls, user=None, **options):
        made = burnish.connect(f"unix:{cls.server.socket}", user=user, **options)
        cls.addClassCleanup(made.close)
        return made

    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="burnish-")
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def open(self, name=None):
        """Opens this test's own session."""
        session = self.connection.open_session(self.scan, name or self.id(), depth=DEPTH)
        self.addCleanup(self.delete, session)
        return session

    @staticmethod
    def delete(session):
        with contextlib.suppress(burnish.NotFound):
            session.delete()

    @property
    def cell_size(self):
        return self.scan.prepared(DEPTH).cell_size

    def assertRefused(self, kind, *words):
        """Awaits an error of this kind whose message has these words."""
        return self.assertRaisesRegex(kind, "".join(f"(?=.*{word})" for word in words))
