// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/session/round_marks.hpp"

#include <algorithm>
#include <cmath>

namespace psicarve::session {
namespace {

/// Of a step: sums of steps are not exact.
constexpr double kSlack_ratio = 1e-9;
constexpr double kLeastExtent = 1e-6;

}  // namespace

RoundMarks round_marks(double low, double high, int most) {
    RoundMarks marks;
    if (!std::isfinite(low) || !std::isfinite(high) || high < low) return marks;
    const double extent = std::max(high - low, kLeastExtent);
    auto power = static_cast<int>(std::floor(std::log10(extent / most)));
    for (;; ++power) {
        for (const double of_ten : {1.0, 2.0, 5.0}) {
            const double step = of_ten * std::pow(10.0, power);
            const double first = std::ceil(low / step - kSlack_ratio);
            const double last = std::floor(high / step + kSlack_ratio);
            if (last - first + 1.0 > most) continue;
            for (double i = first; i <= last; ++i) marks.values.push_back(i == 0.0 ? 0.0 : i * step);
            marks.decimals = std::max(0, -power);
            return marks;
        }
    }
}

}  // namespace psicarve::session
