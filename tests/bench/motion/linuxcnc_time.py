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
import os
import pathlib
import pwd
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "reference"))

import linuxcnc_config as config
from machine_limits import read_layers, read_limits

SERVO_S = 0.001


def layer_points(layer):
    """(R1, R2, psi in degrees) of each point."""
    return [(r1, r2, math.degrees(psi)) for r1, r2, psi in zip(*layer.r_mm, layer.psi_rad)]


def axis_limits(limits):
    psi = (math.degrees(limits.psi.speed), math.degrees(limits.psi.accel))
    return [(head.speed, head.accel) for head in limits.heads] + [psi]


def run(points, limits, tolerance_mm, limit_s):
    """Commanded positions of the three axes, one entry a servo tick."""
    with tempfile.TemporaryDirectory(prefix="layer-time-") as folder:
        files = {
            "machine.ini": config.ini_text(axis_limits(limits)),
            "machine.hal": config.HAL,
            "layer.ngc": config.program_text(points, tolerance_mm),
            "operate.py": config.OPERATOR.format(limit_s=limit_s),
            "parameters.var": "",
            "tools.tbl": "",
        }
        for name, text in files.items():
            path = pathlib.Path(folder, name)
            path.write_text(text)
            path.chmod(0o755)
        command = ["timeout", str(limit_s + 60), "linuxcnc", "-r", "machine.ini"]
        environment = dict(os.environ, HOME=folder)
        if os.geteuid() == 0:
            nobody = pwd.getpwnam("nobody")
            for path in (folder, *pathlib.Path(folder).iterdir()):
                os.chown(path, nobody.pw_uid, nobody.pw_gid)
            command = ["runuser", "-u", "nobody", "--", "env", f"HOME={folder}"] + command
        done = subprocess.run(
            command, cwd=folder, env=environment, capture_output=True, text=True, stdin=subprocess.DEVNULL
        )
        outcome = pathlib.Path(folder, "outcome.txt")
        if not outcome.exists() or outcome.read_text() != "finished":
            raise RuntimeError("LinuxCNC did not finish:\n" + (done.stdout + done.stderr)[-2000:])
        return read_samples(pathlib.Path(folder, "samples.txt"))


def read_samples(path):
    samples = []
    for line in path.read_text().splitlines():
        if "overrun" in line:
            raise RuntimeError("LinuxCNC ran faster than its positions could be recorded")
        words = line.split()
        if len(words) >= 3:
            samples.append(tuple(map(float, words[:3])))
    return samples


def carving_part(samples):
    """From the last position of the rest before the first point to the first position of the rest after the last."""
    moving = [i for i in range(1, len(samples)) if samples[i] != samples[i - 1]]
    gaps = [after - before for before, after in zip(moving, moving[1:])]
    start = moving[gaps.index(max(gaps)) + 1]
    return samples[start - 1 : moving[-1] + 1]


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
    path = carving_part(run(points, limits, tolerance_mm, limit_s))
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
