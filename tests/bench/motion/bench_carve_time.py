#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Carving time of six jobs against its own reference time, an independent one, the angle planner and LinuxCNC.

usage: bench_carve_time.py BUILD [--work DIR] [--machines NAME ...] [--jobs NAME ...] [--scan MESH] [--layers N ...]
                           [--halvings N] [--no-reference] [--linuxcnc] [--json]

BUILD is a build folder with psicarve, psicarve-rtcore and job_from_csv. All carving is on the virtual clock, so the
figures are the machine's and the same everywhere; every run is verified on its pins. The script fails if one is not as its
job asks, or if a ratio is beyond what is wanted of it: ahead/T_ref at most 1.01 (1.003 where a tick is 10 us or less),
T_ref/bending at most 1.02, T_ref/least at most 1.05, angle/ahead at least 1, linuxcnc/ahead above 1. Columns:

  whole job     angle, ahead       carving time with either planner [s]; angle/ahead
                ahead/T_ref        T_ref: reference_seconds of the same run
  single layer  T_ref/bending      against reference_time.py's curve of least bending,
                T_ref/least        and against the least time over all curves that it found
                linuxcnc/ahead     LinuxCNC's time over ours, both without a feed (--linuxcnc)

bunny is a real scan, from Debian's glmark2-data, which the script downloads. --scan MESH adds a job from a mesh of your
own, scaled to 30 mm. The references take minutes a layer; what was found
once is kept in the working folder.
"""

import argparse
import json
import pathlib
import sys
import tempfile
import tomllib

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "reference"))

import bench_jobs as jobs
import linuxcnc_time
from layer_time import least_layer_time
from machine_limits import read_layers, read_limits

NAMES = ("vase", "figurine", "gear", "relief", "scan", "bunny")
WHOLE_LAYERS = 8


MOST = {"ahead/t_ref": 1.01, "t_ref/bending": 1.02, "t_ref/least": 1.05}
LEAST = {"angle/ahead": 1.0, "linuxcnc/ahead": 1.0}
MOST_OF_FAST_TICKS = {"ahead/t_ref": 1.003}
FAST_TICK_US = 10.0


def beyond(figures, tick_us):
    """The ratios that are not as wanted, in words."""
    most = MOST | (MOST_OF_FAST_TICKS if tick_us <= FAST_TICK_US else {})
    return [f"{key} {figures[key]:.4f}, wanted at most {limit}" for key, limit in most.items()
            if figures.get(key) is not None and figures[key] > limit] + [
            f"{key} {figures[key]:.4f}, wanted at least {limit}" for key, limit in LEAST.items()
            if figures.get(key) is not None and figures[key] < limit]


def ratio(over, under):
    return None if over is None or not under else over / under


def whole_job(programs, machine, work, table):
    angle, ahead = (
        jobs.carve(programs, table, jobs.profile_file(programs, machine, work, planner), work)
        for planner in ("angle", "lookahead")
    )
    return {
        "angle_s": angle["carve_seconds"],
        "ahead_s": ahead["carve_seconds"],
        "t_ref_s": ahead["reference_seconds"],
        "angle/ahead": ratio(angle["carve_seconds"], ahead["carve_seconds"]),
        "ahead/t_ref": ratio(ahead["carve_seconds"], ahead["reference_seconds"]),
    }


def single_layer(programs, machine, work, table, number, options):
    profile = jobs.profile_file(programs, machine, work, "lookahead")
    limits = read_limits(profile)
    layer = next(layer for layer in read_layers(table, limits) if layer.number == number)
    ahead = jobs.carve(programs, table, profile, work, number)
    found = {
        "layer": number,
        "ahead_s": ahead["carve_seconds"],
        "t_ref_s": ahead["reference_seconds"],
        "ahead/t_ref": ratio(ahead["carve_seconds"], ahead["reference_seconds"]),
    }
    inputs = [table.read_text(), repr(limits), str(number)]
    if not options.no_reference:
        key = [*inputs, str(options.halvings)]
        found |= jobs.remembered(work, "reference", key, lambda: reference(layer, limits, options))
        found["t_ref/bending"] = ratio(found["t_ref_s"], found["bending_s"])
        found["t_ref/least"] = ratio(found["t_ref_s"], found["least_s"])
    if options.linuxcnc:
        found |= jobs.remembered(work, "linuxcnc", inputs, lambda: linuxcnc(layer, limits))
        no_feed = jobs.profile_file(programs, machine, work, "lookahead", jobs.NO_FEED_MM_S)
        found["ahead_no_feed_s"] = jobs.carve(programs, table, no_feed, work, number)["carve_seconds"]
        found["linuxcnc/ahead"] = ratio(found["linuxcnc_s"], found["ahead_no_feed_s"])
    return found


def reference(layer, limits, options):
    found = least_layer_time(layer, limits, halvings=options.halvings)
    return {"bending_s": found.bending_seconds, "least_s": found.seconds, "last_halving": found.change}


def linuxcnc(layer, limits):
    seconds, cut_mm = linuxcnc_time.layer_time(layer, limits, limits.path_tolerance_mm)
    return {"linuxcnc_s": seconds, "linuxcnc_cut_mm": cut_mm}


def read_tick_us(profile):
    return float(tomllib.loads(profile.read_text())["tick"]["period_us"])


def say(title, figures):
    words = [f"{key} {'-' if value is None else format(value, '.4g')}" for key, value in figures.items()]
    print(f"{title:22s} {'  '.join(words)}", flush=True)


def measure(options, work):
    programs = jobs.Programs.in_build(options.build)
    report = []
    for machine in (machine for machine in jobs.MACHINES if machine.name in options.machines):
        tick_us = read_tick_us(jobs.profile_file(programs, machine, work, "lookahead"))
        for name in options.jobs + (["own-scan"] if options.scan else []):
            table = jobs.table_file(programs, machine, work, name, WHOLE_LAYERS, options.scan)
            figures = whole_job(programs, machine, work, table)
            singles = [single_layer(programs, machine, work, table, n, options) for n in options.layers]
            for one in [figures, *singles]:
                jobs.found_wrong += [f"{name}, {machine.name}: {words}" for words in beyond(one, tick_us)]
            report.append({"job": name, "machine": machine.name, "whole": figures, "layers": singles})
            if not options.json:
                say(f"{name}, {machine.name}", figures)
                for one in singles:
                    say("  one layer", one)
    return report


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--work", type=pathlib.Path, help="kept and used again; default: a temporary folder")
    machines = [machine.name for machine in jobs.MACHINES]
    parser.add_argument("--machines", nargs="+", choices=machines, default=machines)
    parser.add_argument("--jobs", nargs="+", choices=NAMES, default=list(NAMES))
    parser.add_argument("--scan", type=pathlib.Path, metavar="MESH")
    parser.add_argument("--layers", nargs="+", type=int, default=[2], help=f"single layers, of 0-{WHOLE_LAYERS - 1}")
    parser.add_argument("--halvings", type=int, default=5, help="of the reference's grid, at most")
    parser.add_argument("--no-reference", action="store_true")
    parser.add_argument("--linuxcnc", action="store_true")
    parser.add_argument("--json", action="store_true")
    options = parser.parse_args()
    options.build = options.build.resolve()
    with tempfile.TemporaryDirectory(prefix="psicarve-bench-") as temporary:
        work = options.work or pathlib.Path(temporary)
        work.mkdir(parents=True, exist_ok=True)
        report = measure(options, work)
    if options.json:
        print(json.dumps(report))
    sys.exit("\n".join(jobs.found_wrong) or 0)


if __name__ == "__main__":
    main()
