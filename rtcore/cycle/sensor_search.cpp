// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/cycle/sensor_search.hpp"

namespace psicarve::cycle {

bool SensorSearch::watch() noexcept {
    const bool is_tripped = inputs_->is_tripped(axis_);
    const bool was_tripped = was_tripped_;
    was_tripped_ = is_tripped;
    if (has_answered_) return false;
    switch (until_) {
        case Until::none:
            break;
        case Until::sensor_tripped:
            has_answered_ = is_tripped;
            break;
        case Until::sensor_clear:
            has_answered_ = !is_tripped && !inputs_->is_raw_tripped(axis_);
            break;
        case Until::index_edge:
            has_answered_ = is_tripped && !was_tripped;
            break;
    }
    return has_answered_;
}

}  // namespace psicarve::cycle
