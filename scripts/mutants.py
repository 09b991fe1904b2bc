#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Changes one line of the product at a time and runs the unit tests of its folder: tells which changes none notices.

usage: mutants.py [--build FOLDER] [--every N] [--seed S] [--most N] [--lines A-B] [--again | --fresh] FILE...
       mutants.py [--build FOLDER] --list FILE...

FILE is a source below rtcore/cycle, shared/segment* or hmi/verify. Works on a copy of the sources in FOLDER
(build/mutants) and leaves the repository alone. A change that does not compile says nothing of the tests and is not
counted. What was tried stands in FOLDER/verdicts.json: another run goes on from there, and tries anew what stood in a
line that was changed since. A run of a whole folder takes hours. --again tries those that no test noticed once more, for
tests that are new; --fresh tries all of them.

--every N tries one of N changes, chosen by the seed; --most ends after so many. docs/mutants.md holds a verdict on every
change that no test noticed.

Exit code: 0 all changes were noticed, 1 some were not, 2 usage, 3 the tests fail without any change.
"""

import argparse
import hashlib
import json
import os
import random
import re
import shutil
import subprocess
import sys
import time

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))

# Begin of the path -> the test programs that must notice; the quickest first.
JUDGES = (
    ("rtcore/cycle/", ("cycle_parts_test", "cycle_interpolation_test", "cycle_pulse_test", "cycle_two_timer_test",
                       "cycle_machine_test", "cycle_moves_test", "cycle_path_test")),
    ("rtcore/guard/", ("guard_test",)),
    ("shared/segment/segment", ("shared_segment_test",)),
    ("hmi/verify/", ("hmi_verify_test", "hmi_trace_files_test")),
)
OPTIONS = ("-DCMAKE_BUILD_TYPE=Debug", "-DCMAKE_CXX_FLAGS_DEBUG=-O1", "-DPSICARVE_UNHURRIED_FLAGS=-O0",
           "-DPSICARVE_SWEEP_FLAGS=-O1", "-DPSICARVE_WINDOW=OFF", "-DCMAKE_UNITY_BUILD=OFF",
           "-DPSICARVE_WARNINGS_AS_ERRORS=OFF")
# A test that waits for what never comes now; a change that makes loops endless is noticed by that.
SLOWEST = 10
LEAST_S = 20

# Pattern in the code (comments and texts are blanked out before) -> what stands there instead.
OPERATORS = (
    (r"(?<![<>=!\-+*/&|^])<=(?!>)", "<"), (r"(?<![<>=!\-])>=", ">"),
    (r" < ", " <= "), (r" > ", " >= "), (r"==", "!="), (r"!=", "=="),
    (r"&&", "||"), (r"\|\|", "&&"), (r"(?<=[(\s])!(?=[\w(:])", ""),
    (r" \+ ", " - "), (r" - ", " + "), (r" \* ", " + "), (r" \+= ", " -= "), (r" -= ", " += "),
    (r" & ", " | "), (r" \| ", " & "), (r" &= ", " |= "), (r" \|= ", " &= "), (r"(?<=[\s(&])~(?=[\w(])", ""),
    (r"\btrue\b", "false"), (r"\bfalse\b", "true"),
    (r"\bstd::min\b", "std::max"), (r"\bstd::max\b", "std::min"),
    (r"\+\+", "--"), (r"(?<![\w.'])1(?![\w.'])", "2"), (r"(?<![\w.'])(?<!== )(?<!!= )0(?![\w.'x])", "1"),
)
# A statement by itself: an assignment or a call. Left out.
STATEMENT = re.compile(r"^\s+(?!return|const |constexpr|static|using|auto |case|throw|break|continue|else|default|if|for"
                       r"|while|switch|template|struct|class|enum|friend|public|private)[\w:.\->\[\]()*]+"
                       r"(?: (?:[-+*/|&^]|<<|>>)?= .*|\(.*\));$")
DECLARATION = re.compile(r"^\s*(static_assert|#|using |template|namespace|struct |class |enum |friend |\[\[)")


def blanked(line):
    """The line with comments and texts replaced by blanks of the same length."""
    line = re.sub(r'"(?:[^"\\]|\\.)*"', lambda text: '"' + " " * (len(text.group()) - 2) + '"', line)
    line = re.sub(r"(?<![\w])'(?:[^'\\]|\\.)'", lambda text: " " * len(text.group()), line)
    return re.sub(r"//.*$", lambda text: " " * len(text.group()), line)


def mutants_of(path):
    """[(line number, the line changed, what was done)] of a source."""
    with open(os.path.join(ROOT, path), encoding="utf-8") as file:
        lines = file.read().split("\n")
    found = []
    for number, line in enumerate(lines, 1):
        code = blanked(line)
        if DECLARATION.match(code) or not code.strip():
            continue
        for pattern, instead in OPERATORS:
            for hit in re.finditer(pattern, code):
                changed = line[:hit.start()] + instead + line[hit.end():]
                found.append((number, changed, f"{hit.group().strip() or '?'} -> {instead.strip() or 'nothing'}"))
        begun_before = number > 1 and blanked(lines[number - 2]).rstrip()[-1:] not in ("", ";", "{", "}", ":")
        if STATEMENT.match(code) and not begun_before:
            found.append((number, re.match(r"\s*", line).group() + ";", "left out"))
    return found


def key_of(path, line, changed, lines_around):
    """Stays the same when the file grows elsewhere."""
    return hashlib.sha256("\0".join((path, line, changed, *lines_around)).encode()).hexdigest()[:16]


def judges_of(path):
    for begin, programs in JUDGES:
        if path.startswith(begin):
            return programs
    sys.exit(f"mutants.py: no unit tests are known for {path}; known are {', '.join(begin for begin, _ in JUDGES)}")


class Workshop:
    """A copy of the sources, built; one file of it is changed at a time."""

    def __init__(self, folder):
        self.tree = os.path.join(folder, "tree")
        self.build = os.path.join(folder, "objects")
        self.usual_s = {}

    def refresh(self):
        """Makes the copy what the repository is, and leaves the dates of what is alike."""
        listed = subprocess.run(["git", "-C", ROOT, "ls-files", "-z"], capture_output=True, check=True).stdout
        for name in filter(None, listed.decode().split("\0")):
            source, copy = os.path.join(ROOT, name), os.path.join(self.tree, name)
            if not os.path.isfile(source):
                continue
            os.makedirs(os.path.dirname(copy), exist_ok=True)
            with open(source, "rb") as file:
                wanted = file.read()
            if not os.path.exists(copy) or open(copy, "rb").read() != wanted:
                shutil.copy2(source, copy)
                os.utime(copy)

    def configure(self):
        subprocess.run(["cmake", "-S", self.tree, "-B", self.build, "-G", "Ninja", *OPTIONS], check=True,
                       stdout=subprocess.DEVNULL)

    def compiles(self, programs):
        done = subprocess.run(["ninja", "-C", self.build, *programs], capture_output=True, text=True)
        self.said = done.stdout
        return done.returncode == 0

    def noticed_by(self, programs):
        """The first program that fails or does not end; empty: none."""
        for name in programs:
            begin = time.monotonic()
            limit = max(LEAST_S, SLOWEST * self.usual_s[name]) if name in self.usual_s else None
            try:
                run = subprocess.run([os.path.join(self.build, "tests", name), "--gtest_fail_fast", "--gtest_brief=1"],
                                     cwd=self.build, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                     stderr=subprocess.STDOUT, timeout=limit)
            except subprocess.TimeoutExpired:
                return f"{name} (did not end)"
            self.said = run.stdout.decode(errors="replace")
            if run.returncode != 0:
                failed = re.search(r"\[  FAILED  \] (\S+?)[,.]?(?: |$)", self.said)
                return f"{name} {failed.group(1) if failed else '(crashed)'}"
            self.usual_s.setdefault(name, time.monotonic() - begin)
        return ""

    def try_out(self, path, number, changed, programs):
        """"" if no test notices, "no code" if it does not compile, else who noticed."""
        copy = os.path.join(self.tree, path)
        with open(copy, encoding="utf-8") as file:
            whole = file.read()
        lines = whole.split("\n")
        lines[number - 1] = changed
        try:
            with open(copy, "w", encoding="utf-8") as file:
                file.write("\n".join(lines))
            return self.noticed_by(programs) if self.compiles(programs) else "no code"
        finally:
            with open(copy, "w", encoding="utf-8") as file:
                file.write(whole)


def chosen(options):
    """[(path, number, line, changed, deed, key)] of all files, thinned as the options say."""
    found = []
    for path in options.files:
        path = os.path.relpath(os.path.abspath(path), ROOT)
        with open(os.path.join(ROOT, path), encoding="utf-8") as file:
            lines = [""] + file.read().split("\n") + [""]
        for number, changed, deed in mutants_of(path):
            if options.lines and not options.lines[0] <= number <= options.lines[1]:
                continue
            key = key_of(path, lines[number], changed, (lines[number - 1], lines[number + 1]))
            found.append((path, number, lines[number], changed, deed, key))
    random.Random(options.seed).shuffle(found)
    found = found[::options.every]
    return sorted(found[:options.most] if options.most else found)


def span(text):
    first, _, last = text.partition("-")
    return int(first), int(last or first)


def options_from(arguments):
    parser = argparse.ArgumentParser(prog="mutants.py", usage=__doc__.split("usage: ")[1].split("\n\nFILE")[0])
    parser.add_argument("--build", default=os.path.join(ROOT, "build", "mutants"))
    parser.add_argument("--every", type=int, default=1)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--most", type=int)
    parser.add_argument("--lines", type=span)
    parser.add_argument("--list", action="store_true")
    parser.add_argument("--again", action="store_true")
    parser.add_argument("--fresh", action="store_true")
    parser.add_argument("files", nargs="+")
    options = parser.parse_args(arguments)
    if options.every < 1 or (options.most is not None and options.most < 1):
        parser.error("--every and --most are at least 1")
    for path in options.files:
        if not os.path.isfile(path):
            parser.error(f"{path}: no such file")
        judges_of(os.path.relpath(os.path.abspath(path), ROOT))
    return options


def show(mutant, verdict):
    path, number, line, changed, deed, _ = mutant
    print(f"{path}:{number}: {deed}: {verdict}", flush=True)
    if verdict == "NOT NOTICED":
        print(f"    - {line.strip()}\n    + {changed.strip()}", flush=True)


def main(arguments):
    options = options_from(arguments)
    mutants = chosen(options)
    if options.list:
        for mutant in mutants:
            show(mutant, mutant[3].strip())
        return 0
    book_path = os.path.join(options.build, "verdicts.json")
    book = {}
    if os.path.exists(book_path) and not options.fresh:
        with open(book_path, encoding="utf-8") as file:
            book = json.load(file)
    workshop = Workshop(options.build)
    workshop.refresh()
    workshop.configure()
    programs = sorted({name for mutant in mutants for name in judges_of(mutant[0])})
    print(f"{len(mutants)} changes; building {', '.join(programs)}", flush=True)
    if not workshop.compiles(programs) or workshop.noticed_by(programs):
        print(workshop.said[-4000:], file=sys.stderr)
        print("mutants.py: build or tests fail without any change", file=sys.stderr)
        return 3
    counts = {"noticed": 0, "NOT NOTICED": 0, "no code": 0}
    for mutant in mutants:
        path, number, _, changed, _, key = mutant
        if key not in book or (options.again and book[key] == ""):
            book[key] = workshop.try_out(path, number, changed, judges_of(path))
            with open(book_path + ".new", "w", encoding="utf-8") as file:
                json.dump(book, file, indent=0, sort_keys=True)
            os.replace(book_path + ".new", book_path)
        kind = {"": "NOT NOTICED", "no code": "no code"}.get(book[key], "noticed")
        counts[kind] += 1
        show(mutant, "NOT NOTICED" if kind == "NOT NOTICED" else book[key])
    print(", ".join(f"{number} {kind}" for kind, number in counts.items()))
    return 1 if counts["NOT NOTICED"] else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
