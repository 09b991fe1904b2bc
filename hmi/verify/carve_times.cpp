// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/verify/carve_times.hpp"

#include <algorithm>

#include "shared/base/units.hpp"

namespace psicarve::verify {

double CarveTimes::carve_seconds() const noexcept {
    // Of an attempt that missed all further points nothing was reached since.
    return has_left_ && arrived_ns_ > left_ns_ ? seconds_from_ns(arrived_ns_ - left_ns_) : 0.0;
}

double CarveTimes::seconds_so_far() const noexcept {
    const std::int64_t last_ns = std::max(arrived_ns_, gone_ns_);
    return has_left_ && last_ns > left_ns_ ? seconds_from_ns(last_ns - left_ns_) : 0.0;
}

std::vector<PassTime> CarveTimes::pass_times(const JobView& job) const {
    const auto passes = job.passes();
    std::vector<PassTime> times;
    if (passes.size() < 2 || pass_ended_ns_.size() != passes.size()) return times;
    std::int64_t before_ns = left_ns_;
    for (std::size_t i = 0; i < passes.size(); ++i) {
        // Several runs carved to one depth are one pass.
        const bool goes_on = i > 0 && passes[i].number == passes[i - 1].number;
        if (!goes_on) times.push_back({pass_name(passes[i]), 0, 0.0});
        times.back().layers += passes[i].layer_count;
        times.back().seconds += seconds_from_ns(pass_ended_ns_[i] - before_ns);
        before_ns = pass_ended_ns_[i];
    }
    return times;
}

}  // namespace psicarve::verify
