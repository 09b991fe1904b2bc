#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""scripts/asan_cover.py leaves out no test that alone reaches a line, and its lists name tests that exist."""

import glob
import importlib.util
import os
import re
import unittest

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
spec = importlib.util.spec_from_file_location("asan_cover", os.path.join(ROOT, "scripts", "asan_cover.py"))
asan_cover = importlib.util.module_from_spec(spec)
spec.loader.exec_module(asan_cover)


class Cover(unittest.TestCase):
    def test_a_test_that_alone_reaches_a_line_is_run(self):
        lines = {"a": {"x:1", "x:2"}, "b": {"x:2", "x:3"}, "c": {"x:2"}}
        self.assertEqual(asan_cover.cover({"a": 9.0, "b": 9.0, "c": 0.1}, lines), {"a", "b"})

    def test_of_two_that_reach_the_same_the_quicker_is_run(self):
        lines = {"a": {"x:1", "x:2"}, "b": {"x:1", "x:2"}}
        self.assertEqual(asan_cover.cover({"a": 2.0, "b": 1.0}, lines), {"b"})

    def test_whom_later_ones_make_needless_is_dropped(self):
        # The quick one is taken first, for its time.
        lines = {"quick": {"x:2"}, "left": {"x:1", "x:2"}, "right": {"x:2", "x:3"}}
        self.assertEqual(asan_cover.cover({"quick": 0.1, "left": 5.0, "right": 5.0}, lines), {"left", "right"})

    def test_what_is_run_in_any_case_stays_and_makes_others_needless(self):
        lines = {"kept": {"x:1"}, "dear": {"x:1", "x:2"}, "same": {"x:1"}, "quick": {"x:2"}}
        seconds = {"kept": 9.0, "dear": 5.0, "same": 0.1, "quick": 1.0}
        self.assertEqual(asan_cover.cover(seconds, lines, {"kept"}), {"kept", "quick"})

    def test_whose_data_counts_is_known_by_its_name(self):
        names = ["RecordMutation.ThousandsLetNoTornOrForeignRecordThrough", "BrokenInput.ModelsAreRefusedBySlice",
                 "WriterDeath.AtAnyInstant", "CoreReplay.CarvingByCommandsTwiceGivesTheSameBytes", "CoreFault.AKilledCoreLeaves",
                 "SnapshotFault.AFullDisk", "Gcode/BadPrograms.AreTold/endless", "FromPackages/RealMeshes.AreSliced/bearing",
                 "PrintableOutput.IsAllThatCommandsSayOfHostileNames"]
        self.assertEqual([name for name in names if not asan_cover.counts_by_its_data(name)], [])
        others = ["HeadLift.LeavesEveryPulse", "FromPackages/RealMeshGouges.AreNoDeeper/bunny", "Skill.OfAnything",
                  "DefaultTool.IsOne"]
        self.assertEqual([name for name in others if asan_cover.counts_by_its_data(name)], [])


class Lists(unittest.TestCase):
    def test_name_no_test_whose_data_counts_and_are_of_programs_that_say_so(self):
        self.assertIn("hmi_ui_test", asan_cover.listed_programs())
        for program in asan_cover.listed_programs():
            self.assertEqual([name for name in asan_cover.left_out(program) if asan_cover.counts_by_its_data(name)], [], program)
            with open(os.path.join(os.path.dirname(asan_cover.list_path(program)), "CMakeLists.txt"), encoding="utf-8") as file:
                self.assertRegex(file.read(), rf"psicarve_test\({program} (\w+ )*REPEATS\b")

    def test_name_tests_that_exist(self):
        for path in glob.glob(os.path.join(ROOT, "tests", "**", "*.repeats"), recursive=True):
            text = ""
            for source in glob.glob(os.path.join(os.path.dirname(path), "*.cpp")):
                with open(source, encoding="utf-8") as file:
                    text += file.read()
            tests = {f"{suite}.{name}" for suite, name in re.findall(r"TEST(?:_[FP])?\(\s*(\w+),\s*(\w+)\)", text)}
            with open(path, encoding="utf-8") as file:
                named = [line.strip() for line in file if not line.startswith("#")]
            self.assertTrue(named, path)
            # INSTANCE/SUITE.TEST/PARAMETER
            plain = {name: re.sub(r"^[^./]*/(?=[^/]*\.)|(?<=\w)/[^/]*$", "", name) for name in named}
            self.assertEqual([name for name in named if plain[name] not in tests], [], path)


if __name__ == "__main__":
    unittest.main()
