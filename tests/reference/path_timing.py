# SPDX-License-Identifier: GPL-3.0-or-later
"""Least time along a given curve: time-optimal path parameterisation by reachability.

The curve is R1(psi), R2(psi); the unknown is b = (dpsi/dt)^2 at the nodes of a grid, linear in psi between them. Then
d2psi/dt2 = b'/2 and d2R/dt2 = R''*b + R'*b'/2, which is held below a_k in the middle of each cell:

    |alpha*b0 + beta*b1| <= a,   alpha = R''/2 - R'/2h,   beta = R''/2 + R'/2h

Where alpha and beta differ in sign this bounds b1 by b0 and b0 by b1, both rising: passes backwards and forwards
find the greatest b everywhere at once, and with it the least time. Where they agree (the axis turns around) both ends
stay below a/|R''|, which is stricter than need be by an amount that goes with the cell's width.
"""

import dataclasses
import itertools

import numpy as np

from outside import NOWHERE, nodes_at_the_feed


@dataclasses.dataclass(frozen=True)
class SampledCurve:
    """Values at nodes have one entry more than those of cells; tuples are R1, R2."""

    width_rad: np.ndarray
    node_r_mm: tuple
    node_slope: tuple
    cell_slope: tuple  # in the middle
    cell_second: tuple
    node_is_fed: tuple  # by head: whether the feed holds


def sample_curve(grid, curve, cells, is_outside=NOWHERE):
    """Both heads' splines on a grid `cells` times as fine as their own. is_outside: by head, of each line."""
    inner = grid.node_rad[:-1, None] + grid.width_rad[:, None] * (np.arange(cells) / cells)[None, :]
    node = np.append(inner.ravel(), grid.node_rad[-1])
    middle = 0.5 * (node[1:] + node[:-1])
    value, slope, at_middle = grid.value(node), grid.slope(node), grid.slope(middle)
    return SampledCurve(
        np.diff(node),
        tuple(value @ head for head in curve),
        tuple(slope @ head for head in curve),
        tuple(at_middle @ head for head in curve),
        tuple(np.repeat(grid.second @ head, cells) for head in curve),
        tuple(nodes_at_the_feed(grid, head, cells) for head in is_outside),
    )


def speed_caps(sampled, limits):
    """Greatest b at each node that top speeds, the feed and the jumps at both ends allow."""
    cap = np.full(len(sampled.width_rad) + 1, limits.psi.speed**2)
    ends = np.full(2, limits.psi.start_stop**2)
    heads = zip(limits.heads, sampled.node_r_mm, sampled.node_slope, sampled.node_is_fed)
    for axis, r, slope, is_fed in heads:
        square = np.maximum(slope**2, 1e-18)
        cap = np.minimum(cap, axis.speed**2 / square)
        cap = np.where(is_fed, np.minimum(cap, limits.feed_mm_s**2 / (r**2 + square)), cap)
        ends = np.minimum(ends, axis.start_stop**2 / square[[0, -1]])
    cap[[0, -1]] = np.minimum(cap[[0, -1]], ends)
    return cap


def accelerations(sampled, limits):
    """Of each axis: R'' and R' in the middle of the cells, and the limit."""
    zero, one = np.zeros_like(sampled.width_rad), np.ones_like(sampled.width_rad)
    heads = zip(sampled.cell_second, sampled.cell_slope, limits.heads)
    return [(zero, one, limits.psi.accel)] + [(second, slope, axis.accel) for second, slope, axis in heads]


def end_factors(second, slope, width_rad):
    """alpha and beta."""
    return 0.5 * second - 0.5 * slope / width_rad, 0.5 * second + 0.5 * slope / width_rad


def fastest_timing(sampled, limits, most=np.inf):
    """The greatest b at every node; nowhere above `most`."""
    cap = np.minimum(speed_caps(sampled, limits), most)
    return greatest_along(sampled.width_rad, cap, accelerations(sampled, limits))


def greatest_along(width, cap, axes):
    """The greatest b at every node below `cap`, which it lowers; axes: R'' and R' in the middle of the cells, limit."""
    _cap_where_axes_disagree(cap, axes)
    rules = []
    for second, slope, accel in axes:
        alpha, beta = end_factors(second, slope, width)
        turning = alpha * beta >= 0.0
        _lower_both_ends(cap, np.where(turning, accel / np.maximum(np.abs(second), 1e-18), np.inf))
        # Where it turns, a rule that never binds: 0*b0 <= a + 0*b1.
        rules.append([np.where(turning, 0.0, np.abs(factor)).tolist() for factor in (alpha, beta)] + [accel])
    return _greatest(cap.tolist(), rules)


def _lower_both_ends(cap, most):
    np.minimum(cap[:-1], most, out=cap[:-1])
    np.minimum(cap[1:], most, out=cap[1:])


def _cap_where_axes_disagree(cap, axes):
    """Two axes that ask for different b' at the same b: above this b no b' suits both."""
    for (second_i, slope_i, accel_i), (second_j, slope_j, accel_j) in itertools.combinations(axes, 2):
        cross = np.abs(second_i * slope_j - second_j * slope_i)
        most = accel_i * np.abs(slope_j) + accel_j * np.abs(slope_i)
        _lower_both_ends(cap, np.where(cross > 1e-12 * most, most / np.maximum(cross, 1e-300), np.inf))


def _greatest(b, rules):
    """Backward and forward passes until neither lowers anything."""
    last = len(b) - 1
    before = np.inf
    while before - sum(b) > 1e-9 * sum(b):
        before = sum(b)
        for i in range(last - 1, -1, -1):
            for alpha, beta, accel in rules:
                if alpha[i] * b[i] > accel + beta[i] * b[i + 1]:
                    b[i] = (accel + beta[i] * b[i + 1]) / alpha[i]
        for i in range(last):
            for alpha, beta, accel in rules:
                if beta[i] * b[i + 1] > accel + alpha[i] * b[i]:
                    b[i + 1] = (accel + alpha[i] * b[i]) / beta[i]
    return np.array(b)


def seconds(width_rad, b):
    root = np.sqrt(b)
    return float(np.sum(2.0 * width_rad / (root[1:] + root[:-1])))
