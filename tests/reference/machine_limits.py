# SPDX-License-Identifier: GPL-3.0-or-later
"""A machine profile's motion limits and a job's layers, in mm, radians and seconds.

Reads what `psicarve profile show` and `psicarve snapshot export --format csv` write.
"""

import csv
import dataclasses
import math
import tomllib

import numpy as np

from outside import NOWHERE, Run, lines_outside


@dataclasses.dataclass(frozen=True)
class AxisLimits:
    """Of one axis, in mm (heads) or radians (table)."""

    pulse: float
    speed: float
    accel: float
    start_stop: float
    tip_mm: float = 0.0  # of a head: how much further out than counted the tip is


@dataclasses.dataclass(frozen=True)
class MachineLimits:
    r1: AxisLimits
    r2: AxisLimits
    psi: AxisLimits
    feed_mm_s: float
    path_tolerance_mm: float
    core_radius_mm: float
    travel_mm: tuple  # greatest radius of each head
    clearance_mm: float = 0.0
    blank_mm: float = 0.0  # how far out it reaches all round; 0: not known

    @property
    def heads(self):
        return (self.r1, self.r2)


@dataclasses.dataclass(frozen=True)
class Layer:
    """One layer's points. psi_rad grows from 0, also where the table turns backwards."""

    number: int
    psi_rad: np.ndarray
    r_mm: tuple  # two arrays, R1 and R2
    is_outside: tuple = NOWHERE  # of each line between two points, R1 and R2: keeps to no feed


def read_limits(path):
    with open(path, "rb") as file:
        profile = tomllib.load(file)
    job, axis, blank = profile["job"], profile["axis"], profile["blank"]
    return MachineLimits(
        r1=_head(axis["r1"]),
        r2=_head(axis["r2"]),
        psi=_table(axis["psi"]),
        feed_mm_s=job["feed_mm_s"],
        path_tolerance_mm=job["path_tolerance_mm"],
        core_radius_mm=profile["core_radius_mm"],
        travel_mm=(axis["r1"]["travel_mm"][1], axis["r2"]["travel_mm"][1]),
        clearance_mm=job["clearance_mm"],
        blank_mm=blank["radius_mm"] and blank["radius_mm"] + math.hypot(blank["offset_x_mm"], blank["offset_z_mm"]),
    )


def _head(keys):
    return AxisLimits(
        1.0 / keys["pulses_per_mm"],
        keys["speed_mm_s"],
        keys["accel_mm_s2"],
        keys["start_stop_mm_s"],
        keys["tip_offset_mm"] + keys["tool_wear_mm"],
    )


def _table(keys):
    return AxisLimits(
        2.0 * math.pi / keys["pulses_per_rev"],
        math.radians(keys["speed_deg_s"]),
        math.radians(keys["accel_deg_s2"]),
        math.radians(keys["start_stop_deg_s"]),
    )


def read_layers(path, limits):
    """All layers of an exported job, in order."""
    rows, passes = {}, {}
    with open(path, newline="") as file:
        for row in csv.DictReader(file):
            values = [int(row[key]) for key in ("psi_pulses", "r_left_pulses", "r_right_pulses")]
            rows.setdefault(int(row["layer"]), []).append(values)
            # A job of one pass has no such columns.
            passes[int(row["layer"])] = int(row.get("run", 1)), float(row.get("clear_mm", 0.0))
    layers = [_layer(number, np.array(points, dtype=float), limits) for number, points in sorted(rows.items())]
    outside = lines_outside(_runs(layers, passes, limits), limits)
    return [dataclasses.replace(layer, is_outside=lines) for layer, lines in zip(layers, outside)]


def _runs(layers, passes, limits):
    runs = {}
    for layer in layers:
        number, clear_mm = passes[layer.number]
        tips = [r + axis.tip_mm for r, axis in zip(layer.r_mm, limits.heads)]
        runs.setdefault(number, Run(clear_mm, [])).tip_mm.append(tips)
    return [run for _, run in sorted(runs.items())]


def _layer(number, points, limits):
    psi = np.abs(points[:, 0] - points[0, 0]) * limits.psi.pulse
    if len(psi) < 2 or np.any(np.diff(psi) <= 0.0):
        raise ValueError(f"layer {number}: the table does not turn one way from point to point")
    return Layer(number, psi, (points[:, 1] * limits.r1.pulse, points[:, 2] * limits.r2.pulse))
