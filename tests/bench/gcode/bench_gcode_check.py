#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Reading G-code, beside LinuxCNC's interpreter: processor time of whole commands on one program, as a ratio.

usage: bench_gcode_check.py BUILD [--rs274 FILE] [--lines N] [--pairs N]

BUILD is a build folder, as build/release. The program is made here: lines, arcs, helices, turns of C, feeds, G91, N
words and comments, all within the built-in profile's travel. `psicarve gcode check` (language and machine) and
`rs274 -g` run in turn; the median of the pairs' ratios counts. Exit code 1 where it is less than wanted.
rs274 comes with Debian's linuxcnc-uspace; without it only our own time is told.
"""
import argparse
import os
import pathlib
import random
import shutil
import statistics
import sys
import tempfile

WANTED = 3.0
SEED = 17


def block(draw):
    kind = draw.randrange(20)
    r1, y = draw.uniform(21.0, 40.0), draw.uniform(40.0, 100.0)
    if kind < 12:
        return f"X{r1:.4f} Y{y:.4f} C{draw.uniform(-720.0, 720.0):.3f}"
    if kind < 14:
        return f"G1 X{r1:.3f} Y{y:.3f} F{draw.randrange(50, 2000)}"
    if kind < 15:
        return f"G0 X{r1:.2f} Z{draw.uniform(21.0, 40.0):.2f} (a rapid move)\nG1 Y{y:.3f}"
    if kind < 17:
        return f"G{draw.choice('23')} X30 Y70 R{draw.uniform(60.0, 90.0):.4f}\nG1 X{r1:.4f} Y{y:.4f}"
    if kind < 18:
        return f"G1 X30 Y70\nG3 X30 Y70 I{draw.uniform(-8.0, 8.0):.4f} J1.5 Z30\nG1 X30.0005"
    if kind < 19:
        return f"G91 X0.01 Y-{draw.uniform(0.0, 1.0):.3f}\nG90 G1 X{r1:.4f} Y{y:.4f}"
    return f"; layer {draw.randrange(1000)}\nN{draw.randrange(99999)} Y{y:.4f}"


def write_program(path, count):
    draw = random.Random(SEED)
    lines = ["G21 G17 G90 G94 F600", "G0 X30 Z30 Y70 C0", "G1 X30.5"]
    while len(lines) < count - 1:
        lines += block(draw).split("\n")
    path.write_text("\n".join(lines[:count - 1] + ["M2"]) + "\n")


def processor_s(words, folder):
    sys.stdout.flush()
    child = os.fork()
    if child == 0:
        os.chdir(folder)
        nothing = os.open(os.devnull, os.O_RDWR)
        for stream in (0, 1, 2):
            os.dup2(nothing, stream)
        os.execv(words[0], words)
    _, status, used = os.wait4(child, 0)
    if status != 0:
        sys.exit(f"{' '.join(words)} ended with {os.waitstatus_to_exitcode(status)}")
    return used.ru_utime + used.ru_stime


def main():
    parser = argparse.ArgumentParser(usage=__doc__.split("usage: ")[1].split("\n")[0])
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--rs274", default=shutil.which("rs274"))
    parser.add_argument("--lines", type=int, default=1_000_000)
    parser.add_argument("--pairs", type=int, default=5)
    told = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        work = pathlib.Path(folder)
        program = work / "program.ngc"
        write_program(program, told.lines)
        (work / "tool.tbl").write_text("T1 P1 Z0 D1\n")
        (work / "sim.var").touch()
        psicarve = str(told.build.resolve() / "bin" / "psicarve")
        os.environ["PSICARVE_PROFILE"] = ""
        ours = [psicarve, "gcode", "check", str(program)]
        theirs = [told.rs274, "-g", "-t", str(work / "tool.tbl"), "-v", str(work / "sim.var"), str(program)]
        ratios, times = [], []
        for _ in range(told.pairs):
            times.append(processor_s(ours, work))
            if told.rs274:
                ratios.append(processor_s(theirs, work) / times[-1])
        print(f"psicarve gcode check, {told.lines} lines: {statistics.median(times):.2f} s of processor time")
        if not told.rs274:
            print("no rs274 here: nothing to compare with (Debian: linuxcnc-uspace)")
            return
        ratio = statistics.median(ratios)
        print(f"rs274 -g takes {ratio:.2f} times as long ({min(ratios):.2f} to {max(ratios):.2f}); wanted {WANTED:g}")
        sys.exit(0 if ratio >= WANTED else 1)


main()
