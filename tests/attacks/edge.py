"""Strangers: data that reaches the server before authentication."""

import random
import struct
import time
import zlib

import grpc

from attack import MIB, Attack
from client import Client
from http2 import (CANCEL, CONTINUATION, END_HEADERS, FRAME_BYTES_MAX, HEADERS, RST_STREAM,
                   Http2, grpc_headers, grpc_message, frame, hpack,
                   hpack_integer)
from server import token_of

APPLY = "/burnish.v1.Editing/Apply"
LIST_SCANS = "/burnish.v1.Library/ListScans"


class CompressedMessageIsRefusedUnread(Attack):
    finding = "H1"

    def attack(self, server):
        packer = zlib.compressobj(9, wbits=31)
        unpacked = self.size(400, 3000)
        data = b"".join(packer.compress(bytes(MIB)) for _ in range(unpacked)) + packer.flush()
        stranger = Http2(server)
        stranger.send(HEADERS, END_HEADERS, 1, grpc_headers(APPLY, ("grpc-encoding", "gzip")))
        stranger.send_data(1, grpc_message(data, compressed=True))
        ended = stranger.wait_for_end(1, 20)
        stranger.close()
        return "%d bytes that unpack to %d MiB; %s" % (len(data), unpacked,
                                                       "refused" if ended else "no answer")


class _EndlessHeader(Attack):
    """HEADERS that never end, in CONTINUATION frames. gRPC keeps them, and reads them again and
    again; a proxy that knows HTTP/2 cuts them at its own limit."""
    finding = "H2"
    needs_proxy = True
    enough_bytes = MIB  # more than anybody may send as the header of one call

    def attack(self, server):
        stranger = Http2(server)
        stranger.socket.settimeout(2)
        stranger.listen(0.2)
        stranger.send(HEADERS, 0, 1, self.begin())
        sent, end = 0, time.monotonic() + self.size(4, 20)
        while stranger.is_open and time.monotonic() < end and server.is_alive():
            payload = self.more(sent)
            stranger.send(CONTINUATION, 0, 1, payload)
            stranger.listen(0.001 if sent < 4 * MIB else 0)  # gives a peer the time to hang up
            sent += len(payload)
        if stranger.is_open and sent > self.enough_bytes:
            self.hole("%d KiB of one header, and it is still read" % (sent >> 10))
        stranger.close()
        return "%d KiB of header sent, %s" % (sent >> 10, "taken" if stranger.is_open else "cut off")


class EndlessHeaderIsCut(_EndlessHeader):
    def begin(self):
        return grpc_headers(APPLY) + b"\0" + hpack_integer(1, 7) + b"x" + hpack_integer(1 << 30, 7)

    def more(self, sent):
        return b"y" * FRAME_BYTES_MAX


class ManyHeadersAreCut(_EndlessHeader):
    needs_proxy = False

    def begin(self):
        return grpc_headers(APPLY)

    def more(self, sent):
        return hpack([("x%d" % sent, "y" * (FRAME_BYTES_MAX - 64))])


class RepeatedHeadersAreCut(_EndlessHeader):
    """One header goes into HPACK's table, and each byte that follows stands for all of it."""
    value_bytes = 4000  # of the table's 4096
    repeats = 250  # a megabyte of headers for each frame
    enough_bytes = 250 * 16

    def begin(self):
        return b"\x40" + hpack_integer(1, 7) + b"x" + hpack_integer(self.value_bytes, 7) + b"y" * self.value_bytes

    def more(self, sent):
        time.sleep(0.01)
        return bytes([0x80 | 62]) * self.repeats  # the newest entry of the table


class _SilentConnections(Attack):
    """One address opens more connections than the server takes, and stays silent."""
    finding = "M2"
    fresh_connections = True
    greet = False

    def attack(self, server):
        end = time.monotonic() + self.size(5, 40)
        silent = [self.connect(server) for _ in range(300)]
        while time.monotonic() < end and server.is_alive():
            for number, connection in enumerate(silent):
                connection.listen(0)
                if not connection.is_open:
                    connection.close()
                    silent[number] = self.connect(server)
            time.sleep(0.05)
        for connection in silent:
            connection.close()
        return "300 connections that come back"

    def connect(self, server):
        return Http2(server, greet=self.greet)


class SilentSocketsLockNobodyOut(_SilentConnections):
    pass


