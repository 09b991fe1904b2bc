# SPDX-License-Identifier: GPL-3.0-or-later
"""Quadratic splines R(psi) over a layer: continuous slope, constant second derivative in each cell.

Everything that timing asks of a curve is linear in the spline's coefficients, so a curve is a vector, and what is
asked of it are sparse matrices made once for a grid.
"""

import numpy as np
import scipy.interpolate
import scipy.sparse


class SplineGrid:
    """Interval i of the table (between its points i and i+1) is cut into cells_per_interval[i] equal cells."""

    def __init__(self, psi_rad, cells_per_interval):
        cuts = [
            np.linspace(start, end, cells, endpoint=False)
            for start, end, cells in zip(psi_rad[:-1], psi_rad[1:], cells_per_interval)
        ]
        self.node_rad = np.append(np.concatenate(cuts), psi_rad[-1])
        self.width_rad = np.diff(self.node_rad)
        self.point_node = np.concatenate([[0], np.cumsum(cells_per_interval)])
        self.cell_interval = np.repeat(np.arange(len(cells_per_interval)), cells_per_interval)
        ends = self.node_rad[[0, -1]]
        self._knots = np.concatenate([ends[[0, 0]], self.node_rad, ends[[1, 1]]])
        self.size = len(self._knots) - 3
        # The slope is a linear spline: its coefficients are its values at the nodes.
        self.node_slope = (
            scipy.sparse.diags(2.0 / (self._knots[3:-1] - self._knots[1:-3])) @ differences(self.size)
        ).tocsr()
        self.second = (
            scipy.sparse.diags(1.0 / self.width_rad) @ differences(self.size - 1) @ self.node_slope
        ).tocsr()

    def value(self, at_rad):
        """Matrix that gives R at these angles."""
        return scipy.interpolate.BSpline.design_matrix(at_rad, self._knots, 2).tocsr()

    def slope(self, at_rad):
        """Matrix that gives dR/dpsi at these angles."""
        linear = scipy.interpolate.BSpline.design_matrix(at_rad, self._knots[1:-1], 1)
        return linear.tocsr() @ self.node_slope

    def halved(self):
        """The same grid with every cell cut in two."""
        return SplineGrid(self.node_rad[self.point_node], 2 * np.diff(self.point_node))

    def coefficients_on(self, finer, coefficients):
        """The same curve on a grid that holds all of this one's nodes: F(t, u) = R(t) + R'(t)*(u - t)/2."""
        left, right = finer._knots[1:-2], finer._knots[2:-1]
        return self.value(left) @ coefficients + 0.5 * (right - left) * (self.slope(left) @ coefficients)

    def coefficient_rad(self):
        """Where each coefficient has its say: the coefficients of a straight line are its values there."""
        return 0.5 * (self._knots[1:-2] + self._knots[2:-1])


def differences(size):
    """Next minus this: size - 1 rows."""
    ones = np.ones(size - 1)
    return scipy.sparse.diags([-ones, ones], [0, 1], shape=(size - 1, size)).tocsr()
