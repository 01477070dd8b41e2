"""Edits, and the history of a session."""

import os
import subprocess
import unittest

import numpy as np

import burnish
from sdk import Sdk

COARSE = burnish.TransferCurve.constant(8)


class Edits(Sdk):
    def setUp(self):
        super().setUp()
        self.session = self.open()

    def summaries(self):
        return [entry.summary for entry in self.session.history()]

    def test_each_kind_of_edit_is_in_the_history(self):
        path = self.mesh.vertices[np.argsort(self.mesh.vertices[:, 0])[:50:10]]
        numbers = self.session.apply(
            burnish.GradientScale(0.5), burnish.TransferCurve({-3.0: 20.0, 3.0: 80.0}),
            burnish.Controls(cap=0.5), burnish.Equaliser([burnish.Band(1, 0), burnish.Band(2, 2)]),
            burnish.Palette([burnish.PaletteCurve("edges", COARSE)]),
            burnish.Stroke(burnish.Brush(2, beta=2.5, strength=0.8), path),
            burnish.Stroke(burnish.Brush(2, beta=0.5, band=2), path),
            burnish.Stroke(burnish.Brush(2, curve=1), path),
            burnish.ProtectCurvature(40, 1e9), burnish.GrowProtected(2),
            burnish.InvertProtected(), burnish.ClearProtected(),
            burnish.ProtectPiece(self.mesh.vertices[0]),
            burnish.ProtectLasso(np.eye(4) / 20, [[-1, -1], [1, -1], [0, 1]], release=True))
        self.assertEqual(numbers, list(range(1, 15)))
        self.assertEqual([entry.kind for entry in self.session.history()],
                         ["gradient scale", "transfer curve", "controls", "equaliser", "palette",
                          *["stroke"] * 3, *["protect"] * 6])
        stroke = list(self.session.history())[5]
        self.assertEqual((stroke.name, stroke.details, stroke.radius),
                         ("Sharpen stroke", f"β 2.5, brush strength 0.8, {len(path)} points", 2))
        self.assertEqual({entry.author for entry in self.session.history()}, {"Zoë"})
        state = self.session.state()
        self.assertEqual((state.beta, state.controls.cap, state.edits), (0.5, 0.5, 14))
        self.assertEqual(state.curve.points, {-3.0: 20.0, 3.0: 80.0})
        self.assertEqual(state.bands, [burnish.Band(1, 0), burnish.Band(2, 2)])
        self.assertEqual(state.palette, [burnish.PaletteCurve("edges", COARSE)])
        self.assertEqual(state.colour, burnish.ColourFilter(1))
        self.assertEqual(state.edges.strength, 0)

    def test_edges_are_kept_and_the_state_says_how(self):
        edges = burnish.EdgeFilter(0.5, "edges", 30, 3, 0.25)
        self.session.apply(edges)
        self.assertEqual(self.session.state().edges, edges)
        self.assertEqual([entry.kind for entry in self.session.history()], ["edges"])
        with self.assertRaisesRegex(burnish.FailedPrecondition, "kept"):
            self.session.apply(burnish.Equaliser([burnish.Band(1, 0)]))
        with self.assertRaisesRegex(ValueError, "'median' is not one of bilateral, edges"):
            self.session.apply(burnish.EdgeFilter(filter="median"))
        with self.assertRaisesRegex(burnish.InvalidArgument, "angle 200 is outside 5..120"):
            self.session.apply(burnish.EdgeFilter(edge_angle=200))

    def test_a_proposal_says_the_noise_and_its_filter_is_an_edit(self):
        proposal = self.session.propose_edges()
        self.assertGreater(proposal.mean_edge, 0)
        self.assertGreaterEqual(proposal.noise, 0)
        self.assertEqual(proposal, self.session.propose_edges())
        self.assertEqual(list(self.session.history()), [])
        self.session.apply(proposal.filter)
        self.assertEqual(self.session.state().edges, proposal.filter)
        with self.assertRaisesRegex(burnish.NotFound, "'none'"):
            burnish.scan.propose_edges(self.session._calls, "none")

    def test_a_wrong_type_is_told_with_the_argument_its_value_and_what_it_takes(self):
        for words, make in (
                (("points", "'1'", "TransferCurve.constant"), lambda: burnish.TransferCurve("1")),
                (("alpha", "'8'", "a number"), lambda: self.session.set_alpha("8")),
                (("beta", "None", "a number"), lambda: self.session.set_beta(None)),
                (("radius", "'2'", "a number"), lambda: burnish.Brush("2")),
                (("brush", "2", "a Brush"), lambda: burnish.Stroke(2, [[0, 0, 0]])),
                (("path", "'x'", "numbers"),
                 lambda: self.session.apply(burnish.Stroke(burnish.Brush(2), "x"))),
                (("pin_rims", "'off'", "True or False"), lambda: burnish.Controls("off")),
                (("curve", "'1'", "a TransferCurve"), lambda: burnish.PaletteCurve("a", "1")),
                (("curves[0]", "'a'", "a PaletteCurve"), lambda: burnish.Palette(["a"])),
                (("cells", "1.5", "a whole number"), lambda: burnish.GrowProtected(1.5)),
                (("change", "0.5", "GradientScale(0.5)"), lambda: self.session.apply(0.5)),
                (("change", "InvertProtected", "GradientScale(0.5)"),
                 lambda: self.session.apply(burnish.InvertProtected))):
            with self.assertRaises(TypeError) as raised:
                make()
            for word in words:
                self.assertIn(word, str(raised.exception))
        with self.assertRaisesRegex(ValueError, "'gamma' is not one of beta"):
            self.session.cells("gamma")
        self.assertEqual(self.summaries(), [])

    def test_a_brush_is_connected_unless_it_goes_through(self):
        path = self.mesh.vertices[:1]
        brushes = [burnish.Brush(2), burnish.Brush(2, through=True)]
        self.assertEqual([brush.message().connected for brush in brushes], [True, False])
        self.session.apply(*[burnish.Stroke(brush, path) for brush in brushes])
        self.assertEqual(len(self.summaries()), 2)

    def test_a_brush_paints_one_thing(self):
        self.assertTrue(burnish.Brush(2, 4, texture=True).message().texture)
        self.assertFalse(burnish.Brush(2).message().HasField("paints"))
        with self.assertRaisesRegex(ValueError, "not colour and texture"):
            burnish.Brush(2, colour=True, texture=True).message()
        with self.assertRefused(burnish.FailedPrecondition, "no colours"):
            self.session.apply(burnish.Stroke(burnish.Brush(2, texture=True), self.mesh.vertices[:1]))

    def test_cells_are_set_and_read(self):
        betas = self.session.cells("beta")
        np.testing.assert_array_equal(betas, 1)
        cell = np.floor((self.mesh.vertices[:1] - self.corner()) / self.cell_size)
        self.session.apply(burnish.CellFields(cell, alpha1=50, alpha2=50, beta=[0.25]))
        self.assertEqual(np.flatnonzero(self.session.cells("beta") == 0.25).size, 1)
        with self.assertRefused(burnish.InvalidArgument, "cell 0 0 0"):
            self.session.apply(burnish.CellFields([[0, 0, 0]], 50, 50, 1))

    def corner(self):
        with self.session.live() as live:
            return live.origin

    def test_undo_and_redo_are_about_ones_own(self):
        other = self.connect("Anna").session(self.session.name)
        first = self.session.set_beta(0.5)
        second = other.set_beta(0.2)
        self.assertEqual(self.session.undo(), first)
        self.assertEqual(self.session.state().beta, 0.2)
        self.assertEqual(other.undo(), second)
        self.assertEqual(self.session.state().beta, 1)
        self.assertEqual(self.session.redo(), first)
        self.assertEqual(self.session.state().beta, 0.5)
        with self.assertRefused(burnish.FailedPrecondition):
            self.session.redo()

    def test_states_have_names(self):
        self.session.set_beta(0.5)
        self.session.checkpoint("half")
        number = self.session.set_beta(0)
        self.session.restore("half")
        self.assertEqual(self.session.state().beta, 0.5)
        self.session.switch(number, True)
        self.assertEqual(self.session.state().beta, 0)
        with self.assertRefused(burnish.NotFound, "other"):
            self.session.restore("other")
        fork = self.session.fork(self.id() + " fork", until="half")
        self.addCleanup(self.delete, fork)
        self.assertEqual([entry.summary for entry in fork.history()], ["beta 0.5", "half"])
        coarse = self.session.fork(self.id() + " coarse", depth=5)
        self.addCleanup(self.delete, coarse)
        self.assertEqual(coarse.depth, 5)

    def test_all_edits_are_applied_or_none(self):
        with self.assertRefused(burnish.InvalidArgument, "beta", "11", "10"):
            self.session.apply(burnish.GradientScale(0.5), burnish.GradientScale(11))
        self.assertEqual(self.summaries(), [])

    def test_refusals_name_thing_value_and_limit(self):
        point = self.mesh.vertices[:1]
        for change, words in (
                (burnish.TransferCurve.constant(2e5), ["alpha", "2e[+]05", "1e[+]05"]),
                (burnish.TransferCurve({0.0: 0.05, 1.0: 60.0}), ["1200", "1000"]),
                (burnish.Stroke(burnish.Brush(1, strength=2), point), ["strength", "2", "1"]),
                (burnish.Stroke(burnish.Brush(1e-3), [[0, 0, 0]]), ["surface"]),
                (burnish.Equaliser([burnish.Band(1, 11)]), ["gain", "11", "10"]),
                (burnish.TextureFilter(gain=5), ["texture", "gain", "5", "4"]),
                (burnish.TextureFilter(remove_light=2), ["light", "2", "1"]),
                (burnish.TextureFilter(level_seams=2), ["seams", "2", "1"]),
                (burnish.GrowProtected(65), ["65", "64"])):
            with self.subTest(words), self.assertRefused(burnish.InvalidArgument, *words):
                self.session.apply(change)
        with self.assertRefused(burnish.FailedPrecondition, "colours"):
            self.session.apply(burnish.ColourFilter(0.5))
        with self.assertRefused(burnish.FailedPrecondition, "colours"):
            self.session.apply(burnish.TextureFilter(2))
        with self.assertRefused(burnish.InvalidArgument, "65", "64"):
            self.session.apply(*[burnish.GradientScale(1)] * 65)

    def test_arrays_and_words_are_checked_here(self):
        for wrong in (burnish.Stroke(burnish.Brush(1), [[0, 0]]),
                      burnish.Stroke(burnish.Brush(1, fall_off="wide"), [[0, 0, 0]]),
                      burnish.Stroke(burnish.Brush(1, band=1, colour=True), [[0, 0, 0]])):
            with self.assertRaises(ValueError):
                self.session.apply(wrong)

    def test_a_wavelength_is_an_alpha_of_the_scan(self):
        self.session.set_wavelength(2)
        self.session.set_alpha(self.scan.prepared(self.session.depth).alpha_of(2))
        by_length, by_alpha = self.summaries()
        self.assertEqual(by_length, by_alpha)

    def test_a_preset_is_the_programs(self):
        program = self.open(f"{self.id()} by the program")
        self.assertIn("Soften", burnish.presets())
        for name, strength in (("Bring out an inscription", 0.5), ("Sharpen flats", 1.0),
                               ("Reduce scanner noise", 1.0)):
            self.session.set_preset(name, strength)
            subprocess.run([os.environ["BURNISH_BINARY"], "edit", program.id, "--preset", name,
                            "--strength", str(strength), "--server", f"unix:{self.server.socket}"],
                           check=True, stdout=subprocess.DEVNULL)
            ours, theirs = self.session.state(), program.state()
            self.assertEqual((ours.beta, ours.curve, ours.bands, ours.edges, ours.edits),
                             (theirs.beta, theirs.curve, theirs.bands, theirs.edges, theirs.edits))

    def test_a_preset_that_is_not_there_or_too_strong_is_refused(self):
        with self.assertRefused(burnish.NotFound, "Harden"):
            self.session.set_preset("Harden")
        with self.assertRefused(burnish.InvalidArgument, "1.5"):
            self.session.set_preset("Soften", 1.5)
        self.assertEqual(self.session.state().edits, 0)

    def test_deviation_and_section_measure_the_surface(self):
        self.assertEqual(self.session.deviation().max, 0)
        self.session.apply(burnish.GradientScale(0), COARSE)
        moved = np.linalg.norm(self.session.mesh().vertices - self.mesh.vertices, axis=1).max()
        deviation = self.session.deviation()
        self.assertAlmostEqual(deviation.max, moved, delta=1e-3)
        self.assertAlmostEqual(deviation.histogram.sum(), 1)
        moves = self.session.mesh().vertices - self.mesh.vertices
        for axis, along in enumerate(deviation.along):
            self.assertAlmostEqual(along.least, moves[:, axis].min(), delta=1e-3)
            self.assertAlmostEqual(along.most, moves[:, axis].max(), delta=1e-3)
            self.assertLessEqual(abs(along.mean), along.rms)
        self.assertEqual(len(deviation.along), 3)
        original, edited = self.session.section([0, 0, 0], [0, 0, 1])
        radii = [np.linalg.norm(np.concatenate(lines), axis=1) for lines in (original, edited)]
        self.assertAlmostEqual(radii[0].mean(), 10, delta=0.5)
        self.assertLess(np.ptp(radii[1]), np.ptp(radii[0]))

    def test_sessions_are_listed_renamed_closed_and_deleted(self):
        session = self.connection.open_session(self.scan, depth=6)
        self.assertIn(session.id, [one.id for one in self.connection.sessions()])
        session.rename(self.id() + " second")
        self.assertEqual(self.connection.session(session.id).name, self.id() + " second")
        with self.assertRefused(burnish.AlreadyExists, self.session.name):
            session.rename(self.session.name)
        session.close()
        session.delete()
        with self.assertRefused(burnish.NotFound, session.id):
            self.connection.session(session.id)


if __name__ == "__main__":
    unittest.main()
