#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The time that is told of the five benchmark jobs while they are planned never falls by more than a tenth,
nor does what is left from a layer on.

usage: estimate_course_test.py PSICARVE ESTIMATE_COURSE WORK

Few layers and many, rings and a spiral, with and without backlash; see estimate_course.cpp.
"""

import pathlib
import re
import subprocess
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "bench" / "motion"))

import bench_jobs

NAMES = ("vase", "figurine", "gear", "relief", "scan")
POINTS = 300
LAYERS = (8, 60)


def profiles(psicarve, work):
    text = bench_jobs.run(psicarve, "profile", "show")
    played, count = re.subn(r"(?m)^backlash_mm = [0-9.]+", "backlash_mm = 0.05", text)
    assert count == 3
    for name, content in (("plain", text), ("backlash", played)):
        (work / f"{name}.toml").write_text(content)
        yield work / f"{name}.toml"


def main():
    psicarve, estimate_course, work = map(pathlib.Path, sys.argv[1:])
    work.mkdir(parents=True, exist_ok=True)
    made = []
    for profile in profiles(psicarve, work):
        for name in NAMES:
            model = bench_jobs.model_file(name, work, None)
            for layers in LAYERS:
                for joining in ("continuous", "spiral"):
                    job = work / f"{name}-{profile.stem}-{layers}-{joining}.job"
                    words = ("--layers", layers, "--points", POINTS, "--joining", joining, "--profile", profile)
                    bench_jobs.run(psicarve, "slice", model, "-o", job, *words)
                    made.append(job)
    sys.exit(subprocess.run([estimate_course, *made], check=False).returncode)


if __name__ == "__main__":
    main()
