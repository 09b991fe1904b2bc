# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads pin traces in the form of a value-change dump (docs/trace.md), and makes runs to draw."""

import json
import os
import re
import subprocess

AXES = ("r1", "r2", "psi", "y")


class PinTrace:
    """events: (ns, signal, level) in their order, and (ns, "position", {axis: pulses}) where positions are defined;
    period_ns: the tick."""

    def __init__(self, file):
        self.events = []
        codes, now_ns = {}, 0
        with open(file, encoding="ascii") as lines:
            for line in lines:
                if line[0] == "#":
                    now_ns = int(line[1:])
                elif line[0] in "01" and line[1:].strip() in codes:
                    self.events.append((now_ns, codes[line[1:].strip()], int(line[0])))
                elif line.startswith("$var"):
                    codes[line.split()[3]] = line.split()[4]
                elif "period_ns" in line:
                    self.period_ns = int(line.split()[2])
                elif "position_pulses" in line:
                    found = {axis: int(pulses) for axis, pulses in re.findall(r"(\w+)=(-?\d+)", line)}
                    self.events.append((now_ns, "position", found))

    def steps(self, axis):
        """(ns, position behind it [pulses]) of each rising step edge of an enabled drive."""
        pulses, direction, is_enabled, out = 0, 0, False, []
        for now_ns, signal, level in self.events:
            if signal == "position":
                pulses = level[axis]
            elif signal == axis + "_dir":
                direction = level
            elif signal == axis + "_enable":
                is_enabled = bool(level)
            elif signal == axis + "_step" and level and is_enabled:
                pulses += 1 if direction else -1
                out.append((now_ns, pulses))
        return out


def carve(programs, scratch, model, *options):
    """Carves a model on the simulated machine. Returns its trace, its job's tables (rows of dicts of whole numbers) and
    the report."""
    name = f"/pictures-{os.getpid()}"
    psicarve = os.path.join(programs, "psicarve")
    job, pins = os.path.join(scratch, "picture.job"), os.path.join(scratch, "picture.vcd")
    environment = {**os.environ, "PSICARVE_PROFILE": ""}

    def say(*words):
        return subprocess.run([psicarve, "--segment", name, *words], check=True, stdout=subprocess.PIPE, text=True,
                              env=environment).stdout

    say("slice", model, "-o", job, *options)
    try:
        report = json.loads(say("carve", job, "--trace", pins, "--json"))
    finally:
        if os.path.exists("/dev/shm" + name):  # a carve leaves its segment for later questions
            os.unlink("/dev/shm" + name)
    head, *rows = say("snapshot", "export", job, "--format", "csv").split()
    names = head.split(",")
    return PinTrace(pins), [dict(zip(names, map(int, row.split(",")))) for row in rows], report
