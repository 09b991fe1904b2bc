#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the two schedules of the core can do on this computer.

usage: bench_schedules.py BUILD [--rounds N] [--seconds N] [--cpu N]

Each in turn, N rounds: the core on its real clock carves the example figurine at speeds that all of them can
make. Told of each: the lateness of all its ticks (two-timer: of both its threads), the share of them missed, the
most pulses an axis can make, how soon a limit acts,
and how long the figurine takes on the virtual clock with axes as fast as the schedule allows (at most twice the
built-in profile's speeds and accelerations).
"""

import argparse
import json
import os
import re
import statistics
import subprocess
import tempfile

from bench_lateness import Core, percentile

SCHEDULES = {
    "single, 50 us": ("single", 50, 50),
    "single, 100 us": ("single", 100, 100),
    "two-timer, 100 and 500 us": ("two-timer", 100, 500),
}
PULSES_PER_MM = 400.0


def most_pulses_per_s(kind, period_us, io_us):
    return 1e6 / io_us if kind == "two-timer" else 1e6 / (2 * period_us)


class ScheduledCore(Core):
    def __init__(self, build, folder, schedule, cpu):
        kind, period_us, io_us = schedule
        super().__init__(build, folder, period_us, cpu)
        self.kind = kind
        self.io_us = io_us

    def with_schedule(self, text, speed_mm_s, speed_deg_s):
        text = re.sub(r"(?m)^schedule = .*$", f'schedule = "{self.kind}"', text)
        text = re.sub(r"(?m)^io_us = .*$", f"io_us = {self.io_us}.0", text)
        text = re.sub(r"(?m)^speed_mm_s = .*$", f"speed_mm_s = {speed_mm_s}", text)
        text = re.sub(r"(?m)^home_speed_mm_s = .*$", "home_speed_mm_s = 4.0", text)
        return re.sub(r"(?m)^speed_deg_s = .*$", f"speed_deg_s = {speed_deg_s}", text)

    def profile(self):
        path = super().profile()
        with open(path, encoding="utf-8") as file:
            text = self.with_schedule(file.read(), 4.0, 90.0)
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        return path

    def carving_s(self, model):
        most = most_pulses_per_s(self.kind, self.period_us, self.io_us)
        shown = subprocess.run([os.path.join(self.bin, "psicarve"), "profile", "show"], capture_output=True,
                               text=True, check=True).stdout
        text = re.sub(r"(?m)^period_us = .*$", f"period_us = {self.period_us}.0", shown)
        text = self.with_schedule(text, min(20.0, most / PULSES_PER_MM), min(450.0, most * 360.0 / 6400.0))
        text = re.sub(r"(?m)^accel_mm_s2 = .*$", "accel_mm_s2 = 200.0", text)
        text = re.sub(r"(?m)^accel_deg_s2 = .*$", "accel_deg_s2 = 4500.0", text)
        text = re.sub(r"(?m)^feed_mm_s = .*$", "feed_mm_s = 40.0", text)
        path = os.path.join(self.folder, "fast.toml")
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        report = json.loads(self.psicarve("carve", model, "--profile", path, "--layers", "100", "--json"))
        return report["carve_seconds"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build")
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--seconds", type=int, default=8)
    parser.add_argument("--cpu", type=int, default=max(os.sched_getaffinity(0)))
    options = parser.parse_args()
    build = os.path.abspath(options.build)
    model = os.path.join(os.path.dirname(__file__), "..", "..", "..", "examples", "figurine.stl")
    figures = {name: [] for name in SCHEDULES}
    with tempfile.TemporaryDirectory() as folder:
        for _ in range(options.rounds):
            for name, schedule in SCHEDULES.items():
                bins, status = ScheduledCore(build, folder, schedule, options.cpu).run(model, options.seconds)
                ticks = sum(bins.values())
                figures[name].append((percentile(bins, 0.5), percentile(bins, 0.99), max(bins),
                                      100.0 * status["missed_ticks"] / (ticks + status["missed_ticks"])))
                print(name, "p50 %.1f p99 %.1f latest %d us, missed %.2f %%" % figures[name][-1], flush=True)
        print("\nschedule: p50, p99, latest [us], missed [%] (medians); most pulses/s; limit acts in us; "
              "figurine of 100 layers [s]")
        for name, schedule in SCHEDULES.items():
            core = ScheduledCore(build, folder, schedule, options.cpu)
            medians = [statistics.median(column) for column in zip(*figures[name])]
            print(f"{name}: " + ", ".join(f"{value:.2f}" for value in medians) +
                  f"; {most_pulses_per_s(*schedule):.0f}; {schedule[2]}; {core.carving_s(model):.1f}")


if __name__ == "__main__":
    main()
