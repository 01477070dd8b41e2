"""Scans, pages and files (docs/protocol.md, section 3)."""

import hashlib
import unittest

import grpc
import numpy as np

from burnish.formats.wire import morton_key
from burnish.v1 import editing_pb2
from client import join_chunks
from served import DEPTH, Served
from shown import Scan, match


class Files(Served):
    def test_an_import_is_announced_received_and_done(self):
        kinds = [event.WhichOneof("event") for event in self.events]
        self.assertEqual((kinds[0], kinds[-1]), ("received", "done"))
        self.assertEqual(self.scan.id, hashlib.sha256(self.ply).hexdigest())

    def test_a_known_scan_is_not_sent_again(self):
        events = self.client.import_scan("again", self.ply, DEPTH, sha256=self.scan.id)
        self.assertEqual([event.WhichOneof("event") for event in events][-1], "done")
        self.assertNotIn("received", [event.WhichOneof("event") for event in events])
        self.assertTrue(events[-1].done.already_present)

    def test_a_damaged_chunk_is_data_loss(self):
        def damage(chunk):
            chunk.crc32 ^= 1
        self.assertFails(grpc.StatusCode.DATA_LOSS, lambda: self.client.import_scan(
            "damaged", self.ply, DEPTH, damage=damage))

    def test_a_file_that_is_not_what_was_announced_is_data_loss(self):
        self.assertFails(grpc.StatusCode.DATA_LOSS, lambda: self.client.import_scan(
            "another", self.ply, DEPTH, sha256="0" * 64))

    def test_level_0_holds_the_scans_vertices_to_half_a_step(self):
        scan = self.fetch(self.open())
        step = scan.head.side / (1 << scan.head.bits)
        triangles, seen = 0, set()
        for page in scan.pages.values():
            places = scan.head.places(page.positions)
            vertices = match(places, self.vertices, step)
            self.assertLess(np.abs(places - self.vertices[vertices]).max() / step, 0.51)
            seen.update(vertices.tolist())
            triangles += len(page.triangles)
        self.assertEqual(triangles, len(self.triangles))
        self.assertEqual(seen, set(range(len(self.vertices) - 1)))  # the last has no triangle

    def fetch(self, session):
        """Returns the pages of level 0."""
        scan = Scan(self.client, session)
        scan.fetch(scan.level_0)
        return scan

    def test_pages_have_the_scans_colours(self):
        corners = np.array([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)])
        faces = [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)]
        text = ["ply", "format ascii 1.0", "element vertex 4",
                *(f"property {kind} {name}" for kind, names in (
                    ("double", "x y z"), ("uchar", "red green blue")) for name in names.split()),
                "element face 4", "property list uchar int vertex_indices", "end_header",
                *("%d %d %d %d %d %d" % (*corner, *(200 * corner + 5)) for corner in corners),
                *("3 %d %d %d" % face for face in faces), ""]
        events = self.client.import_scan("coloured", "\n".join(text).encode(), 4)
        scan = self.fetch(editing_pb2.SessionInfo(scan_id=events[-1].done.scan.id, depth=4))
        page = scan.pages[0]
        nearest = np.rint(scan.head.places(page.positions)).astype(int)
        np.testing.assert_array_equal(page.colours[:, :3], 200 * nearest + 5)
        np.testing.assert_array_equal(page.colours[:, 3], 255)

    def test_cells_come_in_morton_order(self):
        session = self.open()
        scan = self.fetch(session)
        cells = np.unique(np.concatenate([scan.cells(page) for page in scan.pages]), axis=0)
        i, j, k = cells[7].tolist()
        cell = editing_pb2.CellField(i=i, j=j, k=k, alpha1=50, alpha2=50, beta=0.5)
        self.assertEqual(self.client.upload_cells(session, "upload", [cell]).applied, 1)
        self.assertEqual(self.client.upload_cells(session, "upload", [cell]).known, 1)
        request = editing_pb2.GetCellsRequest(session=session.id,
                                              value=editing_pb2.CELL_VALUE_BETA)
        data = join_chunks(self.client.call(self.client.editing.GetCells, request))
        betas = np.frombuffer(data, "<f4")
        self.assertGreaterEqual(len(betas), len(cells))  # cells without a vertex come too
        place = np.flatnonzero(betas == 0.5)
        self.assertEqual(len(place), 1)
        before = (morton_key(cells) < morton_key(cells[7:8])).sum()
        self.assertGreaterEqual(place[0], before)

        for page, (low, high, steps) in self.client.page_values(
                session, editing_pb2.CELL_VALUE_BETA, list(scan.pages)).items():
            own = (scan.cells(page) == (i, j, k)).all(axis=1)
            self.assertEqual((low, high), (0.5, 1) if own.any() else (1, 1))
            np.testing.assert_array_equal(steps, np.where(own, 0, 255) if own.any() else [])

    def test_values_are_of_pages_that_there_are(self):
        session = self.open()
        count = Scan(self.client, session).head.page_count
        for pages, text in ([count], f"0..{count - 1}"), ([], "1..4096"), ([0] * 4097, "4097"):
            with self.assertRaisesRegex(grpc.RpcError, text):
                self.client.page_values(session, editing_pb2.CELL_VALUE_BETA, pages)

    def test_an_upload_that_ends_early_is_data_loss(self):
        session = self.open()
        self.assertFails(grpc.StatusCode.DATA_LOSS, lambda: self.client.upload_cells(
            session, "upload", [], announced=1))


if __name__ == "__main__":
    unittest.main()
