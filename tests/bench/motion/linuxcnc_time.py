#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""How long LinuxCNC's trajectory planner takes for one layer of a job, headless, in simulation.

usage: linuxcnc_time.py JOB.csv PROFILE.toml [--layer N] [--tolerance MM] [--json]

The same points, axis limits and tolerance (G64 P) as ours; no feed, which LinuxCNC would apply to another speed than
ours: compare with a job whose feed does not matter. Counted in servo ticks of 1 ms on the commanded positions, from the
first motion after the approach to the last; the computer's own speed does not come into it. Needs Debian's
linuxcnc-uspace. LinuxCNC refuses to run as root: then it runs as the user `nobody`.
"""

import argparse
import json
import math
import pathlib
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "reference"))

import linuxcnc_config as config
from linuxcnc_run import SERVO_S, carving_part, run
from machine_limits import read_layers, read_limits

def layer_points(layer):
    """(R1, R2, psi in degrees) of each point."""
    return [(r1, r2, math.degrees(psi)) for r1, r2, psi in zip(*layer.r_mm, layer.psi_rad)]


def axis_limits(limits):
    psi = (math.degrees(limits.psi.speed), math.degrees(limits.psi.accel))
    return [(head.speed, head.accel) for head in limits.heads] + [psi]


def cut_mm(path, points):
    """Greatest distance in R from the chords at equal psi."""
    worst, at = 0.0, 0
    for *radii, psi in path:
        while at < len(points) - 2 and points[at + 1][2] < psi:
            at += 1
        share = min(max((psi - points[at][2]) / (points[at + 1][2] - points[at][2]), 0.0), 1.0)
        for head, radius in enumerate(radii):
            chord = points[at][head] + share * (points[at + 1][head] - points[at][head])
            worst = max(worst, abs(radius - chord))
    return worst


def layer_time(layer, limits, tolerance_mm, limit_s=300):
    """Seconds, and by how much corners are cut [mm]."""
    points = layer_points(layer)
    path = carving_part(run(config.program_text(points, tolerance_mm), axis_limits(limits), limit_s))
    return SERVO_S * (len(path) - 1), cut_mm(path, points)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("job")
    parser.add_argument("profile")
    parser.add_argument("--layer", type=int, default=0)
    parser.add_argument("--tolerance", type=float, help="default: the profile's path_tolerance_mm")
    parser.add_argument("--json", action="store_true")
    options = parser.parse_args()
    limits = read_limits(options.profile)
    layer = next((one for one in read_layers(options.job, limits) if one.number == options.layer), None)
    if layer is None:
        sys.exit(f"linuxcnc_time.py: {options.job} has no layer {options.layer}")
    tolerance_mm = limits.path_tolerance_mm if options.tolerance is None else options.tolerance
    seconds, cut = layer_time(layer, limits, tolerance_mm)
    if options.json:
        print(json.dumps({"layer": layer.number, "seconds": seconds, "tolerance_mm": tolerance_mm, "cut_mm": cut}))
    else:
        print(f"layer {layer.number}: LinuxCNC takes {seconds:.3f} s (G64 P{tolerance_mm}, cuts {cut:.4f} mm)")


if __name__ == "__main__":
    main()
