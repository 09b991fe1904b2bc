// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "shared/job/job.hpp"

namespace psicarve {

/// Any table as one of a spiral: its rows meet, and the last one closes as high as the one before.
inline JobTable spiral_of(JobTable table) {
    table.joining = Joining::spiral;
    if (table.layer_count < 2) return table;
    table.layer_height_pulses.back() = table.layer_height_pulses[table.layer_count - 2];
    for (std::size_t row = 1; row < table.layer_count; ++row) {
        const std::size_t begin = row * table.point_count;
        table.r_left_pulses[begin] = table.r_left_pulses[begin - 1];
        table.r_right_pulses[begin] = table.r_right_pulses[begin - 1];
    }
    return table;
}

}  // namespace psicarve
