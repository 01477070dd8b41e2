"""Pictures of mesh files."""

import pathlib
import tempfile
import unittest
import warnings

import numpy as np

import burnish
from png_file import decoded, encoded

SIDE = 256  # texels
STRIPE = 16  # texels


class Render(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="burnish-")
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.scan = self.folder / "scan.obj"
        self.scan.write_text("mtllib skin.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\n"
                             "vt 1 1\nvt 0 1\nusemtl skin\nf 1/1 2/2 3/3\nf 1/1 3/3 4/4\n", "utf-8")
        (self.folder / "skin.mtl").write_text("newmtl skin\nmap_Kd skin.png\n", "utf-8")

    def render(self, **options):
        """Returns the middle of a picture of the scan from the front."""
        out = self.folder / "out.png"
        burnish.render(self.scan, out, view=(0, 0), size=(320, 240), **options)
        return decoded(out.read_bytes())[100:140, 100:220]

    def test_a_file_with_a_picture_shows_its_texels(self):
        stripes = np.where(np.arange(SIDE) // STRIPE % 2, 190, 60)
        texels = np.broadcast_to(stripes[None, :, None], (SIDE, SIDE, 3)).astype(np.uint8)
        (self.folder / "skin.png").write_bytes(encoded(texels))
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            shown = self.render(light="unlit")
        for grey in (60, 190):
            self.assertGreater((abs(shown - grey) < 12).all(2).mean(), 0.3)

    def test_a_picture_that_is_missing_is_a_warning(self):
        with self.assertWarnsRegex(UserWarning, "skin.png"):
            self.render()

    def test_a_scale_bar_is_there_if_it_is_wished(self):
        def drawn(**options):
            out = self.folder / "bar.png"
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")  # the picture is missing
                burnish.render(self.scan, out, size=(320, 240), **options)
            return decoded(out.read_bytes())
        plain, bare, named = drawn(), drawn(scale_bar=""), drawn(scale_bar="mm")
        for barred in (bare, named):
            changed = np.argwhere((barred != plain).any(2))
            self.assertGreater(len(changed), 200)
            self.assertTrue((changed >= (210, 160)).all())
        self.assertTrue((bare != named).any())


if __name__ == "__main__":
    unittest.main()
