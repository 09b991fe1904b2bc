# SPDX-License-Identifier: GPL-3.0-or-later
"""Newton's method with a logarithmic barrier for `JointProblem`: every step stays strictly inside all limits."""

import numpy as np
import scipy.linalg
import scipy.sparse as sparse


def fastest_inside(problem, x, first=0.02, last=2e-4, steps=60):
    """From a strictly allowed x to one of locally least time.

    first, last: the barrier's weight times the nodes' count, as a share of the time; steps: at most, for each weight.
    """
    nodes = problem.sizes[2]
    weight = first * problem.seconds(x) / nodes
    while True:
        for _ in range(steps):
            direction, gain = _newton_direction(problem, x, weight)
            step = _step_length(problem, x, direction, gain, weight)
            x = x + step * direction
            if step == 0.0 or gain < 1e-2 * weight * nodes:
                break
        if weight * nodes < last * problem.seconds(x):
            return x
        weight *= 0.35


def _barrier(problem, x, weight):
    """Time and weight times the logarithms of all distances; infinite outside."""
    if problem.parts(x)[2].min() <= 0.0:
        return np.inf
    logs = 0.0
    for rule in problem.rules(x):
        for distance in (1.0 - rule.value, 1.0 + rule.value)[: 1 + rule.either_sign]:
            if distance.min() <= 0.0:
                return np.inf
            logs += np.log(distance).sum()
    return problem.seconds(x) - weight * logs


def is_inside(problem, x):
    return np.isfinite(_barrier(problem, x, 1.0))


def _newton_direction(problem, x, weight):
    """The direction, and by how much the model falls along it (twice)."""
    gradient, certain, bilinear = _model(problem, x, weight)
    in_order = gradient[problem.order]
    sure, rest = _bands(problem, certain), _bands(problem, bilinear)
    # All of the second derivative where that is a minimum, less of its indefinite part where it is not.
    for share in (1.0, 0.7, 0.4, 0.2, 0.1, 0.03, 0.0):
        bands = sure + share * rest
        bands[0] += 1e-12 * sure[0]
        try:
            factor = scipy.linalg.cholesky_banded(bands, lower=True, check_finite=False)
        except np.linalg.LinAlgError:
            continue
        direction = np.empty_like(x)
        direction[problem.order] = -scipy.linalg.cho_solve_banded((factor, True), in_order, check_finite=False)
        return direction, float(-gradient @ direction)
    raise ArithmeticError("the barrier's certain part is not positive")


def _model(problem, x, weight):
    """Gradient, and the Hessian in two parts: one that is positive, and what the bilinear limits add."""
    curve, nodes = problem.sizes[0], problem.sizes[2]
    time_slope, time_curve = problem.seconds_slopes(x)
    forces, stiffness, jacobian = [], [], []
    cross = [sparse.csr_matrix((curve, nodes)) for _ in range(2)]
    for rule in problem.rules(x):
        near = weight / (1.0 - rule.value)
        far = weight / (1.0 + rule.value) if rule.either_sign else 0.0
        force = near - far
        forces.append(force)
        stiffness.append((near**2 + far**2) / weight)
        by_curve, by_b = rule.derivatives()
        blocks = [sparse.csr_matrix((len(force), curve)) for _ in range(2)] + [by_b]
        if rule.head >= 0:
            blocks[rule.head] = by_curve
        jacobian.append(sparse.hstack(blocks))
        for rows, columns in rule.cross:
            cross[rule.head] = cross[rule.head] + rows.T @ sparse.diags(force) @ columns
    jacobian = sparse.vstack(jacobian).tocsr()
    gradient = jacobian.T @ np.concatenate(forces)
    gradient[2 * curve :] += time_slope
    certain = jacobian.T @ sparse.diags(np.concatenate(stiffness)) @ jacobian
    certain = certain + sparse.block_diag([sparse.csr_matrix((2 * curve, 2 * curve)), time_curve])
    empty = sparse.csr_matrix((curve, curve))
    bilinear = sparse.bmat(
        [[empty, None, cross[0]], [None, empty, cross[1]], [cross[0].T, cross[1].T, None]]
    )
    return gradient, certain, bilinear


def _bands(problem, matrix):
    """Lower diagonals of a symmetric matrix whose unknowns are put into the problem's order."""
    rank = np.empty_like(problem.order)
    rank[problem.order] = np.arange(len(rank))
    entries = matrix.tocsr().tocoo()  # each place once
    row, column = rank[entries.row], rank[entries.col]
    below = row - column
    bands = np.zeros((problem.band + 1, matrix.shape[0]))
    kept = below >= 0
    assert below.max() <= problem.band
    bands[below[kept], column[kept]] = entries.data[kept]
    return bands


def _step_length(problem, x, direction, gain, weight):
    """Halved until the barrier falls by a good part of what the model promises; 0: no progress any more."""
    start = _barrier(problem, x, weight)
    step = 1.0
    while step > 1e-6:
        if _barrier(problem, x + step * direction, weight) < start - 1e-4 * step * gain:
            return step
        step *= 0.5
    return 0.0
