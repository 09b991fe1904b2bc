#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The core's reference time against the independent one, on two small layers without corners.

usage: core_reference_test.py PSICARVE JOB_FROM_CSV WORK

Both layers are carved by a private core on the virtual clock, which reports its reference_seconds.
"""

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

MOST = 1.02  # the core's time over the independent one
HALF_TURN_PULSES = 3200


def lobed(psi):
    return 20.0 + 2.0 * np.cos(5.0 * psi) + np.cos(13.0 * psi)


def wavy(psi):
    return 12.0 + 0.8 * np.cos(3.0 * psi) + 0.25 * np.cos(17.0 * psi + 1.0)


def run(*words):
    return subprocess.run([str(word) for word in words], capture_output=True, text=True, check=True).stdout


class CoreReference(unittest.TestCase):
    def compare(self, name, radius_mm, points, feed_mm_s):
        WORK.mkdir(parents=True, exist_ok=True)
        table, profile, job = (WORK / f"{name}.{kind}" for kind in ("csv", "toml", "job"))
        text = run(PSICARVE, "profile", "show")
        text = re.sub(r'(?m)^planner = "\w+"', 'planner = "lookahead"', text)
        profile.write_text(re.sub(r"(?m)^feed_mm_s = [0-9.]+", f"feed_mm_s = {feed_mm_s}", text))
        table.write_text(table_text(radius_mm, points))
        run(JOB_FROM_CSV, table, profile, job)
        core_s = json.loads(run(PSICARVE, "replay", job, "--json"))["reference_seconds"]
        self.assertIsNotNone(core_s, "the core reports no reference time")
        limits = read_limits(profile)
        (layer,) = read_layers(table, limits)
        least = least_layer_time(layer, limits, halvings=2)
        self.assertLess(core_s, MOST * least.seconds)
        # Nor may it promise what no motion does: the independent time is converged to 0.3 %, the core's too.
        self.assertGreater(core_s, 0.99 * least.seconds)

    def test_of_deep_lobes_is_within_two_per_cent(self):
        self.compare("lobed", lobed, 321, 20.0)

    def test_of_fine_waves_is_within_two_per_cent(self):
        self.compare("wavy", wavy, 121, 12.0)


def table_text(radius_mm, points):
    rows = ["layer,point,y_pulses,psi_pulses,r_left_pulses,r_right_pulses"]
    for point in range(points):
        psi_pulses = (2 * point * HALF_TURN_PULSES + points - 1) // (2 * (points - 1))
        psi = psi_pulses * np.pi / HALF_TURN_PULSES
        radii = [round(400.0 * float(radius_mm(psi + turn))) for turn in (0.0, np.pi)]
        rows.append(f"0,{point},400,{psi_pulses},{radii[0]},{radii[1]}")
    return "\n".join(rows) + "\n"


if __name__ == "__main__":
    PSICARVE, JOB_FROM_CSV, WORK = (pathlib.Path(word) for word in sys.argv[1:4])
    unittest.main(argv=sys.argv[:1])
