"""HTTP/2 by hand, for bytes that no library sends: the part of RFC 9113 that the attacks need."""

import select
import socket
import ssl
import struct
import time

DATA, HEADERS, RST_STREAM, SETTINGS, PING, GOAWAY, WINDOW_UPDATE, CONTINUATION = (
    0, 1, 3, 4, 6, 7, 8, 9)
END_STREAM, END_HEADERS, ACK = 1, 4, 1
CANCEL = 8
SETTINGS_INITIAL_WINDOW_SIZE = 4
PREFACE = b"PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n"
FRAME_BYTES_MAX = 16384
WINDOW_BYTES = 65535  # of streams and the connection, until the peer changes it
SOMEBODY_ELSE = "127.0.0.2"  # address of the attackers, so that limits per address spare others


def frame(kind, flags, stream, payload=b""):
    return struct.pack(">I", len(payload))[1:] + struct.pack(">BBI", kind, flags, stream) + payload


def hpack_integer(value, bits, first=0):
    """RFC 7541, 5.1."""
    top = (1 << bits) - 1
    if value < top:
        return bytes([first | value])
    coded = bytearray([first | top])
    value -= top
    while value >= 128:
        coded.append(value % 128 + 128)
        value //= 128
    coded.append(value)
    return bytes(coded)


def hpack(headers):
    """Literals without indexing and without Huffman's code (RFC 7541, 6.2.2)."""
    coded = b""
    for name, value in headers:
        coded += b"\0" + hpack_integer(len(name), 7) + name.encode()
        coded += hpack_integer(len(value), 7) + value.encode()
    return coded


def grpc_headers(path, *more):
    return hpack([(":method", "POST"), (":scheme", "http"), (":path", path),
                  (":authority", "localhost"), ("te", "trailers"),
                  ("content-type", "application/grpc"), *more])


def grpc_message(data, compressed=False):
    return struct.pack(">BI", compressed, len(data)) + data


class Http2:
    """One connection. `is_open` turns false when the peer hangs up or says GOAWAY."""

    def __init__(self, server, source=SOMEBODY_ELSE, greet=True):
        self.is_open, self.ended = True, set()
        self._received, self._window, self._stream_window = b"", WINDOW_BYTES, {}
        self._first_window = WINDOW_BYTES
        try:
            self.socket = self._connect(server, source, secure=server.ca and greet)
        except OSError:  # the server refused
            self.socket, self.is_open = socket.socket(), False
        if greet:
            self.write(PREFACE + frame(SETTINGS, 0, 0))

    @staticmethod
    def _connect(server, source, secure):
        host, port = server.address.rsplit(":", 1)
        connection = socket.create_connection((host, int(port)), 10, (source, 0))
        if not secure:
            return connection
        trust = ssl.create_default_context(cadata=server.ca)
        trust.set_alpn_protocols(["h2"])
        return trust.wrap_socket(connection, server_hostname="localhost")

    def write(self, data):
        try:
            self.socket.sendall(data)
        except OSError:
            self.is_open = False

    def send(self, kind, flags, stream, payload=b""):
        self.write(frame(kind, flags, stream, payload))

    def send_data(self, stream, data, wait_s=10):
        """Sends as the peer's windows allow. Returns false if it does not take everything."""
        end = time.monotonic() + wait_s
        sent = 0
        while sent < len(data) and self.is_open and stream not in self.ended:
            room = min(self._window, self._stream_window.get(stream, 0) + self._first_window,
                       FRAME_BYTES_MAX, len(data) - sent)
            if room <= 0:
                if time.monotonic() > end:
                    return False
                self.listen(0.05)
                continue
            last = END_STREAM if sent + room == len(data) else 0
            self.send(DATA, last, stream, data[sent:sent + room])
            sent += room
            self._window -= room
            self._stream_window[stream] = self._stream_window.get(stream, 0) - room
            self.listen(0)
        return sent == len(data)

    def listen(self, wait_s):
        """Reads waiting frames and answers SETTINGS and PING."""
        while self.is_open and self._has_news(wait_s):
            wait_s = 0
            try:
                received = self.socket.recv(1 << 20)
            except OSError:
                received = b""
            if not received:
                self.is_open = False
            self._received += received
            self._take_frames()

    def _has_news(self, wait_s):
        unpacked = isinstance(self.socket, ssl.SSLSocket) and self.socket.pending()
        return unpacked or select.select([self.socket], [], [], wait_s)[0]

    def wait_for_end(self, stream, wait_s):
        """Returns whether the call has ended within the time, well or not."""
        end = time.monotonic() + wait_s
        while self.is_open and stream not in self.ended and time.monotonic() < end:
            self.listen(0.05)
        return stream in self.ended or not self.is_open

    def _take_frames(self):
        while len(self._received) >= 9:
            size = int.from_bytes(self._received[:3], "big")
            if len(self._received) < 9 + size:
                return
            kind, flags, stream = struct.unpack(">BBI", self._received[3:9])
            self._take(kind, flags, stream & 0x7FFFFFFF, self._received[9:9 + size])
            self._received = self._received[9 + size:]

    def _take(self, kind, flags, stream, payload):
        if kind == SETTINGS and not flags & ACK:
            for at in range(0, len(payload), 6):
                name, value = struct.unpack(">HI", payload[at:at + 6])
                if name == SETTINGS_INITIAL_WINDOW_SIZE:
                    self._first_window = value
            self.send(SETTINGS, ACK, 0)
        elif kind == PING and not flags & ACK:
            self.send(PING, ACK, 0, payload)
        elif kind == WINDOW_UPDATE:
            more = struct.unpack(">I", payload)[0]
            if stream == 0:
                self._window += more
            else:
                self._stream_window[stream] = self._stream_window.get(stream, 0) + more
        elif kind == RST_STREAM or (kind in (DATA, HEADERS) and flags & END_STREAM):
            self.ended.add(stream)
        elif kind == GOAWAY:
            self.is_open = False

    def close(self):
        self.socket.close()
