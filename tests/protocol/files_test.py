"""Scans, views and files (docs/protocol.md, section 3)."""

import hashlib
import unittest

import grpc
import numpy as np

from burnish.v1 import editing_pb2
from client import join_chunks
from served import DEPTH, Served
from wire import morton_point


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

    def test_a_view_holds_the_scans_vertices_to_a_millionth_of_a_cell(self):
        view = self.client.fetch_view(self.open())
        np.testing.assert_array_equal(view.triangles, self.triangles)
        off = np.abs(view.positions() - self.vertices).max() / view.cell_size
        self.assertLess(off, 1e-6)
        self.assertEqual(view.homes[-1], -1)
        np.testing.assert_array_equal(view.strays, self.vertices[-1:])

    def test_a_view_has_the_scans_colours(self):
        corners = np.array([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)])
        faces = [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)]
        text = ["ply", "format ascii 1.0", "element vertex 4",
                *(f"property {kind} {name}" for kind, names in (
                    ("double", "x y z"), ("uchar", "red green blue")) for name in names.split()),
                "element face 4", "property list uchar int vertex_indices", "end_header",
                *("%d %d %d %d %d %d" % (*corner, *(200 * corner + 5)) for corner in corners),
                *("3 %d %d %d" % face for face in faces), ""]
        events = self.client.import_scan("coloured", "\n".join(text).encode(), 4)
        view = self.client.fetch_view(
            editing_pb2.SessionInfo(scan_id=events[-1].done.scan.id, depth=4))
        np.testing.assert_array_equal(view.colours[:, :3], 200 * corners + 5)
        np.testing.assert_array_equal(view.colours[:, 3], 255)

    def test_a_depth_that_nobody_prepared_is_a_failed_precondition(self):
        self.assertFails(grpc.StatusCode.FAILED_PRECONDITION, lambda: self.client.fetch_view(
            editing_pb2.SessionInfo(scan_id=self.scan.id, depth=5)))

    def test_cells_come_in_the_views_order(self):
        session = self.open()
        view = self.client.fetch_view(session)
        i, j, k = morton_point(view.cells[7:8])[0].tolist()
        cell = editing_pb2.CellField(i=i, j=j, k=k, alpha1=50, alpha2=50, beta=0.5)
        self.assertEqual(self.client.upload_cells(session, "upload", [cell]).applied, 1)
        self.assertEqual(self.client.upload_cells(session, "upload", [cell]).known, 1)
        request = editing_pb2.GetCellsRequest(session=session.id,
                                              value=editing_pb2.CELL_VALUE_BETA)
        data = join_chunks(self.client.call(self.client.editing.GetCells, request))
        expected = np.ones(len(view.cells), np.float32)
        expected[7] = 0.5
        np.testing.assert_array_equal(np.frombuffer(data, "<f4"), expected)


    def test_an_upload_that_ends_early_is_data_loss(self):
        session = self.open()
        self.assertFails(grpc.StatusCode.DATA_LOSS, lambda: self.client.upload_cells(
            session, "upload", [], announced=1))


if __name__ == "__main__":
    unittest.main()
