"""A client of Burnish, written from docs/protocol.md and the comments in proto/ alone."""

import itertools
import queue
import zlib

import grpc

import wire
from burnish.v1 import common_pb2, editing_pb2, editing_pb2_grpc, library_pb2, library_pb2_grpc

PATIENCE_S = 120  # how long a call may take before it counts as hanging
CHUNK_BYTES = 1 << 20


def join_chunks(chunks):
    data = b""
    for chunk in chunks:
        wire.require(chunk.offset == len(data), "a gap between chunks")
        wire.require(chunk.crc32 == zlib.crc32(chunk.data), "a damaged chunk")
        data += chunk.data
    return data


class Client:
    """`address`: HOST:PORT, or unix:PATH."""

    def __init__(self, address, user=None, token=None):
        self.channel = grpc.insecure_channel(
            address, options=[("grpc.max_receive_message_length", 64 << 20)])
        self.library = library_pb2_grpc.LibraryStub(self.channel)
        self.editing = editing_pb2_grpc.EditingStub(self.channel)
        self.metadata = []
        if user is not None:
            self.metadata.append(("burnish-user-bin", user.encode()))
        if token is not None:
            self.metadata.append(("authorization", "Bearer " + token))

    def close(self):
        self.channel.close()

    def call(self, method, request):
        """Of an RPC that takes one message: its answer, or the stream of its answers."""
        return method(request, metadata=self.metadata, timeout=PATIENCE_S)

    def import_scan(self, name, ply, depth=0, sha256="", damage=lambda chunk: None):
        """Returns the events. `damage` may change the chunks."""
        requests = queue.SimpleQueue()
        requests.put(library_pb2.ImportRequest(header=library_pb2.ImportHeader(
            name=name, format=common_pb2.MESH_FORMAT_PLY, size_bytes=len(ply), sha256=sha256,
            depth=depth)))
        events = self.call(self.library.Import, iter(requests.get, None))
        first = next(events)
        if first.WhichOneof("event") == "received":
            for offset in range(0, len(ply), CHUNK_BYTES):
                piece = ply[offset:offset + CHUNK_BYTES]
                chunk = common_pb2.Chunk(offset=offset, data=piece, crc32=zlib.crc32(piece))
                damage(chunk)
                requests.put(library_pb2.ImportRequest(chunk=chunk))
        requests.put(None)
        return [first, *events]

    def open_session(self, scan, name, depth):
        request = editing_pb2.OpenSessionRequest(scan=scan, name=name, depth=depth)
        return self.call(self.editing.OpenSession, request).session

    def fetch_view(self, session, triangles_max=0):
        """What the frames of a session are of."""
        request = library_pb2.FetchViewRequest(
            scan=session.scan_id, depth=session.depth, curvature_radius=session.curvature_radius,
            triangles_max=triangles_max)
        events = list(self.call(self.library.FetchView, request))
        header = next(event.header for event in events if event.HasField("header"))
        data = join_chunks(event.chunk for event in events if event.HasField("chunk"))
        wire.require(len(data) == header.size_bytes, "the view is cut off")
        return wire.read_view(data)

    def apply(self, session, *edits):
        request = editing_pb2.ApplyRequest(session=session.id, edits=edits)
        return self.call(self.editing.Apply, request)

    def upload_cells(self, session, edit_id, cells, announced=None):
        header = editing_pb2.CellFieldsHeader(
            session=session.id, edit_id=edit_id, cells=len(cells) if announced is None else announced)
        return self.call(self.editing.UploadCellFields, iter([
            editing_pb2.UploadCellFieldsRequest(header=header),
            editing_pb2.UploadCellFieldsRequest(cells=editing_pb2.SetCellFields(cells=cells))]))

    def export(self, session, **until):
        """The file, and its summary."""
        request = editing_pb2.ExportRequest(session=session.id, format=common_pb2.MESH_FORMAT_PLY,
                                            **until)
        events = list(self.call(self.editing.Export, request))
        return (join_chunks(event.chunk for event in events if event.HasField("chunk")),
                events[-1].summary)

    def history(self, session, page):
        """All entries, `page` at a time."""
        after = 0
        while True:
            request = editing_pb2.GetHistoryRequest(session=session.id, after=after, count=page)
            response = self.call(self.editing.GetHistory, request)
            yield from response.entries
            if response.complete:
                return
            after = response.entries[-1].number


