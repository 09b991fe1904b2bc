// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/resource.h>
#include <time.h>

#include <algorithm>
#include <vector>

#include "shared/base/units.hpp"

namespace psicarve::bench {

/// CPU time of this process, all threads [s].
inline double cpu_s() {
    timespec now{};
    ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + seconds_from_ns(now.tv_nsec);
}

inline double wall_s() {
    timespec now{};
    ::clock_gettime(CLOCK_MONOTONIC, &now);
    return static_cast<double>(now.tv_sec) + seconds_from_ns(now.tv_nsec);
}

inline double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

}  // namespace psicarve::bench
