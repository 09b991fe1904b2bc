// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "rtcore/plan/curve_nodes.hpp"

namespace psicarve::plan {

/// The curve of least bending, the integral of q''^2, that stays between low and high at every node:
/// its control points. O(nodes); primal-dual interior point method with Mehrotra's predictor and corrector,
/// all axes side by side. Source: Nocedal and Wright, Numerical Optimization, ch. 16.
class CurveFit {
public:
    /// Bending much smaller than these accelerations [pulses/s^2] is not worth another iteration.
    explicit CurveFit(const Lanes& accel) : accel_(accel) {}

    /// The first and the last control point are the middles of their bounds; `fixed` gives the first ones
    /// (up to two), when they are decided already. Requires at least three nodes.
    void solve(const CurveNodes& nodes, std::span<const Lanes> fixed = {});

    /// One a node, until the next solve().
    const std::vector<Lanes>& control() const noexcept { return control_; }
    int iterations() const noexcept { return iterations_; }

private:
    /// One number an axis, in the processor's own vectors. Never passed or returned by value.
    /// Aligned alike in code for wide registers and in other code.
    using Vec = double __attribute__((vector_size(kAxisCount * sizeof(double)), aligned(16)));

    using Mask = std::int64_t __attribute__((vector_size(kAxisCount * sizeof(std::int64_t)), aligned(16)));

    /// Containers would forget a Vec's alignment.
    struct Four {
        Vec axes;
    };
    /// A linear form of the control points before, at and after a node; the same for all axes.
    struct Row {
        double before, at, after;
    };
    /// One bound at one node: the distance to it, how hard it presses, and what an iteration changes.
    struct Bound {
        Vec distance, press, inverse_distance, distance_change, press_change;
    };
    /// A node's curve value and bounds.
    struct State {
        Vec low, high, value, shift;
        Bound lower, upper;
    };
    struct Band {
        Vec at, next, second;  ///< a row of the matrix from its diagonal on; later of its factors
    };
    /// Rows of a band matrix, one after the other: what those before take off the present one.
    class Elimination {
    public:
        /// at becomes 1 / pivot, next and second the factors.
        void eliminate(Band& row) {
            row.at -= at_;
            row.next -= next_;
            const Vec inverse = 1.0 / row.at;
            const Vec next = row.next * inverse;
            const Vec second = row.second * inverse;
            at_ = at_after_ + next * row.next;
            next_ = next * row.second;
            at_after_ = second * row.second;
            row.at = inverse;
            row.next = next;
            row.second = second;
        }
        void substitute(const Band& row, Vec& side) {
            side -= side_;
            side_ = side_after_ + row.next * side;
            side_after_ = row.second * side;
        }

    private:
        Vec at_{}, at_after_{}, next_{}, side_{}, side_after_{};
    };
    /// For all axes: how far an iteration can go, and the sum of distance * press along it.
    struct Reach {
        Vec shrink;  ///< the greatest relative shrinking of a distance or a press
        Vec linear, square;
    };

    void prepare(const CurveNodes& nodes);
    void start(const CurveNodes& nodes, std::span<const Lanes> fixed);
    bool has_converged();
    static void weigh(State& state, Vec& weight, Vec& push);
    void build_and_eliminate();
    void substitute_back(std::vector<Four>& side) const;
    Reach predict();
    void correct(const Vec& target);
    Reach reach_corrected(const Vec& target);
    void advance(const Vec& length);
    void mend(const CurveNodes& nodes);

    Lanes accel_;
    std::size_t count_ = 0;
    std::size_t fixed_ = 1;
    double bound_count_ = 0.0;
    double length_ = 0.0;
    std::vector<Row> bend_;                         ///< sqrt(H_j) * q''_j
    std::vector<Row> value_;                        ///< q(u_j)
    std::vector<std::array<double, 3>> stiffness_;  ///< bend' * bend, three diagonals
    std::vector<Four> points_;                      ///< control points
    std::vector<Four> change_;
    std::vector<Four> side_;
    std::vector<State> states_;
    std::vector<Band> band_;
    std::vector<Lanes> control_;
    Vec gap_{};
    Mask is_done_{};  ///< by axis: -1 once it has converged
    int iterations_ = 0;
};

}  // namespace psicarve::plan
