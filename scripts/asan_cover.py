#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Which tests of these programs the suite runs under AddressSanitizer in every run: so few that they reach all code of
the product that all tests of these programs reach together, those of which the data counts (DATA_COUNTS), and the quick
ones (QUICK_S). The others are for `scripts/test.sh --long`, and for dev.

usage: asan_cover.py measure [PROGRAM...]
       asan_cover.py choose [PROGRAM...]
       asan_cover.py check [PROGRAM...]

Without PROGRAM: those that have a list.

measure: builds asan once more in build/cover, so that processes tell which blocks of code they reach
    (tests/reached_code.cpp), and runs each test of these programs by itself. Keeps what each of them and its children
    reached, and its processor time, in build/cover/reached/PROGRAM.jsonl. Tests that have been measured since the build are
    not run again.
choose: writes PROGRAM.repeats beside the CMakeLists.txt of each PROGRAM, the names of its tests that are left out: at each
    step the test is taken that reaches most new code for its time, and at last those are dropped that the others have made
    needless. A line that only one test reached, by chance or not, keeps this test. What was not measured is not left out.
    A test of one program may stand for one of another: name them together, here and in check.
check: what no test reaches any more that is not left out, by line, and what is named there and does not exist, or must not
    be named.
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
import textwrap
import threading

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
import suite  # noqa: E402  beside us

ROOT = os.path.dirname(os.path.dirname(os.path.realpath(__file__)))
BUILD = os.path.join(ROOT, "build", "cover")
REACHED = os.path.join(BUILD, "reached")
PRODUCT = ("hmi/", "rtcore/", "shared/")
# Programs that tests start.
STARTED = ("psicarve", "psicarve-rtcore", "psicarve-hmi", "fake_port_preload")
LONGEST_S = 600  # of a test
# Of processor time: what takes less is not left out. Half of it is a program's begin, and of other data there are chances.
QUICK_S = 0.25
# Where not the lines count but what goes through them: mutated, broken, hostile and foreign input, deaths of processes, faults.
DATA_COUNTS = [
    *suite.EXACT,
    r"Mutation",
    r"Broken",
    r"Damaged",
    r"Death",
    r"Kill(s|ed)?(?![a-z])",
    r"Fault\.",
    r"Fuzz",
    r"Garbage",
    r"Hostile",
    r"^RandomCommands\.",
    r"Torn",
    r"Truncat",
    r"BadPrograms\.",
    r"^FromPackages/RealDrawing",
    r"^FromPackages/RealMeshes\.",
]
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


def counts_by_its_data(name):
    return any(re.search(pattern, name) for pattern in DATA_COUNTS)


def cover(seconds, lines, kept=frozenset()):
    """Names of tests that reach all lines together, kept among them. seconds, lines: by test."""
    bit = {line: 1 << n for n, line in enumerate(sorted(set().union(*lines.values())))}
    bits = {name: sum(bit[line] for line in of_test) for name, of_test in lines.items()}
    wanted = (1 << len(bit)) - 1
    for name in kept:
        wanted &= ~bits[name]
    chosen = []
    while wanted:
        best = max(bits, key=lambda name: ((bits[name] & wanted).bit_count() / max(seconds[name], 0.01), name))
        chosen.append(best)
        wanted &= ~bits[best]
    always = 0
    for name in kept:
        always |= bits[name]
    # The dearest first: others may have made it needless.
    for name in sorted(chosen, key=lambda name: (-seconds[name], name)):
        others = always
        for other in chosen:
            others |= bits[other] if other != name else 0
        if others.bit_count() == len(bit):
            chosen.remove(name)
    return set(chosen) | set(kept)


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


def listed_programs():
    lists = glob.glob(os.path.join(ROOT, "tests", "**", "*.repeats"), recursive=True)
    return sorted(os.path.basename(path).removesuffix(".repeats") for path in lists)


def measured(programs):
    """(program -> names of its tests, seconds by test, lines by test)."""
    tests = {program: read_kept(program) for program in programs}
    for program, kept in tests.items():
        if not kept:
            raise SystemExit(f"{program} was not measured since it was built")
    reached = collections.defaultdict(set)
    for entry in (entry for kept in tests.values() for entry in kept.values()):
        for part, addresses in entry["reached"].items():
            reached[part].update(addresses)
    places = {part: places_of(part, addresses) for part, addresses in reached.items()}
    seconds, lines = {}, {}
    for name, entry in (item for kept in tests.values() for item in kept.items()):
        seconds[name] = entry["seconds"]
        lines[name] = {places[part][address] for part, addresses in entry["reached"].items() for address in addresses}
        lines[name].discard(None)
    return {program: list(kept) for program, kept in tests.items()}, seconds, lines


def choose(programs):
    tests, seconds, lines = measured(programs)
    kept = {name for name in lines if seconds[name] < QUICK_S or counts_by_its_data(name)}
    chosen = cover(seconds, lines, kept)
    for program, names in tests.items():
        rest = sorted(set(names) - chosen)
        if not rest:
            if os.path.exists(list_path(program)):
                os.remove(list_path(program))
            continue
        with open(list_path(program), "w", encoding="utf-8") as file:
            file.write("# Tests that reach no line of the product that the others do not, of this program or of those that\n"
                       "# were measured with it: under AddressSanitizer only with --long. Made by scripts/asan_cover.py choose\n"
                       f"{textwrap.fill(' '.join(programs) + '.', 120, initial_indent='# ', subsequent_indent='# ')}\n")
            file.writelines(name + "\n" for name in rest)
    tell(tests, seconds, lines, set(lines) - chosen)
    return True


def tell(tests, seconds, lines, rest):
    for program, names in (*tests.items(), ("altogether", list(lines))):
        run = [name for name in names if name not in rest]
        print(f"{program}: {len(run)} of {len(names)} tests, {sum(seconds[name] for name in run):.0f} of"
              f" {sum(seconds[name] for name in names):.0f} s of processor time")
    run_lines = set().union(*(lines[name] for name in lines if name not in rest))
    print(f"{len(run_lines)} of {len(set().union(*lines.values()))} lines")


def check(programs):
    tests, seconds, lines = measured(programs)
    rest = {name for program in programs for name in left_out(program)}
    gone = sorted(rest - set(lines))
    reached = set().union(*(lines[name] for name in lines if name not in rest))
    tell(tests, seconds, lines, rest)
    for name in gone:
        print(f"no test is called {name}")
    wrong = sorted(name for name in rest if counts_by_its_data(name))
    for name in wrong:
        print(f"of {name} the data counts")
    by_test = {name: lines[name] - reached for name in sorted(rest - set(gone))}
    for name, missed in by_test.items():
        if missed:
            print(f"only {name}: {', '.join(sorted(missed)[:5])}{' ...' if len(missed) > 5 else ''}")
    return not gone and not wrong and not any(by_test.values())


def main(arguments):
    does = {"measure": measure, "choose": choose, "check": check}
    if not arguments or arguments[0] not in does:
        print(__doc__.strip(), file=sys.stderr)
        return 2
    return 0 if does[arguments[0]](arguments[1:] or listed_programs()) else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
