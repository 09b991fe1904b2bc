# SPDX-License-Identifier: GPL-3.0-or-later
"""An owl on a tree stump that looks over its shoulder [mm]; it faces +x, its head a little to the left."""

from math import sqrt

from shapes.solids import (Figure, ball, cone, ellipsoid, girth, mirrored, pleats, ring, scales, smooth_step, turned,
                           waves)

HEAD_TURN = (12.0 / 13.0, 5.0 / 13.0)  # cosine and sine of 22.6 degrees


def owl():
    figure = Figure()
    _body(figure)
    _wings(figure)
    _head(figure)
    _stump(figure)
    _feet(figure)
    figure.cut(lambda x, y, z: z, 0.01)
    return figure


def _body(figure):
    figure.add(ellipsoid((-0.4, 0.0, 23.0), (8.8, 9.4, 15.0), up=(0.06, 0.0, 1.0)), 0.1)
    figure.add(ellipsoid((1.6, 0.0, 19.5), (7.6, 8.2, 10.5)), 2.0)
    breast = ellipsoid((9.0, 0.0, 21.5), (8.5, 7.6, 12.5))
    figure.emboss(breast, 0.95, lambda x, y, z: scales(y, z + 0.06 * y * y, 2.9, 2.5))
    back = ellipsoid((-9.0, 0.0, 26.0), (8.0, 8.5, 12.0))
    figure.emboss(back, 0.8, lambda x, y, z: scales(y, z, 3.1, 2.7))
    figure.add(ellipsoid((-8.4, 0.0, 11.0), (2.0, 4.8, 10.6), up=(0.28, 0.0, 1.0)), 1.5)
    figure.emboss(ellipsoid((-12.0, 0.0, 7.0), (6.5, 7.0, 10.0)), 0.8, lambda x, y, z: pleats(abs(y) - 0.8, 1.9))


def _wings(figure):
    figure.add(mirrored(ellipsoid((-1.6, 8.3, 21.5), (6.8, 2.9, 13.6), up=(0.24, -0.05, 1.0))), 0.5)
    figure.add(mirrored(ball((1.4, 7.8, 30.2), 3.3)), 2.0)
    figure.emboss(mirrored(ellipsoid((-1.6, 13.0, 21.0), (9.0, 8.0, 15.0), up=(0.24, 0.0, 1.0))), 0.9, _wing_feathers)


def _wing_feathers(x, y, z):
    """Short feathers in rows above, long ones side by side below."""
    slanted = x - 0.24 * z
    lower_end = 19.0 + 0.25 * x
    short = smooth_step((z - lower_end) / 0.8)
    return short * scales(slanted, z - 0.25 * x, 2.7, 2.2) + (1.0 - short) * 0.8 * pleats(slanted, 2.1)


def _head(figure):
    def add(solid, blend_mm):
        figure.add(turned(solid, *HEAD_TURN), blend_mm)

    def cut(solid, blend_mm):
        figure.cut(turned(solid, *HEAD_TURN), blend_mm)

    def emboss(region, depth_mm, pattern):
        figure.emboss(turned(region, *HEAD_TURN), depth_mm, turned(pattern, *HEAD_TURN))

    disc, facing = (8.5, 4.1, 40.0), (0.90, 0.40, 0.06)
    add(ellipsoid((0.6, 0.0, 39.6), (8.4, 9.5, 7.6)), 2.5)
    emboss(ellipsoid((-4.6, 0.0, 41.0), (9.6, 12.5, 9.0)), 0.75,
           lambda x, y, z: scales(girth(x, y, 9.0), z, 2.75, 2.0))
    add(mirrored(cone((2.4, 5.0, 44.2), 2.7, (2.0, 8.0, 52.0), 0.6)), 1.6)
    cut(mirrored(ball((11.2, 4.9, 40.2), 4.9)), 0.5)
    emboss(mirrored(ball(disc, 4.4)), 0.35, lambda x, y, z: waves(12, abs(y) - disc[1], z - disc[2]))
    add(mirrored(ring((8.0, 4.15, 40.0), facing, 4.35, 0.7)), 0.5)
    add(mirrored(ball((6.9, 3.8, 40.2), 2.6)), 0.3)
    cut(mirrored(ball((9.9, 4.5, 40.4), 1.3)), 0.7)
    add(mirrored(cone((9.6, 0.7, 41.6), 1.0, (6.4, 5.2, 45.2), 1.25)), 0.6)
    add(mirrored(cone((6.4, 5.2, 45.2), 1.25, (2.9, 7.7, 50.4), 0.7)), 1.2)
    add(cone((8.9, 0.0, 40.6), 1.35, (10.9, 0.0, 38.6), 1.15), 0.5)
    add(cone((10.9, 0.0, 38.6), 1.15, (10.6, 0.0, 35.6), 0.4), 0.4)


def _stump(figure):
    figure.add(_bark, 0.6)


def _feet(figure):
    figure.add(mirrored(ellipsoid((5.6, 4.0, 11.3), (3.0, 2.7, 3.4))), 1.2)
    for end_y, reach in ((1.7, 11.9), (4.2, 12.6), (6.6, 11.3)):
        toe, claw = (reach, end_y, 9.2), (reach + 1.6, end_y * 1.06, 6.4)
        figure.add(mirrored(cone((6.8, 4.1, 9.9), 1.4, toe, 1.05)), 0.4)
        figure.add(mirrored(cone(toe, 0.95, claw, 0.3)), 0.3)


def _bark(x, y, z):
    """A stump 9 mm high that spreads into roots; its bark winds a little to the right."""
    turn = 0.028 * z
    scale = 1.0 / (1.0 + turn * turn)
    c, s = (1.0 - turn * turn) * scale, 2.0 * turn * scale
    u, v = c * x + s * y, c * y - s * x
    spread = 1.0 - z / 9.0
    spread = 0.0 if spread < 0.0 else 1.0 if spread > 1.0 else spread
    radius = 10.6 + 2.6 * spread * spread + (0.25 + 1.1 * spread * spread) * waves(5, u, v)
    radius += 0.42 * waves(17, u, v) + 0.22 * waves(29, v, u)
    side = (sqrt(x * x + y * y) - radius) * 0.75
    height = abs(z - 4.5) - 4.5
    inner = min(max(side + 0.8, height + 0.8), 0.0)
    a, b = max(side + 0.8, 0.0), max(height + 0.8, 0.0)
    return inner + sqrt(a * a + b * b) - 0.8
