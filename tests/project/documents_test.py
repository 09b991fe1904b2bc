#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""documents_test.py SOURCES: each rule of scripts/documents.py catches its violation, and wrapping changes no word."""

import os
import subprocess
import sys
import tempfile
import unittest

SCRIPT = ""
LONG = "word " * 30


class Documents(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.root = scratch.name
        self.write("README.md", "# A tree\n\nShort. [A page](docs/page.md#a-heading).\n")
        self.write("docs/page.md", "# Page\n\n## A `heading`\n\n| a | b |\n| --- | --- |\n| 1 | " + LONG + "|\n")
        self.write("docs/decisions/0001-first.md", "# 1. First\n")

    def write(self, name, text):
        file = os.path.join(self.root, name)
        os.makedirs(os.path.dirname(file), exist_ok=True)
        with open(file, "w", encoding="utf-8") as out:
            out.write(text)

    def run_script(self, *words):
        return subprocess.run([sys.executable, "-B", SCRIPT, *words], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
                              text=True, check=False)

    def assert_said(self, words):
        outcome = self.run_script("check", self.root)
        self.assertEqual(outcome.returncode, 1)
        self.assertIn(words, outcome.stdout)

    def test_what_is_right_is_taken(self):
        outcome = self.run_script("check", self.root)
        self.assertEqual(outcome.returncode, 0, outcome.stdout)

    def test_a_long_line_is_refused_in_text_and_in_code(self):
        self.write("docs/page.md", "# Page\n\n## A heading\n\n" + LONG + "\n")
        self.assert_said("docs/page.md:5: 150 columns")
        self.write("docs/page.md", "# Page\n\n## A heading\n\n    | " + LONG + "\n")
        self.assert_said("docs/page.md:5: 156 columns")

    def test_a_row_with_a_cell_too_many_is_refused(self):
        self.write("docs/page.md", "## A heading\n\n| a | b |\n| --- | --- |\n| 1 | 2 | 3 |\n")
        self.assert_said("docs/page.md:5: a row of 3 cells below a head of 2")

    def test_links_lead_to_files_and_headings(self):
        self.write("docs/page.md", "## Another heading\n\n[gone](nowhere.md)\n")
        self.assert_said("links to nowhere.md")
        self.assert_said("links to docs/page.md#a-heading")

    def test_two_decisions_have_no_number_in_common(self):
        self.write("docs/decisions/0001-second.md", "# 1. Second\n")
        self.assert_said("decision 1 is docs/decisions/0001-first.md")
        self.write("docs/decisions/0002-third.md", "# 3. Third\n")
        self.assert_said("0002-third.md: its heading has another number")

    def test_wrapping_lays_out_long_entries_alone(self):
        entry = "- " + "`a b` - 1. " * 30 + "\n  and on\n- short\n\nText.\n"
        code = "    " + "word " * 40 + "\n"
        table = "| " + "word " * 40 + "|\n"
        self.write("docs/page.md", entry + "\n" + code + "\n" + table)
        file = os.path.join(self.root, "docs", "page.md")
        self.assertEqual(self.run_script("wrap", file).returncode, 0)
        with open(file, encoding="utf-8") as text:
            after = text.read()
        self.assertEqual(after.split(), (entry + code + table).split())
        self.assertTrue(after.endswith("\n- short\n\nText.\n\n" + code + "\n" + table))
        for line in after.split("\n- short")[0].split("\n")[1:]:
            self.assertRegex(line, r"^  (`a b`|and|on)")
            self.assertLessEqual(len(line), 120)
        self.run_script("wrap", file)
        with open(file, encoding="utf-8") as text:
            self.assertEqual(text.read(), after)


if __name__ == "__main__":
    SCRIPT = os.path.join(sys.argv.pop(1), "scripts", "documents.py")
    unittest.main()
