"""What counts as a command of a document, and where its commands run."""

import unittest

from blocks import blocks_of, faults_of
from desk import Desk
from inline import faults_in

PAGE = """# A page

Text.

<!-- not run: needs root -->
```sh
apt install burnish
```

<!-- before: touch scan -->
<!-- file: server.toml -->

```toml
listen = ""
```

- a list

  ```sh
  burnish filter
    indented
  ```

```
no language
```
"""


class Blocks(unittest.TestCase):
    def setUp(self):
        self.marked, self.file, self.listed, self.nameless = blocks_of("page.md", PAGE)

    def test_a_block_has_its_place_and_its_text_without_the_indentation_of_a_list(self):
        self.assertEqual(self.listed.place, "page.md:19")
        self.assertEqual(self.listed.text, "burnish filter\n  indented\n")
        self.assertTrue(self.listed.runs)

    def test_comments_before_a_block_are_its_marks(self):
        self.assertEqual(self.marked.marks, {"not run": "needs root"})
        self.assertEqual(self.file.marks, {"before": "touch scan", "file": "server.toml"})
        self.assertEqual(self.listed.marks, {})
        self.assertFalse(self.marked.runs or self.file.runs)

    def test_a_block_without_a_language_is_a_fault_so_that_none_goes_untested(self):
        self.assertIn("'' is not one of sh", faults_of(self.nameless))
        self.assertEqual([faults_of(one) for one in (self.marked, self.file, self.listed)],
                         [None, None, None])

    def test_a_reason_is_for_blocks_that_would_run(self):
        self.file.marks = {"not run": "it is a file"}
        self.assertIn("needs no reason", faults_of(self.file))

    def test_a_block_that_does_not_end_is_named(self):
        with self.assertRaisesRegex(ValueError, "page.md:2"):
            blocks_of("page.md", "text\n```sh\nburnish\n")


class Inline(unittest.TestCase):
    def test_options_in_sentences_exist(self):
        self.assertEqual(faults_in("`burnish filter IN OUT --beta 1`, `burnish --script FILE` and "
                                   "`burnish bench serve --clients 8`; `burnish-server journal copy "
                                   "A B`, `burnish COMMAND --help`"), [])

    def test_an_option_that_does_not_exist_is_named(self):
        self.assertEqual(len(faults_in("`burnish filter --glow`")), 1)
        self.assertIn("--clientz", faults_in("`burnish bench serve --clientz 8`")[0])
        self.assertEqual(faults_in("```sh\nburnish `burnish x --glow`\n```\n"), [])


class Desks(unittest.TestCase):
    def setUp(self):
        self.desk = Desk()
        self.addCleanup(self.desk.close)

    def test_a_command_that_fails_is_named(self):
        code, output = self.desk.run("sh", "true\nfalse\ntrue\n")
        self.assertEqual((code, output), (1, "failed: false\n"))
        self.assertEqual(self.desk.run("python", "import nothing_of_this_name")[0], 1)

    def test_addresses_are_free_ports_and_one_name_stays_one_place(self):
        text = self.desk.here("127.0.0.1:7411 burnish.lab:7443 0.0.0.0:7411 /var/lib/burnish/x")
        first, second, third, folder = text.split()
        self.assertEqual(first, third)
        self.assertNotIn("7411", first)
        self.assertEqual(second.split(":")[0], "localhost")
        self.assertEqual(folder, f"{self.desk.folder}/var/lib/burnish/x")

    def test_a_server_goes_on_behind_its_block_and_makes_room_for_the_next(self):
        start = "burnish-server --listen 127.0.0.1:7411 --data {} &\nburnish meshes --json\n"
        for folder in ("one", "two"):
            self.assertEqual(self.desk.run("sh", start.format(folder)), (0, "[]\n"))
        self.assertEqual(self.desk.run("sh", "burnish meshes --json"), (0, "[]\n"))

    def test_a_server_that_does_not_start_is_a_fault(self):
        code, output = self.desk.run("sh", "burnish-server --listen nowhere")
        self.assertNotEqual(code, 0)
        self.assertIn("nowhere", output)

    def test_generated_scans_are_small(self):
        for words in ("--vertices 1000000", ""):
            code, output = self.desk.run("sh", f"burnish generate blob b.ply {words}")
            self.assertEqual(code, 0, output)
            self.assertLess(int(output.split()[1]), 10_000)


if __name__ == "__main__":
    unittest.main()
