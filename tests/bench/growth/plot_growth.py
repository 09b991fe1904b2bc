#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws what bench_growth printed: processor time and memory against triangles, layers and points, both scales
logarithmic, so that a slope is a power.

    bench_growth > growth.csv; plot_growth.py growth.csv growth.svg
"""

import csv
import math
import sys

SWEEPS = [("triangles", "triangles", "500 layers × 500 points a head"),
          ("layers", "layers", "100 000 triangles, 500 points a head"),
          ("points", "points a head", "100 000 triangles, 500 layers")]
STAGES = [("slice", "slicing, a point", "#0F62A8"), ("ball", "slicing, ball 3 mm", "#B4500A"),
          ("rough", "roughing", "#00785A"), ("plan", "planning", "#6B3FA0"), ("preview", "expected piece", "#666666")]
WIDTH, HEIGHT = 300, 240  # of one plot
LEFT, TOP, GAP_X, GAP_Y = 70, 60, 40, 60
INK, GRID, PAPER = "#1B1F24", "#D5D9DE", "#FFFFFF"


def decades(values):
    return math.floor(math.log10(min(values))), math.ceil(math.log10(max(values)))


def power_text(exponent):
    return f"{10 ** exponent:,}".replace(",", " ") if exponent >= 0 else f"{10.0 ** exponent:g}"


class Plot:
    """One pair of logarithmic axes."""

    def __init__(self, x, y, horizontal, vertical):
        self.x, self.y = x, y
        self.horizontal, self.vertical = horizontal, vertical

    def place(self, value, figure):
        from_x, to_x = self.horizontal
        from_y, to_y = self.vertical
        return (self.x + WIDTH * (math.log10(value) - from_x) / (to_x - from_x),
                self.y + HEIGHT * (1 - (math.log10(figure) - from_y) / (to_y - from_y)))

    def frame(self, title, unit):
        out = [f'<text x="{self.x + WIDTH / 2}" y="{self.y + HEIGHT + 34}" text-anchor="middle">{title}</text>',
               f'<text x="{self.x}" y="{self.y - 8}">{unit}</text>']
        for exponent in range(self.vertical[0], self.vertical[1] + 1):
            _, y = self.place(10 ** self.horizontal[0], 10.0 ** exponent)
            out.append(f'<line x1="{self.x}" y1="{y:.1f}" x2="{self.x + WIDTH}" y2="{y:.1f}" stroke="{GRID}"/>')
            out.append(f'<text x="{self.x - 6}" y="{y + 4:.1f}" text-anchor="end">{power_text(exponent)}</text>')
        for exponent in range(self.horizontal[0], self.horizontal[1] + 1):
            x, _ = self.place(10.0 ** exponent, 10.0 ** self.vertical[0])
            out.append(f'<line x1="{x:.1f}" y1="{self.y}" x2="{x:.1f}" y2="{self.y + HEIGHT}" stroke="{GRID}"/>')
            out.append(f'<text x="{x:.1f}" y="{self.y + HEIGHT + 16}" text-anchor="middle">{power_text(exponent)}</text>')
        return out

    def line(self, points, colour):
        places = [self.place(value, figure) for value, figure in points]
        out = [f'<polyline points="{" ".join(f"{x:.1f},{y:.1f}" for x, y in places)}" fill="none" stroke="{colour}" '
               'stroke-width="1.8"/>']
        out += [f'<circle cx="{x:.1f}" cy="{y:.1f}" r="2.6" fill="{colour}"/>' for x, y in places]
        return out


def legend():
    out = []
    x = LEFT
    for _, words, colour in STAGES:
        out.append(f'<line x1="{x}" y1="20" x2="{x + 22}" y2="20" stroke="{colour}" stroke-width="2.4"/>')
        out.append(f'<text x="{x + 28}" y="24">{words}</text>')
        x += 60 + 7 * len(words)
    return out


def drawn(rows):
    figures = {}
    for row in rows:
        figures[row["sweep"], row["stage"], int(row["value"])] = (float(row["cpu_s"]), float(row["peak_mb"]))
    total_x = LEFT + len(SWEEPS) * (WIDTH + LEFT) - LEFT + GAP_X
    total_y = TOP + 2 * (HEIGHT + GAP_Y)
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{total_x}" height="{total_y}" '
           f'viewBox="0 0 {total_x} {total_y}" font-family="sans-serif" font-size="12" fill="{INK}">',
           f'<rect width="{total_x}" height="{total_y}" fill="{PAPER}"/>'] + legend()
    for line, (which, unit) in enumerate([(0, "processor time, s"), (1, "peak memory, MB")]):
        vertical = decades([max(figure[which], 1e-4) for figure in figures.values()])
        for column, (sweep, title, rest) in enumerate(SWEEPS):
            values = sorted({key[2] for key in figures if key[0] == sweep})
            plot = Plot(LEFT + column * (WIDTH + LEFT), TOP + line * (HEIGHT + GAP_Y), decades(values), vertical)
            out += plot.frame(f"{title} ({rest})", unit)
            for stage, _, colour in STAGES:
                points = [(value, max(figures[sweep, stage, value][which], 1e-4))
                          for value in values if (sweep, stage, value) in figures]
                out += plot.line(points, colour)
    return "\n".join(out + ["</svg>", ""])


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    with open(sys.argv[1], encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    with open(sys.argv[2], "w", encoding="utf-8") as file:
        file.write(drawn(rows))


if __name__ == "__main__":
    main()
