# SPDX-License-Identifier: GPL-3.0-or-later
"""Curve and timing as one problem: the least time over all curves in the tube and all timings of them.

Unknowns: the coefficients of R1(psi) and R2(psi), and b = (dpsi/dt)^2 at the nodes, linear in between. In a cell R'' is
constant and R', b are linear, so R''*b + R'*b'/2 is linear: held at both ends, it is held everywhere. Every limit is
written as value <= 1, those of either sign as |value| <= 1.

The unknowns stand in one vector, neighbours in psi beside each other: R1's coefficient i at 3i, R2's at 3i + 1, b of
node i at 3i + 2. Node i sees the coefficients i and i + 1, cell i (between the nodes i and i + 1) those and i + 2.
"""

import dataclasses

import numpy as np

from outside import nodes_at_the_feed
from tube import tube_of

BAND = 6  # unknowns further apart never meet in a limit
B_HERE, B_NEXT = 2, 5  # places of b beside coefficient i


@dataclasses.dataclass
class Rule:
    """A family of limits, one for each node or cell i: value <= 1, or |value| <= 1.

    slopes: derivative by the unknown at 3i + place, for each place. products: (place, place, factor) of what is a
    product of two unknowns and so not convex.
    """

    value: np.ndarray
    either_sign: bool
    slopes: dict
    products: tuple = ()


class JointProblem:
    def __init__(self, layer, grid, limits):
        self.grid, self.limits = grid, limits
        self.nodes = len(grid.node_rad)
        self.tubes = [tube_of(layer, head, grid, limits) for head in (0, 1)]
        self._is_fed = [nodes_at_the_feed(grid, head) for head in layer.is_outside]
        rows = grid.value(self.tubes[0].at_rad)
        self._node_value, self._middle_value = _window(rows[: self.nodes], 2), _window(rows[self.nodes :], 3)
        self._node_slope, self._cell_bend = _window(grid.node_slope, 2), _window(grid.second, 3)
        self._half_rise = 0.5 / grid.width_rad

    def packed(self, curve, b):
        x = np.empty(3 * self.nodes + 2)
        x[0::3], x[1::3], x[2::3] = *curve, b
        return x

    def parts(self, x):
        """R1's coefficients, R2's, b."""
        return [x[0::3], x[1::3], x[2::3]]

    def seconds(self, x):
        root = np.sqrt(x[2::3])
        return float(np.sum(2.0 * self.grid.width_rad / (root[1:] + root[:-1])))

    def seconds_slopes(self, x):
        """Gradient of `seconds` by b, and its Hessian, which is positive: the diagonal and the one beside it."""
        h, root = self.grid.width_rad, np.sqrt(x[2::3])
        total = root[:-1] + root[1:]
        slope, curve = -2.0 * h / total**2, 4.0 * h / total**3
        gradient, diagonal = np.zeros_like(root), np.zeros_like(root)
        for part in (slice(None, -1), slice(1, None)):
            end = root[part]
            gradient[part] += slope / (2.0 * end)
            diagonal[part] += curve / (4.0 * end**2) - slope / (4.0 * end**3)
        return gradient, diagonal, curve / (4.0 * root[:-1] * root[1:])

    def rules(self, x):
        *curve, b = self.parts(x)
        found = self._table_rules(b)
        for head, coefficients in enumerate(curve):
            r = _along(self._node_value, coefficients)
            slope = _along(self._node_slope, coefficients)
            found += self._accel_rules(head, _along(self._cell_bend, coefficients), slope, b)
            found += self._speed_rules(head, r, slope, b)
            found += self._tube_rules(head, coefficients, r)
        return found

    def holds(self, curve):
        """Whether both heads stay strictly inside their tubes."""
        for head, coefficients in enumerate(curve):
            for rule in self._tube_rules(head, coefficients, _along(self._node_value, coefficients)):
                if np.abs(rule.value).max() >= 1.0:
                    return False
        return True

    def excess(self, x):
        """At each node the greatest value of the limits on motion there and in the cells beside it."""
        worst = np.zeros(self.nodes)
        for rule in self.rules(x):
            if B_HERE not in rule.slopes:
                continue  # the tube's
            value = np.abs(rule.value)
            worst[: len(value)] = np.maximum(worst[: len(value)], value)
            if len(value) < self.nodes:
                worst[1:] = np.maximum(worst[1:], value)
        return worst

    def _table_rules(self, b):
        psi = self.limits.psi
        cap = np.full(len(b), psi.speed**2)
        cap[[0, -1]] = min(psi.speed, psi.start_stop) ** 2
        per_accel = self._half_rise / psi.accel
        return [
            Rule((b[1:] - b[:-1]) * per_accel, True, {B_HERE: -per_accel, B_NEXT: per_accel}),
            Rule(b / cap, False, {B_HERE: 1.0 / cap}),
        ]

    def _accel_rules(self, head, bend, slope, b):
        accel, half = self.limits.heads[head].accel, self._half_rise
        rise = (b[1:] - b[:-1]) * half
        found = []
        for end in (0, 1):
            part, b_there = (slice(None, -1), B_HERE) if end == 0 else (slice(1, None), B_NEXT)
            slopes = {B_HERE: -slope[part] * half / accel, B_NEXT: slope[part] * half / accel}
            slopes[b_there] = slopes[b_there] + bend / accel
            products = []
            for at in range(3):
                by_bend = self._cell_bend[at] / accel
                beside = at - end  # of the two coefficients that the slope at this end sees
                by_slope = self._node_slope[beside][part] / accel if beside in (0, 1) else 0.0
                place = 3 * at + head
                slopes[place] = by_bend * b[part] + by_slope * rise
                products.append((place, b_there, by_bend))
                products += [(place, B_HERE, -by_slope * half), (place, B_NEXT, by_slope * half)]
            found.append(Rule((bend * b[part] + slope[part] * rise) / accel, True, slopes, tuple(products)))
        return found

    def _speed_rules(self, head, r, slope, b):
        axis = self.limits.heads[head]
        feed = np.where(self._is_fed[head], self.limits.feed_mm_s**2, np.inf)
        top = np.full(len(b), axis.speed**2)
        top[[0, -1]] = min(axis.speed, axis.start_stop) ** 2
        of_speed, of_feed = {B_HERE: slope**2 / top}, {B_HERE: (slope**2 + r**2) / feed}
        for at in (0, 1):
            by_slope = 2.0 * b * slope * self._node_slope[at]
            of_speed[3 * at + head] = by_slope / top
            of_feed[3 * at + head] = (by_slope + 2.0 * b * r * self._node_value[at]) / feed
        return [Rule(b * slope**2 / top, False, of_speed), Rule(b * (slope**2 + r**2) / feed, False, of_feed)]

    def _tube_rules(self, head, coefficients, r):
        tube, found = self.tubes[head], []
        middle, half = 0.5 * (tube.high_mm + tube.low_mm), 0.5 * (tube.high_mm - tube.low_mm)
        nodes, between = slice(None, self.nodes), slice(self.nodes, None)
        for part, window, value in (
            (nodes, self._node_value, r),
            (between, self._middle_value, _along(self._middle_value, coefficients)),
        ):
            slopes = {3 * at + head: column / half[part] for at, column in enumerate(window)}
            found.append(Rule((value - middle[part]) / half[part], True, slopes))
        return found


def _window(rows, width):
    """Columns i, i + 1, ... of row i, for all rows: all that these rows hold."""
    return [rows.diagonal(at) for at in range(width)]


def _along(window, coefficients):
    """What the rows give for these coefficients."""
    return sum(column * coefficients[at : at + len(column)] for at, column in enumerate(window))
