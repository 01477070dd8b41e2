"""The add-on for Blender, in a Blender without a window."""

import json
import os
import pathlib
import shutil
import subprocess
import tempfile
import tomllib
import unittest
import zipfile

import burnish

HERE = pathlib.Path(__file__).parent
# Of Blender's manual, "How to create extensions"; some of the tags.
TAGS = {"3D View", "Mesh", "Modeling", "Object", "Sculpt"}
PERMISSIONS = {"camera", "clipboard", "files", "microphone", "network"}
TEXT_LENGTH_MAX = 64
PACK = HERE.parents[2] / "client" / "blender" / "pack"


class Blender(unittest.TestCase):
    def test_a_mesh_is_sent_edited_live_kept_painted_and_finished(self):
        if shutil.which("blender") is None:
            self.skipTest("blender is not installed: deploy/setup --libraries installs it")
        with tempfile.TemporaryDirectory(prefix="burnish-") as folder:
            subprocess.run([PACK, f"{folder}/burnish_live.zip"], check=True, stdout=subprocess.DEVNULL)
            code = ("import os, sys; sys.path[:0] = os.environ['PYTHONPATH'].split(':'); "
                    f"exec(compile(open({str(HERE / 'blender_scene.py')!r}).read(), 'scene', 'exec'))")
            done = subprocess.run(
                ["blender", "--background", "--factory-startup", "--python-exit-code", "1",
                 "--python-expr", code, "--", folder], capture_output=True, text=True, check=False,
                env={**os.environ, "HOME": folder, "BLENDER_USER_SCRIPTS": folder})
        lines = [line for line in done.stdout.splitlines() if line.startswith("FACTS ")]
        self.assertEqual(len(lines), 1, done.stdout + done.stderr)
        self.check(json.loads(lines[0][6:]))

    def test_the_file_is_an_extension_by_the_rules_of_blender_4_2(self):
        with tempfile.TemporaryDirectory(prefix="burnish-") as folder:
            subprocess.run([PACK, f"{folder}/burnish_live.zip"], check=True, stdout=subprocess.DEVNULL)
            with zipfile.ZipFile(f"{folder}/burnish_live.zip") as packed:
                names = packed.namelist()
                manifest = tomllib.loads(packed.read("burnish_live/blender_manifest.toml").decode())
                source = packed.read("burnish_live/__init__.py").decode()
        self.assertEqual({name.split("/")[0] for name in names}, {"burnish_live"})
        self.assertEqual((manifest["schema_version"], manifest["type"]), ("1.0.0", "add-on"))
        self.assertTrue(manifest["id"].isidentifier())
        for version in ("version", "blender_version_min"):
            self.assertRegex(manifest[version], r"^\d+\.\d+\.\d+$")
        self.assertRegex(source, r'"version": \({}\)'.format(manifest["version"].replace(".", ", ")))
        self.assertTrue(manifest["name"] and manifest["maintainer"])
        self.assertTrue(all(one.startswith("SPDX:") for one in manifest["license"]))
        self.assertLessEqual(set(manifest["tags"]), TAGS)
        self.assertLessEqual(set(manifest["permissions"]), PERMISSIONS)
        for text in (manifest["tagline"], *manifest["permissions"].values()):
            self.assertLessEqual(len(text), TEXT_LENGTH_MAX)
            self.assertTrue(text[-1].isalnum(), text)

    def check(self, facts):
        self.assertGreater(facts["slider moves the key"], 0.01)
        self.assertLess(facts["slider takes it back"], 0.001)
        self.assertEqual(facts["edits before keep"], 0)
        self.assertEqual(facts["edits after keep"], ["gradient scale", "transfer curve"])
        self.assertEqual(facts["presets"], ["SLIDERS", *burnish.presets()])
        self.assertEqual(facts["edits of a preset"], ["transfer curve", "gradient scale"])
        self.assertEqual(facts["edits while its strength moves"], 2)
        self.assertEqual(facts["preset at a strength"], [True, True])
        self.assertAlmostEqual(facts["beta after undo"], 0.2, 6)
        self.assertAlmostEqual(facts["the sliders' last places are kept"], 0.5, 6)
        self.assertAlmostEqual(facts["beta after all undos"], 0.2, 6)
        self.assertEqual(facts["painted weights"], ["edges kept", "protection"])
        self.assertGreater(facts["protected"], 0)
        self.assertLess(facts["protected"], 0.6)
        self.assertLess(facts["edit of another is seen"], 0.001)
        self.assertGreater(facts["who joins sees the edits"], 0.005)
        self.assertIn("those of the imported file", facts["another mesh"])
        inside, outside = facts["group"]
        self.assertGreater(inside, 5 * outside)
        self.assertIn("'none' is not a vertex group", facts["wrong group"])
        self.assertEqual(facts["painted gain"], ["texture gain"])
        self.assertIn("no colours", facts["gain without colours"])
        self.assertLess(facts["exact"], 1e-6)
        self.assertTrue(facts["basis stays"])
        self.assertEqual(facts["links"], 0)


if __name__ == "__main__":
    unittest.main()
