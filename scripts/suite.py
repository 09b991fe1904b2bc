#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the suites of builds and tells tests that are broken from tests that are flaky.

usage: suite.py run PRESET[,PRESET...] LOGS [CTEST ARGUMENT...]
       suite.py again BUILD N NAME

run: all tests of these presets side by side, as one suite (pool.py), in build/suite. Those that fail run again, alone, at
most twice: whoever fails three times is broken. Who passes then is flaky: a line FLAKY goes to LOGS/flaky, what it said at
first to LOGS/flaky-PRESET-NAME.log, and whoever calls us decides how many are too many. No second chance has a test whose
outcome must not depend on what else the computer does (EXACT below). What a sanitizer reports, of any process and whatever
its test says, goes to LOGS/sanitizer-PRESET.PID and is broken (a process that has become another user may not write there,
and its report goes where its errors go). So is a test that could not be started.
What ctest says goes to LOGS/ctest-all.log; of each preset its closing words, and of what was tried again, to
LOGS/ctest-PRESET.log, and one line to LOGS/verdicts: PRESET, passed or FAILED, and after how many seconds its last test had
ended.
Exit codes: 0 passed, perhaps flaky; 1 something is broken; 2 wrong usage.

again: the tests called NAME (a name, or the beginning of several, as Jogging.) N times each, with as many busy loops
beside them as there are processors. Says how often each failed; what it said then is in BUILD/again-NAME.log.
Exit codes: 0 none failed; 1 some did; 2 no such test, or wrong usage.
"""

import glob
import json
import os
import re
import shlex
import signal
import subprocess
import sys
import tempfile
import time
import xml.etree.ElementTree as ElementTree

sys.dont_write_bytecode = True
import pool  # noqa: E402  beside us

SECOND_CHANCES = 2
MOST_TRIED_AGAIN = 20  # of a suite: where more fail it is not for want of luck

# Equality of bytes, mutated segments, deaths of processes, the guard: a failure that comes now and then is a fault.
EXACT = [
    r"SameBytes",
    r"ByteForByte",
    r"^SegmentMutation\.",
    r"^CarvingMutation\.",
    r"^SegmentDeath\.",
    r"^OperatorDeath\.",
    r"^SamePulses\.",
    r"^WriterDeath\.",
    r"^CoreGuard\.",
]
SANITIZER_VARIABLES = ["ASAN_OPTIONS", "UBSAN_OPTIONS", "TSAN_OPTIONS"]
LINES_OF_A_REPORT = 60


def root():
    return os.path.dirname(os.path.dirname(os.path.realpath(__file__)))


def report_path(folder, preset):
    """To this, with a dot and the process' number behind it, sanitizers write."""
    return os.path.join(os.path.abspath(folder), f"sanitizer-{preset}")


def sanitizer_variables(path):
    """[VARIABLE=VALUE...]: standard error of the processes that a test starts goes to files that are gone when the test is."""
    variables = []
    for variable in SANITIZER_VARIABLES:
        before = os.environ.get(variable)
        variables.append(f"{variable}=" + (before + ":" if before else "") + f"log_path=\"{path}\"")
    return variables


def sanitizer_environment(path):
    return {**os.environ, **dict(entry.split("=", 1) for entry in sanitizer_variables(path))}


def reports_at(path):
    """(file, how it begins) of each report of a sanitizer."""
    reports = []
    for report in sorted(glob.glob(glob.escape(path) + ".*")):
        with open(report, encoding="utf-8", errors="replace") as file:
            reports.append((report, "\n".join(file.read().splitlines()[:LINES_OF_A_REPORT])))
    return reports


class Outcome:
    """What ctest said of a run: its exit code, (name, output) of each test that failed, the names of those that could not
    be started, of those that left themselves out, and of all."""

    def __init__(self, code, cases):
        self.code = code
        self.failed = [(case.get("name"), case.findtext("system-out") or "") for case in cases if case.get("status") == "fail"]
        self.names = [case.get("name") for case in cases]
        self.skipped = []
        self.not_started = []
        for case in cases:
            if case.get("status") != "notrun":
                continue
            skipped = case.find("skipped")
            message = "" if skipped is None else skipped.get("message") or ""
            (self.skipped if message.startswith("SKIP_") else self.not_started).append(case.get("name"))

    def of(self, preset):
        """That part of a run of several presets that is of this one."""
        part = Outcome(self.code, [])
        own = f"{preset}:"
        part.names, part.skipped, part.not_started = (
            [name.removeprefix(own) for name in names if name.startswith(own)]
            for names in (self.names, self.skipped, self.not_started)
        )
        part.failed = [(name.removeprefix(own), output) for name, output in self.failed if name.startswith(own)]
        return part

    def summary(self, seconds, left_out):
        not_run = [(name, "Skipped") for name in self.skipped] + [(name, "Not Run") for name in self.not_started]
        return pool.summary(self.names, [name for name, _ in self.failed], not_run, seconds, left_out)


