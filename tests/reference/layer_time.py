# SPDX-License-Identifier: GPL-3.0-or-later
"""The least time of one layer: curve and timing on ever finer grids until halving the cells changes little."""

import dataclasses

import numpy as np

from barrier_method import fastest_inside, is_inside
from joint_problem import JointProblem
from least_bending import NoCurve, least_bending
from outside import NOWHERE
from path_timing import fastest_timing, sample_curve, seconds
from spline_curve import SplineGrid
from tube import cells_for, tube_of


@dataclasses.dataclass
class LayerTime:
    layer: int
    points: int
    seconds: float  # the least found
    bending_seconds: float  # along the curve of least bending
    change: float  # of either at the last halving, the larger share
    cells: int


def least_layer_time(layer, limits, converged=0.003, halvings=4, bending_only=False):
    grid, last, coarser = SplineGrid(layer.psi_rad, cells_for(layer, limits)), None, None
    for _ in range(halvings + 1):
        try:
            bent = bending_curve(layer, grid, limits)
        except NoCurve:
            grid = grid.halved()
            continue
        bending = time_along(grid, bent, limits, layer.is_outside)
        best = bending
        if not bending_only:
            coarser = solve_jointly(layer, grid, limits, bent, coarser)
            best = min(best, time_along(grid, coarser.curve, limits, layer.is_outside))
        now = LayerTime(layer.number, len(layer.psi_rad), best, bending, np.inf, len(grid.width_rad))
        if last is not None:
            now.change = max(abs(last.seconds / best - 1.0), abs(last.bending_seconds / bending - 1.0))
            if now.change < converged:
                return now
        last, grid = now, grid.halved()
    if last is None:
        raise NoCurve(f"layer {layer.number}: no smooth curve stays inside the tolerance")
    return last


def bending_curve(layer, grid, limits):
    """Of both heads, and a hair inside the tube."""
    return [least_bending(grid, tube_of(layer, head, grid, limits).narrowed(0.99)) for head in (0, 1)]


def time_along(grid, curve, limits, is_outside=NOWHERE, cells=4):
    """Of a given curve; the timing's grid is `cells` times as fine as the curve's."""
    sampled = sample_curve(grid, curve, cells, is_outside)
    return seconds(sampled.width_rad, fastest_timing(sampled, limits))


@dataclasses.dataclass
class JointSolution:
    grid: SplineGrid
    curve: list
    b: np.ndarray


def solve_jointly(layer, grid, limits, bent, coarser=None):
    """Curve and timing together, from what the grid of half as many cells gave, else from the curve of least bending."""
    problem = JointProblem(layer, grid, limits)
    curve = bent
    if coarser is not None:
        before = [coarser.grid.coefficients_on(grid, head) for head in coarser.curve]
        # The finer grid asks at more places: a little of the other curve brings it back inside.
        share = next(share for share in (0.1, 0.3, 1.0) if problem.holds(_mixed(before, bent, share)))
        curve = _mixed(before, bent, share)
    # Well inside: from close to the limits the barrier's method creeps along them.
    start = problem.packed(curve, 0.6 * _allowed_timing(problem, curve, layer.is_outside))
    *curve, b = problem.parts(fastest_inside(problem, start, 0.02 if coarser is None else 0.005))
    return JointSolution(grid, curve, b)


def _mixed(curve, other, share):
    return [(1.0 - share) * a + share * b for a, b in zip(curve, other)]


def _allowed_timing(problem, curve, is_outside):
    """b strictly inside all limits: the fastest timing, lowered where the cells' ends ask for more than their middles."""
    sampled = sample_curve(problem.grid, curve, 1, is_outside)
    most = np.inf
    for _ in range(30):
        b = 0.97 * fastest_timing(sampled, problem.limits, most)
        x = problem.packed(curve, b)
        if is_inside(problem, x):
            return b
        most = b / np.maximum(problem.excess(x), 0.9)
    while not is_inside(problem, problem.packed(curve, b)):
        b = 0.95 * b
    return b
