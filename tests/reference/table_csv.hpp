// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "shared/base/result.hpp"
#include "shared/job/job.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve {

struct LayerRange {
    unsigned first = 0;
    unsigned last = UINT32_MAX;
};

/// A table as `psicarve snapshot export --format csv` prints it, whole or some layers of it, as a continuous
/// job's from layer 0 on, its first point at psi = 0. Fails with bad_input, the file or the point named.
Result<JobTable> table_from_csv(const std::string& path, const Profile& profile, LayerRange range = {});

}  // namespace psicarve
