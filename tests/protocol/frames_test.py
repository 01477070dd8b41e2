"""Frames and the credits for them (docs/protocol.md, sections 5 and 7)."""

import hashlib
import unittest

import numpy as np

import edits
import scan
from burnish.v1 import editing_pb2
from frame import FrameDecoder
from layout import Layout
from served import Served

STEP = 1 / 256  # cells
CONTENTS = {"coefficients": editing_pb2.FRAME_CONTENT_COEFFICIENTS,
            "vertices": editing_pb2.FRAME_CONTENT_VERTICES}


class Frames(Served):
    def test_both_sides_compute_the_same_layout(self):
        session = self.open()
        for content in CONTENTS.values():
            for triangles_max in (0, 3000):
                live = self.join(session, content, triangles_max)
                self.assertEqual(live.welcome.content, content)
                self.assertEqual(live.layout.fingerprint, live.welcome.layout_fingerprint)

    def test_settled_frames_are_the_exported_surface(self):
        """Key frames and differences are within half a step after sliders, a curve and a stroke."""
        path = self.vertices[np.argsort(self.vertices[:, 0])[:400:10]]
        for name, content in CONTENTS.items():
            session = self.open(f"{self.id()} {name}")
            live = self.join(session, content)
            live.settle()
            self.assertEqual(live.headers[0].reference, 0)
            np.testing.assert_allclose(live.positions(), self.vertices, atol=1e-5)
            for change in (edits.slider(0.2), edits.curve((-3, 20), (3, 80)),
                           edits.stroke(path, radius=2, beta=2.5)):
                before = len(live.headers)
                live.grant()  # for a frame of the first cycle, while the surface moves
                live.settle(live.apply(change).edits)
                self.assertTrue(all(header.reference for header in live.headers[before:]))
                self.assertCurrent(live, session)
            moving = [header.step_shift for header in live.headers if header.step_shift]
            self.assertEqual(set(moving), {2}, "1/64 cell while it moves")

    def assertCurrent(self, live, session):
        """An export relaxes the surface a little further; the next frame shows the same surface."""
        cycles = live.frame.cycles
        ply, summary = self.client.export(session)
        self.assertEqual(hashlib.sha256(ply).hexdigest(), summary.sha256)
        live.receive_frame(lambda frame: frame.cycles == cycles + summary.cycles and
                           frame.state == editing_pb2.SOLVE_STATE_SETTLED)
        exported, triangles = scan.read_ply(ply)
        np.testing.assert_array_equal(triangles, self.triangles)
        cell_size = live.view.cell_size
        moved = np.abs(exported - self.vertices).max() / cell_size
        off = np.abs(live.positions() - exported).max() / cell_size
        self.assertGreater(moved, 8 * STEP)
        self.assertLess(off, STEP / 2 + 1e-5)

    def test_moving_frames_of_both_contents_are_as_near_as_their_steps(self):
        session = self.open()
        both = [self.join(session, content) for content in CONTENTS.values()]
        for frame_bytes, step_shift, change in (
                (0, 2, edits.slider(0.2)), (1000, 6, edits.curve((-3, 2), (3, 150)))):
            for live in both:
                live.settle()
                live.grant(frame_bytes=frame_bytes)
                live.send(heartbeat=editing_pb2.Heartbeat())
                live.receive("heartbeat")  # so the server also has the credit
            both[0].send(apply=editing_pb2.ApplyEdits(edits=[change]))
            frames = [live.receive("frame") for live in both]
            self.assertEqual(frames[0].cycles, frames[1].cycles)
            self.assertEqual([live.headers[-1].step_shift for live in both], [step_shift] * 2)
            off = np.abs(both[0].positions() - both[1].positions()).max() / both[0].view.cell_size
            step = 2**step_shift * STEP
            self.assertLess(off, (step + STEP / 2) + (step / 2 + STEP / 2))
            self.assertGreater(off, STEP)

    def test_small_frames_are_coarser_and_end_exact(self):
        session = self.open()
        live = self.join(session)
        live.settle()
        live.grant(frame_bytes=1000)
        outcome = live.apply(edits.slider(0))
        live.settle(outcome.edits, frame_bytes=1000)
        steps = [header.step_shift for header in live.headers]
        self.assertEqual(max(steps), 6, steps)
        self.assertGreater(steps.count(0), 2, "the still surface comes in parts")
        self.assertCurrent(live, session)

    def test_a_frame_that_shows_nothing_new_has_no_data(self):
        session = self.open()
        live = self.join(session)
        cycles = live.settle().cycles
        summary = self.client.export(session, cycles=3)[1]
        frame = live.receive_frame(lambda frame: frame.cycles == cycles + summary.cycles)
        self.assertEqual(frame.data, b"")

    def test_a_frame_whose_reference_was_lost_is_refused_and_a_key_frame_comes(self):
        session = self.open()
        live = self.join(session)
        live.settle()
        live.decoder.forget()
        live.settle(live.apply(edits.slider(0.2)).edits)
        self.assertEqual([header.reference for header in live.headers].count(0), 2)
        self.assertCurrent(live, session)

    def test_who_holds_nothing_asks_for_a_key_frame(self):
        live = self.join(self.open())
        live.settle()
        live.decoder.forget()
        live.grant(key_frame=True)
        live.receive("frame")
        self.assertEqual(live.headers[-1].reference, 0)
        self.assertEqual(len(live.headers), 2)

    def test_until_a_frame_is_named_all_are_key_frames(self):
        live = self.join(self.open())
        for beta in (0.5, 0.2):
            live.apply(edits.slider(beta))
            live.send(credit=editing_pb2.Credit(frames=1))
            live.receive("frame")
        self.assertEqual([header.reference for header in live.headers], [0, 0])

    def test_a_watcher_gets_key_frames_without_asking(self):
        session = self.open()
        view = self.client.fetch_view(session)
        request = editing_pb2.WatchRequest(greeting=editing_pb2.Greeting(session=session.id))
        messages = self.client.call(self.client.editing.Watch, request)
        self.addCleanup(messages.cancel)
        welcome = next(message.welcome for message in messages if message.HasField("welcome"))
        decoder = FrameDecoder(Layout(view, welcome.content - 1))
        outcome = self.client.apply(session, edits.slider(0.2))
        for message in messages:
            if message.frame.data:
                self.assertEqual(decoder.decode(message.frame.data).reference, 0)
            if message.HasField("frame") and message.frame.edits == outcome.edits:
                return
        self.fail("the stream ended")


if __name__ == "__main__":
    unittest.main()
