# SPDX-License-Identifier: GPL-3.0-or-later
"""The suites of several presets as one, for suite.py: ctest runs all their tests side by side, so that those that compute
have the processor while others wait for a clock, whichever preset they are of, and a resource that a test holds is held
against the tests of every preset. A test is called PRESET:NAME there."""

import json
import os
import re
import subprocess
import time


def bracketed(text):
    """A word of CMake in which nothing is special."""
    marks = "="
    while f"]{marks}]" in text or text.endswith(f"]{marks}"):
        marks += "="
    return f"[{marks}[{text}]{marks}]"


def tests_of(preset, root):
    """ctest's own description of each test of a preset that has been built."""
    shown = subprocess.run(
        ["ctest", "--preset", preset, "--show-only=json-v1"], cwd=root, capture_output=True, text=True, check=False,
    )
    if shown.returncode != 0:
        raise RuntimeError(f"ctest does not say what tests {preset} has: {shown.stderr.strip()}")
    return json.loads(shown.stdout)["tests"]


def value_of(entry, environment):
    """What a property is set to; environment is added to a test's own."""
    value = entry["value"]
    if entry["name"] == "ENVIRONMENT":
        value = value + environment
    if isinstance(value, list):
        return ";".join(item.replace(";", "\\;") for item in value)
    if isinstance(value, bool):
        return "TRUE" if value else "FALSE"
    return f"{value:g}" if isinstance(value, float) else str(value)


def lines_for(preset, test, environment):
    """add_test() and set_tests_properties() of one test. One that was not built has no command, and none is found."""
    name = bracketed(f"{preset}:{test['name']}")
    command = " ".join(bracketed(word) for word in test.get("command", [f"{test['name']}_NOT_BUILT"]))
    properties = test.get("properties", [])
    if not any(entry["name"] == "ENVIRONMENT" for entry in properties):
        properties = [*properties, {"name": "ENVIRONMENT", "value": []}]
    pairs = " ".join(f"{entry['name']} {bracketed(value_of(entry, environment))}" for entry in properties)
    return f"add_test({name} {command})\nset_tests_properties({name} PROPERTIES {pairs})\n"


def is_left_out(test):
    """Whether only a long run has it (tests/CMakeLists.txt)."""
    labels = next((entry["value"] for entry in test.get("properties", []) if entry["name"] == "LABELS"), [])
    return "long" in labels and os.environ.get("PSICARVE_LONG") != "1"


def write_pool(folder, root, environments):
    """Makes folder a build folder for ctest with the tests of all presets. environments: preset -> [VARIABLE=VALUE...].
    Returns how many tests of each preset are left out."""
    os.makedirs(folder, exist_ok=True)
    left_out = dict.fromkeys(environments, 0)
    with open(os.path.join(folder, "CTestTestfile.cmake"), "w", encoding="utf-8") as file:
        for preset, environment in environments.items():
            for test in tests_of(preset, root):
                if is_left_out(test):
                    left_out[preset] += 1
                    continue
                file.write(lines_for(preset, test, environment))
    return left_out


class Stopwatch:
    """When the last test of each preset had ended, from what ctest says of each as it goes [s since the begin]."""

    def __init__(self):
        self.begin = time.monotonic()
        self.last_end = {}

    def hear(self, line):
        ended = re.match(r" *\d+/\d+ +Test +#\d+: (\w+):", line)
        if ended:
            self.last_end[ended[1]] = time.monotonic() - self.begin

    def seconds(self, preset):
        return self.last_end.get(preset, 0.0)


def summary(names, failed, not_run, seconds, left_out=0):
    """The closing words of ctest for the tests of one preset. not_run: (name, why)."""
    if not names:
        return "0% tests passed, no test ran, or ctest ended before it could say which did\n"
    ran = len(names) - len(not_run)
    bad = len(failed) + sum(why != "Skipped" for _, why in not_run)
    share = 100 if not bad else min(99, 100 * (ran - len(failed)) // len(names))
    lines = [f"{share}% tests passed, {bad} tests failed out of {len(names)}", "", f"Total Test time (real) = {seconds:6.2f} sec"]
    if left_out:
        lines += ["", f"{left_out} more tests run with --long"]
    if not_run:
        lines += ["", "The following tests did not run:", *(f"\t{name} ({why})" for name, why in not_run)]
    if failed:
        lines += ["", "The following tests FAILED:", *(f"\t{name} (Failed)" for name in failed)]
    return "\n".join(lines) + "\n"
