"""A live session: one stream of Edit (docs/protocol.md, section 5)."""

import queue

from burnish.formats.frames import MissingReference, read_frame_header
from burnish.v1 import editing_pb2
from shown import Scan


class LiveSession:
    """Decodes frames as they come, and names them in the next credit. Shows nothing at first."""

    def __init__(self, client, session, kind=editing_pb2.FRAME_KIND_UNSPECIFIED):
        self._requests = queue.SimpleQueue()
        self._call = client.call(client.editing.Edit, iter(self._requests.get, None))
        self._decoded = []
        self.headers = []  # of the decoded frames
        self.frame = None  # the newest message
        self.is_shown = False  # the newest message was decoded
        self.scan = Scan(client, session)
        self.decoder = self.scan.decoder()
        self.send(greeting=editing_pb2.Greeting(session=session.id, kind=kind, pages=True, held=True))
        self.welcome = self.receive("welcome")

    def send(self, **message):
        self._requests.put(editing_pb2.ClientMessage(**message))

    def show(self, added, removed=()):
        """Shows other pages from the next frames on."""
        self.scan.fetch(added)
        revision = self.decoder.show(added, removed)
        self.send(show_pages=editing_pb2.ShowPages(revision=revision, added=added,
                                                   removed=removed))
        return revision

    def receive(self, kind):
        """Returns the next message of this kind."""
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
        """Grants a credit for each frame until `is_wanted` accepts one."""
        while True:
            self.grant(**credit)
            frame = self.receive("frame")
            if self.is_shown and is_wanted(frame):
                return frame

    def settle(self, edits=0, previews=0, **credit):
        """Waits until the surface with this many edits and previews is at rest, and all pages that
        were asked for are shown."""
        return self.receive_frame(lambda frame: (
            frame.state == editing_pb2.SOLVE_STATE_SETTLED and frame.edits >= edits and
            frame.previews >= previews and len(self.decoder.revisions) == 1), **credit)

    def displacements(self):
        """Returns the displacements of the shown pages' vertices in the newest frame, by page."""
        return {page: self.decoder.displacements(page) for page in self.decoder.state}

    def leave(self):
        """Closes this side. Returns the remaining messages and the call's status."""
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
        except MissingReference:
            self.is_shown = False
            sequence = read_frame_header(frame.data).sequence
            self.send(credit=editing_pb2.Credit(refused=[sequence]))
