"""The examples of docs/protocol.md."""

import pathlib
import unittest

import numpy as np

from burnish.errors import Damaged
from burnish.formats.frames import FrameDecoder, MissingReference, read_frame_header
from burnish.formats.layout import VERTICES, Layout
from burnish.formats.pages import read_page

EXAMPLES = pathlib.Path(__file__).parents[2] / "docs" / "examples"


def example(name):
    """Returns the bytes of an example of the protocol's page."""
    return bytes.fromhex((EXAMPLES / f"{name}.hex").read_text(encoding="ascii"))


class Page(unittest.TestCase):
    def setUp(self):
        page = read_page(example("page"))
        self.decoder = FrameDecoder(lambda number, kind: Layout(page, 8, kind))
        self.decoder.show([9], [])

    def test_the_frames_say_what_the_page_says(self):
        key, delta = example("key-frame"), example("next-frame")
        frame = self.decoder.decode(key)
        self.assertEqual((frame.reference, frame.revision, frame.kind), (0, 1, VERTICES))
        self.assertEqual(frame.largest_move, 0.25)
        self.assertEqual(self.decoder.state[9].gain, 1)
        expected = np.array([(64, 0, -value) for value in range(5)])
        np.testing.assert_array_equal(self.decoder.state[9].values, expected)
        np.testing.assert_array_equal(self.decoder.displacements(9), expected / 256)
        self.assertEqual(self.decoder.decode(delta).reference, 1)
        expected[0, 0] += 8
        expected[:, 2] = (0, 0, 0, -4, -4)
        np.testing.assert_array_equal(self.decoder.state[9].values, expected)

    def test_the_page_of_the_scan_says_what_the_page_says(self):
        page = read_page(example("page"))
        self.assertEqual((page.number, page.border), (9, 2))
        self.assertEqual(page.patches, [(3, 4), (5, 2)])
        self.assertEqual(sorted(map(tuple, page.positions.tolist())), [
            (1000, 1000, 1000), (1000, 1200, 1000), (1100, 1100, 1150), (1200, 1000, 1000),
            (1200, 1200, 1000)])
        tip = page.positions[:, 2].argmax()
        self.assertEqual((page.triangles == tip).sum(axis=1).tolist(), [1, 1, 1, 1, 0, 0])
        np.testing.assert_array_equal(page.normals[tip], (0, 0, 1))
        self.assertEqual(page.colours[tip].tolist(), [255] * 4)

    def test_a_flipped_bit_is_found(self):
        for data, read in [(example("key-frame"), read_frame_header),
                           (example("page"), read_page)]:
            for byte in range(len(data)):
                flipped = bytearray(data)
                flipped[byte] ^= 1 << byte % 8
                with self.assertRaises(Damaged, msg=f"byte {byte}"):
                    read(bytes(flipped))

    def test_a_frame_without_its_reference_is_told_from_a_damaged_one(self):
        with self.assertRaises(MissingReference):
            self.decoder.decode(example("next-frame"))


if __name__ == "__main__":
    unittest.main()
