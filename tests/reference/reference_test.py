#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Proves the yardstick itself: each part against a closed form or against a general solver of scipy."""

import dataclasses
import math
import sys
import unittest

sys.dont_write_bytecode = True  # leaves nothing beside the sources

import numpy as np
import scipy.optimize
import scipy.sparse as sparse

import path_timing
from layer_time import bending_curve, least_layer_time, solve_jointly, time_along
from least_bending import NoCurve, least_bending
from machine_limits import AxisLimits, Layer, MachineLimits
from outside import NOWHERE, Run, lines_outside, nodes_at_the_feed
from spline_curve import SplineGrid
from tube import cells_for, tube_of

PSI_PULSE = 2.0 * math.pi / 6400


def machine(speed=50.0, accel=500.0, start_stop=5.0, feed=1000.0):
    """Heads as given; table 180 deg/s, 1000 deg/s2, 18 deg/s."""
    head = AxisLimits(1.0 / 400.0, speed, accel, start_stop)
    psi = AxisLimits(PSI_PULSE, math.pi, math.radians(1000.0), math.radians(18.0))
    return MachineLimits(head, head, psi, feed, 0.01, 1.5, (60.0, 60.0))


def layer_of(radius_mm, points=501, sweep_pulses=6400):
    """R2 stands half a turn on; angles and radii are whole pulses."""
    psi = np.round(np.arange(points) * sweep_pulses / (points - 1)) * PSI_PULSE
    return Layer(0, psi, tuple(np.round(400.0 * radius_mm(psi + turn)) / 400.0 for turn in (0.0, math.pi)))


def lobed(psi):
    return 20.0 + 2.0 * np.cos(5.0 * psi) + np.cos(13.0 * psi)


def jagged(psi):
    """Ramps with a sharp foot and a sharp crest."""
    return 15.0 + 1.5 * np.abs((psi / 0.4) % 2.0 - 1.0)


class Timing(unittest.TestCase):
    def test_a_circle_takes_the_time_of_a_trapezoid(self):
        limits, layer = machine(), layer_of(lambda psi: 20.0 + 0.0 * psi)
        v, a, j = limits.psi.speed, limits.psi.accel, limits.psi.start_stop
        ramp = (v * v - j * j) / (2.0 * a)
        expected = 2.0 * (v - j) / a + (2.0 * math.pi - 2.0 * ramp) / v
        found = least_layer_time(layer, limits)
        self.assertAlmostEqual(found.bending_seconds, expected, delta=1e-3 * expected)
        self.assertAlmostEqual(found.seconds, expected, delta=1e-3 * expected)

    def test_the_feed_slows_a_circle_down(self):
        found = least_layer_time(layer_of(lambda psi: 20.0 + 0.0 * psi), machine(feed=10.0), bending_only=True)
        self.assertAlmostEqual(found.seconds, 40.0 * math.pi / 10.0, delta=0.02)

    def test_no_timing_of_the_curve_is_faster_says_a_linear_programme(self):
        limits = machine()
        grid = SplineGrid(layer_of(lobed, 121, 1600).psi_rad, np.full(120, 4))
        curve = [np.array(lobed(grid.coefficient_rad() + turn)) for turn in (0.0, math.pi)]
        sampled = path_timing.sample_curve(grid, curve, 4)
        b = path_timing.fastest_timing(sampled, limits)
        found = path_timing.seconds(sampled.width_rad, b)
        self.assertLess(found - lower_bound(sampled, limits, b), 0.003 * found)


def lower_bound(sampled, limits, b):
    """Time is convex in b, so its tangent at b, minimised over all that the limits allow, bounds it from below."""
    nodes = len(b)
    first, second = sparse.eye(nodes - 1, nodes, 0), sparse.eye(nodes - 1, nodes, 1)
    rows = []
    for bend, slope, accel in path_timing.accelerations(sampled, limits):
        alpha, beta = path_timing.end_factors(bend, slope, sampled.width_rad)
        rows.append((sparse.diags(alpha) @ first + sparse.diags(beta) @ second) / accel)
    limit = sparse.vstack(rows + [-row for row in rows])
    root = np.sqrt(b)
    slope = np.zeros(nodes)
    share = -2.0 * sampled.width_rad / (root[1:] + root[:-1]) ** 2
    slope[:-1] += share / (2.0 * root[:-1])
    slope[1:] += share / (2.0 * root[1:])
    ranges = np.column_stack([np.zeros(nodes), path_timing.speed_caps(sampled, limits)])
    best = scipy.optimize.linprog(slope, A_ub=limit, b_ub=np.ones(limit.shape[0]), bounds=ranges, method="highs")
    return path_timing.seconds(sampled.width_rad, b) + best.fun - slope @ b


