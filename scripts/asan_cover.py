#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Which tests of a program the suite runs under AddressSanitizer in every run: so few that they reach all code of the
product that all its tests reach. The others are for `scripts/test.sh --long`, and for dev.

usage: asan_cover.py measure PROGRAM...
       asan_cover.py choose PROGRAM
       asan_cover.py check PROGRAM

measure: builds asan once more in build/cover, so that processes tell which blocks of code they reach
    (tests/reached_code.cpp), and runs each test of these programs by itself. Keeps what each of them and its children
    reached, and its processor time, in build/cover/reached/PROGRAM.jsonl. Tests that have been measured since the build are
    not run again.
choose: writes PROGRAM.repeats beside the CMakeLists.txt of PROGRAM, the names of the tests that are left out: at each step
    the test is taken that reaches most new code for its time, and at last those are dropped that the others have made
    needless. A line that only one test reached, by chance or not, keeps this test. What was not measured is not left out.
check: what no test reaches any more that is not left out, by line, and what is named there and does not exist.
Exit codes: 0; 1 something failed, or check has found something; 2 wrong usage.
"""

import collections
import concurrent.futures
import glob
import json
import os
import re
import signal
import subprocess
import sys
import tempfile
import threading

ROOT = os.path.dirname(os.path.dirname(os.path.realpath(__file__)))
BUILD = os.path.join(ROOT, "build", "cover")
REACHED = os.path.join(BUILD, "reached")
PRODUCT = ("hmi/", "rtcore/", "shared/")
# Programs that tests start.
STARTED = ("psicarve", "psicarve-rtcore", "psicarve-hmi", "fake_port_preload")
LONGEST_S = 600  # of a test
LEFT_OUT_SOURCES = "[coverage]\nsrc:tests/*\nsrc:*/tests/*\nsrc:*_autogen*\n"


def build(programs):
    """As asan is built, and instrumented."""
    os.makedirs(REACHED, exist_ok=True)
    ignored = os.path.join(BUILD, "ignored")
    if not os.path.exists(ignored):
        with open(ignored, "w", encoding="utf-8") as file:
            file.write(LEFT_OUT_SOURCES)
    teller = os.path.join(BUILD, "reached_code.o")
    source = os.path.join(ROOT, "tests", "reached_code.cpp")
    subprocess.run(["clang++-14", "-std=c++20", "-O2", "-fPIC", "-c", source, "-o", teller], check=True)
    script = (f'root="{ROOT}"; source "$root/scripts/build.sh"; configure_preset asan "$1" "$2" "$3" && shift 3 &&'
              f' build "{BUILD}" "$@"')
    flags = f"-fsanitize-coverage=trace-pc-guard -fsanitize-coverage-ignorelist={ignored}"
    subprocess.run(["bash", "-c", script, "build", BUILD, f"-DCMAKE_CXX_FLAGS={flags}",
                    f"-DCMAKE_EXE_LINKER_FLAGS_DEBUG={teller}", *programs, *STARTED], check=True)


def tests_of(program):
    """Name -> ctest's description of each test that this program has."""
    shown = subprocess.run(["ctest", "--show-only=json-v1"], cwd=BUILD, capture_output=True, text=True, check=True)
    path = os.path.join(BUILD, "tests", program)
    return {test["name"]: test for test in json.loads(shown.stdout)["tests"] if path in test.get("command", [])}


def property_of(test, name, otherwise):
    return next((entry["value"] for entry in test.get("properties", []) if entry["name"] == name), otherwise)


def addresses_in(path):
    with open(path, "rb") as file:
        words = memoryview(file.read()).cast("Q")
    return {word for word in words if word}


def run(test):
    """(exit code, s of processor time with its children, program -> addresses)."""
    command = test["command"]
    if os.path.basename(command[0]) == "nice":  # as ctest is told to: nothing waits for this one
        command = command[3:]
    with tempfile.TemporaryDirectory(prefix="psicarve-reached-") as folder:
        environment = {**os.environ, "PSICARVE_REACHED": folder}
        environment.update(entry.split("=", 1) for entry in property_of(test, "ENVIRONMENT", []))
        with open(os.path.join(REACHED, f"{test['name'].replace('/', '_')}.log"), "wb") as log:
            process = subprocess.Popen(command, cwd=property_of(test, "WORKING_DIRECTORY", None), env=environment,
                                       stdin=subprocess.DEVNULL, stdout=log, stderr=log, start_new_session=True)
            limit = threading.Timer(LONGEST_S, os.killpg, (process.pid, signal.SIGKILL))
            limit.start()
            _, status, used = os.wait4(process.pid, 0)
            limit.cancel()
            process.returncode = os.waitstatus_to_exitcode(status)
        reached = collections.defaultdict(set)
        for path in glob.glob(os.path.join(folder, "*")):
            reached[os.path.basename(path).rsplit(".", 1)[0]] |= addresses_in(path)
        if process.returncode == 0:
            os.remove(log.name)
        return process.returncode, used.ru_utime + used.ru_stime, reached


def kept_path(program):
    return os.path.join(REACHED, f"{program}.jsonl")


def program_path(program):
    return next(path for path in (os.path.join(BUILD, folder, program) for folder in ("bin", "tests")) if os.path.exists(path))


def read_kept(program):
    """Name -> what was kept of it, of tests that were measured since the build."""
    path = kept_path(program)
    built = max(os.path.getmtime(program_path(part)) for part in (program, *STARTED[:2]))
    if not os.path.exists(path) or os.path.getmtime(path) < built:
        return {}
    with open(path, encoding="utf-8") as file:
        return {entry["name"]: entry for entry in map(json.loads, file)}


