#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Ticks a second of the virtual clock with the verification of every pin: core, pipe and verifier together.

usage: bench_verified_carving.py BUILD [--runs N] [--model FILE] [--layers N] [--points N]

BUILD is a build folder with psicarve and psicarve-rtcore (preset release). In turn: `psicarve carve JOB`, which judges
the pins while the core runs; `psicarve-rtcore --replay JOB` alone, the reference; and `psicarve verify` of the trace.
Told are medians, by the wall clock (processor time in brackets), and the ratio to the core alone; at last what the
processor times of core and verifier alone would make on two idle cores: the slower of the two.
"""

import argparse
import contextlib
import json
import os
import pathlib
import statistics
import subprocess
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[3]


def run(command):
    begin = time.monotonic()
    with subprocess.Popen([str(word) for word in command], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL) as process:
        out = process.stdout.read()
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0:
        raise SystemExit(f"{' '.join(map(str, command))} ended with {process.returncode}")
    return out, (time.monotonic() - begin, usage.ru_utime + usage.ru_stime)


@contextlib.contextmanager
def removed(segment):
    """A core leaves its segment for the next program. None comes here, so this removes it."""
    try:
        yield
    finally:
        pathlib.Path(f"/dev/shm{segment}").unlink(missing_ok=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--runs", type=int, default=5)
    parser.add_argument("--model", type=pathlib.Path, default=ROOT / "examples/figurine.stl")
    parser.add_argument("--layers", default="200")
    parser.add_argument("--points", default="500")
    options = parser.parse_args()
    psicarve, core = options.build / "bin/psicarve", options.build / "bin/psicarve-rtcore"
    segment = f"/psicarve-bench-{os.getpid()}"
    with tempfile.TemporaryDirectory() as folder, removed(segment):
        job, trace = f"{folder}/bench.job", f"{folder}/bench.trace"
        run([psicarve, "slice", options.model, "-o", job, "--layers", options.layers, "--points", options.points])
        out, _ = run([psicarve, "replay", job, "--trace", trace, "--json"])
        report = json.loads(out)
        profile, _ = run([psicarve, "profile", "show", job])
        period_us = float(next(line for line in profile.decode().splitlines() if line.startswith("period_us")).split()[2])
        ticks = report["total_seconds"] * 1e6 / period_us
        replay = [core, "--segment", segment, "--clock", "virtual", "--replay", job]
        ways = {"core alone": replay,
                "core, traced": [*replay, "--trace", f"{folder}/again.trace"],
                "carve, verified": [psicarve, "--segment", segment, "carve", job, "--json"],
                "verify, from a file": [psicarve, "verify", job, trace, "--json"]}
        took = {name: [] for name in ways}
        for _ in range(options.runs):
            for name, command in ways.items():
                took[name].append(run(command)[1])
    print(f"{ticks / 1e6:.1f} million ticks, {sum(report['pulses'].values()) / 1e6:.2f} million pulses")
    reference_s = statistics.median(wall_s for wall_s, _ in took["core alone"])
    for name, runs in took.items():
        wall_s = statistics.median(wall for wall, _ in runs)
        cpu_s = statistics.median(cpu for _, cpu in runs)
        print(f"  {name:20} {wall_s:5.2f} s ({cpu_s:.2f} s), {ticks / wall_s / 1e6:5.1f} million ticks a second, "
              f"{wall_s / reference_s:.2f} times the core alone")
    slower_s = max(statistics.median(cpu for _, cpu in took[name]) for name in ("core, traced", "verify, from a file"))
    print(f"  two idle cores: {ticks / slower_s / 1e6:.1f} million ticks a second")


if __name__ == "__main__":
    main()