class Curve(unittest.TestCase):
    def test_bends_least_says_a_general_solver(self):
        limits, layer = machine(), layer_of(lobed, 9, 100)
        grid = SplineGrid(layer.psi_rad, np.full(8, 3))
        tube = tube_of(layer, 0, grid, limits)
        found = least_bending(grid, tube)
        rows, width = grid.value(tube.at_rad).toarray(), grid.width_rad
        bend = grid.second.toarray() * np.sqrt(width)[:, None] * width[0]
        least = np.sum((bend @ found) ** 2)
        bend /= math.sqrt(least)
        # From the chords' own corners, in hundredths of a millimetre.
        start, unit = np.interp(grid.coefficient_rad(), layer.psi_rad, layer.r_mm[0]), 0.01
        general = scipy.optimize.minimize(
            lambda y: np.sum((bend @ (start + unit * y)) ** 2),
            np.zeros(grid.size),
            jac=lambda y: 2.0 * unit * bend.T @ (bend @ (start + unit * y)),
            constraints=[
                {"type": "ineq", "fun": lambda y: rows @ y - (tube.low_mm - rows @ start) / unit, "jac": lambda y: rows},
                {"type": "ineq", "fun": lambda y: (tube.high_mm - rows @ start) / unit - rows @ y, "jac": lambda y: -rows},
            ],
            method="SLSQP",
            options={"maxiter": 500, "ftol": 1e-10},
        )
        self.assertTrue(general.success, general.message)
        self.assertAlmostEqual(general.fun, 1.0, delta=1e-3)

    def test_is_refused_on_a_grid_too_coarse_for_the_tube(self):
        limits, layer = machine(), layer_of(lobed, 21, 800)
        grid = SplineGrid(layer.psi_rad, np.full(20, 1))
        with self.assertRaises(NoCurve):
            bending_curve(layer, grid, limits)

    def test_stays_the_same_on_a_halved_grid(self):
        grid = SplineGrid(layer_of(lobed, 41, 800).psi_rad, np.full(40, 2))
        coefficients = np.cos(1.7 * np.arange(grid.size))
        finer = grid.halved()
        at = np.linspace(grid.node_rad[0], grid.node_rad[-1], 997)
        same = finer.value(at) @ grid.coefficients_on(finer, coefficients)
        self.assertLess(np.abs(same - grid.value(at) @ coefficients).max(), 1e-12)


class Joint(unittest.TestCase):
    def test_is_never_slower_than_the_curve_of_least_bending(self):
        found = least_layer_time(layer_of(jagged, 61, 800), machine(), halvings=1)
        self.assertLess(found.seconds, 0.99 * found.bending_seconds)

    def test_keeps_every_limit_in_time(self):
        """The motion as a function of time, differentiated numerically: other formulas than the solver's."""
        limits, layer = machine(speed=20.0, accel=200.0, start_stop=0.5, feed=30.0), layer_of(jagged, 61, 800)
        grid = SplineGrid(layer.psi_rad, cells_for(layer, limits))
        found = solve_jointly(layer, grid, limits, bending_curve(layer, grid, limits))
        root = np.sqrt(found.b)
        at_node_s = np.concatenate([[0.0], np.cumsum(2.0 * grid.width_rad / (root[1:] + root[:-1]))])
        step_s = 1e-4
        time_s = np.arange(0.0, at_node_s[-1], step_s)
        cell = np.clip(np.searchsorted(at_node_s, time_s, side="right") - 1, 0, len(grid.width_rad) - 1)
        since, accel = time_s - at_node_s[cell], np.diff(found.b)[cell] / (2.0 * grid.width_rad[cell])
        psi = np.minimum(grid.node_rad[cell] + root[cell] * since + 0.5 * accel * since**2, grid.node_rad[-1])
        radii = [grid.value(psi) @ head for head in found.curve]
        for axis, position in zip((limits.psi, *limits.heads), (psi, *radii)):
            self.assertLess(np.abs(np.diff(position)).max() / step_s, 1.002 * axis.speed)
            self.assertLess(np.abs(np.diff(position, 2)).max() / step_s**2, 1.01 * axis.accel)
            self.assertLess(abs(position[1] - position[0]) / step_s, axis.start_stop + 1.01 * axis.accel * step_s)
        for r in radii:
            speed = np.hypot(r[1:] * np.diff(psi), np.diff(r)) / step_s
            self.assertLess(speed.max(), 1.002 * limits.feed_mm_s)
        for head, r in enumerate(layer.r_mm):
            off = np.abs(grid.value(layer.psi_rad) @ found.curve[head] - r)
            self.assertLess(off.max(), 0.5 * limits.heads[head].pulse)


