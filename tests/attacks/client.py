"""A client of the protocol that anybody could write: any RPC by its name, and live streams."""

import queue
import zlib

import grpc
from burnish.v1 import editing_pb2, library_pb2

from server import token_of

PATIENCE_S = 60
CHUNK_BYTES = 1 << 20
METHODS = {method.name: method
           for file in (editing_pb2, library_pb2)
           for service in file.DESCRIPTOR.services_by_name.values()
           for method in service.methods}
OPTIONS = [("grpc.max_receive_message_length", -1), ("grpc.max_send_message_length", -1),
           ("grpc.use_local_subchannel_pool", 1)]


def request(method, **fields):
    return METHODS[method].input_type._concrete_class(**fields)


def channel_to(server):
    if not server.ca:
        return grpc.insecure_channel(server.address, OPTIONS)
    trust = grpc.ssl_channel_credentials(server.ca.encode())
    return grpc.secure_channel(server.address, trust, OPTIONS)


def outcome_of(future):
    """Returns the name of a running call's outcome: OK, NOT_FOUND, ..."""
    return future.code().name


def end_of(answers):
    """Does the same for a call with many answers, and reads them."""
    try:
        for _ in answers:
            pass
    except grpc.RpcError as error:
        return error.code().name
    return "OK"


class Client:
    """`user` gives a token if the server has users, else only its name; none: a stranger."""

    def __init__(self, server, user=None):
        self.channel = channel_to(server)
        self.metadata = []
        if user is not None and server.users:
            self.metadata = [("authorization", "Bearer " + token_of(user))]
        elif user is not None:
            name = user if isinstance(user, bytes) else user.encode()
            self.metadata = [("burnish-user-bin", name)]

    def _stub(self, method, kind):
        known = METHODS[method]
        path = "/%s/%s" % (known.containing_service.full_name, method)
        return getattr(self.channel, kind)(path, lambda message: message.SerializeToString(),
                                           known.output_type._concrete_class.FromString)

    def ask(self, method, timeout=PATIENCE_S, **fields):
        """A call with one answer. Raises grpc.RpcError."""
        return self._stub(method, "unary_unary")(request(method, **fields), timeout,
                                                 metadata=self.metadata)

    def start(self, method, timeout=PATIENCE_S, **fields):
        """Does the same without waiting: returns a future."""
        return self._stub(method, "unary_unary").future(request(method, **fields), timeout,
                                                        metadata=self.metadata)

    def read(self, method, timeout=PATIENCE_S, **fields):
        """A call with many answers: an iterator."""
        return self._stub(method, "unary_stream")(request(method, **fields), timeout,
                                                  metadata=self.metadata)

    def send(self, method, requests, timeout=PATIENCE_S):
        """A call with many requests and one answer."""
        return self._stub(method, "stream_unary")(iter(requests), timeout, metadata=self.metadata)

    def talk(self, method, requests, timeout=PATIENCE_S):
        return self._stub(method, "stream_stream")(iter(requests), timeout, metadata=self.metadata)

    def code(self, method, timeout=PATIENCE_S, **fields):
        """Returns only the outcome's name: OK, NOT_FOUND, ..."""
        return self.start(method, timeout, **fields).code().name

    def import_scan(self, name, file, depth=0, sha256=None, format=1, timeout=PATIENCE_S, **more):
        """Returns the scan's id. Raises grpc.RpcError."""
        header = dict(name=name, format=format, size_bytes=len(file), sha256=sha256, depth=depth, **more)
        waiting = queue.Queue()
        waiting.put(request("Import", header=header))
        invited = False
        for event in self.talk("Import", iter(waiting.get, None), timeout):
            if event.HasField("done"):
                return event.done.scan.id
            if event.HasField("received") and not invited:
                invited = True
                for offset in range(event.received.bytes, len(file), CHUNK_BYTES):
                    data = file[offset:offset + CHUNK_BYTES]
                    chunk = dict(offset=offset, data=data, crc32=zlib.crc32(data))
                    waiting.put(request("Import", chunk=chunk))
                waiting.put(None)

    def slide(self, session, edit_id, beta=1.0, timeout=PATIENCE_S):
        """Makes one edit, acknowledged when this returns."""
        return self.ask("Apply", timeout, session=session,
                        edits=[dict(id=edit_id, gradient_scale=dict(beta=beta))])


class Live:
    """A stream of Editing.Edit. Reads only on request."""

    def __init__(self, client, session, timeout=PATIENCE_S):
        self._waiting = queue.Queue()
        self.say(greeting=dict(session=session, pages=True))
        self.answers = client.talk("Edit", iter(self._waiting.get, None), timeout)

    def say(self, **message):
        self._waiting.put(request("Edit", **message))

    def slide(self, edit_id, beta=1.0):
        self.say(apply=dict(edits=[dict(id=edit_id, gradient_scale=dict(beta=beta))]))

    def next(self, *kinds):
        """Returns the next message of one of the kinds. Raises grpc.RpcError or StopIteration."""
        while True:
            message = next(self.answers)
            if message.WhichOneof("message") in kinds:
                return message

    def close(self):
        self._waiting.put(None)
        self.answers.cancel()
