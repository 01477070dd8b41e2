"""Pages, frames and the credits for them (docs/protocol.md, sections 5 and 7)."""

import hashlib
import unittest

import numpy as np

import edits
import scan
from burnish.v1 import editing_pb2
from served import DEPTH, Served
from shown import match

STEP = 1 / 256  # cells
KINDS = {"corners": editing_pb2.FRAME_KIND_CORNERS, "vertices": editing_pb2.FRAME_KIND_VERTICES}


class Frames(Served):
    def test_settled_frames_are_the_exported_surface(self):
        """Key frames and differences are right after sliders, a curve and a stroke."""
        path = self.vertices[np.argsort(self.vertices[:, 0])[:400:10]]
        for name, kind in KINDS.items():
            session = self.open(f"{self.id()} {name}")
            live = self.join(session, kind)
            live.settle()
            self.assertEqual(live.headers[0].reference, 0)
            for moved in live.displacements().values():
                np.testing.assert_array_equal(moved, 0)
            for change in (edits.slider(0.2), edits.curve((-3, 20), (3, 80)),
                           edits.stroke(path, radius=2, beta=2.5)):
                before = len(live.headers)
                live.grant()  # for a frame of the first cycle, while the surface moves
                live.settle(live.apply(change).edits)
                self.assertTrue(all(header.reference for header in live.headers[before:]))
                self.assertCurrent(live, session)

    def assertCurrent(self, live, session):
        """An export relaxes the surface a little further; the next frame shows the same surface."""
        cycles = live.frame.cycles
        ply, summary = self.client.export(session)
        self.assertEqual(hashlib.sha256(ply).hexdigest(), summary.sha256)
        live.receive_frame(lambda frame: frame.cycles == cycles + summary.cycles and
                           frame.state == editing_pb2.SOLVE_STATE_SETTLED)
        exported, triangles = scan.read_ply(ply)
        np.testing.assert_array_equal(triangles, self.triangles)
        moves = (exported - self.vertices) / live.scan.cell_size
        self.assertGreater(np.abs(moves).max(), 8 * STEP)
        header = live.headers[-1]
        self.assertAlmostEqual(header.largest_move, np.linalg.norm(moves, axis=1).max(), delta=STEP)
        for page, moved in live.displacements().items():
            # A page's vertex is up to half a lattice step from the scan's, where the move is another.
            self.assertLess(np.abs(moved - moves[self.vertices_of(live, page)]).max(), 4 * STEP)

    def vertices_of(self, live, page):
        """Returns the scan's vertex of each vertex of a page of level 0."""
        head = live.scan.head
        places = head.places(live.scan.pages[page].positions)
        return match(places, self.vertices[:-1], head.side / (1 << head.bits))

    def test_frames_of_both_kinds_are_the_same_surface_on_pages_of_each_level(self):
        session = self.open()
        both = [self.join(session, kind, []) for kind in KINDS.values()]
        pages = list(range(both[0].scan.head.page_count))
        change = both[0].apply(edits.curve((-3, 2), (3, 150)), edits.slider(0.2))
        for live in both:
            live.show(pages)
            live.settle(change.edits)
        for page in pages:
            corners, vertices = (live.displacements()[page] for live in both)
            self.assertLess(np.abs(corners - vertices).max(), STEP)

    def test_borders_of_pages_have_no_cracks(self):
        live = self.join(self.open(), editing_pb2.FRAME_KIND_VERTICES)
        edited = live.apply(edits.slider(0), edits.curve((-3, 2), (3, 150))).edits
        live.receive_frame(lambda frame: frame.edits >= edited, frame_bytes=1000)
        shared, moves = 0, {}
        for page, moved in live.displacements().items():
            for place, move in zip(live.scan.pages[page].positions.tolist(), moved.tolist()):
                shared += tuple(place) in moves
                self.assertEqual(moves.setdefault(tuple(place), move), move)
        self.assertGreater(shared, 0)

    def test_a_page_comes_with_the_next_frame_and_goes_for_nothing(self):
        live = self.join(self.open(), pages=[])
        edited = live.apply(edits.slider(0.2)).edits
        first, second = live.scan.level_0[:2]
        for added, removed, sent in ([first], [], [first]), ([second], [first], [second]), (
                [], [second], []):
            revision = live.show(added, removed)
            live.settle(edited)
            self.assertEqual((live.headers[-1].revision, live.headers[-1].sent), (revision, sent))
            self.assertEqual(live.headers[-1].step_shift, 0)
            self.assertEqual(sorted(live.displacements()), sorted(added))

    def test_a_dab_sends_only_the_pages_that_it_touches(self):
        live = self.join(self.open())
        live.settle()
        before = len(live.headers)
        live.settle(live.apply(edits.stroke(self.vertices[:1], radius=1, beta=0)).edits)
        self.assertGreater(len(live.headers), before)
        for header in live.headers[before:]:
            self.assertLess(len(header.sent), len(live.scan.level_0))

    def test_small_frames_are_coarser_and_end_exact(self):
        session = self.open()
        live = self.join(session)
        live.settle(frame_bytes=1000)
        outcome = live.apply(edits.curve((-3, 2), (3, 150)), edits.slider(0))
        live.settle(outcome.edits, frame_bytes=1000)
        steps = [header.step_shift for header in live.headers]
        self.assertEqual(max(steps), 6, steps)
        self.assertEqual(steps[-1], 0)
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

    def test_the_gain_is_above_the_largest_beta(self):
        live = self.join(self.open())
        for beta, gain in (1.0, 0), (1.5, 1), (2.0, 1), (9.0, 4):
            live.settle(live.apply(edits.slider(beta)).edits)
            self.assertEqual({page.gain for page in live.decoder.state.values()}, {gain})

    def test_held_rims_stay_in_frames_of_both_kinds(self):
        """On half of the scan. A new session holds the rim."""
        upper = self.triangles[(self.vertices[self.triangles, 2] > 0).all(axis=1)]
        event = self.client.import_scan("half", scan.write_ply(self.vertices, upper), DEPTH)[-1]
        ways = np.sort(np.concatenate([upper[:, [0, 1]], upper[:, [1, 2]], upper[:, [2, 0]]]), axis=1)
        edges, count = np.unique(ways, axis=0, return_counts=True)
        rim = np.unique(edges[count == 1])
        session = self.client.open_session(event.done.scan.id, self.id(), DEPTH)
        self.addCleanup(self.delete, session)
        for kind in KINDS.values():
            live = self.join(session, kind)
            for pin_rims in True, False:
                change = live.apply(edits.slider(0), edits.curve((-3, 2), (3, 150)),
                                    edits.controls(pin_rims))
                live.settle(change.edits)
                far = [np.abs(moved[np.isin(self.vertices_of(live, page), rim)]).max(initial=0)
                       for page, moved in live.displacements().items()]
                self.assertEqual(max(far) == 0, pin_rims, far)
                names = any(state.held.size for state in live.decoder.state.values())
                self.assertEqual(names, pin_rims and kind == KINDS["corners"])

    def test_a_watcher_gets_key_frames_without_asking(self):
        session = self.open()
        live = self.join(session, pages=[])  # for its pages
        pages = live.scan.level_0
        live.scan.fetch(pages)
        decoder = live.scan.decoder()
        decoder.show(pages, [])
        request = editing_pb2.WatchRequest(
            greeting=editing_pb2.Greeting(session=session.id, pages=True), pages=pages)
        messages = self.client.call(self.client.editing.Watch, request)
        self.addCleanup(messages.cancel)
        outcome = self.client.apply(session, edits.slider(0.2))
        for message in messages:
            if message.frame.data:
                frame = decoder.decode(message.frame.data)
                self.assertEqual((frame.reference, frame.revision), (0, 1))
            if message.HasField("frame") and message.frame.edits == outcome.edits:
                return
        self.fail("the stream ended")


if __name__ == "__main__":
    unittest.main()
