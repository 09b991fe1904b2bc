# SPDX-License-Identifier: GPL-3.0-or-later
"""The curve of least bending in a tube: a quadratic programme, by a primal-dual interior point with banded matrices.

minimise  1/2 * integral of (R'')^2 dpsi   subject to   low <= A*c <= high       (Mehrotra's predictor and corrector)
"""

import numpy as np
import scipy.linalg
import scipy.sparse


class NoCurve(Exception):
    """No spline of this grid stays inside the tube."""


def least_bending(grid, tube):
    """Coefficients of the spline."""
    rows = grid.value(tube.at_rad)
    unit = float(np.median(grid.width_rad))
    cost = grid.second.T @ scipy.sparse.diags(grid.width_rad * unit**3) @ grid.second
    # The unknown is the offset from the tube's middle, in widths of the tube: numbers near one.
    scale = float(np.median(tube.high_mm - tube.low_mm))
    order = np.argsort(tube.at_rad)
    middle = 0.5 * (tube.low_mm + tube.high_mm)
    start = np.interp(grid.coefficient_rad(), tube.at_rad[order], middle[order])
    low, high = (tube.low_mm - rows @ start) / scale, (tube.high_mm - rows @ start) / scale
    return start + scale * _Programme(cost.tocsr(), cost @ start / scale, rows, low, high).solve()


class _Programme:
    """minimise 1/2 x'Hx + f'x with low <= Ax <= high; s: distance to each bound, z: its multiplier."""

    def __init__(self, cost, linear, rows, low, high):
        self.cost, self.linear, self.rows = cost, linear, rows
        self.bounds = np.concatenate([low, -high])
        self.both = scipy.sparse.vstack([rows, -rows]).tocsr()  # both*x >= bounds
        self.across = self.both.T.tocsr()
        self.room = np.tile(np.maximum(high - low, 1e-9), 2)

    def solve(self, rounds=100):
        x = np.zeros(self.cost.shape[0])
        s = np.maximum(self.both @ x - self.bounds, 0.1 * self.room)
        z = np.full_like(s, 1e-3)
        for _ in range(rounds):
            dual = self.cost @ x + self.linear - self.across @ z
            gap = self.both @ x - self.bounds - s
            nearness = s @ z / len(s)
            if np.abs(gap / self.room).max() < 1e-7 and nearness < 1e-13:
                break
            with np.errstate(over="ignore"):
                stiffness = z / s
            if not np.all(np.isfinite(stiffness)):
                raise NoCurve
            factor = banded_factor(self.cost + self.across @ scipy.sparse.diags(stiffness) @ self.both, 2)
            dx, ds, dz = self._step(factor, s, z, dual, gap, s * z)
            ahead = (s + _reach(s, ds) * ds) @ (z + _reach(z, dz) * dz) / len(s)
            centre = nearness * min(1.0, ahead / nearness) ** 3
            dx, ds, dz = self._step(factor, s, z, dual, gap, s * z + ds * dz - centre)
            primal, second = (min(1.0, 0.995 * _reach(*pair, most=2.0)) for pair in ((s, ds), (z, dz)))
            x, s, z = x + primal * dx, s + primal * ds, z + second * dz
        # Written so that a solution that is not a number is none.
        if not ((self.bounds - self.both @ x) / self.room).max() <= 1e-4:
            raise NoCurve
        return x

    def _step(self, factor, s, z, dual, gap, complement):
        right = -dual - self.across @ ((complement + z * gap) / s)
        dx = scipy.linalg.cho_solve_banded((factor, True), right, check_finite=False)
        ds = self.both @ dx + gap
        return dx, ds, -(complement + z * ds) / s


def banded_factor(matrix, width):
    """Cholesky factor of a symmetric matrix with `width` diagonals below its own."""
    bands = np.zeros((width + 1, matrix.shape[0]))
    for k in range(width + 1):
        bands[k, : matrix.shape[0] - k] = matrix.diagonal(-k)
    bands[0] *= 1.0 + 1e-12
    return scipy.linalg.cholesky_banded(bands, lower=True, check_finite=False)


def _reach(value, change, most=1.0):
    """Greatest step up to `most` that keeps every value positive."""
    falling = change < 0.0
    return min(most, float((-value[falling] / change[falling]).min(initial=np.inf)))
