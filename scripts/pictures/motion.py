#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws docs/pictures/speed.svg, corner.svg and tick.svg from pins of the simulated machine, on the virtual clock: the
same programs make the same bytes.

    scripts/pictures/motion.py PROGRAMS [FOLDER]    (build/dev/bin, docs/pictures)
"""

import bisect
import math
import os
import re
import subprocess
import sys
import tempfile

from pin_trace import carve
from svg import Page, Plot, number

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
PULSES_PER_MM, DEG_PER_PULSE = 400, 360 / 6400  # of the built-in profile
FINE_PULSES_PER_MM, FINE_PULSES_PER_REV = 4000, 128000  # of examples/fine.toml
LAYER = 1


def profile_value(text, table, key):
    return float(re.search(rf"(?ms)^\[{re.escape(table)}\].*?^{key} *= *([-\d.]+)", text)[1])


def places_at(steps, times_ns):
    """Where an axis is at these times [pulses]: straight from step to step."""
    edges = [ns for ns, _ in steps]
    out = []
    for now_ns in times_ns:
        after = bisect.bisect_right(edges, now_ns)
        if after in (0, len(edges)):
            out.append(float(steps[min(after, len(edges) - 1)][1]))
            continue
        (t0, p0), (t1, p1) = steps[after - 1], steps[after]
        # A pause ends with its last step, and is no slow way.
        t0 = max(t0, t1 - 20_000_000)
        out.append(p0 + (p1 - p0) * max(0.0, (now_ns - t0) / (t1 - t0)))
    return out


def speeds(steps, times_ns, window_ns):
    """Pulses a second, each over a window about its time."""
    before = places_at(steps, [ns - window_ns / 2 for ns in times_ns])
    behind = places_at(steps, [ns + window_ns / 2 for ns in times_ns])
    return [(b - a) / window_ns * 1e9 for a, b in zip(before, behind)]


def draw_speed(trace, rows, profile, file):
    layer = [row for row in rows if row["layer"] == LAYER]
    psi = trace.steps("psi")
    begin_ns = max(ns for ns, pulses in psi if pulses <= layer[0]["psi_pulses"])
    end_ns = min(ns for ns, pulses in psi if pulses >= layer[-1]["psi_pulses"])
    times_ns = list(range(begin_ns - 20_000_000, end_ns + 20_000_000, 6_000_000))
    shown = (0, math.ceil((end_ns - begin_ns) / 1e8) / 10)
    page = Page(860, 470, "Speed of R1 and of the table through one layer, from the pins")
    axes = [("R1 [mm/s]", "r1", "axis.r1", "mm", 1 / PULSES_PER_MM, 60),
            ("Table [°/s]", "psi", "axis.psi", "deg", DEG_PER_PULSE, 270)]
    for name, axis, table, unit, scale, top in axes:
        most = profile_value(profile, table, f"speed_{unit}_s")
        jump = profile_value(profile, table, f"start_stop_{unit}_s")
        gain = profile_value(profile, table, f"accel_{unit}_s2")
        low = -1.15 * most if axis == "r1" else -0.1 * most
        plot = Plot(page, (70, top, 760, 150), shown, (low, 1.15 * most))
        if axis == "r1":
            page.rect(70, plot.y(jump), 760, plot.y(-jump) - plot.y(jump), "band")
        plot.frame([value / 2 for value in range(int(2 * shown[1]) + 1)],
                   [-most, 0, most] if axis == "r1" else [0, most / 2, most], name,
                   "seconds since the layer below was done: first the way up, then the layer" if axis == "psi" else "")
        for value in ([most, -most] if axis == "r1" else [most]):
            page.line(70, plot.y(value), 830, plot.y(value), "limit", 1.2, stroke_dasharray="6 4")
        values = [(ns, speed * scale) for ns, speed in zip(times_ns, speeds(trace.steps(axis), times_ns, 20_000_000))]
        page.path(plot.at([((ns - begin_ns) / 1e9, value) for ns, value in values
                           if 0 <= (ns - begin_ns) / 1e9 <= shown[1]]), axis, 1.6)
        # How steep the speed may be: from the jump to the top, beside the curve.
        seconds = (most - jump) / gain
        at = 0.35
        page.path(plot.at([(at, jump), (at + seconds, most)]), "limit", 2)
        degrees = unit.replace("deg", "°")
        page.text(plot.x(at) + 16, plot.y(0.5 * most) + 4, f"a = {number(gain)} {degrees}/s²", "limit", "start", 12)
        page.text(76, plot.y(most) - 5, f"v = {number(most)}", "limit", "start", 12)
        if axis == "r1":
            page.text(76, plot.y(-jump) + 13, f"±j = {number(jump)}", "dim", "start", 12)
    page.text(70, 26, "Speed from the pulses, over windows of 20 ms", "ink", "start", 15)
    page.write(file)


def draw_corner(trace, rows, file, point=140, reach=2):
    """In the plane of R1 about a point: x along the surface at that point's radius."""
    layer = [row for row in rows if row["layer"] == LAYER]
    middle = layer[point]
    radius_mm = middle["r_left_pulses"] / FINE_PULSES_PER_MM
    mm_per_psi = radius_mm * 2 * math.pi / FINE_PULSES_PER_REV

    def place(psi_pulses, r_pulses):
        return ((psi_pulses - middle["psi_pulses"]) * mm_per_psi, r_pulses / FINE_PULSES_PER_MM)
    knots = [place(row["psi_pulses"], row["r_left_pulses"]) for row in layer[point - reach:point + reach + 1]]
    tolerance_mm = 0.01
    first, last = layer[point - reach]["psi_pulses"], layer[point + reach]["psi_pulses"]
    now = {"r1": None, "psi": None}
    way = []
    for ns, axis, pulses in sorted([(ns, axis, pulses) for axis in now for ns, pulses in trace.steps(axis)]):
        now[axis] = pulses
        if None not in now.values() and first <= now["psi"] <= last and abs(now["r1"] - middle["r_left_pulses"]) < 6000:
            way.append(place(now["psi"], now["r1"]))
    xs, ys = [x for x, _ in knots], [y for _, y in knots]
    scale = 760 / (max(xs) - min(xs) + 0.06)
    height = scale * (max(ys) - min(ys) + 0.06)
    page = Page(860, round(height) + 110, "A corner of the letter: points, tube, and the pulses' way")
    plot = Plot(page, (60, 50, 760, height), (min(xs) - 0.03, max(xs) + 0.03), (min(ys) - 0.03, max(ys) + 0.03))
    for (x0, y0), (x1, y1) in zip(knots, knots[1:]):
        length = math.hypot(x1 - x0, y1 - y0)
        off = (-(y1 - y0) / length * tolerance_mm, (x1 - x0) / length * tolerance_mm)
        page.path(plot.at([(x0 + off[0], y0 + off[1]), (x1 + off[0], y1 + off[1]),
                           (x1 - off[0], y1 - off[1]), (x0 - off[0], y0 - off[1])]), "band", 0.5, "band", True)
    plot.frame([value / 20 for value in range(math.ceil(20 * (min(xs) - 0.03)), math.floor(20 * (max(xs) + 0.03)) + 1)],
               [value / 20 for value in range(math.ceil(20 * (min(ys) - 0.03)), math.floor(20 * (max(ys) + 0.03)) + 1)],
               "radius of R1 [mm]", "along the surface [mm]")
    page.path(plot.at(knots), "dim", 1, None, stroke_dasharray="5 4")
    page.path(plot.at(way), "r1", 1.4)
    for x, y in knots:
        page.circle(plot.x(x), plot.y(y), 4.5, "paper", "r2", 2)
    right = 812
    for row, (words, colour) in enumerate([("points of the table, met to the pulse", "r2"),
                                           ("straight way between them", "dim"),
                                           ("tube: 0.01 mm to either side", "dim"),
                                           ("what came out of the pins", "r1")]):
        page.text(right, 74 + 18 * row, words, colour, "end", 13)
    page.write(file)


