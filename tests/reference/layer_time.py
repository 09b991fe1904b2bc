# SPDX-License-Identifier: GPL-3.0-or-later
"""The least time of one layer: curve and timing on ever finer grids until halving the cells changes little."""

import dataclasses

import numpy as np

from barrier_method import fastest_inside, is_inside
from joint_problem import JointProblem
from least_bending import NoCurve, least_bending
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
        bending = time_along(grid, bent, limits)
        best = bending
        if not bending_only:
            coarser = solve_jointly(layer, grid, limits, bent, coarser)
            best = min(best, time_along(grid, coarser.curve, limits))
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


def time_along(grid, curve, limits, cells=4):
    """Of a given curve; the timing's grid is `cells` times as fine as the curve's."""
    sampled = sample_curve(grid, curve, cells)
    return seconds(sampled.width_rad, fastest_timing(sampled, limits))


@dataclasses.dataclass
class JointSolution:
    grid: SplineGrid
    curve: list
    b: np.ndarray


def solve_jointly(layer, grid, limits, bent, coarser=None):
    """Curve and timing together, from what the grid of half as many cells gave, else from the curve of least bending."""
    problem = JointProblem(layer, grid, limits)
    if coarser is None:
        curve, b, first = bent, 0.98 * fastest_timing(sample_curve(grid, bent, 1), limits), 0.02
    else:
        # The finer grid asks at more places: a little of the other curve brings it back inside.
        curve = [coarser.grid.coefficients_on(grid, head) for head in coarser.curve]
        curve = [0.97 * head + 0.03 * other for head, other in zip(curve, bent)]
        b, first = 0.98 * np.interp(grid.node_rad, coarser.grid.node_rad, coarser.b), 0.002
    while not is_inside(problem, np.concatenate([*curve, b])):
        curve = [0.9 * head + 0.1 * other for head, other in zip(curve, bent)]
        b = 0.95 * b
    *curve, b = problem.parts(fastest_inside(problem, np.concatenate([*curve, b]), first))
    return JointSolution(grid, curve, b)
