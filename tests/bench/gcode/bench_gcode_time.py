#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""How long programs in G-code take, beside LinuxCNC's trajectory planner: same program, axis limits and G64 P.

usage: bench_gcode_time.py BUILD [--tolerance MM ...] [--programs NAME ...]

`wide` is run only where it is named: the curve of `dense` twice as large, on which an axis is at its top speed for 80 % of
the time, so that planners hardly differ (docs/performance.md).

BUILD is a build folder with program_seconds, as build/release. Three programs are made here, on the built-in profile's
machine: a pocket in zigzag, lines of 0.05 mm along a curve, and arcs. Their feed is beyond what the axes have. Ours is
the planned time of the motion, which the machine keeps to a tick; LinuxCNC's is counted in servo ticks of 1 ms on its
commanded positions, in simulation: the computer's own speed does not come into either. Exit code 1 where a ratio is not
below what is wanted. LinuxCNC comes with Debian's linuxcnc-uspace; without it only our own times are told.
"""
import argparse
import math
import pathlib
import shutil
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "motion"))

import linuxcnc_run

WANTED = 0.95
# Of the built-in profile: X is R1, Y is y, Z is R2 [mm/s, mm/s^2].
SPEEDS = [(10.0, 100.0)] * 3
LIMIT_S = 300


def pocket():
    lines = []
    for row in range(24):
        lines += [f"G1 X{33.0 if row % 2 == 0 else 30.0:.4f}", f"Y{50.0 + 0.25 * (row + 1):.4f}"]
    return lines


def dense(scale=1.0):
    """Lines of 0.05 mm along a curve whose radius goes from 0.2 to 2 mm and back, times `scale`."""
    x, y, heading, lines = 30.0, 50.0, 0.0, []
    for step in range(1200):
        x, y = x + 0.05 * math.cos(heading), y + 0.05 * math.sin(heading)
        lines.append(f"G1 X{x:.4f} Y{y:.4f}")
        way = 0.05 * step
        bend = math.sin(way / 0.8 / scale) / (0.2 + 1.8 * math.sin(way / 11.0 / scale) ** 2)
        heading += 0.05 * bend / scale
    return lines


def arcs():
    """Slots with round ends, some of their lines at an angle to the arcs."""
    lines = []
    for row in range(12):
        y, radius = 50.0 + 1.5 * row, 0.25 + 0.05 * row
        lines += [f"G1 X30 Y{y:.4f}", "X32", f"G3 X32 Y{y + 2.0 * radius:.4f} I0 J{radius:.4f}",
                  "G1 X30", f"G2 X30.4 Y{y + 2.0 * radius + 0.4:.4f} I0.4 J0"]
    return lines


PROGRAMS = {"pocket": pocket, "dense": dense, "arcs": arcs, "wide": lambda: dense(2.0)}


def program_text(lines, tolerance_mm):
    """A rest marks the begin of what is timed."""
    head = ["G21 G90 G94 G17 G40 G49 G80", f"G64 P{tolerance_mm}", "G0 Z30", "G0 X30 Y50", "G4 P0.3", "F9999"]
    return "\n".join(head + lines + ["M2", ""])


def our_time(build, text):
    with tempfile.TemporaryDirectory() as folder:
        program = pathlib.Path(folder) / "program.ngc"
        program.write_text(text)
        told = subprocess.run([build / "bench" / "program_seconds", program], capture_output=True, text=True)
    if told.returncode != 0:
        sys.exit(told.stderr)
    seconds, rests = told.stdout.split()[:2]
    return float(seconds), int(rests)


def linuxcnc_s(text):
    path = linuxcnc_run.carving_part(linuxcnc_run.run(text, SPEEDS, LIMIT_S))
    return linuxcnc_run.SERVO_S * (len(path) - 1)


def main():
    parser = argparse.ArgumentParser(usage=__doc__.split("usage: ")[1].split("\n")[0])
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--tolerance", type=float, nargs="+", default=[0.01, 0.05])
    parser.add_argument("--programs", nargs="+", choices=PROGRAMS, default=["pocket", "dense", "arcs"])
    told = parser.parse_args()
    has_linuxcnc = shutil.which("linuxcnc") is not None
    if not has_linuxcnc:
        print("no linuxcnc here: nothing to compare with (Debian: linuxcnc-uspace)")
    is_slow = False
    for tolerance_mm in told.tolerance:
        for name in told.programs:
            text = program_text(PROGRAMS[name](), tolerance_mm)
            ours_s, rests = our_time(told.build.resolve(), text)
            line = f"{name:8} G64 P{tolerance_mm:g}: {ours_s:.3f} s, {rests} rests on the way"
            if has_linuxcnc:
                theirs_s = linuxcnc_s(text)
                line += f"; LinuxCNC {theirs_s:.3f} s: {ours_s / theirs_s:.3f} of it, wanted below {WANTED:g}"
                is_slow = is_slow or ours_s >= WANTED * theirs_s
            print(line, flush=True)
    sys.exit(1 if is_slow else 0)


if __name__ == "__main__":
    main()
