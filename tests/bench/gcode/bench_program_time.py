#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""How long programs in G-code really take through a ring of 8192 records, against T_ref, which knows no ring.

usage: bench_program_time.py BUILD [--programs NAME ...] [--tolerance MM ...] [--no-reference]

BUILD is a build folder with psicarve, psicarve-rtcore, program_seconds and job_from_csv, as build/release. Each program is
run whole by a core on the virtual clock; what its approach takes, as far as a dwell, is taken off. Times are the machine's,
the same on every computer. Two yardsticks, neither of which may be exceeded by more than 2 %:

  T_ref   the planner's own continuous time where all ways between two rests are planned at once (program_seconds): what
          the ring, the receding horizon and the ticks cost stands beside it
  table   one layer of a table, written as G-code: T_ref of the job of that table, and with python3-numpy and
          python3-scipy the time along tests/reference's curve of least bending, other code and method

The programs: lines of 0.05 mm, arcs and lines, a pocket in zigzag, layers of a table, and so many of these that their
records fill the ring twice; their feed is beyond what the axes of the built-in profile have. Exit code 1 where a ratio is
beyond what is wanted.
"""
import argparse
import json
import math
import os
import pathlib
import subprocess
import sys
import tempfile
import time

sys.dont_write_bytecode = True
HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parents[1] / "reference")]

from bench_gcode_time import arcs, dense, pocket, program_text

MOST = 1.02
RING = "8192"
LOOK_S = 0.05
POINTS = 500
HALF_TURN_PULSES = 3200
PULSES_PER_MM = 400
COLUMNS = "layer,point,y_pulses,psi_pulses,r_left_pulses,r_right_pulses"


def table_rows(layers):
    """Of each layer and point: Y, psi, R1 and R2 in pulses of the built-in profile; odd layers run back."""
    def radius(psi, layer):
        return 25.0 + 2.0 * math.cos(5.0 * psi) + math.cos(13.0 * psi + 0.05 * layer)

    for layer in range(layers):
        for step in range(POINTS):
            point = step if layer % 2 == 0 else POINTS - 1 - step
            psi = round(HALF_TURN_PULSES * point / (POINTS - 1))
            turn = math.pi * psi / HALF_TURN_PULSES
            left, right = (round(PULSES_PER_MM * radius(at, layer)) for at in (turn, turn + math.pi))
            yield layer, point, 20000 + 80 * layer, psi, left, right


def table_line(row):
    _, _, y, psi, left, right = row
    return (f"X{left / PULSES_PER_MM:.4f} Z{right / PULSES_PER_MM:.4f} Y{y / PULSES_PER_MM:.4f}"
            f" C{180.0 * psi / HALF_TURN_PULSES:.5f}")


def table_text(layers, tolerance_mm):
    first, *rest = (table_line(row) for row in table_rows(layers))
    return "\n".join(["G21 G90 G94", f"G64 P{tolerance_mm}", f"G0 {first}", "G4 P0.3", "F9999", f"G1 {rest[0]}",
                      *rest[1:], "M2", ""])


PROGRAMS = {
    "dense": lambda mm: program_text(dense(), mm),
    "arcs": lambda mm: program_text(arcs(), mm),
    "pocket": lambda mm: program_text(pocket(), mm),
    "table": lambda mm: table_text(8, mm),
}
# More records than the ring has room for.
MEASURED = {**PROGRAMS, "long": lambda mm: table_text(40, mm)}


class Machine:
    """A homed core on the virtual clock for each program."""

    def __init__(self, build, work):
        self.build, self.work = build, work
        self.segment = ["--segment", f"/psicarve-bench-{os.getpid()}"]

    def run(self, *words):
        done = subprocess.run([str(word) for word in words], capture_output=True, text=True)
        if done.returncode != 0:
            sys.exit(f"{' '.join(map(str, words))}\nended with {done.returncode}: {done.stderr}{done.stdout}")
        return done.stdout

    def psicarve(self, *words):
        return self.run(self.build / "bin" / "psicarve", *words)

    def carved_s(self, text):
        program = self.work / "program.ngc"
        program.write_text(text)
        core = subprocess.Popen([self.build / "bin" / "psicarve-rtcore", *self.segment, "--clock", "virtual",
                                 "--program-ring", RING], stderr=subprocess.DEVNULL)
        try:
            status = [self.build / "bin" / "psicarve", "status", *self.segment]
            while subprocess.run(status, capture_output=True).returncode != 0:
                time.sleep(LOOK_S)
            self.psicarve("home", *self.segment)
            said = json.loads(self.psicarve("gcode", "run", program, "--json", *self.segment))
        finally:
            core.terminate()
            core.wait()
        if said["starvations"] != 0:
            sys.exit(f"starved {said['starvations']} times")
        return said["seconds"]

    def ways_s(self, text):
        """Behind the dwell."""
        return self.carved_s(text) - self.carved_s(before_the_ways(text))

    def planned(self, text):
        """Behind the dwell: seconds, rests, T_ref."""
        program = self.work / "program.ngc"
        program.write_text(text)
        ways_s, rests, t_ref_s = self.run(self.build / "bench" / "program_seconds", program).split()
        return float(ways_s), int(rests), float(t_ref_s)


def before_the_ways(text):
    """As far as the dwell."""
    return text[:text.index("\n", text.index("G4 ")) + 1] + "M2\n"


def job_of_layer(machine, tolerance_mm):
    """T_ref of a job of the table's first layer without a feed, and the independent time, if it can be had."""
    profile, table, job = (machine.work / name for name in ("no_feed.toml", "layer.csv", "layer.job"))
    text = machine.psicarve("profile", "show")
    wanted = {"feed_mm_s": "feed_mm_s = 1000.0", "path_tolerance_mm": f"path_tolerance_mm = {tolerance_mm}",
              "planner": 'planner = "lookahead"'}
    lines = [next((to for key, to in wanted.items() if line.startswith(key + " =")), line) for line in text.split("\n")]
    profile.write_text("\n".join(lines))
    table.write_text("\n".join([COLUMNS, *(",".join(map(str, row)) for row in table_rows(1))]) + "\n")
    machine.run(machine.build / "tests" / "job_from_csv", table, profile, job)
    return profile, table, json.loads(machine.psicarve("replay", job, "--json"))["reference_seconds"]


