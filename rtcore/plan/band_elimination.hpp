// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "rtcore/plan/wide.hpp"

namespace psicarve::plan {

/// A row of a symmetric band matrix with five diagonals, for each axis one matrix: from its diagonal on;
/// later of its factors L D L'.
struct BandRow {
    Vec at, next, second;
};

/// Rows of a band matrix, one after the other: what those before take off the present one.
class BandElimination {
public:
    /// at becomes 1 / pivot, next and second the factors.
    PSICARVE_INLINE void eliminate(BandRow& row) {
        row.at = (row.at - at_by_second_) - at_by_next_;
        row.next -= next_by_both_;
        const Vec inverse = 1.0 / row.at;
        at_by_second_ = at_after_;
        at_by_next_ = row.next * row.next * inverse;
        next_by_both_ = row.next * row.second * inverse;
        at_after_ = row.second * row.second * inverse;
        row.at = inverse;
        row.next *= inverse;
        row.second *= inverse;
    }
    PSICARVE_INLINE void substitute(const BandRow& row, Vec& side) {
        side = (side - side_by_second_) - side_by_next_;
        side_by_second_ = side_after_;
        side_by_next_ = row.next * side;
        side_after_ = row.second * side;
    }
    /// Backwards: `side` went forwards through the rows' factors.
    PSICARVE_INLINE void substitute_back(const BandRow& row, Vec& side) {
        side = (side * row.at - row.second * side_by_second_) - row.next * side_by_next_;
        side_by_second_ = side_by_next_;
        side_by_next_ = side;
    }

private:
    Vec at_by_second_{}, at_by_next_{}, at_after_{}, next_by_both_{};
    Vec side_by_second_{}, side_by_next_{}, side_after_{};
};

}  // namespace psicarve::plan
