#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the carved piece costs a run on the virtual clock: the same job carved without and with it, in turn.

usage: bench_carved_piece.py BUILD [--pairs N] [--model FILE] [--tool TOOL] [--layers N] [--points N]

BUILD is a build folder with psicarve and psicarve-rtcore (preset release). Carved are the job alone and with --piece,
and the model, which is sliced first, with --no-deviation and with --deviation; the order turns from pair to pair, so that what else the
computer does meets all alike. Told are medians over the pairs, and the median of each pair's ratio to the run without:

  program    from psicarve's begin to its end by the wall clock, the simulated run, its verification and files included
  processor  of psicarve and its core
  peak       memory of the larger of the two

and how many times faster than the machine the program was.
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
UNITS = {"program": "s", "processor": "s", "peak": "MB"}


def run(command):
    """The report of a command, and what it took."""
    begin = time.monotonic()
    with subprocess.Popen([str(word) for word in command], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL) as process:
        report = json.loads(process.stdout.read())
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0:
        raise SystemExit(f"psicarve ended with {process.returncode}: {report.get('error')}")
    return report, {"program": time.monotonic() - begin, "processor": usage.ru_utime + usage.ru_stime,
                    "peak": usage.ru_maxrss / 1024.0}


def tell(name, runs, before, machine_s):
    text = []
    for key, unit in UNITS.items():
        middle = statistics.median(figures[key] for figures in runs)
        ratio = statistics.median(figures[key] / other[key] for figures, other in zip(runs, before))
        text.append(f"{key} {middle:.1f} {unit} ({ratio:.2f})")
    pace = machine_s / statistics.median(figures["program"] for figures in runs)
    print(f"  {name:18} {', '.join(text)}, {pace:.0f} times the machine's pace")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--pairs", type=int, default=5)
    parser.add_argument("--model", type=pathlib.Path, default=ROOT / "examples/figurine.stl")
    parser.add_argument("--tool", default="ball:3")
    parser.add_argument("--layers", default=200)
    parser.add_argument("--points", default=500)
    arguments = parser.parse_args()
    psicarve = arguments.build / "bin/psicarve"
    how = ["--tool", arguments.tool, "--layers", arguments.layers, "--points", arguments.points]
    segment = f"psicarve-bench-{os.getpid()}"
    with tempfile.TemporaryDirectory() as folder, contextlib.ExitStack() as end:
        end.callback(lambda: pathlib.Path("/dev/shm", segment).unlink(missing_ok=True))
        job = f"{folder}/bench.job"
        run([psicarve, "slice", arguments.model, "-o", job, "--json", *how])
        kinds = {"job": [job], "job --piece": [job, "--piece", f"{folder}/piece.ply"],
                 "model": [arguments.model, *how, "--no-deviation"],
                 "model --deviation": [arguments.model, *how, "--deviation", f"{folder}/piece.png"]}
        found = {name: [] for name in kinds}
        for pair in range(arguments.pairs):
            names = list(kinds)
            for name in names[pair % len(names):] + names[:pair % len(names)]:
                report, figures = run([psicarve, "carve", *kinds[name], "--json", "--segment",
                                       f"/{segment}"])
                found[name].append(figures)
    machine_s = report["total_seconds"]
    print(f"{arguments.model.name}, {arguments.layers} x {arguments.points}, {arguments.tool}: "
          f"{machine_s:.0f} s of the machine's time; medians of {arguments.pairs}")
    for name in kinds:
        tell(name, found[name], found["job" if name.startswith("job") else "model"], machine_s)


main()
