# SPDX-License-Identifier: GPL-3.0-or-later
"""Curve and timing as one problem: the least time over all curves in the tube and all timings of them.

Unknowns: the coefficients of R1(psi) and R2(psi), and b = (dpsi/dt)^2 at the nodes, linear in between. In a cell R'' is
constant and R', b are linear, so R''*b + R'*b'/2 is linear: held at both ends, it is held everywhere. Every limit is
written as value <= 1, those of either sign as |value| <= 1.
"""

import dataclasses
import typing

import numpy as np
import scipy.sparse as sparse

from tube import tube_of


@dataclasses.dataclass
class Rule:
    """A family of limits: value <= 1 (or |value| <= 1)."""

    value: np.ndarray
    either_sign: bool
    head: int  # whose coefficients; -1: none
    derivatives: typing.Callable  # matrices: by that head's coefficients (None without a head), by b
    cross: tuple = ()  # pairs (P, Q): the value holds (P*c)*(Q*b), the part that is not convex


class JointProblem:
    def __init__(self, layer, grid, limits):
        self.grid, self.limits = grid, limits
        nodes = len(grid.node_rad)
        self.tubes = [tube_of(layer, head, grid, limits) for head in (0, 1)]
        self.tube_rows = grid.value(self.tubes[0].at_rad)
        self.node_rows = self.tube_rows[:nodes]
        self.first = sparse.eye(nodes - 1, nodes, 0).tocsr()
        self.second = sparse.eye(nodes - 1, nodes, 1).tocsr()
        self.half_rise = (sparse.diags(0.5 / grid.width_rad) @ (self.second - self.first)).tocsr()
        self.sizes = (grid.size, grid.size, nodes)
        # Neighbours in psi become neighbours in the matrix, which makes it a narrow band.
        place = [np.arange(grid.size) - 0.5, np.arange(grid.size) - 0.4, np.arange(nodes)]
        self.order = np.argsort(np.concatenate(place), kind="stable")
        self.band = 11

    def parts(self, x):
        """R1's coefficients, R2's, b."""
        return np.split(x, np.cumsum(self.sizes)[:2])

    def seconds(self, x):
        root = np.sqrt(self.parts(x)[2])
        return float(np.sum(2.0 * self.grid.width_rad / (root[1:] + root[:-1])))

    def seconds_slopes(self, x):
        """Gradient of `seconds` by b, and the three diagonals of its Hessian, which is positive."""
        h, root = self.grid.width_rad, np.sqrt(self.parts(x)[2])
        left, right = root[:-1], root[1:]
        total = left + right
        slope, curve = -2.0 * h / total**2, 4.0 * h / total**3
        gradient, diagonal = np.zeros_like(root), np.zeros_like(root)
        for part, end in ((slice(None, -1), left), (slice(1, None), right)):
            gradient[part] += slope / (2.0 * end)
            diagonal[part] += curve / (4.0 * end**2) - slope / (4.0 * end**3)
        beside = curve / (4.0 * left * right)
        return gradient, sparse.diags([beside, diagonal, beside], [-1, 0, 1])

    def rules(self, x):
        *curve, b = self.parts(x)
        found = self._table_rules(b)
        for head, coefficients in enumerate(curve):
            found += self._accel_rules(head, coefficients, b)
            found += self._speed_rules(head, coefficients, b)
            found.append(self._tube_rule(head, coefficients))
        return found

    def holds(self, curve):
        """Whether both heads stay strictly inside their tubes."""
        return all(np.abs(self._tube_rule(head, c).value).max() < 1.0 for head, c in enumerate(curve))

    def excess(self, x):
        """At each node the greatest value of the limits on motion there and in the cells beside it."""
        worst = np.zeros(self.sizes[2])
        for rule in self.rules(x):
            value = np.abs(rule.value)
            if len(value) == len(worst):
                worst = np.maximum(worst, value)
            elif len(value) == len(worst) - 1:
                worst[:-1] = np.maximum(worst[:-1], value)
                worst[1:] = np.maximum(worst[1:], value)
        return worst

    def _table_rules(self, b):
        psi = self.limits.psi
        cap = np.full(len(b), psi.speed**2)
        cap[[0, -1]] = min(psi.speed, psi.start_stop) ** 2
        return [
            Rule(self.half_rise @ b / psi.accel, True, -1, lambda: (None, self.half_rise / psi.accel)),
            Rule(b / cap, False, -1, lambda: (None, sparse.diags(1.0 / cap))),
        ]

    def _accel_rules(self, head, coefficients, b):
        accel = self.limits.heads[head].accel
        bend, slope, rise = self.grid.second @ coefficients, self.grid.node_slope @ coefficients, self.half_rise @ b
        found = []
        for end, part in ((self.first, slice(None, -1)), (self.second, slice(1, None))):

            def derivatives(end=end, part=part):
                by_bend = sparse.diags(b[part] / accel) @ self.grid.second
                by_slope = sparse.diags(rise / accel) @ self.grid.node_slope[part]
                by_b = sparse.diags(bend / accel) @ end + sparse.diags(slope[part] / accel) @ self.half_rise
                return by_bend + by_slope, by_b

            value = (bend * b[part] + slope[part] * rise) / accel
            cross = ((self.grid.second / accel, end), (self.grid.node_slope[part] / accel, self.half_rise))
            found.append(Rule(value, True, head, derivatives, cross))
        return found

    def _speed_rules(self, head, coefficients, b):
        axis = self.limits.heads[head]
        slope, r = self.grid.node_slope @ coefficients, self.node_rows @ coefficients
        top = np.full(len(b), axis.speed**2)
        top[[0, -1]] = min(axis.speed, axis.start_stop) ** 2
        feed = self.limits.feed_mm_s**2

        def by_slope(limit):
            return sparse.diags(2.0 * b * slope / limit) @ self.grid.node_slope

        def of_speed():
            return by_slope(top), sparse.diags(slope**2 / top)

        def of_feed():
            by_curve = by_slope(feed) + sparse.diags(2.0 * b * r / feed) @ self.node_rows
            return by_curve, sparse.diags((slope**2 + r**2) / feed)

        return [
            Rule(b * slope**2 / top, False, head, of_speed),
            Rule(b * (slope**2 + r**2) / feed, False, head, of_feed),
        ]

    def _tube_rule(self, head, coefficients):
        tube = self.tubes[head]
        half = 0.5 * (tube.high_mm - tube.low_mm)
        value = (self.tube_rows @ coefficients - 0.5 * (tube.high_mm + tube.low_mm)) / half
        none = sparse.csr_matrix((len(value), self.sizes[2]))
        return Rule(value, True, head, lambda: (sparse.diags(1.0 / half) @ self.tube_rows, none))
