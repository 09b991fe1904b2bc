# SPDX-License-Identifier: GPL-3.0-or-later
"""usage: suite_test.py ROOT WORK
The suites of two presets as one (scripts/suite.py, scripts/pool.py), of a project without a build: its tests are shell
commands, its presets' folders hold a CTestTestfile.cmake."""

import os
import shutil
import subprocess
import sys
import unittest

SOURCE, WORK = os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2])
PRESETS = """{"version": 6, "configurePresets": [%s], "testPresets": [%s]}"""
# dev has all tests: suite.py wants one of each kind that has no second chance.
EXACT = ["A.SameBytes", "A.ByteForByte", "SegmentMutation.A", "CarvingMutation.A", "SegmentDeath.A", "OperatorDeath.A", "CoreGuard.A",
         "SamePulses.A", "WriterDeath.A"]


def test(name, command, properties=""):
    text = f'add_test([=[{name}]=] "/bin/sh" "-c" [=[{command}]=])\n'
    return text + (f"set_tests_properties([=[{name}]=] PROPERTIES {properties})\n" if properties else "")


class Suite(unittest.TestCase):
    def setUp(self):
        shutil.rmtree(WORK, ignore_errors=True)
        os.makedirs(os.path.join(WORK, "scripts"))
        self.logs = os.path.join(WORK, "logs")
        os.makedirs(self.logs)
        for script in ("suite.py", "pool.py"):
            shutil.copy(os.path.join(SOURCE, "scripts", script), os.path.join(WORK, "scripts", script))
        names = ["dev", "asan"]
        configure = ", ".join(
            f'{{"name": "{n}", "generator": "Ninja", "binaryDir": "${{sourceDir}}/build/{n}"}}' for n in names
        )
        tests = ", ".join(f'{{"name": "{n}", "configurePreset": "{n}"}}' for n in names)
        self.write("CMakePresets.json", PRESETS % (configure, tests))
        self.exact = "".join(test(name, "true") for name in EXACT)

    def write(self, name, text):
        path = os.path.join(WORK, name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)

    def read(self, name):
        with open(os.path.join(WORK, name), encoding="utf-8") as file:
            return file.read()

    def run_suite(self, dev, asan):
        self.write("build/dev/CTestTestfile.cmake", self.exact + dev)
        self.write("build/asan/CTestTestfile.cmake", asan)
        ran = subprocess.run(
            [sys.executable, "-B", "scripts/suite.py", "run", "dev,asan", self.logs, "--parallel", "4"], cwd=WORK,
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False,
        )
        self.said = ran.stdout
        self.verdicts = {line.split()[0]: line.split()[1] for line in self.read("logs/verdicts").splitlines()}
        return ran.returncode

    def test_both_pass_and_each_has_its_summary(self):
        self.assertEqual(self.run_suite(test("B.One  # GetParam() = ]=;\"x", "true"), test("B.One", "true")), 0, self.said)
        self.assertEqual(self.verdicts, {"dev": "passed", "asan": "passed"})
        self.assertIn(f"100% tests passed, 0 tests failed out of {len(EXACT) + 1}\n", self.read("logs/ctest-dev.log"))
        self.assertIn("100% tests passed, 0 tests failed out of 1\n", self.read("logs/ctest-asan.log"))

    def test_a_failure_is_its_own_presets_and_is_tried_three_times(self):
        count = os.path.join(WORK, "count")
        self.assertEqual(self.run_suite(test("B.One", "true"), test("B.One", f"echo >>{count}; exit 3")), 1)
        self.assertEqual(self.verdicts, {"dev": "passed", "asan": "FAILED"})
        self.assertEqual(self.read("count").count("\n"), 3)
        self.assertIn("0% tests passed, 1 tests failed out of 1\n", self.read("logs/ctest-asan.log"))
        self.assertIn("\tB.One (Failed)\n", self.read("logs/ctest-asan.log"))

    def test_who_passes_then_is_flaky_and_named_with_its_preset(self):
        mark = os.path.join(WORK, "mark")
        once = f"test -e {mark} || {{ touch {mark}; echo at first; exit 1; }}"
        self.assertEqual(self.run_suite("", test("B.One", once)), 0, self.said)
        self.assertIn("FLAKY B.One (asan), failed 1 of 2; ", self.read("logs/flaky"))
        self.assertIn("at first", self.read("logs/flaky-asan-B.One.log"))

    def test_what_must_never_fail_has_no_second_chance(self):
        count = os.path.join(WORK, "count")
        self.assertEqual(self.run_suite("", test("CoreGuard.One", f"echo >>{count}; exit 1")), 1)
        self.assertEqual(self.read("count").count("\n"), 1)

    def test_a_resource_is_held_against_every_preset(self):
        held = os.path.join(WORK, "held")
        take = f"mkdir {held} || exit 1; sleep 0.3; rmdir {held}"
        lock = "RESOURCE_LOCK realtime"
        self.assertEqual(self.run_suite(test("B.One", take, lock), test("B.One", take, lock)), 0, self.said)
        self.assertFalse(os.path.exists(os.path.join(self.logs, "flaky")), self.said)

    def test_a_sanitizers_report_is_red_for_its_preset_whatever_the_test_says(self):
        report = 'p=${ASAN_OPTIONS##*log_path=}; p=${p#?}; echo found >"${p%?}.7"'
        self.assertEqual(self.run_suite("", test("B.One", report)), 1, self.said)
        self.assertEqual(self.verdicts, {"dev": "passed", "asan": "FAILED"})
        self.assertTrue(os.path.exists(os.path.join(self.logs, "sanitizer-asan.7")))

    def test_who_cannot_be_started_and_who_leaves_itself_out_are_told_apart(self):
        left_out = test("B.Two", "echo '[  SKIPPED ]'", r'SKIP_REGULAR_EXPRESSION [=[\[  SKIPPED \]]=]')
        self.assertEqual(self.run_suite(left_out, 'add_test(B.One "/nowhere/there")\n'), 1)
        self.assertEqual(self.verdicts, {"dev": "passed", "asan": "FAILED"})
        self.assertIn("\tB.Two (Skipped)\n", self.read("logs/ctest-dev.log"))
        self.assertIn("\tB.One (Not Run)\n", self.read("logs/ctest-asan.log"))

    def test_what_only_a_long_run_has_is_left_out_and_counted(self):
        count = os.path.join(WORK, "count")
        asan = test("B.One", f"echo one >>{count}") + test("B.Two", f"echo two >>{count}", "LABELS long")
        self.assertEqual(self.run_suite("", asan), 0, self.said)
        self.assertEqual(self.read("count").split(), ["one"])
        self.assertIn("0 tests failed out of 1\n", self.read("logs/ctest-asan.log"))
        self.assertIn("\n1 more tests run with --long\n", self.read("logs/ctest-asan.log"))
        self.assertNotIn("--long", self.read("logs/ctest-dev.log"))
        self.addCleanup(os.environ.pop, "PSICARVE_LONG")
        os.environ["PSICARVE_LONG"] = "1"
        self.assertEqual(self.run_suite("", asan), 0, self.said)
        self.assertEqual(sorted(self.read("count").split()), ["one", "one", "two"])

    def test_no_test_at_all_is_no_success(self):
        self.assertEqual(self.run_suite("", ""), 1)
        self.assertEqual(self.verdicts, {"dev": "passed", "asan": "FAILED"})
        self.assertTrue(self.read("logs/ctest-asan.log").startswith("0% tests passed, no test ran"))

    def test_a_ctest_that_dies_passes_nobody(self):
        self.assertEqual(self.run_suite(test("B.One", "kill -9 $PPID; true"), test("B.One", "true")), 1)
        self.assertEqual(self.verdicts, {"dev": "FAILED", "asan": "FAILED"})
        self.assertNotIn("100%", self.read("logs/ctest-dev.log") + self.read("logs/ctest-asan.log"))

    def test_a_kind_that_is_missing_in_dev_is_red(self):
        self.exact = self.exact.replace("OperatorDeath.A", "Renamed.A")
        self.assertEqual(self.run_suite("", test("B.One", "true")), 1)
        self.assertEqual(self.verdicts["dev"], "FAILED")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