def run_ctest(log, arguments, environment=None, hear=lambda line: None):
    """Runs tests. What ctest says goes to log, to us, and line by line to hear()."""
    with tempfile.NamedTemporaryFile(suffix=".xml") as report:
        command = ["ctest", "--no-tests=error", "--output-junit", report.name, *arguments]
        with open(log, "a", encoding="utf-8", errors="replace") as file:
            run = subprocess.Popen(
                command, cwd=root(), env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                errors="replace",
            )
            for line in run.stdout:
                file.write(line)
                print(line, end="", flush=True)  # a suite that is ended at the time limit has said how far it came
                hear(line)
            code = run.wait()
        try:
            return Outcome(code, list(ElementTree.parse(report.name).getroot().iter("testcase")))
        except ElementTree.ParseError:  # it ended before it wrote one
            return Outcome(code or 1, [])


def file_name_of(name):
    return re.sub(r"[^A-Za-z0-9.]+", "_", name)[:120]


def only(name):
    """ctest arguments for this test alone."""
    quoted = re.sub(r"([][^$.*+?|()\\])", r"\\\1", name)  # CMake's own expressions know no more than these
    return ["--parallel", "1", "-R", f"^{quoted}$"]


def try_again(preset, logs, name):
    """How often a test that failed once was tried altogether; None when it never passed."""
    log = os.path.join(logs, f"ctest-{preset}.log")
    environment = sanitizer_environment(report_path(logs, preset))
    for tried in range(SECOND_CHANCES):
        outcome = run_ctest(log, ["--preset", preset, *only(name)], environment)
        if outcome.code == 0 and outcome.names == [name] and not outcome.skipped:
            return tried + 2
    return None


def judge_failed(preset, logs, name, output):
    """Whether a test that failed passes when it is tried again; then it is noted as flaky."""
    if any(re.search(pattern, name) for pattern in EXACT):
        print(f"no second chance for {name}: it must never fail", flush=True)
        return False
    kept = os.path.join(logs, f"flaky-{preset}-{file_name_of(name)}.log")
    with open(kept, "w", encoding="utf-8", errors="replace") as file:
        file.write(output)
    tries = try_again(preset, logs, name)
    if tries is None:
        return False
    with open(os.path.join(logs, "flaky"), "a", encoding="utf-8") as file:
        file.write(f"FLAKY {name} ({preset}), failed {tries - 1} of {tries}; first output: {os.path.relpath(kept, root())}\n")
    return True


def judge(preset, logs, outcome, may_try_again):
    """Whether the tests of one preset have passed, if need be when they are tried again."""
    is_green = not outcome.failed and bool(outcome.names)
    # dev has all tests.
    forgotten = [pattern for pattern in EXACT if not any(re.search(pattern, name) for name in outcome.names)]
    if preset == "dev" and outcome.names and forgotten:
        print(f"no test is called {' or '.join(forgotten)} any more: EXACT in scripts/suite.py", flush=True)
        return False
    if outcome.not_started:
        print(f"could not be started ({preset}): " + ", ".join(outcome.not_started), flush=True)
    elif outcome.failed and may_try_again:
        verdicts = [judge_failed(preset, logs, name, output) for name, output in outcome.failed]
        is_green = all(verdicts)
    reports = reports_at(report_path(logs, preset))
    for report, text in reports:
        print(f"a sanitizer has reported: {os.path.relpath(report, root())}\n{text}", flush=True)
    return is_green and not outcome.not_started and not reports


