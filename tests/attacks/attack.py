"""An attack and its run: its own server, a witness next to it, a verdict."""

import json
import os
import subprocess
import sys
import time
from dataclasses import dataclass, field

import grpc

import scans
from client import Client
from proxy import ProxiedServer
from server import Server

MIB = 1 << 20
HERE = os.path.dirname(os.path.abspath(__file__))
RSS_BYTES_MAX = {False: 2 << 30, True: 4 << 30}  # above, the witness ends the server; long: True


class Attack:
    """A subclass's name is the fact that it tries to break. `attack()` returns the attacker's gain in
    words, and calls `hole()` for each success that should be impossible. In every attack the server
    must also live, answer others, and keep its memory."""

    finding = ""  # its name in the list of findings
    users = True  # the server has authentication
    config = ""  # further lines of server.toml
    flags = ()  # of burnish-server
    descriptors_max = 1024  # limit of the server's files and sockets
    scan_rows = 24  # rows of the sphere that everybody edits
    witness_session = "others"  # "": the witness only asks for the scans
    needs_proxy = False  # open without a proxy before the server, as known
    is_known = False  # found, but not repaired yet
    fresh_connections = False  # the witness reconnects for each question
    growth_mib_max = 150  # of resident memory
    answer_s_max = 4  # limit of another user's wait

    def __init__(self, long):
        self.long, self.holes = long, []

    def hole(self, what):
        self.holes.append(what)

    def size(self, short, long):
        return long if self.long else short

    def prepare(self, server):
        """Runs before the witness starts; self.owner exists, and the scan is imported."""

    def attack(self, server):
        raise NotImplementedError

    def check(self, server):
        """Runs after the witness has ended, while the server lives."""


@dataclass
class Seen:
    """The outcome of an attack."""
    name: str
    finding: str
    seconds: float = 0
    end: str = ""
    got: str = ""
    witness: dict = field(default_factory=dict)
    holes: list = field(default_factory=list)
    otherwise: str = "broken"  # the verdict on a hole

    verdict = property(lambda self: self.otherwise if self.holes else "held")


def _start_witness(attack, server):
    wish = dict(server=dict(address=server.address, ca=server.ca, users=server.users,
                            pid=server.pid), session=attack.witness_session, fresh_connections=attack.fresh_connections,
                rss_bytes_max=RSS_BYTES_MAX[attack.long])
    witness = subprocess.Popen([sys.executable, os.path.join(HERE, "witness.py"), json.dumps(wish)],
                               stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                               stderr=subprocess.DEVNULL, text=True)
    if witness.stdout.readline() != "ready\n":
        raise RuntimeError("the witness did not start")
    return witness


def _common_holes(attack, server, seen):
    if seen["killed"]:
        yield "took more than %d MiB and was ended" % (RSS_BYTES_MAX[attack.long] // MIB)
    elif not server.is_alive():
        yield "the server is gone: " + server.end_in_words()
    growth = (seen["rss_peak"] - seen["rss_before"]) / MIB
    if growth > attack.growth_mib_max:
        yield "memory grew by %d MiB, limit %d" % (growth, attack.growth_mib_max)
    for what in ("lists", "acks"):
        if seen[what]["worst_s"] > attack.answer_s_max:
            yield "another user waited %.1f s (%s), limit %g" % (seen[what]["worst_s"], what,
                                                                 attack.answer_s_max)
        if server.is_alive() and seen[what]["failures"]:
            yield "another user got %s (%s)" % (seen[what]["failure"], what)


def run(kind, binary, long, behind_proxy):
    attack = kind(long)
    seen = Seen(kind.__name__, kind.finding)
    if kind.is_known or (kind.needs_proxy and not behind_proxy):
        seen.otherwise = "known" if kind.is_known else "proxy"
    start = ProxiedServer if behind_proxy else Server
    server = start(binary, kind.users, kind.config, kind.flags, kind.descriptors_max)
    try:
        attack.owner = Client(server, "olga" if kind.users else None)
        scan = scans.sphere(kind.scan_rows)
        attack.owner.import_scan("scan", scan, sha256=scans.sha256(scan))
        if kind.witness_session:
            attack.owner.ask("OpenSession", scan="scan", name=kind.witness_session)
        attack.prepare(server)
        witness = _start_witness(attack, server)
        begin = time.monotonic()
        try:
            seen.got = attack.attack(server) or ""
        except (grpc.RpcError, StopIteration) as error:
            seen.got = "stopped by " + (error.code().name if isinstance(error, grpc.RpcError)
                                        else "the stream's end")
        seen.seconds = time.monotonic() - begin
        seen.witness = json.loads(witness.communicate(timeout=60)[0])
        if server.is_alive():
            attack.check(server)
        seen.end = server.end_in_words()
        seen.holes = attack.holes + list(_common_holes(attack, server, seen.witness))
    finally:
        server.stop()
    return seen
