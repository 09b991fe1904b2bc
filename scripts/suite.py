#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the suite of a build and tells tests that are broken from tests that are flaky.

usage: suite.py run PRESET LOGS [CTEST ARGUMENT...]
       suite.py again BUILD N NAME

run: all tests side by side. Those that fail run again, alone, at most twice: whoever fails three times is broken. Who
passes then is flaky: a line FLAKY goes to LOGS/flaky, what it said at first to LOGS/flaky-PRESET-NAME.log, and whoever
calls us decides how many are too many. No second chance has a test whose outcome must not depend on what else the
computer does (EXACT below), nor one that a sanitizer has reported on.
Exit codes: 0 passed, perhaps flaky; 1 something is broken; 2 wrong usage.

again: the tests called NAME (a name, or the beginning of several, as Jogging.) N times each, with as many busy loops
beside them as there are processors. Says how often each failed; what it said then is in BUILD/again-NAME.log.
Exit codes: 0 none failed; 1 some did; 2 no such test, or wrong usage.
"""

import json
import os
import re
import shlex
import subprocess
import sys
import tempfile
import time
import xml.etree.ElementTree as ElementTree

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
    r"^CoreGuard\.",
]
SANITIZER_REPORT = re.compile(
    r"ERROR: (Address|Leak)Sanitizer|WARNING: ThreadSanitizer|runtime error: |UndefinedBehaviorSanitizer"
)


def root():
    return os.path.dirname(os.path.dirname(os.path.realpath(__file__)))


def run_ctest(preset, log, arguments):
    """ctest's exit code, (name, output) of each test that failed, and all names. What it says goes to `log` and to us."""
    with tempfile.NamedTemporaryFile(suffix=".xml") as report:
        command = ["ctest", "--preset", preset, "--no-tests=error", "--output-junit", report.name, *arguments]
        with open(log, "a", encoding="utf-8", errors="replace") as file:
            run = subprocess.Popen(command, cwd=root(), stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace")
            for line in run.stdout:
                file.write(line)
                print(line, end="", flush=True)  # whoever is ended at the time limit has said how far it came
            code = run.wait()
        try:
            cases = list(ElementTree.parse(report.name).getroot().iter("testcase"))
        except ElementTree.ParseError:  # it ended before it wrote one
            return code or 1, [], []
        failed = [(case.get("name"), case.findtext("system-out") or "") for case in cases if case.get("status") == "fail"]
        return code, failed, [case.get("name") for case in cases]


def why_no_second_chance(name, output):
    if any(re.search(pattern, name) for pattern in EXACT):
        return "it must never fail"
    if SANITIZER_REPORT.search(output):
        return "a sanitizer has reported"
    return ""


def file_name_of(name):
    return re.sub(r"[^A-Za-z0-9.]+", "_", name)[:120]


def only(name):
    """ctest arguments for this test alone."""
    quoted = re.sub(r"([][^$.*+?|()\\])", r"\\\1", name)  # CMake's own expressions know no more than these
    return ["--parallel", "1", "-R", f"^{quoted}$"]


def try_again(preset, log, name):
    """How often a test that failed once was tried altogether; None when it never passed."""
    for tried in range(SECOND_CHANCES):
        code, _, _ = run_ctest(preset, log, only(name))
        if code == 0:
            return tried + 2
    return None


def run(preset, logs, arguments):
    log = os.path.join(logs, f"ctest-{preset}.log")
    code, failed, names = run_ctest(preset, log, arguments)
    # dev has all tests.
    forgotten = [pattern for pattern in EXACT if not any(re.search(pattern, name) for name in names)]
    if preset == "dev" and names and forgotten:
        print(f"no test is called {' or '.join(forgotten)} any more: EXACT in scripts/suite.py", flush=True)
        return 1
    if code == 0:
        return 0
    if not failed:  # it did not come so far
        return 1
    if len(failed) > MOST_TRIED_AGAIN:
        print(f"{len(failed)} tests failed: none is tried again", flush=True)
        return 1
    is_broken = False
    for name, output in failed:
        reason = why_no_second_chance(name, output)
        if reason:
            print(f"no second chance for {name}: {reason}", flush=True)
            is_broken = True
            continue
        kept = os.path.join(logs, f"flaky-{preset}-{file_name_of(name)}.log")
        with open(kept, "w", encoding="utf-8", errors="replace") as file:
            file.write(output)
        tries = try_again(preset, log, name)
        if tries is None:
            is_broken = True
            continue
        with open(os.path.join(logs, "flaky"), "a", encoding="utf-8") as file:
            file.write(f"FLAKY {name} ({preset}), failed {tries - 1} of {tries}; first output: {os.path.relpath(kept, root())}\n")
    return 1 if is_broken else 0


def tests_called(build, name):
    """ctest's own description of each test with this name, or that begins with it."""
    text = subprocess.run(["ctest", "--show-only=json-v1"], cwd=build, capture_output=True, text=True, check=True).stdout
    tests = [test for test in json.loads(text)["tests"] if "command" in test]
    return [test for test in tests if test["name"] == name] or [test for test in tests if test["name"].startswith(name)]


def property_of(test, name, otherwise):
    return next((entry["value"] for entry in test.get("properties", []) if entry["name"] == name), otherwise)


def run_one(test):
    """Exit code and output of one run, as ctest would run it."""
    environment = dict(os.environ)
    environment.update(entry.split("=", 1) for entry in property_of(test, "ENVIRONMENT", []))
    try:
        ran = subprocess.run(
            test["command"], cwd=property_of(test, "WORKING_DIRECTORY", None), env=environment, stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=property_of(test, "TIMEOUT", 600), check=False,
        )
        return ran.returncode, ran.stdout.decode(errors="replace")
    except subprocess.TimeoutExpired as expired:
        return -1, (expired.stdout or b"").decode(errors="replace") + "\nit ran into its time limit\n"


def again(build, times, name):
    tests = tests_called(build, name)
    if not tests:
        print(f"no test of {build} is called {name}, or begins so", file=sys.stderr)
        return 2
    log = os.path.join(build, f"again-{file_name_of(name)}.log")
    busy = [subprocess.Popen(["sh", "-c", "while :; do :; done"]) for _ in range(os.cpu_count() or 1)]
    failures = dict.fromkeys((test["name"] for test in tests), 0)
    last_word = time.monotonic()
    try:
        with open(log, "w", encoding="utf-8", errors="replace") as file:
            for n in range(1, times + 1):
                for test in tests:
                    code, output = run_one(test)
                    if code != 0:
                        failures[test["name"]] += 1
                        file.write(f"==== {test['name']}, run {n}: exit code {code}\n{shlex.join(test['command'])}\n{output}\n")
                        file.flush()
                if time.monotonic() - last_word > 10:
                    last_word = time.monotonic()
                    print(f"{n} of {times}, failed so far: {sum(failures.values())}", flush=True)
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
        return run(arguments[1], arguments[2], arguments[3:])
    if len(arguments) == 4 and arguments[0] == "again" and arguments[2].isdecimal() and int(arguments[2]) > 0:
        return again(arguments[1], int(arguments[2]), arguments[3])
    print(__doc__.strip(), file=sys.stderr)
    return 2


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
