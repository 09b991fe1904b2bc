# SPDX-License-Identifier: GPL-3.0-or-later
"""A closed triangle mesh of a figure's surface: in each grid cell one vertex for each sheet of the surface.

Sheets are told apart by joining the crossed edges of the cell's faces: two on a face belong together; of four,
those that share a corner inside the figure. Neighbours decide alike about the face between them, so thin gaps
and thin walls leave no edge with more than two triangles.
"""

from math import sqrt

from shapes.solids import distance_to, near

CORNERS = [(i, j, k) for i in (0, 1) for j in (0, 1) for k in (0, 1)]
EDGES = [(a, b) for a in range(8) for b in range(a + 1, 8)
         if sum(abs(p - q) for p, q in zip(CORNERS[a], CORNERS[b])) == 1]
EDGE_NUMBER = {(CORNERS[a], n): number for number, (a, b) in enumerate(EDGES)
               for n in range(3) if CORNERS[a][n] != CORNERS[b][n]}
FACES = [[number for number, (a, b) in enumerate(EDGES) if CORNERS[a][n] == CORNERS[b][n] == side]
         for n in range(3) for side in (0, 1)]
AROUND = ((0, 0), (-1, 0), (-1, -1), (0, -1))


def surface_net(figure, low, cell_mm, levels):
    """Triangles (three points each, counter-clockwise from outside) of the figure inside the cube that starts at
    `low` and is 2^levels cells wide."""
    grid = _Grid(low, cell_mm)
    _visit(grid, figure.steps, (0, 0, 0), 1 << levels)
    grid.close(figure.steps)
    return grid.triangles()


def _visit(grid, steps, base, size):
    """Halves the cube until it is one cell, and leaves out what the surface cannot reach."""
    half = 0.5 * size
    x, y, z = (grid.low[n] + (base[n] + half) * grid.cell_mm for n in range(3))
    reach_mm = half * grid.cell_mm * 1.7320508
    steps = near(steps, x, y, z, reach_mm)
    if not steps or abs(distance_to(steps, x, y, z)) > 1.6 * reach_mm + 0.6:
        return
    if size == 1:
        grid.visit_cell(steps, base)
        return
    step = size // 2
    for corner in CORNERS:
        _visit(grid, steps, tuple(b + step * c for b, c in zip(base, corner)), step)


class _Grid:
    def __init__(self, low, cell_mm):
        self.low = low
        self.cell_mm = cell_mm
        self.distances = {}
        self.points = []
        self.points_of_cell = {}  # cell -> number of a crossed edge -> number of its point

    def distance_at(self, steps, node):
        d = self.distances.get(node)
        if d is None:
            x, y, z = (low + n * self.cell_mm for low, n in zip(self.low, node))
            d = self.distances[node] = distance_to(steps, x, y, z)
        return d

    def visit_cell(self, steps, base):
        values = [self.distance_at(steps, (base[0] + i, base[1] + j, base[2] + k)) for i, j, k in CORNERS]
        crossings = {}
        for number, (a, b) in enumerate(EDGES):
            if (values[a] < 0.0) != (values[b] < 0.0):
                t = values[a] / (values[a] - values[b])
                crossings[number] = [p + t * (q - p) for p, q in zip(CORNERS[a], CORNERS[b])]
        points = self.points_of_cell[base] = {}
        for sheet in _sheets(values, crossings):
            total = [0.0, 0.0, 0.0]
            for edge in sheet:
                total = [t + c for t, c in zip(total, crossings[edge])]
            point = [low + (b + t / len(sheet)) * self.cell_mm for low, b, t in zip(self.low, base, total)]
            for edge in sheet:
                points[edge] = len(self.points)
            self.points.append(_settled(steps, point, 0.5 * self.cell_mm))

    def close(self, steps):
        """Visits the few cells that the halving missed: where relief has steps, distances promise too much."""
        seen = 0
        while seen < len(self.distances):
            seen = len(self.distances)
            for around, _ in list(self._crossed_edges()):
                for cell, _ in around:
                    if cell not in self.points_of_cell:
                        self.visit_cell(steps, cell)

    def triangles(self):
        """Each grid edge that the surface crosses joins the points of its four cells."""
        for around, outwards in self._crossed_edges():
            corners = [self.points[self.points_of_cell[cell][edge]] for cell, edge in around]
            yield from _split(corners if outwards else corners[::-1])

    def _crossed_edges(self):
        """Each grid edge with one end inside: its four cells and its number in each, and whether the lower end is it."""
        for node in sorted(self.distances):
            inside = self.distances[node] < 0.0
            for axis in range(3):
                other = tuple(n + (k == axis) for k, n in enumerate(node))
                if other in self.distances and (self.distances[other] < 0.0) != inside:
                    yield [_beside(node, axis, first, second) for first, second in AROUND], inside


def _beside(node, axis, first, second):
    cell = list(node)
    cell[(axis + 1) % 3] += first
    cell[(axis + 2) % 3] += second
    corner = tuple(n - c for n, c in zip(node, cell))
    return tuple(cell), EDGE_NUMBER[corner, axis]


def _sheets(values, crossings):
    """The crossed edges of a cell, grouped by the sheet of the surface that crosses them."""
    group = {edge: {edge} for edge in crossings}

    def join(first, second):
        merged = group[first] | group[second]
        for edge in merged:
            group[edge] = merged

    for face in FACES:
        crossed = [edge for edge in face if edge in crossings]
        for first in crossed:
            for second in crossed:
                shared = set(EDGES[first]) & set(EDGES[second])
                if first < second and (len(crossed) == 2 or any(values[corner] < 0.0 for corner in shared)):
                    join(first, second)
    return [sorted(sheet) for sheet in {min(sheet): sheet for sheet in group.values()}.values()]


def _settled(steps, point, limit):
    """The point moved onto the surface, along the slope, by at most `limit` on each axis."""
    x, y, z = point
    h = 0.02
    for _ in range(2):
        d = distance_to(steps, x, y, z)
        gx = (distance_to(steps, x + h, y, z) - d) / h
        gy = (distance_to(steps, x, y + h, z) - d) / h
        gz = (distance_to(steps, x, y, z + h) - d) / h
        length = gx * gx + gy * gy + gz * gz
        if length < 0.25:
            break
        x, y, z = (p - d * g / length for p, g in zip((x, y, z), (gx, gy, gz)))
    return tuple(p + max(-limit, min(limit, q - p)) for p, q in zip(point, (x, y, z)))


def _split(quad):
    """Two triangles, along the shorter diagonal."""
    a, b, c, d = quad
    if _distance(a, c) <= _distance(b, d):
        return (a, b, c), (a, c, d)
    return (a, b, d), (b, c, d)


def _distance(p, q):
    x, y, z = (a - b for a, b in zip(p, q))
    return sqrt(x * x + y * y + z * z)
