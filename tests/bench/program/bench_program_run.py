#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A long program through `psicarve gcode run`: memory, and how much faster than the machine it is.

usage: bench_program_run.py BUILD [--lines N] [--profile FILE] [--ring RECORDS] [--words WORDS]

BUILD is a build folder, as build/release. A program of N lines of 0.05 mm, whose feed is beyond what any axis has, is made
here and run on a core on the virtual clock, which knows no waiting: what is measured is interpreter, ring, planner and
tick together. `--words` tells what its lines have: `plain` their end alone, in inches `inch`, from rest to rest `exact`,
with comments `note`; `f` an F of their own each, `g93` the same in inverse time, `gf` an F and G0 and G1 in turn, `system`
G54 to G56 in turn as well, `shift` instead of these a new zero each; `ij` and `r` are small arcs, and `loop` is one line, N
times. Work offsets are kept in a folder of the bench's own. Told are machine time by wall time, lines a second of it,
starvations, and by how much the resident memory of both processes grows: beyond what a program of ten lines takes, and
after the first second. Exit code 1 where the former is more than 16 MB, where the program starves, or where it is less
than 10 times as fast as the machine.
"""
import argparse
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import time

MOST_GROWTH_KB = 16 * 1024
LEAST_RATIO = 10.0
SETTLING_S = 1.0
LOOK_S = 0.1
SHORT_LOOK_S = 0.001


INCH_MM = 25.4
HEADS = {
    "g93": "G93\n",
    "exact": "G61\n",
    "inch": "G20\n",
    "system": "G10 L2 P2 X0.1 Y0.1 Z0.1\nG10 L2 P3 R1\n",
}
ENDS = {
    "f": lambda n: f" F{90000 + n % 9973}",
    "g93": lambda n: f" F{90000 + n % 9973}",
    "gf": lambda n: f" G{n % 2} F{90000 + n % 9973}",
    "note": lambda n: f" (of path {n})\n; path {n} goes on",
    "system": lambda n: f" G{n % 2} G{54 + n % 3} F{90000 + n % 9973}",
    "shift": lambda n: f" G{n % 2} F{90000 + n % 9973}\nG10 L2 P1 X{n % 7 / 100} Y{n % 5 / 100} Z{n % 3 / 100}",
    "ij": lambda n: f" G{2 + n % 2} I{0.025 if 0 < n % 800 <= 400 else -0.025} J0",
    "r": lambda n: f" G{2 + n % 2} R0.04",
}
LOOP = """#1=0
o1 repeat [{count}]
X[59-0.05*ABS[400-[#1 MOD 800]]] Y[10.2-0.005*ABS[40-[#1 MOD 80]]]
#1=[#1+1]
o1 endrepeat
"""
WORDS = sorted({"plain", "loop", *HEADS, *ENDS})


def write_program(path, count, words):
    unit_mm, digits = (INCH_MM, 5) if words == "inch" else (1, 2)
    is_of_arcs = words in ("ij", "r")
    end = ENDS.get(words, lambda n: "")
    with path.open("w") as out:
        out.write("G21 G90 G94 F99999 G64 P0.02\nG0 X39 Z50 Y10 C0\nG1\n" + HEADS.get(words, ""))
        if words == "loop":
            out.write(LOOP.format(count=count))
            count = 0
        for n in range(1, count + 1):
            # There and back over 20 mm while Y, but for arcs, rises and falls gently.
            there, wave = n % 800, n % 80
            step = there if there < 400 else 800 - there
            y_mm = 10 if is_of_arcs else 10 + 0.005 * min(wave, 80 - wave)
            out.write(f"X{(39 + 0.05 * step) / unit_mm:.{digits}f} Y{y_mm / unit_mm:.{digits + 1}f}{end(n)}\n")
        out.write("M2\n")


def resident_kb(pid, key="VmRSS"):
    for line in pathlib.Path(f"/proc/{pid}/status").read_text().split("\n"):
        if line.startswith(key + ":"):
            return int(line.split()[1])
    return 0


def run_program(command, pids, look_s):
    """What the run says, by process its resident memory after the first second and at most, and how long it took."""
    began = time.monotonic()
    run = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
    pids = {"gcode run": run.pid, **pids}
    settled, most = {}, {}
    while run.poll() is None:
        for name, pid in pids.items():
            try:
                now = resident_kb(pid, "VmHWM")
            except OSError:
                continue
            if now and time.monotonic() - began >= SETTLING_S:
                settled.setdefault(name, resident_kb(pid))
            if now:
                most[name] = now
        time.sleep(look_s)
    return json.loads(run.stdout.read()), settled, most, time.monotonic() - began


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--lines", type=int, default=10_000_000)
    parser.add_argument("--profile", type=pathlib.Path, help="default: the built-in machine")
    parser.add_argument("--ring", type=int, default=8192)
    parser.add_argument("--words", choices=WORDS, default="plain")
    options = parser.parse_args()
    programs = options.build.resolve() / "bin"
    segment = ["--segment", f"/psicarve-bench-{os.getpid()}"]
    profile = ["--profile", options.profile.resolve()] if options.profile else []

    def psicarve(*words):
        return subprocess.run([programs / "psicarve", *words, *segment], capture_output=True, text=True, check=False)

    with tempfile.TemporaryDirectory() as folder:
        os.environ["XDG_STATE_HOME"] = folder
        short, path = pathlib.Path(folder) / "short.ngc", pathlib.Path(folder) / "long.ngc"
        write_program(short, 10, options.words)
        write_program(path, options.lines, options.words)
        core = subprocess.Popen([programs / "psicarve-rtcore", *segment, "--clock", "virtual", "--program-ring",
                                 str(options.ring), *profile], stderr=subprocess.DEVNULL)
        try:
            while psicarve("status").returncode != 0:
                time.sleep(LOOK_S)
            psicarve("home")
            run = [programs / "psicarve", "gcode", "run", "--json", *segment]
            first = run_program([*run, short], {"core": core.pid}, SHORT_LOOK_S)[2]
            said, settled, most, wall_s = run_program([*run, path], {"core": core.pid}, LOOK_S)
        finally:
            core.terminate()
            core.wait()
            pathlib.Path("/dev/shm" + segment[1]).unlink(missing_ok=True)
    ratio = said["seconds"] / wall_s
    print(f"{options.lines} lines ({options.words}, ring {options.ring}) in {wall_s:.1f} s, {options.lines / wall_s:.0f} a"
          f" second; {said['seconds']:.1f} s of machine time, {options.lines / said['seconds']:.0f} lines a second;"
          f" {ratio:.1f} times as fast; starvations {said['starvations']}")
    is_good = ratio >= LEAST_RATIO and said["starvations"] == 0
    for name, kb in most.items():
        growth_kb = kb - first[name]
        print(f"{name}: resident {kb} KB at most, {growth_kb} KB beyond a program of ten lines, {kb - settled.get(name, kb)} KB"
              " after the first second")
        is_good = is_good and growth_kb <= MOST_GROWTH_KB
    return 0 if is_good else 1


if __name__ == "__main__":
    sys.exit(main())