class LiveSession:
    """One stream of Edit. Frames are decoded as they come, and named in the next credit."""

    def __init__(self, client, session, view, content, triangles_max=0):
        self._requests = queue.SimpleQueue()
        self._call = client.call(client.editing.Edit, iter(self._requests.get, None))
        self._decoded = []
        self.view = view
        self.headers = []  # of the frames that were decoded
        self.frame = None  # the newest message
        self.is_shown = False  # whether that could be decoded
        self.send(greeting=editing_pb2.Greeting(session=session.id, content=content,
                                                triangles_max=triangles_max))
        self.welcome = self.receive("welcome")
        self.layout = wire.Layout(view, self.welcome.content - 1)
        self.decoder = wire.FrameDecoder(self.layout)

    def send(self, **message):
        self._requests.put(editing_pb2.ClientMessage(**message))

    def receive(self, kind):
        """The next message of this kind."""
        for message in self._call:
            if message.HasField("frame"):
                self._take(message.frame)
            if message.WhichOneof("message") == kind:
                return getattr(message, kind)
        raise EOFError(f"the stream ended without a {kind}")

    def grant(self, frames=1, **credit):
        self.send(credit=editing_pb2.Credit(frames=frames, decoded=self._decoded, **credit))
        self._decoded = []

    def apply(self, *edits):
        self.send(apply=editing_pb2.ApplyEdits(edits=edits))
        return self.receive("acknowledged").outcome

    def preview(self, edit_id, **change):
        self.send(preview=editing_pb2.Preview(edit_id=edit_id, **change))

    def receive_frame(self, is_wanted, **credit):
        """Grants a credit for each frame until one is wanted."""
        while True:
            self.grant(**credit)
            frame = self.receive("frame")
            if self.is_shown and is_wanted(frame):
                return frame

    def settle(self, edits=0, previews=0, **credit):
        """Until the surface with so many edits and previews is at rest."""
        return self.receive_frame(lambda frame: (
            frame.state == editing_pb2.SOLVE_STATE_SETTLED and frame.edits >= edits and
            frame.previews >= previews), **credit)

    def positions(self):
        """Of the view's vertices, as the newest frame has them."""
        if self.layout.content == wire.VERTICES:
            return self.view.positions(self.decoder.displacements(len(self.view.homes)))
        at_corners = self.decoder.displacements(len(self.view.corners))
        return self.view.positions(self.view.interpolate(at_corners))

    def leave(self):
        """Closes this side. Returns the rest of the messages, and how the call ended."""
        self._requests.put(None)
        rest = list(self._call)
        return rest, self._call.code()

    def cancel(self):
        self._requests.put(None)
        self._call.cancel()

    def _take(self, frame):
        self.frame = frame
        try:
            if frame.data:
                self.headers.append(self.decoder.decode(frame.data))
                self._decoded.append(self.headers[-1].sequence)
            self.is_shown = True
        except wire.MissingReference:
            self.is_shown = False
            sequence = wire.read_frame_header(frame.data).sequence
            self.send(credit=editing_pb2.Credit(refused=[sequence]))


edit_ids = (f"python-{number}" for number in itertools.count())


def edit(**change):
    return editing_pb2.Edit(id=next(edit_ids), **change)


def slider(beta):
    return edit(gradient_scale=editing_pb2.SetGradientScale(beta=beta))


def curve(*points):
    points = [editing_pb2.CurvePoint(kappa=kappa, alpha=alpha) for kappa, alpha in points]
    return edit(transfer_curve=editing_pb2.SetTransferCurve(points=points))


def stroke(path, radius, beta):
    brush = editing_pb2.Brush(radius=radius, strength=0.8, beta=beta,
                              fall_off=editing_pb2.FALL_OFF_SMOOTH)
    points = [common_pb2.Point(x=x, y=y, z=z) for x, y, z in path]
    return edit(stroke=editing_pb2.Stroke(brush=brush, path=points))
