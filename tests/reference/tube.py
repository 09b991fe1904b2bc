# SPDX-License-Identifier: GPL-3.0-or-later
"""Where a head's curve R(psi) may run, and how fine a grid has to be to follow it.

At a point of the table: within half a pulse of it. Between two points: within path_tolerance_mm of their chord, square to
the chord in the head's plane (r*dpsi, R), r being the larger radius of the two. At a given psi that is a band of
tolerance*sqrt(1 + slope^2). Nowhere below the core radius or beyond the travel.
"""

import dataclasses

import numpy as np


@dataclasses.dataclass(frozen=True)
class Tube:
    at_rad: np.ndarray  # where it is asked for: the cells' ends, then their middles
    low_mm: np.ndarray
    high_mm: np.ndarray

    def narrowed(self, share):
        """The same middle, `share` of the width."""
        middle, half = 0.5 * (self.low_mm + self.high_mm), 0.5 * share * (self.high_mm - self.low_mm)
        return Tube(self.at_rad, middle - half, middle + half)


def chords(layer, head, limits):
    """dR/dpsi of each chord, and the half width of its band."""
    psi, r = layer.psi_rad, layer.r_mm[head]
    rise = np.diff(r) / np.diff(psi)
    slope = rise / np.maximum(r[1:], r[:-1])
    return rise, limits.path_tolerance_mm * np.sqrt(1.0 + slope**2)


def tube_of(layer, head, grid, limits):
    """One head's band at the ends and in the middle of the grid's cells."""
    psi, r = layer.psi_rad, layer.r_mm[head]
    rise, band = chords(layer, head, limits)
    node = grid.node_rad
    at = np.concatenate([node, 0.5 * (node[1:] + node[:-1])])
    interval = np.concatenate([np.append(grid.cell_interval, len(rise) - 1), grid.cell_interval])
    middle = r[interval] + rise[interval] * (at - psi[interval])
    half = band[interval]
    half[grid.point_node] = 0.5 * limits.heads[head].pulse
    # A point may lie on the bound itself: the tube never ends before its own chord.
    low = np.maximum(middle - half, np.minimum(limits.core_radius_mm, middle))
    high = np.minimum(middle + half, np.maximum(limits.travel_mm[head], middle))
    return Tube(at, low, high)


def cells_for(layer, limits):
    """Cells of each interval to begin with: 4, more where a sharp bend has to fit into a narrow band.

    A bend by g (in dR/dpsi) inside a band w takes a length of about w/g.
    """
    width = np.diff(layer.psi_rad)
    needed = np.full(len(width), 4.0)
    for head in (0, 1):
        rise, band = chords(layer, head, limits)
        sharpness = np.abs(np.diff(rise)) / np.minimum(band[1:], band[:-1])
        needed[:-1] = np.maximum(needed[:-1], sharpness * width[:-1])
        needed[1:] = np.maximum(needed[1:], sharpness * width[1:])
    return np.ceil(np.minimum(needed, 64.0)).astype(int)
