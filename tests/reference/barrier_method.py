# SPDX-License-Identifier: GPL-3.0-or-later
"""Newton's method with a logarithmic barrier for `JointProblem`: every step stays strictly inside all limits."""

import numpy as np
import scipy.linalg

from joint_problem import BAND, B_HERE


def fastest_inside(problem, x, first=0.02, last=1e-4, steps=60):
    """From a strictly allowed x to one of locally least time.

    first, last: the barrier's weight times the nodes' count, as a share of the time; steps: at most, for each weight.
    """
    weight = first * problem.seconds(x) / problem.nodes
    while True:
        for _ in range(steps):
            direction, gain = _newton_direction(problem, x, weight)
            step = _step_length(problem, x, direction, gain, weight)
            x = x + step * direction
            if step == 0.0 or gain < 1e-2 * weight * problem.nodes:
                break
        if weight * problem.nodes < last * problem.seconds(x):
            return x
        weight *= 0.35


def is_inside(problem, x):
    return np.isfinite(_barrier(problem, x, 1.0))


def _barrier(problem, x, weight):
    """Time less weight times the logarithms of all distances; infinite outside."""
    if x[B_HERE::3].min() <= 0.0:
        return np.inf
    logs = 0.0
    for rule in problem.rules(x):
        for distance in (1.0 - rule.value, 1.0 + rule.value)[: 1 + rule.either_sign]:
            if distance.min() <= 0.0:
                return np.inf
            logs += np.log(distance).sum()
    return problem.seconds(x) - weight * logs


def _newton_direction(problem, x, weight):
    """The direction, and by how much the model falls along it (twice)."""
    gradient, certain, products = _model(problem, x, weight)
    # All of the second derivative where that has a minimum, less of its indefinite part where it has none.
    for share in (1.0, 0.7, 0.4, 0.2, 0.1, 0.03, 0.0):
        bands = certain + share * products
        bands[0] += 1e-12 * certain[0]
        try:
            factor = scipy.linalg.cholesky_banded(bands, lower=True, check_finite=False)
        except np.linalg.LinAlgError:
            continue
        direction = -scipy.linalg.cho_solve_banded((factor, True), gradient, check_finite=False)
        return direction, float(-gradient @ direction)
    raise ArithmeticError("the barrier's certain part is not positive")


def _model(problem, x, weight):
    """Gradient, and the Hessian's lower bands in two parts: one that is positive, and what the products add."""
    gradient = np.zeros_like(x)
    certain, products = np.zeros((BAND + 1, len(x))), np.zeros((BAND + 1, len(x)))
    by_b, diagonal, beside = problem.seconds_slopes(x)
    gradient[B_HERE::3] += by_b
    certain[0, B_HERE::3] += diagonal
    certain[3, B_HERE:-3:3] += beside
    for rule in problem.rules(x):
        near = weight / (1.0 - rule.value)
        far = weight / (1.0 + rule.value) if rule.either_sign else 0.0
        force, stiffness = near - far, (near**2 + far**2) / weight
        places = sorted(rule.slopes)
        for n, right in enumerate(places):
            gradient[_all(right, force)] += force * rule.slopes[right]
            stiff = stiffness * rule.slopes[right]
            for left in places[n:]:
                certain[left - right, _all(right, force)] += stiff * rule.slopes[left]
        for one, other, factor in rule.products:
            products[abs(one - other), _all(min(one, other), force)] += force * factor
    return gradient, certain, products


def _all(place, family):
    """The unknowns at this place beside each member of a family of limits."""
    return slice(place, place + 3 * len(family), 3)


def _step_length(problem, x, direction, gain, weight):
    """Halved until the barrier falls by a good part of what the model promises; 0: no progress any more."""
    start = _barrier(problem, x, weight)
    step = 1.0
    while step > 1e-6:
        if _barrier(problem, x + step * direction, weight) < start - 1e-4 * step * gain:
            return step
        step *= 0.5
    return 0.0