class SilentPeersLockNobodyOut(_SilentConnections):
    """They greet and answer pings, as HTTP/2 requires."""
    greet = True


class FloodOfResetsIsCut(Attack):
    """Memory and log stay. But gRPC 1.51 reads one connection to its end before it looks at others."""
    finding = "M11"
    needs_proxy = True
    growth_mib_max = 50
    answer_s_max = 5
    log_kib_max = 500

    def attack(self, server):
        before, pairs, connections = server.log_bytes(), 0, 1
        stranger, stream = Http2(server), 1
        headers, cancel = grpc_headers(LIST_SCANS), struct.pack(">I", CANCEL)
        end = time.monotonic() + self.size(6, 20)
        while time.monotonic() < end and server.is_alive() and connections < 1000:
            burst = b""
            for _ in range(50):
                burst += frame(HEADERS, END_HEADERS, stream, headers)
                burst += frame(RST_STREAM, 0, stream, cancel)
                stream += 2
            stranger.write(burst)
            stranger.listen(0)
            pairs += 50
            if not stranger.is_open:
                stranger.close()
                stranger, stream, connections = Http2(server), 1, connections + 1
        stranger.close()
        log = server.log_bytes() - before
        if log > self.log_kib_max << 10:
            self.hole("%d KiB of log" % (log >> 10))
        return "%d calls begun and reset on %d connections, %d KiB of log" % (pairs, connections,
                                                                              log >> 10)


class StrangersMessageIsNotParsed(Attack):
    """A message of 16 MiB with as many empty edits as fit; parsed, each is an object."""
    finding = "M10"

    def attack(self, server):
        message = b"\x0a\x04work" + b"\x12\x00" * (8 * MIB - 1000)
        for _ in range(self.size(1, 4)):
            stranger = Http2(server)
            stranger.send(HEADERS, END_HEADERS, 1, grpc_headers(APPLY))
            stranger.send_data(1, grpc_message(message), wait_s=20)
            stranger.wait_for_end(1, 20)
            stranger.close()
        return "%d bytes without a token" % len(message)


class CallsOutsideTheProtocolEndNothing(Attack):
    """Frames in wrong orders, sizes and places."""

    def attack(self, server):
        chance, tried = random.Random(1), 0
        for _ in range(self.size(60, 3000)):
            stranger = Http2(server)
            for _ in range(chance.randrange(1, 8)):
                payload = chance.choice([b"", grpc_headers(LIST_SCANS), grpc_message(b"\x0a\x01x"),
                                         chance.randbytes(chance.randrange(40))])
                stranger.send(chance.randrange(11), chance.randrange(256), chance.randrange(5),
                              payload)
                tried += 1
            stranger.listen(0.002)
            stranger.close()
        return "%d frames" % tried


class SchemeOfTheTokenIsTakenInAnyCase(Attack):
    """RFC 6750: "bearer" and "BEARER" are Bearer."""
    finding = "low"
    witness_session = ""

    def attack(self, server):
        client, codes = Client(server), []
        for scheme in ("Bearer", "bearer", "BEARER"):
            client.metadata = [("authorization", scheme + " " + token_of("vera"))]
            codes.append(client.code("ListScans"))
        if codes != ["OK"] * 3:
            self.hole(", ".join(codes))
        return ", ".join(codes)


class ServerOutOfDescriptorsTellsNoLies(Attack):
    """Connections take every descriptor that the server may have."""
    finding = "low"
    descriptors_max = 80
    witness_session = ""

    def attack(self, server):
        asking = Client(server, "alice")
        asking.ask("ListScans")
        silent = [Http2(server, source="127.0.0.%d" % (2 + number // 40), greet=False)
                  for number in range(120)]
        time.sleep(0.5)
        said = []
        for _ in range(20):
            try:
                scans = len(asking.ask("ListScans").scans)
                said.append("%d scans" % scans)
                if scans != 1:
                    self.hole("ListScans: OK, %d scans of 1" % scans)
                    break
            except grpc.RpcError as error:
                said.append(error.code().name)
        opened = asking.code("OpenSession", scan="scan", name="new")
        if opened in ("NOT_FOUND", "INVALID_ARGUMENT"):
            self.hole("OpenSession of a scan that is there: " + opened)
        for connection in silent:
            connection.close()
        return "ListScans: %s; OpenSession: %s" % (", ".join(sorted(set(said))), opened)
