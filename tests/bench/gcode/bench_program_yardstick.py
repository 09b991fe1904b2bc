#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""How long programs in G-code take, against the least time along their own curve, found in other code.

usage: bench_program_yardstick.py BUILD [--programs NAME ...] [--tolerance MM ...] [--parts N] [--no-carving]

BUILD is a build folder with psicarve, psicarve-rtcore and program_seconds, as build/release. The programs are those of
bench_program_time.py, and so is their carving time, through a ring of 8192 records. The yardstick has nothing of the
planner but the curve that it carves: parabolas from rest to rest over a parameter u. Each is cut into N parts, and
tests/reference finds the greatest (du/dt)^2 by reachability that keeps all speeds and accelerations of the profile, whole,
and jumps by half of each axis' start-stop speed at rests, as docs/planning.md says of programs. It is told what halving
the parts changes. The axes' shares, as the planner takes 0.998 of speeds and 0.985 of accelerations, can be given to the
yardstick as well: what is left is what the planner's method loses. Exit code 1 where a ratio is beyond 1.02.
Wants python3-numpy.
"""
import argparse
import pathlib
import sys
import tempfile
import tomllib

import numpy as np

sys.dont_write_bytecode = True
HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parents[1] / "reference")]

from bench_program_time import MOST, PROGRAMS, Machine
from path_timing import greatest_along, seconds

AXES = ("r1", "r2", "psi", "y")
OURS = (0.998, 0.985)


def axis_limits(profile):
    """Speed, acceleration and start-stop speed of each axis, in pulses and seconds."""
    limits = []
    for name in AXES:
        keys = profile["axis"][name]
        per_unit = keys["pulses_per_rev"] / 360.0 if name == "psi" else keys["pulses_per_mm"]
        unit = "deg" if name == "psi" else "mm"
        limits.append([per_unit * keys[f"{key}_{unit}_{power}"]
                       for key, power in (("speed", "s"), ("accel", "s2"), ("start_stop", "s"))])
    return np.array(limits)


def curves(text):
    """From rest to rest: lengths of u, slopes at the begins and at the ends, by parabola."""
    rows = np.array([[float(word) for word in line.split(",")] for line in text.split()])
    for run in np.split(rows, np.flatnonzero(rows[:, 0])[1:]):
        yield run[:, 1], run[:, 2:6], run[:, 6:10]


def least_s(curve, limits, parts):
    """Along one curve. Slopes are linear in u in each of its parts."""
    length, begin, end = curve
    share = np.arange(parts) / parts
    width = np.repeat(length / parts, parts)
    slope_begin = (begin[:, None] + share[None, :, None] * (end - begin)[:, None]).reshape(-1, 4)
    second = np.repeat((end - begin) / length[:, None], parts, axis=0)
    slope_end = slope_begin + second * width[:, None]
    # Where two parabolas meet the greater of both, which differ by rounding alone.
    steepest = np.maximum(np.abs(np.vstack([slope_begin, slope_end[-1:]])), np.abs(np.vstack([slope_begin[:1], slope_end])))
    square = np.maximum(steepest**2, 1e-18)
    cap = np.min(limits[:, 0] ** 2 / square, axis=1)
    for at in (0, -1):
        cap[at] = min(cap[at], np.min((0.5 * limits[:, 2]) ** 2 / square[at]))
    middle = 0.5 * (slope_begin + slope_end)
    axes = [(second[:, k], middle[:, k], limits[k, 1]) for k in range(4) if np.any(steepest[:, k] > 1e-9)]
    return seconds(width, greatest_along(width, cap, axes))


def main():
    parser = argparse.ArgumentParser(usage=__doc__.split("usage: ")[1].split("\n")[0])
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--programs", nargs="+", choices=PROGRAMS, default=list(PROGRAMS))
    parser.add_argument("--tolerance", type=float, nargs="+", default=[0.01, 0.05])
    parser.add_argument("--parts", type=int, default=8)
    parser.add_argument("--no-carving", action="store_true", help="the planned time instead, which no core carves")
    options = parser.parse_args()
    is_good = True
    with tempfile.TemporaryDirectory() as folder:
        machine = Machine(options.build.resolve(), pathlib.Path(folder))
        limits = axis_limits(tomllib.loads(machine.psicarve("profile", "show")))
        ours = limits * np.array([*OURS, 1.0])
        for tolerance_mm in options.tolerance:
            for name in options.programs:
                text = PROGRAMS[name](tolerance_mm)
                planned_s, rests, _ = machine.planned(text)
                found = list(curves(machine.run(machine.build / "bench" / "program_seconds",
                                                machine.work / "program.ngc", "--curve")))
                least, coarser, kept = (sum(least_s(curve, of, parts) for curve in found)
                                        for of, parts in ((limits, options.parts), (limits, options.parts // 2),
                                                          (ours, options.parts)))
                taken_s = planned_s if options.no_carving else machine.ways_s(text)
                ratio = taken_s / least
                is_good &= ratio <= MOST
                print(f"{name:7} G64 P{tolerance_mm:g}: {taken_s:.4f} s (planned {planned_s:.4f} s, {rests} rests),"
                      f" least along its curve {least:.4f} s (halving {100.0 * abs(coarser / least - 1.0):.2f} %):"
                      f" {ratio:.4f}, wanted at most {MOST}; with the planner's shares {taken_s / kept:.4f}", flush=True)
    sys.exit(0 if is_good else 1)


if __name__ == "__main__":
    main()
