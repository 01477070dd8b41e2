"""The reference that the programs write: it has all that they have."""

import json
import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest

import burnish

ROOT = pathlib.Path(__file__).parents[2]
PROGRAM, SERVER = os.environ["BURNISH_BINARY"], os.environ["BURNISH_SERVER_BINARY"]


def page(name, *words):
    return subprocess.run([ROOT / "deploy" / "reference" / name, *words], check=True,
                          capture_output=True, text=True).stdout


def printed(*words):
    return subprocess.run(words, check=True, capture_output=True, text=True).stdout


class Reference(unittest.TestCase):
    def test_the_commands_have_their_whole_help(self):
        text = page("commands", PROGRAM)
        listed = re.findall(r"^  (\S+)", printed(PROGRAM, "--help").split("Subcommands:")[1], re.M)
        self.assertEqual(re.findall(r"^## burnish (\S+)$", text, re.M), listed)
        self.assertIn("### burnish bench serve\n", text)
        for command in listed:
            self.assertIn(printed(PROGRAM, command, "--help").strip(), text)

    def test_the_servers_flags_and_commands_are_there(self):
        text = page("commands", SERVER)
        for word in ("# burnish-server\n", "### burnish-server journal copy\n", "--idle-exit"):
            self.assertIn(word, text)

    def test_each_key_has_default_limits_and_meaning(self):
        text = page("configuration", SERVER)
        keys = json.loads(printed(SERVER, "--print-config", "json"))
        rows = re.findall(r"^\| `(\w+)` \| ([^|]+) \| `(.*?)` \| (.*?) \| (.+) \|$", text, re.M)
        self.assertEqual([row[0] for row in rows], [key["name"].split(".")[-1] for key in keys])
        for key, row in zip(keys, rows):
            with self.subTest(key["name"]):
                self.assertEqual(json.loads(row[2]), key["default"])
                self.assertGreater(len(row[4]), 10)
                if "min" in key:
                    self.assertEqual(row[3], f"{key['min']} to {key['max']}")
        self.assertIn("## [limits]\n", text)

    def test_the_printed_file_is_one_that_the_server_takes(self):
        self.assertEqual(printed(SERVER, "--print-config", "toml"),
                         (ROOT / "deploy" / "server.example.toml").read_text(encoding="utf-8"))

    def test_each_message_field_value_and_call_is_there_with_its_comment(self):
        text = page("protocol", ROOT / "proto")
        for file in (ROOT / "proto").rglob("*.proto"):
            source = file.read_text(encoding="utf-8")
            for name in re.findall(r"^ *(?:message|enum) (\w+)", source, re.M):
                self.assertRegex(text, rf"(?m)^### (\w+\.)?{name}$")
            for name in re.findall(r"^ *rpc (\w+)", source, re.M):
                self.assertRegex(text, rf"(?m)^### \w+/{name}$")
            for name, number in re.findall(r"^ *(?:\w[\w. ]* )?(\w+) = (\d+);", source, re.M):
                self.assertRegex(text, rf"(?m)^\| `{name}` \| {number} \|")
        self.assertIn("| `offset` | 1 | uint64 | bytes before this piece |", text)

    def test_each_name_of_the_python_package_is_there_with_its_docstring(self):
        text = page("python", pathlib.Path(burnish.__file__).parents[1])
        names = [name for name in burnish.__all__ if not name.startswith("_")]
        self.assertEqual(re.findall(r"^## (\w+)$", text, re.M), names)
        self.assertIn("fall_off: str = 'smooth'", text)
        self.assertRegex(text, r"(?m)^### Session\.undo\(\)")
        self.assertIn("Raises Unavailable, Unauthenticated, and OSError for files.", text)
        self.assertNotIn("_pb2.", text)

    @unittest.skipUnless(shutil.which("mkdocs"), "deploy/setup --docs installs MkDocs")
    def test_the_site_has_four_kinds_of_pages_and_the_reference(self):
        with tempfile.TemporaryDirectory(prefix="burnish-") as folder:
            site = pathlib.Path(folder)
            printed(ROOT / "deploy" / "docs", "--programs", pathlib.Path(PROGRAM).parent, site)
            start = (site / "index.html").read_text(encoding="utf-8")
            menus = re.findall(r'dropdown-toggle"[^>]*>([\w-]+) ', start)
            self.assertEqual(menus[:4], ["Tutorial", "How-to", "Reference", "Explanation"])
            self.assertIn("--no-clobber",
                          (site / "docs/reference/burnish.html").read_text(encoding="utf-8"))
            shown = (site / "docs" / "tutorial.html").read_text(encoding="utf-8")
            for picture in re.findall(r'src="(pictures/[^"]+)"', shown):
                self.assertTrue((site / "docs" / picture).exists(), picture)


if __name__ == "__main__":
    unittest.main()