class Lobes(unittest.TestCase):
    """501 points of a full turn whose least time is known from an earlier solution: 3.35 s."""

    def test_take_about_three_and_a_third_seconds(self):
        found = least_layer_time(layer_of(lobed), machine(), halvings=1)
        self.assertAlmostEqual(found.bending_seconds, 3.354, delta=0.01)
        self.assertAlmostEqual(found.seconds, 3.342, delta=0.01)
        grid = SplineGrid(layer_of(lobed).psi_rad, np.full(500, 2))
        curve = bending_curve(layer_of(lobed), grid, machine())
        self.assertAlmostEqual(time_along(grid, curve, machine()), 3.354, delta=0.01)


class Outside(unittest.TestCase):
    """From 12 mm of blank on, and 2 mm clearance, 0.01 mm tolerance and a pulse."""

    limits = dataclasses.replace(machine(), clearance_mm=2.0, blank_mm=12.0)
    free_mm = 14.0125

    def expect(self, expected, rough_mm, clear_mm=(12.0, 12.0), finished_mm=10.0, limits=limits):
        """Of R1's lines; the tip of R2 is inside."""
        inside = np.full(len(rough_mm), 12.0)
        finished = np.full(len(rough_mm), finished_mm)
        runs = [Run(clear_mm[0], [(np.array(rough_mm), inside)]), Run(clear_mm[-1], [(finished, finished)])]
        found = lines_outside(runs[2 - len(clear_mm) :], limits)
        self.assertEqual(np.broadcast_to(found[0][0], len(rough_mm) - 1).tolist(), expected)

    def test_is_a_line_both_ends_of_which_are(self):
        free, near = self.free_mm, self.free_mm - 1.0 / 400.0
        self.expect([False, True, False], [near, free, free + 3.0, near])

    def test_is_counted_from_the_most_that_tells_of_the_blank(self):
        free = self.free_mm
        self.expect([True], [free, free])
        self.expect([False], [free, free], clear_mm=(12.0, 12.1))
        self.expect([False], [free, free], finished_mm=12.1)
        self.expect([False], [free, free], limits=dataclasses.replace(self.limits, blank_mm=12.1))
        self.expect([True], [12.5125, 12.6], limits=dataclasses.replace(self.limits, clearance_mm=0.0))
        self.expect([False], [12.51, 12.6], limits=dataclasses.replace(self.limits, clearance_mm=0.0))

    def test_is_nowhere_if_a_pass_does_not_tell_or_there_is_one(self):
        self.expect([False], [20.0, 20.0], clear_mm=(0.0, 12.0))
        self.expect([False], [20.0, 20.0], clear_mm=(12.0, 0.0))
        tips = [(np.full(2, 20.0), np.full(2, 10.0))]
        self.assertEqual(lines_outside([Run(12.0, tips)], self.limits), [NOWHERE])

    def test_is_nowhere_if_a_roughing_pass_were_so_all_over(self):
        out, near = np.full(2, 20.0), np.full(2, 10.0)
        runs = [Run(12.0, [(out, near)]), Run(12.0, [(out, out)]), Run(12.0, [(near, near)])]
        self.assertEqual(lines_outside(runs, self.limits), [NOWHERE] * 3)

    def test_lets_a_circle_turn_as_fast_as_the_table_does(self):
        everywhere = (np.full(120, True), np.full(120, True))
        layer = dataclasses.replace(layer_of(lambda psi: 20.0 + 0.0 * psi, 121), is_outside=everywhere)
        slow, grid = machine(feed=10.0), SplineGrid(layer.psi_rad, np.full(120, 4))
        expected = least_layer_time(dataclasses.replace(layer, is_outside=NOWHERE), machine(), bending_only=True).seconds
        bent = bending_curve(layer, grid, slow)
        self.assertAlmostEqual(time_along(grid, bent, slow, layer.is_outside), expected, delta=1e-3 * expected)
        jointly = solve_jointly(layer, grid, slow, bent)
        taken = path_timing.seconds(grid.width_rad, jointly.b)
        self.assertAlmostEqual(taken, expected, delta=0.03 * expected)  # 0.02: where the barrier ends

    def test_has_the_feed_at_both_ends(self):
        grid = SplineGrid(np.arange(4.0), np.full(3, 2))
        fed = nodes_at_the_feed(grid, np.array([False, True, False]))
        self.assertEqual(fed.tolist(), [True, True, True, False, True, True, True])


if __name__ == "__main__":
    unittest.main()
