// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "rtcore/plan/band_elimination.hpp"
#include "rtcore/plan/bending_forms.hpp"
#include "rtcore/plan/curve_nodes.hpp"
#include "rtcore/plan/wide.hpp"

namespace psicarve::plan {

/// Control points that are decided already: up to two at either end.
struct DecidedEnds {
    std::span<const Lanes> first;
    std::span<const Lanes> last;
};

/// The curve of least bending, the integral of weight * q''^2, that stays between low and high at every node:
/// its control points. O(nodes); primal-dual interior point method with Mehrotra's predictor and corrector,
/// all axes side by side. Source: Nocedal and Wright, Numerical Optimization, ch. 16.
///
/// An iteration goes through the nodes four times, twice forwards and twice backwards. What depends on the
/// node before is slow, one division or two products after the other; everything else that a pass has to do
/// is done meanwhile. Its members: the problem, and the memory of an iteration, kept from one curve to the
/// next.
class CurveFit {
public:
    /// Bending much smaller than these accelerations [pulses/s^2] is not worth another iteration.
    explicit CurveFit(const Lanes& accel) : accel_(accel) {}

    /// The first and the last control point, where not decided, are the middles of their bounds. Requires at
    /// least three nodes, and one control point that is not decided.
    void solve(const NodesView& nodes, const DecidedEnds& decided = {});

    /// One a node, until the next solve().
    const std::vector<Lanes>& control() const noexcept { return control_; }
    int iterations() const noexcept { return iterations_; }
    /// Whether the last solve() came to an end before its last iteration.
    bool has_converged() const noexcept { return has_converged_; }

private:
    // Accelerations below this share of what the motors can do do not matter.
    static constexpr double kAccelTolerance = 0.01;

    /// One bound at one node: the distance to it, how hard it presses, and what an iteration changes.
    struct Bound {
        Vec distance, press, inverse_distance, press_change;
    };
    /// A node's bounds. Both distances add up to the tube's width at all times, so what the curve's value is
    /// off the lower one's is off the upper one's with the other sign, and all that an iteration changes of
    /// one it changes of the other.
    struct State {
        Vec residual;  ///< at the start: value - low - lower.distance
        Vec rise;      ///< what an iteration adds to lower.distance and takes from upper.distance
        Bound lower, upper;
    };
    /// For all axes: how far an iteration can go, and the sum of distance * press along it.
    struct Reach {
        Vec distance_shrink;  ///< the greatest relative shrinking of a distance
        Vec press_shrink;     ///< and of a press
        Vec by_distance, by_press, by_both;
    };

    void start(const NodesView& nodes, const DecidedEnds& decided);
    void start_pressing();
    void advance_and_eliminate();
    bool note_converged();
    void predict(Reach& reach);
    void target_after(const Reach& predicted, Vec& target) const;
    void correct(const Vec& target);
    void reach_corrected(const Vec& target, Reach& reach);
    void set_steps(const Reach& reach);
    void mend(const NodesView& nodes);

    Lanes accel_;
    std::size_t count_ = 0;
    std::size_t begin_ = 1;  ///< of the control points that are not decided
    std::size_t end_ = 0;
    BendingForms forms_;
    WideVector<Four> points_;  ///< control points
    WideVector<Four> change_;
    WideVector<Four> side_;
    WideVector<State> states_;
    WideVector<BandRow> band_;
    std::vector<Lanes> control_;
    Vec distance_step_{};  ///< shares of the changes that are gone
    Vec press_step_{};
    Vec left_{};  ///< of the residuals
    Vec gap_{};   ///< sum of distance * press
    Vec bending_{};
    Vec outside_{};   ///< the furthest that a value is outside its bounds
    Mask is_done_{};  ///< by axis: -1 once it has converged
    bool has_converged_ = false;
    int iterations_ = 0;
};

}  // namespace psicarve::plan