def run(presets, logs, arguments):
    folder = os.path.join(root(), "build", "suite")
    left_out = pool.write_pool(folder, root(), {preset: sanitizer_variables(report_path(logs, preset)) for preset in presets})
    watch = pool.Stopwatch()
    outcome = run_ctest(
        os.path.join(logs, "ctest-all.log"), ["--test-dir", folder, "--output-on-failure", *arguments], hear=watch.hear,
    )
    parts = {preset: outcome.of(preset) for preset in presets}
    for preset, part in parts.items():
        with open(os.path.join(logs, f"ctest-{preset}.log"), "a", encoding="utf-8") as file:
            file.write(part.summary(watch.seconds(preset), left_out[preset]))
    may_try_again = len(outcome.failed) <= MOST_TRIED_AGAIN
    if not may_try_again:
        print(f"{len(outcome.failed)} tests failed: none is tried again", flush=True)
    # A code that no test explains is red for all.
    is_explained = outcome.code == 0 or bool(outcome.failed or outcome.not_started)
    verdicts = {preset: judge(preset, logs, part, may_try_again) and is_explained for preset, part in parts.items()}
    with open(os.path.join(logs, "verdicts"), "a", encoding="utf-8") as file:
        for preset, is_green in verdicts.items():
            file.write(f"{preset} {'passed' if is_green else 'FAILED'} {watch.seconds(preset):.0f}\n")
    return 0 if all(verdicts.values()) else 1


def tests_called(build, name):
    """ctest's own description of each test with this name, or that begins with it."""
    text = subprocess.run(["ctest", "--show-only=json-v1"], cwd=build, capture_output=True, text=True, check=True).stdout
    tests = [test for test in json.loads(text)["tests"] if "command" in test]
    return [test for test in tests if test["name"] == name] or [test for test in tests if test["name"].startswith(name)]


def property_of(test, name, otherwise):
    return next((entry["value"] for entry in test.get("properties", []) if entry["name"] == name), otherwise)


def run_one(test, reports):
    """Exit code and output of one run, as ctest would run it; `reports`: where sanitizers write."""
    environment = sanitizer_environment(reports)
    environment.update(entry.split("=", 1) for entry in property_of(test, "ENVIRONMENT", []))
    try:
        ran = subprocess.run(
            test["command"], cwd=property_of(test, "WORKING_DIRECTORY", None), env=environment, stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=property_of(test, "TIMEOUT", 600), check=False,
        )
        code, output = ran.returncode, ran.stdout.decode(errors="replace")
    except subprocess.TimeoutExpired as expired:
        code, output = -1, (expired.stdout or b"").decode(errors="replace") + "\nit ran into its time limit\n"
    if code == 0 and re.search(r"^\[  SKIPPED \]", output, re.MULTILINE):
        code = -1
    for report, text in reports_at(reports):
        code, output = code or -1, f"{output}\n{text}\n"
        os.remove(report)
    return code, output


def again(build, times, name):
    tests = tests_called(build, name)
    if not tests:
        print(f"no test of {build} is called {name}, or begins so", file=sys.stderr)
        return 2
    log = os.path.join(build, f"again-{file_name_of(name)}.log")
    reports = report_path(build, f"again-{os.getpid()}")
    for report, _ in reports_at(reports):
        os.remove(report)  # of one that was interrupted and had this number
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(1))  # the busy loops end with us
    busy = []
    failures = dict.fromkeys((test["name"] for test in tests), 0)
    last_word = time.monotonic()
    try:
        for _ in range(os.cpu_count() or 1):
            busy.append(subprocess.Popen(["sh", "-c", "while :; do :; done"]))
        with open(log, "w", encoding="utf-8", errors="replace") as file:
            for n in range(1, times + 1):
                for test in tests:
                    code, output = run_one(test, reports)
                    if code != 0:
                        failures[test["name"]] += 1
                        file.write(f"==== {test['name']}, run {n}: exit code {code}\n{shlex.join(test['command'])}\n{output}\n")
                        file.flush()
                if time.monotonic() - last_word > 10:
                    last_word = time.monotonic()
                    print(f"{n} of {times}, failed so far: {sum(failures.values())}", flush=True)
            for report, text in reports_at(reports):  # of what was still at it when its test had ended
                failures[tests[-1]["name"]] += 1
                file.write(f"==== after the last run\n{text}\n")
                os.remove(report)
    finally:
        for loop in busy:
            loop.kill()
    for test, failed in failures.items():
        print(f"{test}: failed {failed} of {times} ({100.0 * failed / times:.1f} %), {len(busy)} busy loops beside it")
    if any(failures.values()):
        print(f"what they said: {os.path.relpath(log)}")
        return 1
    os.remove(log)
    return 0


def main(arguments):
    if len(arguments) >= 3 and arguments[0] == "run":
        return run(arguments[1].split(","), arguments[2], arguments[3:])
    if len(arguments) == 4 and arguments[0] == "again" and arguments[2].isdecimal() and int(arguments[2]) > 0:
        return again(arguments[1], int(arguments[2]), arguments[3])
    print(__doc__.strip(), file=sys.stderr)
    return 2


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