def bending_s(profile, table):
    from layer_time import least_layer_time
    from machine_limits import read_layers, read_limits

    limits = read_limits(profile)
    (layer,) = read_layers(table, limits)
    return least_layer_time(layer, limits, halvings=3, bending_only=True).seconds


def told(name, seconds, yardstick, what):
    ratio = seconds / yardstick
    print(f"{name}: {seconds:.4f} s, {what} {yardstick:.4f} s: {ratio:.4f}, wanted at most {MOST}", flush=True)
    return ratio <= MOST


def main():
    parser = argparse.ArgumentParser(usage=__doc__.split("usage: ")[1].split("\n")[0])
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--programs", nargs="+", choices=MEASURED, default=list(MEASURED))
    parser.add_argument("--tolerance", type=float, nargs="+", default=[0.01, 0.05])
    parser.add_argument("--no-reference", action="store_true")
    options = parser.parse_args()
    is_good = True
    with tempfile.TemporaryDirectory() as folder:
        machine = Machine(options.build.resolve(), pathlib.Path(folder))
        for tolerance_mm in options.tolerance:
            for name in options.programs:
                text = MEASURED[name](tolerance_mm)
                planned_s, rests, t_ref_s = machine.planned(text)
                title = f"{name:7} G64 P{tolerance_mm:g} ({rests} rests; planned {planned_s:.4f} s)"
                is_good &= told(title, machine.ways_s(text), t_ref_s, "T_ref")
        if "table" in options.programs:
            tolerance_mm = options.tolerance[0]
            text = table_text(1, tolerance_mm)
            seconds = machine.ways_s(text)
            profile, table, job_s = job_of_layer(machine, tolerance_mm)
            is_good &= told("a layer", seconds, job_s, "T_ref of its job")
            if not options.no_reference:
                is_good &= told("a layer", seconds, bending_s(profile, table), "least bending")
    sys.exit(0 if is_good else 1)


if __name__ == "__main__":
    main()
