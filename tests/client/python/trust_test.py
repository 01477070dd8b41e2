"""Tokens and certificates."""

import hashlib
import pathlib
import subprocess
import tempfile
import unittest

import burnish
import scan
from server_process import ServerProcess

DEPLOY = pathlib.Path(__file__).parents[3] / "deploy"
TOKENS = {"viewer": "look", "editor": "change"}


class Trust(unittest.TestCase):
    """A server with certificates, and with users who have tokens."""

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory(prefix="burnish-")
        cls.addClassCleanup(folder.cleanup)
        cls.tls = pathlib.Path(folder.name) / "tls"
        subprocess.run([DEPLOY / "make-certificates", cls.tls, "127.0.0.1", "anna"], check=True,
                       capture_output=True)
        users = pathlib.Path(folder.name) / "users.toml"
        users.write_text("".join(
            f'[[user]]\nname = "{role}"\nrole = "{role}"\n'
            f'token_sha256 = "{hashlib.sha256(token.encode()).hexdigest()}"\n'
            for role, token in TOKENS.items()) +
            '[[user]]\nname = "anna"\nrole = "owner"\ncertificate = "anna"\n')
        users.chmod(0o600)
        cls.server = ServerProcess("--tls-certificate", cls.tls / "server.pem", "--tls-key",
                                   cls.tls / "server.key", "--tls-client-ca", cls.tls / "ca.pem",
                                   "--users", users)
        cls.addClassCleanup(cls.server.close)

    def connect(self, **trust):
        made = burnish.connect(self.server.address, ca=self.tls / "ca.pem", patience=2, **trust)
        self.addCleanup(made.close)
        return made

    def test_a_certificate_says_who_calls(self):
        anna = self.connect(certificate=self.tls / "client-anna.pem",
                            key=self.tls / "client-anna.key")
        one = anna.import_scan(burnish.Mesh(*scan.bumpy_sphere(3)), "ball", depth=4)
        session = anna.open_session(one, "ball", depth=4)
        session.set_beta(0.5)
        self.assertEqual([entry.author for entry in session.history()], ["anna"])
        with self.assertRaises(burnish.PermissionDenied):
            self.token("viewer").session("ball").set_beta(0.2)
        self.assertEqual(self.token("editor").session("ball").set_beta(0.2), 2)

    def token(self, role):
        """Connects over the socket, which is in plain text and asks for no certificate."""
        made = burnish.connect(f"unix:{self.server.socket}", token=TOKENS[role])
        self.addCleanup(made.close)
        return made

    def test_a_wrong_token_is_refused(self):
        with self.assertRaises(burnish.Unauthenticated):
            burnish.connect(f"unix:{self.server.socket}", token="guess")
        with self.assertRaises(burnish.Unauthenticated):
            burnish.connect(f"unix:{self.server.socket}")

    def test_a_server_of_another_ca_is_not_trusted(self):
        other = self.tls.parent / "other"
        subprocess.run([DEPLOY / "make-certificates", other, "127.0.0.1"], check=True,
                       capture_output=True)
        with self.assertRaises(burnish.Unavailable):
            burnish.connect(self.server.address, ca=other / "ca.pem", patience=0.2)


if __name__ == "__main__":
    unittest.main()
