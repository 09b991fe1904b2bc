#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""scripts/mutants.py changes what it says it changes, and nothing in comments, texts or declarations."""

import glob
import importlib.util
import os
import re
import sys
import tempfile
import unittest

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
spec = importlib.util.spec_from_file_location("mutants", os.path.join(ROOT, "scripts", "mutants.py"))
mutants = importlib.util.module_from_spec(spec)
spec.loader.exec_module(mutants)


def changes_of(*lines):
    """[(line number, the line changed)] of a source of these lines."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "source.cpp")
        with open(path, "w", encoding="utf-8") as file:
            file.write("\n".join(lines))
        return [(number, changed.strip()) for number, changed, _ in mutants.mutants_of(path)]


class Changes(unittest.TestCase):
    def test_comparisons_and_logic(self):
        self.assertEqual(changes_of("    if (a <= b && !c) return x;"),
                         [(1, "if (a < b && !c) return x;"), (1, "if (a <= b || !c) return x;"),
                          (1, "if (a <= b && c) return x;")])
        self.assertEqual(changes_of("    return tick - since >= filter;"),
                         [(1, "return tick - since > filter;"), (1, "return tick + since >= filter;")])

    def test_a_mask_is_not_compared_with_one(self):
        self.assertEqual(changes_of("    if ((a & b) == 0) return x;"),
                         [(1, "if ((a & b) != 0) return x;"), (1, "if ((a | b) == 0) return x;")])

    def test_statements_are_left_out_whole(self):
        self.assertEqual(changes_of("    put_out();"), [(1, ";")])
        self.assertEqual(changes_of("    accepted_ = raw;"), [(1, ";")])
        self.assertEqual(changes_of("    long_call(a,", "              b.c());"), [], "the rest of another line")
        self.assertEqual(changes_of("    const int a = b;"), [])

    def test_comments_texts_and_declarations_stay(self):
        self.assertEqual(changes_of("// a < b && c", '    return "a == b";', "static_assert(a == 1);", "#if A == 1"), [])
        self.assertEqual(changes_of("    return a;  // true == false"), [])

    def test_templates_and_shifts_are_no_comparisons(self):
        self.assertEqual(changes_of("    const auto a = static_cast<int>(b);"), [])
        self.assertEqual(changes_of("    return a << b >> c;"), [])
        self.assertEqual(changes_of("    return a <=> b;"), [])

    def test_unknown_folders_are_refused(self):
        with self.assertRaises(SystemExit) as refusal:
            mutants.judges_of("hmi/cli/start.cpp")
        self.assertIn("hmi/cli/start.cpp", str(refusal.exception))

    def test_the_judges_are_test_programs_that_there_are(self):
        declared = ""
        for folder, _, names in os.walk(os.path.join(ROOT, "tests")):
            if "CMakeLists.txt" in names:
                with open(os.path.join(folder, "CMakeLists.txt"), encoding="utf-8") as file:
                    declared += file.read()
        for _, programs in mutants.JUDGES:
            for name in programs:
                self.assertIn(f"psicarve_test({name} ", declared.replace("\n", " "))


class Page(unittest.TestCase):
    def test_rows_name_functions_that_are_there(self):
        with open(os.path.join(ROOT, "docs", "mutants.md"), encoding="utf-8") as file:
            rows = [line.split("|")[1] for line in file if line.startswith("| ")]
        named = [pair for row in rows for pair in re.findall(r"(\w+\.[ch]pp) `(\w+)`", row)]
        self.assertGreater(len(named), 3)
        sources = glob.glob(os.path.join(ROOT, "rtcore", "**", "*.?pp"), recursive=True)
        for name, function in named:
            found = [path for path in sources if os.path.basename(path) == name]
            self.assertEqual(len(found), 1, name)
            with open(found[0], encoding="utf-8") as file:
                self.assertRegex(file.read(), rf"\b{function}\(", name)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], "-q"])
