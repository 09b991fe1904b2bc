#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether a program of short lines starves the machine on the real clock.

usage: bench_starvation.py BUILD [--seconds N] [--ring RECORDS] [--cpu N] [--burden N]

BUILD is a build folder with psicarve, psicarve-rtcore and ring_watcher, as build/release. A core on the real clock with
the simulated port runs lines of 0.05 mm with the feed beyond what the axes of the built-in profile have, for N seconds.
Speeds and accelerations are the profile's; its start-stop speeds are lowered and its alarm of missed ticks is switched off,
so that a computer that takes ticks away is counted and does not end the run. `--burden` starts N processes that only
count, beside it. Told are starvations, the least records that waited in the ring once it had been full, ticks missed, lines
a second of the machine's ticks that were not missed, and what part of a processor each process takes. Exit code 1 where it
starves, or the machine stops otherwise.
"""
import argparse
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import time

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))

from bench_program_run import write_program

LINES_A_SECOND = 400  # more than the machine carves
LOOK_S = 0.1
STOP_S = 10.0
CHANGES = {
    "missed_alarm_per_s": "0",
    "start_stop_mm_s": "0.02",
    "start_stop_deg_s": "0.5",
    "home": '"none"',
}


def processor_s(pid):
    fields = pathlib.Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


class Bench:
    def __init__(self, options, folder):
        self.build, self.options, self.folder = options.build.resolve(), options, pathlib.Path(folder)
        self.segment = f"/psicarve-starvation-{os.getpid()}"
        self.children = []

    def start(self, *words, **more):
        self.children.append(subprocess.Popen([str(word) for word in words], stderr=subprocess.DEVNULL, **more))
        return self.children[-1]

    def psicarve(self, *words):
        program = self.build / "bin" / "psicarve"
        return subprocess.run([program, *words, "--segment", self.segment], capture_output=True, text=True, check=False)

    def profile(self):
        text = subprocess.run([self.build / "bin" / "psicarve", "profile", "show"], capture_output=True, text=True,
                              check=True).stdout
        for key, value in CHANGES.items():
            text = re.sub(rf"(?m)^{key} = .*$", f"{key} = {value}", text)
        path = self.folder / "machine.toml"
        path.write_text(text)
        return path

    def core(self):
        cpu = ["--cpu", self.options.cpu] if self.options.cpu is not None else []
        core = self.start(self.build / "bin" / "psicarve-rtcore", "--segment", self.segment, "--profile", self.profile(),
                          "--program-ring", self.options.ring, "--no-state", *cpu)
        while self.psicarve("status").returncode != 0:
            time.sleep(LOOK_S)
        homed = self.psicarve("home")
        if homed.returncode != 0:
            sys.exit(f"not homed: {homed.stderr}")
        return core

    def run(self):
        program = self.folder / "long.ngc"
        write_program(program, LINES_A_SECOND * self.options.seconds + 2 * self.options.ring + 30_000, "plain")
        core = self.core()
        for _ in range(self.options.burden):
            self.start(sys.executable, "-c", "while True: pass")
        reader = self.start(self.build / "bin" / "psicarve", "gcode", "run", program, "--segment", self.segment,
                            "--profile", self.folder / "machine.toml",
                            stdout=subprocess.DEVNULL)
        watcher = self.start(self.build / "bench" / "ring_watcher", self.segment, stdout=subprocess.PIPE, text=True)
        before = {name: processor_s(process.pid) for name, process in (("core", core), ("gcode run", reader))}
        began = time.monotonic()
        while time.monotonic() - began < self.options.seconds and watcher.poll() is None and reader.poll() is None:
            time.sleep(LOOK_S)
        wall_s = time.monotonic() - began
        shares = {name: (processor_s(process.pid) - before[name]) / wall_s
                  for name, process in (("core", core), ("gcode run", reader)) if process.poll() is None}
        status = json.loads(self.psicarve("status", "--json").stdout)
        watcher.terminate()
        told = watcher.communicate()[0]
        self.psicarve("stop")
        return status, json.loads(told) if told else None, shares, wall_s

    def end(self):
        for child in reversed(self.children):
            child.terminate()
            try:
                child.wait(STOP_S)
            except subprocess.TimeoutExpired:
                child.kill()
                child.wait()
        pathlib.Path("/dev/shm" + self.segment).unlink(missing_ok=True)


def main():
    parser = argparse.ArgumentParser(usage=__doc__.split("usage: ")[1].split("\n")[0])
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--seconds", type=int, default=60)
    parser.add_argument("--ring", type=int, default=8192)
    parser.add_argument("--cpu", type=int)
    parser.add_argument("--burden", type=int, default=0)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        bench = Bench(options, folder)
        try:
            status, told, shares, wall_s = bench.run()
        finally:
            bench.end()
    if told is None or status["state"] != "carving":
        print(f"the program did not run: state {status['state']}, alarm {status.get('alarm')}, ring {told}")
        return 1
    made = told["ticks"] - told["missed"]
    seconds = made * status["period_ns"] * 1e-9
    print(f"{wall_s:.0f} s, ring {told['ring']}, burden {options.burden}, load {os.getloadavg()[0]:.1f}: starvations"
          f" {told['starvations']}; lowest filling {told['least']} of {told['ring']} in {told['looks']} looks;"
          f" {told['missed']} of {told['ticks']} ticks missed ({100.0 * told['missed'] / told['ticks']:.1f} %);"
          f" {told['records']} records, {told['records'] / seconds:.0f} a second of ticks made;"
          f" of a processor: " + ", ".join(f"{name} {share:.3f}" for name, share in shares.items()))
    return 0 if told["starvations"] == 0 else 1


if __name__ == "__main__":
    sys.exit(main())
