"""Strangers at the gateway for browsers."""

import base64
import os
import socket
import struct
import time

import grpc

import scans
from attack import MIB, Attack
from client import Client
from http2 import END_HEADERS, HEADERS, Http2, grpc_headers, grpc_message
from server import rss_bytes

TEXT, BINARY, MASKED = 0x81, 0x82, 0x80
CHECK, WATCH = "grpc.health.v1.Health/Check", "grpc.health.v1.Health/Watch"


class Socket:
    """A WebSocket by hand: the part of RFC 6455 that the attacks need."""

    def __init__(self, address, source):
        host, port = address.rsplit(":", 1)
        self.is_open = True
        try:
            self.socket = socket.create_connection((host, int(port)), 10, (source, 0))
        except OSError:
            self.socket, self.is_open = socket.socket(), False
        self.write(("GET /rpc HTTP/1.1\r\nHost: %s\r\nConnection: Upgrade\r\nUpgrade: websocket\r\n"
                    "Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: %s\r\n"
                    "Sec-WebSocket-Protocol: burnish.v1\r\n\r\n"
                    % (address, base64.b64encode(os.urandom(16)).decode())).encode())

    def write(self, data):
        try:
            self.socket.sendall(data)
        except OSError:
            self.is_open = False

    def call(self, method):
        text = ('{"call":"%s"}' % method).encode()
        self.write(bytes([TEXT, MASKED | len(text)]) + bytes(4) + text)

    def promise(self, size, sent):
        """Begins a message of `size` bytes, and stops after `sent`. The mask is zero."""
        self.write(bytes([BINARY, MASKED | 127]) + struct.pack(">Q", size) + bytes(4))
        for begin in range(0, sent, MIB):
            self.write(bytes(min(MIB, sent - begin)))

    def look(self):
        """Notices whether the server has hung up."""
        self.socket.setblocking(False)
        try:
            while self.is_open:
                self.is_open = self.socket.recv(1 << 16) != b""
        except BlockingIOError:
            pass
        except OSError:
            self.is_open = False
        self.socket.setblocking(True)

    def close(self):
        self.socket.close()


class _AtTheGateway(Attack):
    flags = ("--web", "127.0.0.1:0")

    @staticmethod
    def gateway(server):
        return server.announced(rb"web on https?://([^/\s]+)", 0)


class UnfinishedMessagesTakeNoMemory(_AtTheGateway):
    """Sockets promise messages of 16 MiB in a call that is open to all, and stop short of the end."""
    finding = "N1"
    witness_session = ""
    taken_mib_max = 20

    def attack(self, server):
        before, address = rss_bytes(server.pid), self.gateway(server)
        sockets = [Socket(address, "127.0.0.2") for _ in range(60)]
        for one in sockets:
            one.call(CHECK)
            one.promise(16 * MIB, self.size(MIB, 16 * MIB - 300))
        taken = (rss_bytes(server.pid) - before) / MIB
        if taken > self.taken_mib_max:
            self.hole("60 sockets took %d MiB, limit %d" % (taken, self.taken_mib_max))
        for one in sockets:
            one.close()
        return "60 sockets took %d MiB" % taken


class HealthWatchesLockNobodyOut(_AtTheGateway):
    """Five addresses hold every connection that the server takes, each by a watch of its health."""
    finding = "N2"
    fresh_connections = True
    answer_s_max = 1

    def attack(self, server):
        address, end = self.gateway(server), time.monotonic() + self.size(8, 60)
        watching = [self.watch(server, address, number) for number in range(256)]
        opened = len(watching)
        while time.monotonic() < end and server.is_alive():
            for number, one in enumerate(watching):
                one.look() if isinstance(one, Socket) else one.listen(0)
                if not one.is_open:
                    one.close()
                    watching[number] = self.watch(server, address, number)
                    opened += 1
            time.sleep(0.05)
        for one in watching:
            one.close()
        return "256 watches, %d opened" % opened

    @staticmethod
    def watch(server, address, number):
        """Half of them come over gRPC."""
        source = "127.0.0.%d" % (2 + number % 5)
        if number % 2:
            one = Http2(server, source=source)
            one.send(HEADERS, END_HEADERS, 1, grpc_headers("/" + WATCH))
            one.send_data(1, grpc_message(b""), wait_s=0)
            return one
        one = Socket(address, source)
        one.call(WATCH)
        one.promise(0, 0)
        return one


class ImportThatIsGivenUpHoldsUpNoOther(Attack):
    """Triangles at random over few vertices cut millions of cells. Their sender gives up."""
    finding = "N3"
    growth_mib_max = 1000
    next_import_s_max = 5

    def attack(self, server):
        file = scans.needles(1000, self.size(60_000, 500_000))
        try:
            Client(server, "mallory").import_scan("needles", file, 8, scans.sha256(file), timeout=3)
            outcome = "accepted"
        except grpc.RpcError as error:
            outcome = error.code().name
        begin, small = time.monotonic(), scans.two_triangles()
        try:
            Client(server, "bert").import_scan("small", small, 4, scans.sha256(small))
        except grpc.RpcError as error:
            self.hole("another user's import: " + error.code().name)
        waited = time.monotonic() - begin
        if waited > self.next_import_s_max and self.answer_s_max != float("inf"):
            self.hole("another user's import took %.1f s" % waited)
        return "%d bytes: %s; the next import took %.1f s" % (len(file), outcome, waited)
