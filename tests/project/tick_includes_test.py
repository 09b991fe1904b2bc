#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""tick_includes_test.py: what runs in the tick reaches no header that allocates, locks, blocks or talks.

architecture_test.cmake judges what a file of rtcore/cycle includes itself. This follows the includes through our own
headers, of all files of rtcore/cycle and of every header that says `RT: yes`. Which headers are meant is one list,
there (banned_in_cycle)."""

import os
import re
import sys
import tempfile
import unittest

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*(["<])([^">]+)', re.MULTILINE)

MADE_BEFORE = "made before the first tick, which calls it and owns nothing of it: "
SIMULATED = MADE_BEFORE + "a simulated machine, whose configuration comes of a profile"
# Header -> why it may reach what the tick must not use. Nothing of rtcore/cycle may stand here.
EXCEPTIONS = {
    "rtcore/guard/guard_link.hpp": MADE_BEFORE + "opening the guard's page tells errors as text",
    "rtcore/guard/guard_page.hpp": MADE_BEFORE + "opening the guard's page tells errors as text",
    "rtcore/port/fatal_signals.hpp": MADE_BEFORE + "registers are found by a pin map, which errors and a profile make",
    "rtcore/port/parallel_port.hpp": MADE_BEFORE + "opening the hardware tells errors as text",
    "rtcore/port/port_access.hpp": MADE_BEFORE + "registers are found by a pin map, which errors and a profile make",
    "rtcore/port/pulse_times.hpp": MADE_BEFORE + "its times come of a profile",
    "rtcore/port/sim_port.hpp": SIMULATED,
    "rtcore/realtime/priority_mutex.hpp": "the one lock of schedule two-timer, which lets in one half of a tick",
    "rtcore/replay/recorded_inputs_port.hpp": MADE_BEFORE + "it owns its recording",
    "rtcore/sim/axis_unit.hpp": SIMULATED,
    "rtcore/sim/machine.hpp": SIMULATED,
    "rtcore/sim/motor.hpp": SIMULATED,
    "rtcore/sim/rotor_reach.hpp": SIMULATED,
    "rtcore/sim/sensor.hpp": SIMULATED,
    "rtcore/sim/wiring.hpp": SIMULATED,
    "rtcore/sim/workpiece.hpp": SIMULATED,
    "rtcore/supervisor/replay.hpp": MADE_BEFORE + "a replay's script is read from a file by the core's own parts",
    "shared/job/job.hpp": "one function beside a job's table, of numbers alone",
    "shared/job/outside.hpp": MADE_BEFORE + "its limits come of a job",
    "shared/profile/pin_map.hpp": MADE_BEFORE + "its tables come of a profile; a tick looks up in them",
}


def banned_headers(root):
    with open(os.path.join(root, "tests", "architecture_test.cmake"), encoding="utf-8") as file:
        return set(re.search(r"set\(banned_in_cycle\s([^)]*)\)", file.read()).group(1).split())


def text_of(root, path):
    with open(os.path.join(root, path), encoding="utf-8") as file:
        return file.read()


def begins(root):
    """All files of the tick, and every header that says that it may run there."""
    found = []
    for side in ("rtcore", "shared", "hmi"):
        for folder, _, names in os.walk(os.path.join(root, side)):
            for name in names:
                path = os.path.relpath(os.path.join(folder, name), root).replace(os.sep, "/")
                is_tick = path.startswith("rtcore/cycle/") and path.endswith((".hpp", ".cpp"))
                if is_tick or (path.endswith(".hpp") and "RT: yes" in text_of(root, path)):
                    found.append(path)
    return sorted(found)


def way_to_banned(root, begin, banned):
    """The shortest chain of includes from this file to a banned header; [] when there is none."""
    came_from = {begin: None}
    waiting = [begin]
    while waiting:
        path = waiting.pop(0)
        for quote, target in INCLUDE.findall(text_of(root, path)):
            if quote == "<" and re.split(r"[/+]", target)[0] in banned:
                way = [target]
                while path:
                    way.append(path)
                    path = came_from[path]
                return way[::-1]
            if quote == '"' and target not in came_from and os.path.isfile(os.path.join(root, target)):
                came_from[target] = path
                waiting.append(target)
    return []


def violations(root, banned, exceptions):
    found = []
    unused = set(exceptions)
    for begin in begins(root):
        way = way_to_banned(root, begin, banned)
        if way and (begin not in exceptions or begin.startswith("rtcore/cycle/")):
            found.append(" -> ".join(way))
        if way:
            unused.discard(begin)
    return found + [f"{path}: an exception that none needs" for path in sorted(unused)]


class Rule(unittest.TestCase):
    def violations_of(self, files, exceptions=()):
        with tempfile.TemporaryDirectory() as root:
            for path, text in files.items():
                os.makedirs(os.path.dirname(os.path.join(root, path)), exist_ok=True)
                with open(os.path.join(root, path), "w", encoding="utf-8") as file:
                    file.write(text)
            return violations(root, {"string", "mutex", "boost", "toml"}, dict.fromkeys(exceptions, "why"))

    def test_a_clean_tick_passes(self):
        self.assertEqual(self.violations_of({
            "rtcore/cycle/a.cpp": '#include "shared/base/a.hpp"\n#include <array>\n#include <string_view>\n',
            "shared/base/a.hpp": "#include <cstdint>\n",
            "shared/base/b.hpp": "#include <string>\n"}), [])

    def test_the_chain_is_told(self):
        self.assertEqual(self.violations_of({
            "rtcore/cycle/a.cpp": '#include "shared/base/a.hpp"\n',
            "shared/base/a.hpp": '#include "shared/base/b.hpp"\n',
            "shared/base/b.hpp": '#include "shared/base/a.hpp"\n  #  include <string>\n'}),
            ["rtcore/cycle/a.cpp -> shared/base/a.hpp -> shared/base/b.hpp -> string"])

    def test_a_library_is_known_by_its_folder(self):
        for header in ("boost/interprocess/offset_ptr.hpp", "toml++/toml.h", "mutex"):
            self.assertEqual(self.violations_of({"rtcore/cycle/a.hpp": f"#include <{header}>\n"}),
                             [f"rtcore/cycle/a.hpp -> {header}"])

    def test_headers_that_say_so_are_judged_too(self):
        files = {"shared/base/a.hpp": '/// RT: yes.\n#include "shared/base/b.hpp"\n',
                 "shared/base/b.hpp": "#include <string>\n"}
        self.assertEqual(self.violations_of(files), ["shared/base/a.hpp -> shared/base/b.hpp -> string"])
        self.assertEqual(self.violations_of(files, ["shared/base/a.hpp"]), [])

    def test_an_exception_does_not_hold_for_the_tick(self):
        files = {"rtcore/cycle/a.hpp": '#include "shared/base/a.hpp"\n',
                 "shared/base/a.hpp": "/// RT: yes.\n#include <string>\n"}
        expected = ["rtcore/cycle/a.hpp -> shared/base/a.hpp -> string"]
        self.assertEqual(self.violations_of(files, ["shared/base/a.hpp"]), expected)
        self.assertEqual(self.violations_of(files, ["shared/base/a.hpp", "rtcore/cycle/a.hpp"]), expected)

    def test_an_exception_that_none_needs_is_told(self):
        files = {"shared/base/a.hpp": "/// RT: yes.\n#include <array>\n"}
        for path in ("shared/base/a.hpp", "shared/base/gone.hpp"):
            self.assertEqual(self.violations_of(files, [path]), [f"{path}: an exception that none needs"])


class Tree(unittest.TestCase):
    def test_keeps_the_rule(self):
        banned = banned_headers(ROOT)
        self.assertLessEqual({"string", "vector", "map", "mutex", "iostream", "functional"}, banned)
        self.assertGreater(len(begins(ROOT)), 60)
        self.assertEqual(violations(ROOT, banned, EXCEPTIONS), [])


if __name__ == "__main__":
    sys.exit(unittest.main())
