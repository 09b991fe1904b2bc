#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the machine, from above and from the side.

    scripts/pictures/machine.py [FILE]    (docs/pictures/machine.svg)
"""

import math
import os
import sys

from svg import Page

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))


def head(page, x, y, towards, colour, name):
    """A head whose tip is at (x, y); towards: +1 for one that stands left of the axis."""
    page.path([(x, y), (x - 26 * towards, y - 7), (x - 26 * towards, y + 7)], "ink", 1, colour, True)
    page.rect(min(x - 26 * towards, x - 76 * towards), y - 15, 50, 30, "steel", "ink")
    page.text(x - 51 * towards, y + 5, name, "ink", "middle", 14)


def from_above(page, x, y):
    page.text(x, 34, "From above", "ink", "middle", 16)
    page.circle(x, y, 104, "steel", "ink")
    page.circle(x, y, 84, "paper", "dim", 1, stroke_dasharray="5 4")
    outline = []
    for k in range(181):
        angle = math.radians(2 * k)
        radius = 52 + 12 * math.cos(3 * angle) + 4 * math.cos(5 * angle + 1)
        outline.append((x + radius * math.cos(angle), y - radius * math.sin(angle)))
    page.path(outline, "ink", 1.5, "body", True)
    page.circle(x, y, 11, "band", "limit", 1.5, stroke_dasharray="3 3")
    page.circle(x, y, 2, "ink")
    left = 52 + 12 * math.cos(3 * math.pi) + 4 * math.cos(5 * math.pi + 1)
    right = 68 + 4 * (math.cos(1) - 1)
    head(page, x - left, y, 1, "r1", "R1")
    head(page, x + right, y, -1, "r2", "R2")
    for towards, at, colour, name in ((-1, left, "r1", "r1"), (1, right, "r2", "r2")):
        page.arrow(x, y + 126, x + towards * at, y + 126, colour)
        page.line(x + towards * at, y + 12, x + towards * at, y + 132, colour, 0.8, stroke_dasharray="2 3")
        page.text(x + towards * at / 2, y + 144, name, colour, "middle", 14)
    page.line(x, y + 4, x, y + 132, "dim", 0.8, stroke_dasharray="2 3")
    arc = [(x + 122 * math.cos(math.radians(a)), y - 122 * math.sin(math.radians(a))) for a in range(112, 67, -1)]
    page.path(arc, "psi", 2)
    (x1, y1), (x0, y0) = arc[-1], arc[-4]
    page.arrow(x0, y0, x1 + 1, y1 + 1, "psi", 2)
    page.text(x, y - 132, "Ψ grows: the table turns clockwise", "psi", "middle", 14)
    page.text(x - 100, y + 190, "The direction that R1 faces grows, counter-clockwise round the piece;", "dim", "start", 12,
              dx=-70)
    page.text(x - 100, y + 206, "R2 stands half a turn from it, so half a turn of the table is a layer.", "dim", "start", 12,
              dx=-70)


def from_the_side(page, x, table):
    page.text(x, 34, "From the side", "ink", "middle", 16)
    blank, high = 84, 210
    page.rect(x - 104, table, 208, 14, "steel", "ink")
    page.rect(x - 16, table + 14, 32, 34, "steel", "ink")
    page.rect(x - blank, table - high, 2 * blank, high, "body", "dim", stroke_dasharray="5 4")
    cut = 100  # as high as the heads stand
    half = [(50 + 16 * math.sin(k / 16 + 0.6), table - k) for k in range(0, cut + 1, 4)]
    for towards in (-1, 1):
        carved = [(x + towards * blank, table), *[(x + towards * r, y) for r, y in half], (x + towards * blank, table - cut)]
        page.path(carved, "paper", 0.5, "paper", True)
        page.path([(x + towards * r, y) for r, y in half], "ink", 1.5)
        page.line(x + towards * half[-1][0], table - cut, x + towards * blank, table - cut, "ink", 1.5)
        page.line(x + towards * 11, table, x + towards * 11, table - high, "limit", 1.3, stroke_dasharray="3 3")
    page.line(x, table + 60, x, table - high - 22, "dim", 1, stroke_dasharray="12 4 2 4")
    radius = half[-1][0]
    head(page, x - radius, table - cut + 6, 1, "r1", "R1")
    head(page, x + radius, table - cut + 6, -1, "r2", "R2")
    page.arrow(x - 184, table, x - 184, table - cut + 6, "y", 1.8)
    page.line(x - 104, table, x - 192, table, "y", 0.8, stroke_dasharray="2 3")
    page.text(x - 194, table - cut / 2 + 8, "Y", "y", "end", 15)
    page.arrow(x - 146, table - cut - 26, x - 100, table - cut - 26, "r1", 1.5, both=True)
    page.arrow(x + 100, table - cut - 26, x + 146, table - cut - 26, "r2", 1.5, both=True)
    page.text(x + 112, table - high + 14, "blank", "dim", "start", 13)
    page.line(x + blank, table - high + 10, x + 108, table - high + 10, "dim", 0.8)
    page.text(x + 112, table - high - 11, "core radius: no tip comes closer", "limit", "start", 13)
    page.line(x + 11, table - high - 0.0, x + 108, table - high - 16, "limit", 0.8)
    page.text(x - 22, table - high - 26, "axis", "dim", "end", 13)
    page.text(x + 112, table - 30, "carved: layers", "ink", "start", 13)
    page.text(x + 112, table - 14, "from the lowest up", "ink", "start", 13)
    page.text(x + 112, table + 12, "table", "dim", "start", 13)


def main(words):
    page = Page(1060, 430, "The machine: a blank on a rotary table between two heads")
    from_above(page, 230, 205)
    from_the_side(page, 690, 330)
    page.write(words[0] if words else ROOT + "/docs/pictures/machine.svg")


if __name__ == "__main__":
    main(sys.argv[1:])