def draw_levels(page, trace, signals, from_ns, ticks, left, top, wide):
    """Levels of signals as lines, tick by tick; `wide` pixels a tick. Returns the edges of each signal [ns]."""
    until_ns = from_ns + ticks * trace.period_ns
    edges = {}
    for tick in range(ticks + 1):
        x = left + tick * wide
        page.line(x, top - 6, x, top + 40 * len(signals) - 10, "grid", 0.7)
    for row, (signal, name, colour) in enumerate(signals):
        level = 0
        base = top + 40 * row + 24
        points, edges[signal] = [], []
        for ns, found, value in trace.events:
            if found != signal:
                continue
            if ns < from_ns:
                level = value
            elif ns < until_ns:
                points = points or [(left, base - 22 * level)]
                x = left + (ns - from_ns) / trace.period_ns * wide
                points += [(x, base - 22 * level), (x, base - 22 * value)]
                level = value
                edges[signal].append((ns, value))
        points = points or [(left, base - 22 * level)]
        page.path(points + [(left + ticks * wide, base - 22 * level)], colour, 1.8)
        page.text(left - 10, base - 4, name, colour, "end", 13)
    return edges


def span(page, trace, from_ns, left, wide, y, begin_ns, end_ns, words):
    x0, x1 = (left + (ns - from_ns) / trace.period_ns * wide for ns in (begin_ns, end_ns))
    for x in (x0, x1):
        page.line(x, y - 6, x, y + 6, "ink")
    page.line(x0, y, x1, y, "ink", 1.2)
    page.text(max(x1, x0 + 2) + 6, y + 4, words, "ink", "start", 12)


