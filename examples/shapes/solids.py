# SPDX-License-Identifier: GPL-3.0-or-later
"""Solids as signed distances [mm], and a figure put together from them.

A solid is a function (x, y, z) -> distance: negative inside, positive outside, never much steeper than 1.
Only + - * / and the square root are used: these round alike on every machine, so a figure is made the same
to the last bit everywhere (sines need not be, nor Python's sum, which newer versions round otherwise).
"""

from math import floor, sqrt

FAR = 1e9
WIDEST_BLEND_MM = 2.5
DEEPEST_RELIEF_MM = 0.95


def ellipsoid(centre, radii, up=(0.0, 0.0, 1.0), side=(0.0, 1.0, 0.0)):
    """Ellipsoid whose third axis points `up` and whose second one points towards `side`."""
    cx, cy, cz = centre
    third = _unit(up)
    along = _dot(side, third)
    second = _unit(tuple(a - along * b for a, b in zip(side, third)))
    first = _cross(second, third)
    (ux, uy, uz), (vx, vy, vz), (wx, wy, wz) = first, second, third
    a, b, c = (1.0 / radius for radius in radii)
    least = -min(radii)

    def distance(x, y, z):
        x -= cx
        y -= cy
        z -= cz
        p = (ux * x + uy * y + uz * z) * a
        q = (vx * x + vy * y + vz * z) * b
        r = (wx * x + wy * y + wz * z) * c
        scale = sqrt(p * p + q * q + r * r)
        slope = sqrt(p * p * a * a + q * q * b * b + r * r * c * c)
        return least if slope == 0.0 else scale * (scale - 1.0) / slope

    return distance


def ball(centre, radius):
    cx, cy, cz = centre

    def distance(x, y, z):
        x -= cx
        y -= cy
        z -= cz
        return sqrt(x * x + y * y + z * z) - radius

    return distance


def cone(start, start_radius, end, end_radius):
    """A rod from one point to another whose radius changes evenly; both ends are round."""
    ax, ay, az = start
    dx, dy, dz = (e - s for s, e in zip(start, end))
    inverse = 1.0 / (dx * dx + dy * dy + dz * dz)
    growth = end_radius - start_radius

    def distance(x, y, z):
        x -= ax
        y -= ay
        z -= az
        t = (x * dx + y * dy + z * dz) * inverse
        t = 0.0 if t < 0.0 else 1.0 if t > 1.0 else t
        x -= t * dx
        y -= t * dy
        z -= t * dz
        return sqrt(x * x + y * y + z * z) - start_radius - t * growth

    return distance


def ring(centre, axis, major_radius, minor_radius):
    cx, cy, cz = centre
    nx, ny, nz = _unit(axis)

    def distance(x, y, z):
        x -= cx
        y -= cy
        z -= cz
        along = x * nx + y * ny + z * nz
        across = sqrt(max(x * x + y * y + z * z - along * along, 0.0)) - major_radius
        return sqrt(along * along + across * across) - minor_radius

    return distance


def mirrored(solid):
    """The solid and its mirror image in the plane y = 0; it must lie at y > 0 itself."""
    return lambda x, y, z: solid(x, -y if y < 0.0 else y, z)


def turned(solid, cosine, sine):
    """The solid turned counter-clockwise about the z axis."""
    return lambda x, y, z: solid(cosine * x + sine * y, cosine * y - sine * x, z)


def waves(count, x, y):
    """cos(count * angle of (x, y)), by Chebyshev's recurrence."""
    radius = sqrt(x * x + y * y)
    if radius == 0.0:
        return 1.0
    double = 2.0 * x / radius
    before, now = 1.0, 0.5 * double
    for _ in range(count - 1):
        before, now = now, double * now - before
    return now


def scales(across, along, width, height):
    """Overlapping feathers in staggered rows, tips towards smaller `along`; 0 at a root, 1 at a tip."""
    row = floor(along / height)
    depth = 0.0
    # From the lowest row that shows here to the highest: each covers the one below as far as its round tips reach.
    for upper in (row, row + 1):
        shifted = across / width + (0.5 if upper % 2 else 0.0)
        off = 2.0 * (shifted - floor(shifted)) - 1.0
        above = (along - height * (upper - 0.55 * (1.0 - off * off))) / height
        depth += smooth_step(above / 0.26) * (1.0 - 0.6 * above - 0.15 * off * off - depth)
    return depth


def pleats(across, width):
    """Long feathers side by side: each rises slowly and falls off fast."""
    t = across / width
    t -= floor(t)
    return smooth_step(t / 0.75) if t < 0.75 else smooth_step((1.0 - t) / 0.25)


def smooth_step(t):
    t = 0.0 if t < 0.0 else 1.0 if t > 1.0 else t
    return t * t * (3.0 - 2.0 * t)


def girth(x, y, radius):
    """Length round a body of that radius from its back (-x) to (x, y), positive towards +y; near enough for feathers."""
    t = y / (abs(x) + abs(y) + 1e-9)
    return 1.5707963 * radius * (t if x < 0.0 else 2.0 - t if y > 0.0 else -2.0 - t)


class Figure:
    """Solids joined, cut and given relief in the order in which they are named."""

    def __init__(self):
        self.steps = []

    def add(self, solid, blend_mm):
        self.steps.append(("add", solid, blend_mm, None))

    def cut(self, solid, blend_mm):
        self.steps.append(("cut", solid, blend_mm, None))

    def emboss(self, region, depth_mm, pattern):
        """Raises what stands so far, inside `region`, by depth times pattern(x, y, z); fades out at its edge."""
        self.steps.append(("emboss", region, depth_mm, pattern))


def near(steps, x, y, z, reach_mm):
    """The steps that can matter within reach of a point at which the figure's surface may be."""
    margin_mm = 1.6 * reach_mm + WIDEST_BLEND_MM + DEEPEST_RELIEF_MM
    return [step for step in steps if step[1](x, y, z) < margin_mm]


def distance_to(steps, x, y, z):
    """Signed distance to the figure that the steps make."""
    d = FAR
    for kind, solid, amount, pattern in steps:
        s = solid(x, y, z)
        if kind == "add":
            gap = amount - abs(d - s)
            d = min(d, s)
            if gap > 0.0:
                d -= gap * gap / (4.0 * amount)
        elif kind == "cut":
            gap = amount - abs(d + s)
            d = max(d, -s)
            if gap > 0.0:
                d += gap * gap / (4.0 * amount)
        elif s < 0.0 and abs(d) < 3.0:
            d -= amount * min(-s, 1.0) * pattern(x, y, z)
    return d


def _unit(v):
    length = sqrt(_dot(v, v))
    return tuple(a / length for a in v)


def _dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def _cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])