def measure_one(program, test, lock):
    code, seconds, reached = run(test)
    with lock:
        print(f"{seconds:7.2f} s  {test['name']}{f'  FAILED, {code}' if code else ''}", flush=True)
        if code == 0:
            entry = {"name": test["name"], "seconds": seconds, "reached": {k: sorted(v) for k, v in reached.items()}}
            with open(kept_path(program), "a", encoding="utf-8") as file:
                file.write(json.dumps(entry) + "\n")
    return code == 0


def measure(programs):
    build(programs)
    all_passed = True
    lock = threading.Lock()
    for program in programs:
        kept = read_kept(program)
        if not kept and os.path.exists(kept_path(program)):
            os.remove(kept_path(program))
        tests = [test for name, test in tests_of(program).items() if name not in kept]
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as workers:
            all_passed &= all(list(workers.map(lambda test, own=program: measure_one(own, test, lock), tests)))
    return all_passed


def place_in(frames):
    """file:line of the product, of the innermost of the inlined functions that is."""
    for frame in frames:
        name = os.path.relpath(os.path.normpath(os.path.join(BUILD, frame.get("FileName", ""))), ROOT)
        if name.startswith(PRODUCT) and frame["Line"]:  # 0: the compiler's own
            return f"{name}:{frame['Line']}"
    return None


def places_of(program, addresses):
    """Address -> place."""
    addresses = sorted(addresses)
    asked = "".join(f"{address - 1:#x}\n" for address in addresses)  # in the call, not behind it
    answer = subprocess.run(["llvm-symbolizer-14", f"--obj={program_path(program)}", "--output-style=JSON"], input=asked,
                            capture_output=True, text=True, check=True).stdout.splitlines()
    return {address: place_in(json.loads(line).get("Symbol", [])) for address, line in zip(addresses, answer, strict=True)}


def cover(seconds, lines):
    """Names of tests that reach all lines together. seconds, lines: by test."""
    bit = {line: 1 << n for n, line in enumerate(sorted(set().union(*lines.values())))}
    bits = {name: sum(bit[line] for line in of_test) for name, of_test in lines.items()}
    wanted = (1 << len(bit)) - 1
    chosen = []
    while wanted:
        best = max(bits, key=lambda name: ((bits[name] & wanted).bit_count() / max(seconds[name], 0.01), name))
        chosen.append(best)
        wanted &= ~bits[best]
    # The dearest first: others may have made it needless.
    for name in sorted(chosen, key=lambda name: (-seconds[name], name)):
        others = 0
        for other in chosen:
            others |= bits[other] if other != name else 0
        if others.bit_count() == len(bit):
            chosen.remove(name)
    return set(chosen)


def list_path(program):
    """Beside the CMakeLists.txt that makes the program."""
    for folder, _, files in os.walk(os.path.join(ROOT, "tests")):
        if "CMakeLists.txt" in files:
            with open(os.path.join(folder, "CMakeLists.txt"), encoding="utf-8") as file:
                if re.search(rf"^psicarve_test\({program}\b", file.read(), re.MULTILINE):
                    return os.path.join(folder, f"{program}.repeats")
    raise SystemExit(f"no CMakeLists.txt makes {program}")


def left_out(program):
    if not os.path.exists(list_path(program)):
        return set()
    with open(list_path(program), encoding="utf-8") as file:
        return {line.strip() for line in file if line.strip() and not line.startswith("#")}


def measured(program):
    """(seconds, lines) by test."""
    kept = read_kept(program)
    if not kept:
        raise SystemExit(f"{program} was not measured since it was built")
    reached = collections.defaultdict(set)
    for entry in kept.values():
        for part, addresses in entry["reached"].items():
            reached[part].update(addresses)
    places = {part: places_of(part, addresses) for part, addresses in reached.items()}
    lines = {name: {places[part][address] for part, addresses in entry["reached"].items() for address in addresses} - {None}
             for name, entry in kept.items()}
    return {name: entry["seconds"] for name, entry in kept.items()}, lines


def choose(program):
    seconds, lines = measured(program)
    chosen = cover(seconds, lines)
    rest = sorted(set(lines) - chosen)
    with open(list_path(program), "w", encoding="utf-8") as file:
        file.write("# Tests that reach no line of the product that the others do not: under AddressSanitizer only with\n"
                   f"# --long. Made by scripts/asan_cover.py choose {program}.\n")
        file.writelines(name + "\n" for name in rest)
    tell(program, seconds, lines, set(rest))
    return True


def tell(program, seconds, lines, rest):
    all_lines = set().union(*lines.values())
    run_lines = set().union(*(lines[name] for name in lines if name not in rest))
    print(f"{program}: {len(lines) - len(rest)} of {len(lines)} tests, {sum(s for n, s in seconds.items() if n not in rest):.0f}"
          f" of {sum(seconds.values()):.0f} s of processor time, {len(run_lines)} of {len(all_lines)} lines")


def check(program):
    seconds, lines = measured(program)
    rest = left_out(program)
    gone = sorted(rest - set(lines))
    reached = set().union(*(lines[name] for name in lines if name not in rest))
    tell(program, seconds, lines, rest)
    for name in gone:
        print(f"no test is called {name}")
    by_test = {name: lines[name] - reached for name in sorted(rest - set(gone))}
    for name, missed in by_test.items():
        if missed:
            print(f"only {name}: {', '.join(sorted(missed)[:5])}{' ...' if len(missed) > 5 else ''}")
    return not gone and not any(by_test.values())


def main(arguments):
    if len(arguments) >= 2 and arguments[0] == "measure":
        return 0 if measure(arguments[1:]) else 1
    if len(arguments) == 2 and arguments[0] in ("choose", "check"):
        return 0 if {"choose": choose, "check": check}[arguments[0]](arguments[1]) else 1
    print(__doc__.strip(), file=sys.stderr)
    return 2


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
