"""Live sessions: frames, slow readers, servers that come back."""

import threading
import unittest

import numpy as np

import burnish
from burnish.live import Live
from sdk import Sdk
from shown import match

CURVE = burnish.TransferCurve({-3.0: 20.0, 3.0: 80.0})


class LiveSessions(Sdk):
    def join(self, session, **options):
        live = session.live(**options)
        self.addCleanup(live.close)
        return live

    def vertices_of(self, live):
        """Returns the scan's vertex of each vertex of the frames of level 0."""
        return match(live.original.vertices, self.mesh.vertices[:-1], live.lattice_step)

    def test_frames_at_rest_are_within_a_64th_of_a_cell_of_the_export(self):
        session = self.open()
        live = self.join(session)
        vertices = self.vertices_of(live)
        path = self.mesh.vertices[np.argsort(self.mesh.vertices[:, 0])[:400:10]]
        for change in (burnish.GradientScale(0.2), CURVE,
                       burnish.Stroke(burnish.Brush(2, beta=2.5), path)):
            live.apply(change)
            live.settle()
            session.export(self.folder / "out.ply", cycles=1)
            exported = burnish.load_ply(self.folder / "out.ply").vertices
            moves = live.next_frame().displacements
            expected = (exported - self.mesh.vertices)[vertices]
            self.assertGreater(np.abs(expected).max(), self.cell_size / 8)
            self.assertLess(np.abs(moves - expected).max(), self.cell_size / 64)

    def test_the_surface_before_all_edits_is_the_scan(self):
        live = self.join(self.open())
        vertices = self.vertices_of(live)
        self.assertEqual(set(vertices.tolist()), set(range(len(self.mesh.vertices) - 1)))
        faces = np.sort(vertices[live.faces], axis=1)
        self.assertEqual(set(map(tuple, faces.tolist())),
                         set(map(tuple, np.sort(self.mesh.faces, axis=1).tolist())))
        frame = live.settle()
        np.testing.assert_array_equal(frame.vertices, live.original.vertices)

    def test_frames_come_in_the_scans_own_order(self):
        session = self.open()
        live = self.join(session, vertices=self.mesh.vertices)
        np.testing.assert_array_equal(live.settle().vertices, self.mesh.vertices)
        np.testing.assert_array_equal(np.unique(np.sort(live.faces, axis=1), axis=0),
                                      np.unique(np.sort(self.mesh.faces, axis=1), axis=0))
        live.apply(burnish.GradientScale(0.2), CURVE)
        frame = live.settle()
        exported = session.mesh().vertices
        self.assertGreater(np.abs(exported - self.mesh.vertices).max(), self.cell_size / 8)
        self.assertLess(np.abs(frame.vertices - exported).max(), self.cell_size / 64)
        shuffled = np.random.default_rng(1).permutation(len(self.mesh.vertices))
        live = self.join(session, vertices=np.float32(self.mesh.vertices[shuffled]))
        self.assertLess(np.abs(live.settle().vertices - exported[shuffled]).max(),
                        self.cell_size / 64)

    def test_vertices_of_another_mesh_are_refused(self):
        session = self.open()
        with self.assertRaisesRegex(ValueError, r"vertices has none at \d+ of \d+ places"):
            session.live(vertices=self.mesh.vertices * 1.01)
        with self.assertRaisesRegex(ValueError, r"vertices.*\(n, 3\)"):
            session.live(vertices=self.mesh.vertices[:, :2])

    def test_a_poll_returns_the_newest_frame_or_none(self):
        live = self.join(self.open())
        live.apply(burnish.GradientScale(0.2))
        frames = []
        while not frames or not (frames[-1].settled and frames[-1].edits == 1):
            frames += filter(None, [live.poll()])
        self.assertEqual(len(set(map(id, frames))), len(frames))
        while live.poll() is not None:  # a surface at rest sends no more
            pass
        live.close()
        with self.assertRaises(burnish.SessionEnded):
            live.poll()

    def test_a_callback_has_each_new_frame_until_the_session_is_closed(self):
        live, frames, at_rest = self.join(self.open()), [], threading.Event()

        def take(frame):
            frames.append(frame)
            if frame.settled and frame.edits == 1:
                at_rest.set()
        live.on_frame(take)
        live.apply(burnish.GradientScale(0.2))
        self.assertTrue(at_rest.wait(300))
        live.close()
        count = len(frames)
        self.assertGreater(np.abs(frames[-1].displacements).max(), self.cell_size / 8)
        with self.assertRaises(burnish.SessionEnded):
            live.apply(burnish.GradientScale(0.5))
        self.assertEqual(len(frames), count)

    def test_a_callback_may_close_the_session(self):
        live, closed = self.join(self.open()), threading.Event()

        def close(_):
            live.close()
            closed.set()
        live.on_frame(close)
        self.assertTrue(closed.wait(300))
        with self.assertRaises(burnish.SessionEnded):
            live.poll()

    def test_weights_of_vertices_set_the_cells_of_the_surface(self):
        session = self.open()
        vertices = self.mesh.vertices
        live = self.join(session, vertices=vertices)
        betas = np.where(vertices[:, 2] > 0, 0.25, np.nan)
        fields = live.cell_fields(betas, alpha=50)
        session.apply(fields)
        set_cells = session.cells("beta")
        self.assertEqual(np.count_nonzero(set_cells == 0.25), len(fields.cells))
        self.assertEqual(np.count_nonzero(set_cells == 1), len(set_cells) - len(fields.cells))
        self.assertLess(abs(2 * len(fields.cells) / len(set_cells) - 1), 0.1)
        moves = np.abs(live.settle().displacements).max(axis=1)
        self.assertGreater(moves[vertices[:, 2] > 2].max(), self.cell_size / 8)
        self.assertLess(moves[vertices[:, 2] < -4].max(), moves[vertices[:, 2] > 2].max() / 8)
        whole = live.cell_fields(np.ones(len(vertices)), 50)
        self.assertGreater(len(whole.cells), 0.9 * len(set_cells))
        with self.assertRaisesRegex(ValueError, "no triangle is without NaN"):
            live.cell_fields(np.nan, 50)
        session.set_alpha(20)
        self.assertEqual(set(live.cell_fields(0.1).alpha1), {20})
        session.apply(live.cell_fields(10))  # the most that a beta may be
        session.apply(CURVE)
        with self.assertRaisesRegex(burnish.FailedPrecondition, "2 points.*alpha"):
            live.cell_fields(0.5)
        with self.assertRaisesRegex(ValueError, r"beta.*\(3,\).*\(\d+,\)"):
            live.cell_fields([1, 2, 3], 50)

    def test_weights_of_vertices_paint_kept_edges(self):
        session = self.open()
        vertices = self.mesh.vertices
        live = self.join(session, vertices=vertices)
        strengths = np.where(vertices[:, 2] > 0, 1, np.nan)
        edit = live.cell_edges(strengths)
        self.assertTrue((np.asarray(edit.strength) == 1).all())
        for apply in (live.apply, session.apply):  # as one message, and as an upload
            entry, = apply(edit)
            moves = np.abs(live.settle().displacements).max(axis=1)
            self.assertGreater(moves[vertices[:, 2] > 2].max(), 8 * moves[vertices[:, 2] < -2].max())
            self.assertRegex(next(one.summary for one in session.history() if one.number == entry),
                             r"^edges kept in \d+ cells$")
            session.undo()
            live.settle()
        session.apply(burnish.Equaliser([burnish.Band(1, 2)]))
        with self.assertRefused(burnish.FailedPrecondition, "bands", "kept edges"):
            session.apply(edit)
        with self.assertRaisesRegex(ValueError, r"strength has 1\.5: .*0 to 1"):
            live.cell_edges(1.5)

    def test_weights_of_vertices_paint_the_texture_gain_of_a_scan_with_colours(self):
        live = self.join(self.open(), vertices=self.mesh.vertices)
        edit = live.cell_texture(np.where(self.mesh.vertices[:, 2] > 0, 3, np.nan))
        self.assertTrue((np.asarray(edit.gain) == 3).all())
        with self.assertRefused(burnish.FailedPrecondition, "no colours"):
            live.apply(edit)
        with self.assertRaisesRegex(ValueError, r"gain has 4\.5: .*0 to 4"):
            live.cell_texture(4.5)

    def test_weights_of_vertices_protect_and_release(self):
        session = self.open()
        vertices = self.mesh.vertices
        live = self.join(session, vertices=vertices)
        live.apply(live.cell_protection(vertices[:, 2] > 0), burnish.GradientScale(0))
        held = np.count_nonzero(session.cells("protected"))
        self.assertLess(abs(2 * held / len(session.cells("protected")) - 1), 0.1)
        moves = np.abs(live.settle().displacements).max(axis=1)
        self.assertEqual(moves[vertices[:, 2] > 2].max(), 0)
        self.assertGreater(moves[vertices[:, 2] < -2].max(), self.cell_size / 8)
        session.apply(live.cell_protection(np.where(vertices[:, 2] > 4, 0.25, np.nan)))  # releases
        self.assertLess(np.count_nonzero(session.cells("protected")), held)
        session.apply(burnish.ClearProtected())
        self.assertFalse(session.cells("protected").any())
        session.undo()
        self.assertTrue(session.cells("protected").any())
        with self.assertRaisesRegex(ValueError, r"weights has -1: .*0 to 1"):
            live.cell_protection(-1)

    def test_a_coarse_level_has_fewer_triangles(self):
        session = self.open()
        fine, coarse = self.join(session), self.join(session, triangles_max=5000)
        self.assertEqual(len(fine.faces), len(self.mesh.faces))
        self.assertLess(len(coarse.faces), 7000)
        coarse.apply(burnish.GradientScale(0.2))
        self.assertEqual(len(coarse.settle().vertices), len(coarse.original.vertices))
        with self.assertRefused(burnish.ResourceExhausted, "99"):
            session.live(level=99)

    def test_frames_end_with_the_surface_at_rest(self):
        live = self.join(self.open())
        number, = live.apply(burnish.GradientScale(0.2))
        frames = list(live.frames())
        self.assertTrue(frames[-1].settled)
        self.assertEqual(frames[-1].edits, number)
        self.assertGreater(frames[-1].cycles, 0)
        self.assertEqual(list(live.frames()), [])

    def test_a_gesture_is_shown_and_kept_on_demand(self):
        session = self.open()
        live = self.join(session)
        live.settle()
        with live.gesture() as gesture:
            gesture.show(burnish.GradientScale(0))
            while np.abs(live.next_frame().displacements).max() < self.cell_size / 8:
                pass
        while np.abs(live.next_frame().displacements).max() > self.cell_size / 64:
            pass
        self.assertEqual(list(session.history()), [])
        with live.gesture() as gesture:
            gesture.show(burnish.GradientScale(0))
            number = gesture.keep(burnish.GradientScale(0.1))
        self.assertEqual([entry.number for entry in session.history()], [number])
        with self.assertRaises(ValueError):
            live.gesture().show(burnish.Controls())

    def test_a_refused_edit_is_an_exception_and_the_session_goes_on(self):
        live = self.join(self.open())
        with self.assertRefused(burnish.InvalidArgument, "beta", "11", "10"):
            live.apply(burnish.GradientScale(11))
        self.assertEqual(live.apply(burnish.GradientScale(0.5)), [1])

    def test_a_slow_reader_holds_nobody_up_and_stays_alive(self):
        """The reader takes no frame while heartbeats go on, and an editor works beside it."""
        session = self.open()
        slow = Live(session._calls, session._info, triangles_max=1 << 20, level=None,
                    heartbeat_seconds=0.02)
        self.addCleanup(slow.close)
        slow.settle()
        editor = self.join(session)
        for beta in range(10):
            editor.apply(burnish.GradientScale(beta / 10))
            editor.settle()
        slow.wait_for_heartbeats(20)
        self.assertLessEqual(slow.waiting_frames, 1)
        slow.next_frame()
        slow.apply(burnish.GradientScale(0.95))
        self.assertEqual(slow.settle().edits, 11)

    def test_people_are_there_with_their_roles(self):
        session, anna = self.open(), self.connect("Anna")
        session.set_role("Anna", "viewer")
        self.join(session)
        self.join(anna.session(session.id))
        people = session.people()
        self.assertEqual((people.roles["Anna"], people.present), ("viewer", ["Zoë", "Anna"]))
        with self.assertRaises(burnish.PermissionDenied):
            anna.session(session.id).set_beta(0)
        with self.assertRefused(burnish.InvalidArgument, "king", "owner"):
            session.set_role("Anna", "king")

    def test_a_closed_session_is_over_for_good(self):
        session = self.open()
        live = self.join(session)
        live.settle()
        session.close()
        with self.assertRaises(burnish.SessionEnded):
            live.next_frame()

    def test_closing_wakes_who_waits(self):
        live = self.join(self.open())
        live.settle()
        waiting = threading.Timer(0, live.close)
        waiting.start()
        with self.assertRaises(burnish.SessionEnded):
            live.next_frame()
        waiting.join()

    def test_a_surface_at_rest_sends_nothing(self):
        live = self.join(self.open())
        live.settle()
        with self.assertRaises(burnish.DeadlineExceeded):
            live.next_frame(timeout=0.01)


class Restarted(Sdk):
    def test_a_session_goes_on_when_its_server_was_killed(self):
        session = self.open()
        with session.live() as live:
            live.apply(burnish.GradientScale(0.2))
            live.settle()
            self.server.kill()
            applied = []
            editor = threading.Thread(
                target=lambda: applied.extend(live.apply(burnish.GradientScale(0.4))))
            editor.start()
            self.server.start()
            editor.join()
            self.assertEqual(applied, [2])
            self.assertEqual(live.settle().edits, 2)
        self.assertEqual(session.state().beta, 0.4)  # calls come back too

    def test_who_waits_in_vain_is_told(self):
        server = type(self.server)()
        self.addCleanup(server.close)
        with burnish.connect(f"unix:{server.socket}", patience=0.3) as connection:
            scan = connection.import_scan(self.mesh, depth=4)
            live = connection.open_session(scan, "lost", depth=4).live()
            live.settle()
            server.kill()
            with self.assertRaisesRegex(burnish.Unavailable, "server.sock"):
                live.next_frame()
            with self.assertRaises(burnish.Unavailable):
                connection.scans()
            live.close()
            server.start()


if __name__ == "__main__":
    unittest.main()
