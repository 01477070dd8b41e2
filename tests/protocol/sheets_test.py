"""Sheets of a scan's pictures (docs/protocol.md, section 6)."""

import io
import struct
import unittest
import zipfile
import zlib

import numpy as np

import sheets
from burnish.v1 import common_pb2, library_pb2
from served import Served


def png_of(pixels):
    """Returns rows of RGB bytes as a PNG file."""
    def chunk(kind, data):
        return (struct.pack(">I", len(data)) + kind + data +
                struct.pack(">I", zlib.crc32(kind + data)))
    height, width = pixels.shape[:2]
    rows = b"".join(b"\0" + row.tobytes() for row in pixels)
    header = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows)) +
            chunk(b"IEND", b""))


def textured_scan(vertices, triangles):
    """Returns an archive with a picture that is projected along z."""
    places = (vertices[:, :2] - vertices[:, :2].min(axis=0)) / np.ptp(vertices[:, :2], axis=0)
    obj = "mtllib a.mtl\nusemtl a\n"
    obj += "".join("v {} {} {}\n".format(*vertex) for vertex in vertices)
    obj += "".join("vt {} {}\n".format(*place) for place in places)
    obj += "".join("f {0}/{0} {1}/{1} {2}/{2}\n".format(*(corners + 1)) for corners in triangles)
    ramp = np.arange(256, dtype=np.uint8)
    pixels = np.stack(np.broadcast_arrays(ramp[:, None], ramp[None], np.uint8(90)), axis=2)
    content = io.BytesIO()
    with zipfile.ZipFile(content, "w") as archive:
        archive.writestr("a.obj", obj)
        archive.writestr("a.mtl", "newmtl a\nmap_Kd a.png\n")
        archive.writestr("a.png", png_of(np.ascontiguousarray(pixels)))
    return content.getvalue()


class Sheets(Served):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        textured = textured_scan(cls.vertices, cls.triangles)
        events = cls.client.import_scan("textured", textured, 5,
                                        mesh_format=common_pb2.MESH_FORMAT_ZIP)
        cls.textured = events[-1].done.scan
        cls.head = cls.client.describe_pages(cls.textured.id)

    def describe(self, scan_id):
        request = library_pb2.DescribeSheetsRequest(scan=scan_id)
        return list(self.client.call(self.client.library.DescribeSheets, request))[-1].done

    def fetch(self, **parts):
        request = library_pb2.FetchSheetsRequest(scan=self.textured.id, **parts)
        return list(self.client.call(self.client.library.FetchSheets, request))

    def test_a_scan_without_pictures_has_none(self):
        self.assertEqual(self.describe(self.scan.id).head, b"")

    def test_the_sheets_are_what_the_page_says(self):
        head = sheets.read_head(self.describe(self.textured.id).head)
        self.assertEqual(head.pages, self.head.fingerprint)
        entries = [entry for event in self.fetch(blocks=range(head.blocks))
                   for entry in sheets.read_block(event.block.data)]
        self.assertEqual(len(entries), self.head.page_count)
        step = self.head.side / (1 << self.head.bits)
        for number in (0, self.head.page_count - 1):
            page = self.client.fetch_pages(self.textured.id, [number])[number]
            chart_bytes, density, listed = entries[number]
            wanted = [library_pb2.SheetNumber(page=number, halving=halving)
                      for halving in range(len(listed))]
            events = self.fetch(charts=[number], sheets=wanted)
            self.assertEqual(len(events[0].charts.data), chart_bytes)
            charts = sheets.read_charts(events[0].charts.data, number, len(page.triangles))
            for halving, event in enumerate(events[1:]):
                sheet = sheets.read_sheet(event.sheet.data)
                self.assertEqual((sheet.page, sheet.halving), (number, halving))
                self.assertEqual((len(event.sheet.data), sheet.size), listed[halving])
                self.assertEqual(sheet.density, density / 2**halving)
                places = charts.places(page.positions, page.triangles, sheet.density * step)
                self.assert_fit(charts, places, sheet)

    def assert_fit(self, charts, places, sheet):
        """The charts begin at their corners, and end with their gutters on the sheet."""
        for chart, place in enumerate(sheet.places):
            own = places[charts.of_triangle == chart].reshape(-1, 2)
            self.assertTrue((own.min(axis=0) >= -1e-6).all())
            self.assertTrue((own.min(axis=0) < 1).all())
            end = place + np.ceil(own.max(axis=0)) + 2 * sheets.GUTTER + 1
            self.assertTrue((end <= sheet.size).all())


if __name__ == "__main__":
    unittest.main()
