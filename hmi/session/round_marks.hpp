// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace psicarve::session {

/// Marks of an axis at round numbers: 1, 2 or 5 with zeros.
struct RoundMarks {
    std::vector<double> values;  ///< rising, all within the range
    int decimals = 0;            ///< enough to show all exactly
};
/// From `low` to `high`, in their unit; as many as possible, at most `most`. A range without extent has its
/// own value where that is round, else none. `most` > 0.
RoundMarks round_marks(double low, double high, int most);

}  // namespace psicarve::session
