"""A client of Burnish, written from docs/protocol.md and the comments in proto/ alone."""

import queue
import zlib

import grpc
import numpy as np

from burnish.formats.pages import read_head, read_page
from burnish.formats.wire import require
from burnish.v1 import common_pb2, editing_pb2, editing_pb2_grpc, library_pb2, library_pb2_grpc

PATIENCE_S = 120  # a call that takes longer counts as hanging
CHUNK_BYTES = 1 << 20
PAGES_AT_ONCE = 64


def join_chunks(chunks):
    data = b""
    for chunk in chunks:
        require(chunk.offset == len(data), "a gap between chunks")
        require(chunk.crc32 == zlib.crc32(chunk.data), "a damaged chunk")
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
        """Calls an RPC with one message. Returns its answer, or the stream of its answers."""
        return method(request, metadata=self.metadata, timeout=PATIENCE_S)

    def import_scan(self, name, ply, depth=0, sha256="", damage=lambda chunk: None,
                    mesh_format=common_pb2.MESH_FORMAT_PLY):
        """Returns the events. `damage` may change the chunks."""
        requests = queue.SimpleQueue()
        requests.put(library_pb2.ImportRequest(header=library_pb2.ImportHeader(
            name=name, format=mesh_format, size_bytes=len(ply), sha256=sha256,
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

    def describe_pages(self, scan_id):
        """Returns the head of a scan's pages."""
        request = library_pb2.DescribePagesRequest(scan=scan_id)
        events = list(self.call(self.library.DescribePages, request))
        return read_head(events[-1].done.head)

    def fetch_pages(self, scan_id, numbers):
        """Returns pages by their numbers."""
        pages = {}
        for begin in range(0, len(numbers), PAGES_AT_ONCE):
            request = library_pb2.FetchPagesRequest(scan=scan_id,
                                                    pages=numbers[begin:begin + PAGES_AT_ONCE])
            for event in self.call(self.library.FetchPages, request):
                pages[event.page.number] = read_page(event.page.data)
        return pages

    def page_values(self, session, value, numbers):
        """Returns a value per vertex, by page."""
        request = editing_pb2.GetPageValuesRequest(session=session.id, value=value, pages=numbers)
        return {event.page: (event.low, event.high, np.frombuffer(event.steps, np.uint8))
                for event in self.call(self.editing.GetPageValues, request)}

    def apply(self, session, *edits):
        request = editing_pb2.ApplyRequest(session=session.id, edits=edits)
        return self.call(self.editing.Apply, request)

    def upload_cells(self, session, edit_id, cells, announced=None):
        count = len(cells) if announced is None else announced
        header = editing_pb2.CellFieldsHeader(session=session.id, edit_id=edit_id, cells=count)
        return self.call(self.editing.UploadCellFields, iter([
            editing_pb2.UploadCellFieldsRequest(header=header),
            editing_pb2.UploadCellFieldsRequest(cells=editing_pb2.SetCellFields(cells=cells))]))

    def export(self, session, **until):
        """Returns the file and its summary."""
        request = editing_pb2.ExportRequest(session=session.id, format=common_pb2.MESH_FORMAT_PLY,
                                            **until)
        events = list(self.call(self.editing.Export, request))
        return (join_chunks(event.chunk for event in events if event.HasField("chunk")),
                events[-1].summary)

    def history(self, session, page):
        """Returns all entries; asks for `page` at a time."""
        after = 0
        while True:
            request = editing_pb2.GetHistoryRequest(session=session.id, after=after, count=page)
            response = self.call(self.editing.GetHistory, request)
            yield from response.entries
            if response.complete:
                return
            after = response.entries[-1].number
