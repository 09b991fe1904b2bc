// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "rtcore/plan/curve_nodes.hpp"
#include "rtcore/plan/wide.hpp"

namespace psicarve::plan {

/// What a fit makes least and what it bounds, as forms of a curve's control points: of its nodes alone.
struct BendingForms {
    /// A linear form of the control points before, at and after a node; the same for all axes.
    struct Row {
        double before, at, after;
    };

    /// Keeps its memory from one to the next.
    void set(const NodesView& nodes);

    std::vector<Row> bend;                      ///< sqrt(H_j) * q''_j
    std::vector<Row> value;                     ///< q(u_j)
    WideVector<Four> weight;                    ///< of that cell's bending squared
    WideVector<std::array<Four, 3>> stiffness;  ///< bend' * weight * bend, three diagonals
    double length = 0.0;                        ///< of all cells but the first and the last [s of u]
};

}  // namespace psicarve::plan
