#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the models of the motion benchmarks as binary STL, from fixed seeds.

usage: make_models.py NAME OUT.stl      NAME: vase, gear, relief or scan

vase:   smooth, six lobes that wind upwards.
gear:   eighteen teeth with flanks of half a degree, slightly helical.
relief: a cylinder under noise of many wavelengths, down to one millimetre.
scan:   a bust as a hand-held scanner leaves it: uneven triangles, measuring noise, seams where two passes meet.
The fifth job of the benchmarks is examples/figurine.stl.
"""

import struct
import sys

import numpy as np

HEIGHT_MM = 20.0


def vase():
    theta, u = grid(columns=1440, rows=60)
    r = 15.0 + 3.0 * np.sin(2.2 * np.pi * u + 0.4) + 1.3 * np.cos(6.0 * theta + 2.5 * u)
    return theta, u, r


def gear():
    """Corners stand in every row exactly where the outline has them, so that flanks stay as steep as drawn."""
    teeth, flank = 18, np.radians(0.5)
    pitch = 2.0 * np.pi / teeth
    outline = []
    for tooth in range(teeth):
        start = tooth * pitch
        for at, r in ((0.0, 16.0), (flank, 18.0), (0.5 * pitch, 18.0), (0.5 * pitch + flank, 16.0)):
            outline.append((start + at, r))
    angle, radius = np.array(outline).T
    # Arcs between the corners: points every quarter of a degree.
    steps = np.arange(0.0, 2.0 * np.pi, np.radians(0.25))
    at = np.unique(np.round(np.concatenate([steps, angle]), 9))
    r = np.interp(at, np.append(angle, 2.0 * np.pi), np.append(radius, radius[0]))
    u = np.linspace(0.0, 1.0, 21)
    return at[None, :] + 0.1 * u[:, None], u[:, None] + 0.0 * at[None, :], r[None, :] + 0.0 * u[:, None]


def relief():
    theta, u = grid(columns=1440, rows=160)
    random = np.random.default_rng(20)
    r = np.full(theta.shape, 17.0)
    for wavelength_mm, height_mm in ((20.0, 0.6), (8.0, 0.35), (3.0, 0.15), (1.0, 0.05)):
        for _ in range(24):
            turns = max(1, round(2.0 * np.pi * 17.0 / wavelength_mm * random.uniform(0.6, 1.4)))
            rise = 2.0 * np.pi * HEIGHT_MM / wavelength_mm * random.uniform(-1.0, 1.0)
            phase = random.uniform(0.0, 2.0 * np.pi)
            r += height_mm / np.sqrt(12.0) * np.cos(turns * theta + rise * u + phase)
    return theta, u, r


def scan():
    random = np.random.default_rng(5)
    theta, u = grid(columns=300, rows=95)
    step = 2.0 * np.pi / 300
    theta = theta + step * random.uniform(-0.35, 0.35, theta.shape)
    u[1:-1] += random.uniform(-0.35, 0.35, u[1:-1].shape) / 95
    head = 9.0 + 4.5 * np.sin(np.pi * np.clip(1.15 * u, 0.0, 1.0)) ** 0.8
    face = 1.6 * np.exp(-((wrap(theta) / 0.35) ** 2) - ((u - 0.55) / 0.10) ** 2)
    brow = 0.9 * np.exp(-((wrap(theta) / 0.8) ** 2) - ((u - 0.72) / 0.05) ** 2)
    ears = sum(1.8 * np.exp(-((wrap(theta - side) / 0.12) ** 2) - ((u - 0.58) / 0.12) ** 2) for side in (1.6, -1.6))
    hair = 0.35 * np.abs(np.sin(21.0 * theta + 9.0 * u)) * (np.cos(theta) < -0.1)
    r = head + face + brow + ears + hair
    for seam in (0.9, 3.0, 5.2):  # one pass lies a little higher than its neighbour
        r += 0.06 * (wrap(theta - seam) > 0.0) * (np.abs(wrap(theta - seam)) < 1.0)
    return theta, u, r + random.normal(0.0, 0.01, r.shape)


def grid(columns, rows):
    theta = np.arange(columns) * (2.0 * np.pi / columns)
    u = np.linspace(0.0, 1.0, rows + 1)
    return np.meshgrid(theta, u)


def wrap(angle):
    return (angle + np.pi) % (2.0 * np.pi) - np.pi


def triangles(theta, u, r):
    """The closed surface over a grid of directions and heights: sides, bottom and top."""
    side = np.stack([r * np.cos(theta), r * np.sin(theta), HEIGHT_MM * u], axis=-1)
    following = np.roll(side, -1, axis=1)
    low, low_next, high, high_next = side[:-1], following[:-1], side[1:], following[1:]
    parts = [np.stack([low, low_next, high_next], axis=2), np.stack([low, high_next, high], axis=2)]
    for row, order in ((0, (1, 0)), (-1, (0, 1))):
        ends = (side[row], following[row])
        middle = np.broadcast_to([0.0, 0.0, side[row, 0, 2]], side[row].shape)
        parts.append(np.stack([middle, ends[order[0]], ends[order[1]]], axis=1)[None])
    return np.concatenate([part.reshape(-1, 3, 3) for part in parts])


def main():
    models = {"vase": vase, "gear": gear, "relief": relief, "scan": scan}
    if len(sys.argv) != 3 or sys.argv[1] not in models:
        sys.exit(__doc__)
    corners = triangles(*models[sys.argv[1]]())
    facet = [("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("unused", "<u2")]
    record = np.zeros(len(corners), dtype=facet)
    record["corners"] = corners
    with open(sys.argv[2], "wb") as out:
        out.write(b"psicarve motion benchmark".ljust(80, b" ") + struct.pack("<I", len(record)) + record.tobytes())


if __name__ == "__main__":
    main()
