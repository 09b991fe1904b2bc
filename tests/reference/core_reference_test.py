#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The core's reference time against the independent one, on small layers without corners.

usage: core_reference_test.py PSICARVE JOB_FROM_CSV WORK

Each is planned by a private core on the virtual clock: two jobs of one layer, and the roughing layer of a job of two
passes, of which the heads are outside of the blank in part.
"""

import dataclasses
import json
import pathlib
import re
import subprocess
import sys
import unittest

sys.dont_write_bytecode = True

import numpy as np

from layer_time import least_layer_time
from machine_limits import read_layers, read_limits
from outside import NOWHERE

MOST = 1.02  # the core's time over the independent one
HALF_TURN_PULSES = 3200
COLUMNS = "layer,point,y_pulses,psi_pulses,r_left_pulses,r_right_pulses"


def lobed(psi):
    return 20.0 + 2.0 * np.cos(5.0 * psi) + np.cos(13.0 * psi)


def wavy(psi):
    return 12.0 + 0.8 * np.cos(3.0 * psi) + 0.25 * np.cos(17.0 * psi + 1.0)


def raised(direction):
    """Outside of a blank that reaches out to 14 mm about the middle of each half turn, R2 a little later than R1."""
    off = abs(direction - (1.4 if direction < np.pi else np.pi + 1.8))
    share = np.clip((1.2 - off) / 0.9, 0.0, 1.0)
    return 12.0 + 5.0 * share**3 * (10.0 - 15.0 * share + 6.0 * share**2)


def run(*words):
    return subprocess.run([str(word) for word in words], capture_output=True, text=True, check=True).stdout


def written(name, rows, **keys):
    """Paths of a table, of the built-in profile with look-ahead and these keys, and of a job still to be made."""
    WORK.mkdir(parents=True, exist_ok=True)
    table, profile, job = (WORK / f"{name}.{kind}" for kind in ("csv", "toml", "job"))
    text = run(PSICARVE, "profile", "show")
    text = re.sub(r'(?m)^planner = "\w+"', 'planner = "lookahead"', text)
    for key, value in keys.items():
        text, count = re.subn(rf"(?m)^{key} = [0-9.]+", f"{key} = {value:.1f}", text)
        assert count == 1, key
    profile.write_text(text)
    table.write_text("\n".join(rows) + "\n")
    return table, profile, job


class CoreReference(unittest.TestCase):
    def compare(self, name, radius_mm, points, feed_mm_s):
        table, profile, job = written(name, [COLUMNS, *layer_rows(radius_mm, points)], feed_mm_s=feed_mm_s)
        run(JOB_FROM_CSV, table, profile, job)
        core_s = json.loads(run(PSICARVE, "replay", job, "--json"))["reference_seconds"]
        self.assertIsNotNone(core_s, "the core reports no reference time")
        limits = read_limits(profile)
        (layer,) = read_layers(table, limits)
        self.expect_close(core_s, layer, limits)

    def expect_close(self, core_s, layer, limits):
        least = least_layer_time(layer, limits, halvings=2)
        self.assertLess(core_s, MOST * least.seconds)
        # Nor may it promise what no motion does: the independent time is converged to 0.3 %, the core's too.
        self.assertGreater(core_s, 0.99 * least.seconds)

    def test_of_deep_lobes_is_within_two_per_cent(self):
        self.compare("lobed", lobed, 321, 20.0)

    def test_of_fine_waves_is_within_two_per_cent(self):
        self.compare("wavy", wavy, 121, 12.0)

    def test_of_a_roughing_layer_outside_in_part_is_within_two_per_cent(self):
        rows = [COLUMNS + ",run,pass,allowance_mm,depth_mm,clear_mm"]
        rows += [row + ",1,1,0.3,12,14" for row in layer_rows(raised, 121)]
        rows += [row + ",2,2,0,0,14" for row in layer_rows(lambda psi: 7.0 + 0.0 * psi, 121, layer=1)]
        keys = {"feed_mm_s": 8.0, "radius_mm": 11.0, "offset_x_mm": 3.0}
        table, profile, job = written("outside", rows, **keys)
        run(PSICARVE, "slice", table, "--profile", profile, "-o", job)
        # Of the first pass alone, for the ways between passes count with the later ones.
        core_s = json.loads(run(PSICARVE, "estimate", job, "--json"))["passes"][0]["seconds"]
        limits = read_limits(profile)
        layer, _ = read_layers(table, limits)
        for outside in (*layer.is_outside, np.logical_and(*layer.is_outside)):
            self.assertGreater(np.count_nonzero(outside), 20)
        fed = dataclasses.replace(layer, is_outside=NOWHERE)
        self.assertLess(core_s, 0.8 * least_layer_time(fed, limits, halvings=1, bending_only=True).seconds)
        self.expect_close(core_s, layer, limits)


def layer_rows(radius_mm, points, layer=0):
    """Of a continuous job, at the same height."""
    rows = []
    for point in range(points):
        turned = (2 * point * HALF_TURN_PULSES + points - 1) // (2 * (points - 1))
        psi = turned * np.pi / HALF_TURN_PULSES
        radii = [round(400.0 * float(radius_mm(psi + turn))) for turn in (0.0, np.pi)]
        rows.append(f"{layer},{point},400,{layer * HALF_TURN_PULSES + turned},{radii[0]},{radii[1]}")
    return rows


if __name__ == "__main__":
    PSICARVE, JOB_FROM_CSV, WORK = (pathlib.Path(word) for word in sys.argv[1:4])
    unittest.main(argv=sys.argv[:1])
