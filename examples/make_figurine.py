#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the example models, the same to the last byte on every machine.

usage: make_figurine.py [--small | --letter] OUT.stl

Without an option: figurine.stl, an owl on a stump with deep relief and undercuts (about 52 mm high).
--small:  small.stl, a chick of a few hundred triangles, 12 mm across, for tests.
--letter: letter.stl, the letter F raised on one face of a plate: its mirror image is another body.
"""

import struct
import sys

sys.dont_write_bytecode = True  # leaves nothing beside the sources

from shapes.owl import owl
from shapes.solids import Figure, ball, cone, ellipsoid
from shapes.surface_net import surface_net


def figurine():
    return surface_net(owl(), low=(-20.67, -20.5, -2.03), cell_mm=0.4, levels=8)


def chick():
    """Round, with a beak to +x, a lifted wing at +y and a tail: no two sides of it are alike."""
    figure = Figure()
    figure.add(ellipsoid((0.0, 0.0, 4.5), (4.2, 3.8, 4.5)), 0.1)
    figure.add(ball((1.2, 0.0, 10.2), 2.9), 1.0)
    figure.add(cone((3.6, 0.0, 10.2), 1.2, (6.6, 0.0, 9.6), 0.5), 0.4)
    figure.add(ellipsoid((-0.5, 4.6, 5.6), (2.4, 1.2, 2.8), up=(0.0, 0.5, 1.0)), 0.6)
    figure.add(cone((-3.0, 0.0, 4.5), 1.6, (-5.6, -0.8, 6.8), 0.8), 0.6)
    return surface_net(figure, low=(-10.43, -10.45, -1.72), cell_mm=1.3, levels=4)


def letter():
    """Boxes of a grid: the plate (x < 3) and before it the strokes of an F that reads rightly from +x."""
    xs, ys, zs = (-3, 3, 5), (-7, -5, -2, 2, 5, 7), (0, 2, 9, 12, 15, 18, 20)
    strokes = {(1, k) for k in range(1, 5)} | {(2, 2), (2, 4), (3, 4)}
    solid = {(0, j, k) for j in range(len(ys) - 1) for k in range(len(zs) - 1)}
    solid |= {(1, j, k) for j, k in strokes}
    for box in sorted(solid):
        for axis in range(3):
            for end in (0, 1):
                neighbour = tuple(n + (2 * end - 1) * (m == axis) for m, n in enumerate(box))
                if neighbour not in solid:
                    yield from _face((xs, ys, zs), box, axis, end)


def _face(cuts, box, axis, end):
    """The two triangles of a box's face, counter-clockwise from outside."""
    corners = []
    for first, second in ((0, 0), (1, 0), (1, 1), (0, 1)):
        corner = list(box)
        corner[axis] += end
        corner[(axis + 1) % 3] += first
        corner[(axis + 2) % 3] += second
        corners.append(tuple(float(cut[n]) for cut, n in zip(cuts, corner)))
    a, b, c, d = corners if end else corners[::-1]
    return (a, b, c), (a, c, d)


def write_stl(path, triangles, text):
    """Binary STL. The normals are left at zero: readers take them from the order of the corners."""
    body = [struct.pack("<12fH", 0.0, 0.0, 0.0, *a, *b, *c, 0) for a, b, c in triangles]
    with open(path, "wb") as file:
        file.write(text.encode("ascii").ljust(80) + struct.pack("<I", len(body)) + b"".join(body))
    return len(body)


MODELS = {
    "": (figurine, "Psicarve example: an owl on a stump. Made by make_figurine.py [mm]"),
    "--small": (chick, "Psicarve example: a chick. Made by make_figurine.py --small [mm]"),
    "--letter": (letter, "Psicarve example: the letter F. Made by make_figurine.py --letter [mm]"),
}


def main(arguments):
    if arguments in (["-h"], ["--help"]):
        print(__doc__.strip())
        return 0
    option = arguments[0] if len(arguments) == 2 else ""
    if len(arguments) not in (1, 2) or option not in MODELS or arguments[-1].startswith("-"):
        print(__doc__.strip(), file=sys.stderr)
        return 2
    make, text = MODELS[option]
    count = write_stl(arguments[-1], make(), text)
    print(f"{arguments[-1]}: {count} triangles")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
