# SPDX-License-Identifier: GPL-3.0-or-later
"""Where a head keeps to no feed: outside of the blank, on the whole of a line between two points of the table.

    tip >= R + clearance + path tolerance + a pulse     at both ends of the line

R is the most of the blank's reach, of what each pass says and of the finished piece's tips. It is known only where
every pass says how far out material stands. A job of one pass has nothing outside; nor has one with a roughing pass of
which both heads would be outside on all lines, for what it says of its blank cannot be.
"""

import dataclasses

import numpy as np

NOWHERE = (False, False)  # of each head, for as many lines as there are
LEAST_CLEARANCE_MM = 0.5


@dataclasses.dataclass(frozen=True)
class Run:
    """A pass, or one of several of the same depth; tip_mm: by layer and head, where the tips really are."""

    clear_mm: float
    tip_mm: list


def lines_outside(runs, limits):
    """Of each run's layers in turn: of both heads, whether it is outside on each line."""
    layers = [layer for run in runs for layer in run.tip_mm]
    if len(runs) < 2 or min(run.clear_mm for run in runs) <= 0.0:
        return [NOWHERE] * len(layers)
    finished_mm = max(tip.max() for layer in runs[-1].tip_mm for tip in layer)
    blank_mm = max(limits.blank_mm, finished_mm, *(run.clear_mm for run in runs))
    free_mm = blank_mm + max(limits.clearance_mm, LEAST_CLEARANCE_MM) + limits.path_tolerance_mm
    found = [[_outside(layer, limits, free_mm) for layer in run.tip_mm] for run in runs]
    if any(np.all(run) for run in found[:-1]):
        return [NOWHERE] * len(layers)
    return [layer for run in found for layer in run]


def _outside(tip_mm, limits, free_mm):
    is_free = [tip - axis.pulse >= free_mm for tip, axis in zip(tip_mm, limits.heads)]
    return tuple(free[1:] & free[:-1] for free in is_free)


def nodes_at_the_feed(grid, is_outside, cells=1):
    """Of one head, at the nodes of a grid `cells` times as fine: where two lines meet, if the feed holds on one."""
    lines = np.broadcast_to(is_outside, (len(grid.point_node) - 1,))
    cell = np.repeat(lines[grid.cell_interval], cells)
    return ~(np.append(True, cell) & np.append(cell, True))
