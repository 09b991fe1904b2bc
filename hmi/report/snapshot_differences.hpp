// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "shared/record/snapshot_file.hpp"

namespace psicarve::report {

struct Difference {
    std::string what;  ///< "layers", "r_left_pulses", "profile axis.r1.speed_mm_s", "status state"...
    std::string a;
    std::string b;
};

/// Everything that differs between two snapshots or jobs. Each table is one difference, with its first
/// differing layer and point and the number of points that differ.
std::vector<Difference> differences_between(const Snapshot& a, const Snapshot& b);

}  // namespace psicarve::report
