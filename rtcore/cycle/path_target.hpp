// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

namespace psicarve::cycle {

/// The speed squared at which a path is to go, out of those of its two profiles: up to 100 % feed the first
/// scaled down by the square of the feed, from there on a mixture with the second, which is all of it at
/// 200 %. Of either a part may be asked for. Between two allowed motions lies an allowed one, so all of these
/// are. RT: yes.
class PathTarget {
public:
    /// 0 to 2, and of the speed that makes such a part, 0 to 1; at first 1 and all. False: it is so already.
    bool aim(double feed_ratio, double part = 1.0) noexcept {
        if (feed_ratio == feed_ratio_ && part == part_) return false;
        feed_ratio_ = feed_ratio;
        part_ = part;
        const double square = feed_ratio * feed_ratio;
        const double high_share = std::max(0.0, (square - 1.0) / 3.0);
        high_share_ = part * part * high_share;
        low_share_ = part * part * (square <= 1.0 ? square : 1.0 - high_share);
        return true;
    }
    bool is_rest() const noexcept { return feed_ratio_ == 0.0; }
    /// Of the profiles' values at one place; also of their slopes.
    double of(double low, double high) const noexcept { return low_share_ * low + high_share_ * high; }

private:
    double low_share_ = 1.0;
    double high_share_ = 0.0;
    double feed_ratio_ = 1.0;
    double part_ = 1.0;
};

}  // namespace psicarve::cycle
