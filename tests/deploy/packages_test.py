"""What the packages say of the programs: manuals, completion, menu entry."""

import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest
import xml.etree.ElementTree as ET

ROOT = pathlib.Path(__file__).parents[2]
PACKAGES = ROOT / "deploy" / "packages"
PROGRAM, SERVER = os.environ["BURNISH_BINARY"], os.environ["BURNISH_SERVER_BINARY"]


def output_of(*words):
    return subprocess.run(words, check=True, capture_output=True, text=True).stdout


def commands():
    listed = output_of(PROGRAM, "--help").split("Subcommands:")[1]
    return re.findall(r"^  (\S+)", listed, re.M)


class Packages(unittest.TestCase):
    def test_the_manual_has_each_command_and_its_options(self):
        page = output_of(PACKAGES / "manual", PROGRAM, "1", "1.2.3", "24 Nov 2026")
        self.assertEqual(re.findall(r"^\.SS burnish (\S+)", page, re.M), commands())
        self.assertIn(r"\-\-out\-dir", page)
        self.assertIn('"burnish 1.2.3"', page)
        self.assertLess(max(map(len, page.replace("\\", "").splitlines())), 100)

    def test_the_servers_manual_names_its_configuration(self):
        page = output_of(PACKAGES / "manual", SERVER, "8", "1.2.3", "24 Nov 2026")
        for word in ("/etc/burnish/server.toml", r"\-\-idle\-exit", ".BR burnish (1)"):
            self.assertIn(word, page)

    def completed(self, *words):
        """Returns what bash proposes for the last of these words."""
        script = output_of(PACKAGES / "completion", PROGRAM)
        line = (f"{script}\nCOMP_WORDS=({' '.join(map(repr, words))})\n"
                f"COMP_CWORD={len(words) - 1}\n_burnish\nprintf '%s\\n' \"${{COMPREPLY[@]}}\"")
        return output_of("bash", "-c", line).split()

    def test_bash_completes_commands_and_options(self):
        self.assertEqual(self.completed("burnish", "fil"), ["filter"])
        self.assertEqual(self.completed("burnish", "filter", "--no-c"), ["--no-clobber"])
        self.assertIn("--exact", self.completed("burnish", "export", "carving", "out.ply", "--"))
        self.assertEqual(self.completed("burnish", "--ver"), ["--version"])

    def test_the_menu_entry_opens_what_the_program_reads(self):
        entry = (PACKAGES / "burnish.desktop").read_text(encoding="utf-8")
        kinds = re.search(r"^MimeType=(.*);$", entry, re.M)[1].split(";")
        types = ET.parse(PACKAGES / "burnish.xml").getroot()
        own = [one.get("type") for one in types]
        self.assertEqual(own, ["model/ply", "model/x-off"])
        self.assertLessEqual(set(own), set(kinds))
        self.assertIn("Icon=burnish\n", entry)
        ET.parse(PACKAGES / "burnish.svg")

    def test_the_flavour_with_cuda_takes_the_place_of_the_server(self):
        with tempfile.TemporaryDirectory(prefix="burnish-") as folder:
            debian = pathlib.Path(folder) / "debian"
            shutil.copytree(PACKAGES / "debian", debian)
            for unit in ("burnish-server.service", "burnish-server@.service"):
                (debian / unit).write_text("[Unit]\n", encoding="utf-8")
            output_of(PACKAGES / "cuda_flavour", debian)
            control = (debian / "control").read_text(encoding="utf-8")
            self.assertEqual(re.findall(r"^Package: (.*)", control, re.M), ["burnish-server-cuda"])
            for line in ("Provides: burnish-server (= ${binary:Version})", "Source: burnish",
                         "Conflicts: burnish-server", "Replaces: burnish-server"):
                self.assertRegex(control, rf"(?m)^{re.escape(line)}$")
            names = {path.name for path in debian.iterdir()}
            self.assertLessEqual({"burnish-server-cuda.burnish-server.service",
                                  "burnish-server-cuda@.burnish-server.service",
                                  "burnish-server-cuda.prerm",
                                  "burnish-server-cuda.install"}, names)
            self.assertFalse([name for name in names
                              if name.startswith(("burnish.", "burnish-server.", "burnish-server@",
                                                  "python3"))])
            self.assertIn("dh_installsystemd --name=burnish-server",
                          (debian / "rules").read_text(encoding="utf-8"))

    def test_the_servers_folder_is_the_units(self):
        unit = (ROOT / "deploy" / "burnish-server.service").read_text(encoding="utf-8")
        user = (PACKAGES / "debian" / "burnish-server.sysusers").read_text(encoding="utf-8")
        self.assertIn("User=burnish\n", unit)
        self.assertIn("StateDirectory=burnish\n", unit)
        self.assertRegex(user, r"^u burnish .* /var/lib/burnish\n")


if __name__ == "__main__":
    unittest.main()
