"""A live session: one stream of Edit (docs/protocol.md, section 5)."""

import queue

from burnish.v1 import editing_pb2
from frame import FrameDecoder, MissingReference, read_frame_header
from layout import VERTICES, Layout


class LiveSession:
    """Decodes frames as they come, and names them in the next credit."""

    def __init__(self, client, session, view, content, triangles_max=0):
        self._requests = queue.SimpleQueue()
        self._call = client.call(client.editing.Edit, iter(self._requests.get, None))
        self._decoded = []
        self.view = view
        self.headers = []  # of the decoded frames
        self.frame = None  # the newest message
        self.is_shown = False  # the newest message was decoded
        self.send(greeting=editing_pb2.Greeting(session=session.id, content=content,
                                                triangles_max=triangles_max))
        self.welcome = self.receive("welcome")
        self.layout = Layout(view, self.welcome.content - 1)
        self.decoder = FrameDecoder(self.layout)

    def send(self, **message):
        self._requests.put(editing_pb2.ClientMessage(**message))

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
        """Waits until the surface with this many edits and previews is at rest."""
        return self.receive_frame(lambda frame: (
            frame.state == editing_pb2.SOLVE_STATE_SETTLED and frame.edits >= edits and
            frame.previews >= previews), **credit)

    def positions(self):
        """Returns the positions of the view's vertices in the newest frame."""
        if self.layout.content == VERTICES:
            return self.view.positions(self.decoder.displacements(len(self.view.homes)))
        at_corners = self.decoder.displacements(len(self.view.corners))
        return self.view.positions(self.view.interpolate(at_corners))

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