def draw_tick(trace, profile, file):
    asked = {key: profile_value(profile, "port", key) / 1000
             for key in ("dir_setup_ns", "dir_hold_ns", "step_high_ns", "step_low_ns")}
    period_us = trace.period_ns // 1000
    begin_ns = trace.steps("y")[-1][0]  # behind homing and approach: the last layer is being carved
    turns, last_ns, turn_ns = [], None, None
    quick, before_ns = None, None
    for ns, signal, level in trace.events:
        if ns < begin_ns:
            continue
        if signal == "r1_dir":
            turn_ns = ns
        elif signal == "r1_step" and level:
            if turn_ns is not None and last_ns is not None:
                turns.append((ns - last_ns, last_ns, turn_ns, ns))
            last_ns, turn_ns = ns, None
            if before_ns is not None and (quick is None or ns - before_ns < quick[0]):
                quick = (ns - before_ns, before_ns)
            before_ns = ns
    _, last_ns, turn_ns, next_ns = min(turns)
    page = Page(860, 480, "Steps and directions tick by tick, where R1 turns back and where it is fast")
    left = 100
    page.text(left, 26, f"R1 turns back: a tick is {period_us} µs", "ink", "start", 15)
    wide = 740 / 84
    from_ns = last_ns - 6 * trace.period_ns
    draw_levels(page, trace, [("r1_dir", "R1 direction", "r1"), ("r1_step", "R1 step", "r1"),
                              ("psi_step", "table step", "psi")], from_ns, 84, left, 46, wide)
    span(page, trace, from_ns, left, wide, 182, last_ns, turn_ns,
         f"hold: {(turn_ns - last_ns) // 1000} µs from the rising step, {asked['dir_hold_ns']:g} µs are asked for")
    span(page, trace, from_ns, left, wide, 204, turn_ns, next_ns, "")
    page.text(left + (turn_ns - from_ns) / trace.period_ns * wide, 226,
              f"set-up: {(next_ns - turn_ns) // 1000} µs before the next step, {asked['dir_setup_ns']:g} µs are asked for",
              "ink", "start", 12)
    ticks = 24
    wide = 740 / ticks
    from_ns = quick[1] - 3 * trace.period_ns
    page.text(left, 270, "R1 is fast", "ink", "start", 15)
    edges = draw_levels(page, trace, [("r1_dir", "R1 direction", "r1"), ("r1_step", "R1 step", "r1"),
                                      ("psi_step", "table step", "psi")], from_ns, ticks, left, 290, wide)["r1_step"]
    up_ns = quick[1]
    down_ns = next(ns for ns, level in edges if ns > up_ns and not level)
    again_ns = next(ns for ns, level in edges if ns > down_ns and level)
    span(page, trace, from_ns, left, wide, 426, up_ns, down_ns,
         f"high: {(down_ns - up_ns) // 1000} µs, {asked['step_high_ns']:g} µs are asked for")
    span(page, trace, from_ns, left, wide, 448, down_ns, again_ns,
         f"low: {(again_ns - down_ns) // 1000} µs, {asked['step_low_ns']:g} µs are asked for")
    page.write(file)


def main(words):
    programs = os.path.abspath(words[0] if words else ROOT + "/build/dev/bin")
    folder = os.path.abspath(words[1] if len(words) > 1 else ROOT + "/docs/pictures")
    os.makedirs(folder, exist_ok=True)
    with tempfile.TemporaryDirectory() as scratch:
        profile = subprocess.run([programs + "/psicarve", "profile", "show", "--built-in"], check=True,
                                 stdout=subprocess.PIPE, text=True).stdout
        trace, rows, _ = carve(programs, scratch, ROOT + "/examples/figurine.stl", "--layers", "3", "--points", "500")
        draw_speed(trace, rows, profile, folder + "/speed.svg")
        trace, rows, _ = carve(programs, scratch, ROOT + "/examples/letter.stl", "--layers", "3", "--points", "300")
        draw_tick(trace, profile, folder + "/tick.svg")
        trace, rows, _ = carve(programs, scratch, ROOT + "/examples/letter.stl", "--layers", "2", "--points", "240",
                               "--profile", ROOT + "/examples/fine.toml")
        draw_corner(trace, rows, folder + "/corner.svg")


if __name__ == "__main__":
    main(sys.argv[1:])
